// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterTranslucentLayer: what is translucent in a mirrored
// view, volumes included, apart from the rest: for waves that follow rays. See
// Documentation/decisions/006-lookup.md.
#ifndef vtkWaterTranslucentLayer_h
#define vtkWaterTranslucentLayer_h

#include "vtkWaterProps.h"
#include "vtkWaterQuad.h"
#include "vtkWaterTarget.h"

#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkTextureObject;
class vtkWaterShaderHook;
class vtkWaterTranslucent;
class vtkWindow;
struct water_plan;

class vtkWaterTranslucentLayer
{
public:
  // Is any of the props translucent, or a volume?
  static bool IsNeeded(const std::vector<vtkProp*>& props, const std::vector<vtkProp*>& others);

  // Keeps what the reflection texture shows before anything translucent is drawn into it. The bound
  // framebuffer and the scissor test are others afterwards.
  //
  // Returns false when the GPU gives no textures for it.
  bool Keep(vtkOpenGLRenderWindow* window, vtkWaterTarget& reflection);

  // Draws the layer: Bind, then viewport and scissor of the reflection texture, then Draw.
  bool Bind() { return this->Layer.Bind(); }
  void Draw(vtkRenderer* renderer, vtkWaterShaderHook* hook, const water_plan& plan,
    std::vector<vtkProp*>& props, vtkWaterTranslucent& translucent);

  // The same for a layer that ranks join: it begins with the depth of all ranks' opaque props;
  // after Bind its colours are drawn, then its depths where rays look for them, and resolved.
  //
  // hasSamples  of each sample, else of the pixels
  // hasOpaque   keeps the reflection texture's colours, too
  bool KeepDepth(
    vtkOpenGLRenderWindow* window, vtkWaterTarget& reflection, bool hasSamples, bool hasOpaque);
  void DrawColors(
    vtkRenderer* renderer, std::vector<vtkProp*>& props, vtkWaterTranslucent& translucent);
  void DrawDepths(vtkRenderer* renderer, vtkWaterShaderHook* hook, const water_plan& plan,
    const std::vector<vtkProp*>& props);
  vtkOpenGLFramebufferObject* Resolve(); // holds the pixels of what was drawn

  // Fills the mip levels.
  void MakeLevels();

  vtkTextureObject* GetOpaque() { return this->Opaque.GetColor(); } // all else
  vtkTextureObject* GetColor() { return this->Layer.GetColor(); }   // times alpha, and alpha
  vtkTextureObject* GetDepth() { return this->Layer.GetDepth(); }   // of all

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void DrawAlpha(vtkRenderer* renderer, const std::vector<vtkProp*>& props);
  void DrawVolumeDepth(
    vtkOpenGLRenderWindow* window, const water_plan& plan, const vtkWaterProps::Box& box);

  vtkWaterTarget Opaque;
  vtkWaterTarget Layer;
  vtkWaterQuad VolumeDepth;
};

#endif
