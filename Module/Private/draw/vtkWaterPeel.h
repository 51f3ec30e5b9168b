// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPeel: what is behind the first things of the reflection texture, for rays that go behind
// their edges: the second layer of depth peeling.
//
// Source: Everitt, C., "Interactive Order-Independent Transparency", NVIDIA, 2001.
#ifndef vtkWaterPeel_h
#define vtkWaterPeel_h

#include "vtkWaterTarget.h"

class vtkWaterPeel
{
public:
  // Binds what it is drawn into, and the reflection texture's depth for vtkWaterPeelFS.glsl, until
  // End. The caller has pushed the framebuffer bindings and pops them.
  //
  // Returns false, and has bound no texture, when the GPU gives none.
  bool Begin(vtkOpenGLRenderWindow* window, vtkWaterTarget& reflection);
  void End(vtkOpenGLRenderWindow* window);

  vtkOpenGLFramebufferObject* GetFramebuffer() { return this->Target.GetFramebuffer(); }
  vtkTextureObject* GetColor() { return this->Target.GetColor(); }
  vtkTextureObject* GetDepth() { return this->Target.GetDepth(); }

  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Target.ReleaseGraphicsResources(window);
  }

private:
  void BindDepth(vtkOpenGLRenderWindow* window, unsigned int handle);

  vtkWaterTarget Target;
};

#endif
