// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBackdrop: colour and depth of the picture as it is before a water is drawn: what is seen
// through the surface.
#ifndef vtkWaterBackdrop_h
#define vtkWaterBackdrop_h

#include "vtkOpenGLFramebufferObject.h" // for members
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h" // for members

class vtkOpenGLRenderWindow;
class vtkWindow;

class vtkWaterBackdrop
{
public:
  // Copies what the bound framebuffer has in a rectangle (x, y, width, height in pixels). Samples
  // are averaged, as far as the GPU can.
  //
  // Returns false when the GPU refuses; there is then no backdrop.
  //
  // rect  of the picture
  // part  of that, from its corner, that is looked at; the rest of the textures is what it was
  bool Copy(vtkOpenGLRenderWindow* window, const int rect[4], const int part[4]);

  // Did the GPU give no memory for it, when last asked?
  bool GetHasFailed() const { return this->HasFailed; }

  // Are its colours means of several samples?
  bool GetIsMixed() const { return this->IsMixed; }

  vtkTextureObject* GetColor() { return this->Color; }
  vtkTextureObject* GetDepth() { return this->Depth; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Ensure(vtkOpenGLRenderWindow* window, int width, int height);

  vtkSmartPointer<vtkTextureObject> Color;
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer; // only when samples are averaged
  int Width = 0;
  int Height = 0;
  int ColorType = 0; // VTK's, as the picture's
  int DepthFormat = 0;
  bool IsMixed = false;
  bool HasFailed = false;
};

#endif
