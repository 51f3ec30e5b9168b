// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterTranslucent: draws the translucent geometry and the volumes of a mirrored view, blended
// as the renderer blends them in the picture.
#ifndef vtkWaterTranslucent_h
#define vtkWaterTranslucent_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkOpenGLFramebufferObject;
class vtkProp;
class vtkRenderPass;
class vtkRenderer;
class vtkWindow;

class vtkWaterTranslucent
{
public:
  static bool HasPolygons(const std::vector<vtkProp*>& props);

  // Draws over what the bound framebuffer shows: first the polygons, then the volumes, which may
  // have been peeled with them.
  void DrawPolygons(
    vtkRenderer* renderer, std::vector<vtkProp*>& props, vtkOpenGLFramebufferObject* framebuffer);
  void DrawVolumes(vtkRenderer* renderer, const std::vector<vtkProp*>& props);

  // Did the polygons that were drawn last cover alpha as they cover colours?
  bool LeavesAlpha() const;

  void ReleaseGraphicsResources(vtkWindow* window);

  // Does the way in which the renderer blends have samples? Blending in any order does not: VTK
  // draws it into framebuffers of its own.
  static bool HasSamples(vtkRenderer* renderer)
  {
    return GetBlending(renderer) != ORDER_INDEPENDENT;
  }

private:
  enum Blendings // as the renderer's flags choose it
  {
    ORDER_INDEPENDENT,
    PEELING,
    PEELING_WITH_VOLUMES,
    PLAIN
  };
  static Blendings GetBlending(vtkRenderer* renderer);
  vtkRenderPass* GetPass(vtkRenderer* renderer);

  vtkSmartPointer<vtkRenderPass> Pass;
  Blendings Blending = ORDER_INDEPENDENT; // of the pass
  bool HasPeeled = false;                 // the volumes
};

#endif
