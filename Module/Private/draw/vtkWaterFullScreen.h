// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFullScreen: the full-screen draws: the sky behind
// the mirrored view, the water between an eye in it and the scene, and the debug corner.
#ifndef vtkWaterFullScreen_h
#define vtkWaterFullScreen_h

#include "vtkSmartPointer.h"
#include "water_visibility.h"

#include <memory>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkRenderer;
class vtkTextureObject;
class vtkWaterBackdrop;
class vtkWaterSceneDepth;

class vtkWaterFullScreen
{
public:
  // Readies a full-screen quad with a fragment shader, made at first; false: it does not compile.
  static bool Ready(std::unique_ptr<vtkOpenGLQuadHelper>& quad, vtkOpenGLRenderWindow* window,
    const char* fragmentShader);

  vtkWaterFullScreen();
  ~vtkWaterFullScreen();

  // Clears the bound framebuffer to the renderer's background as the mirrored view sees it: a plain
  // colour, or, within its viewport and scissor, the gradient in the direction of each ray.
  // Textured backgrounds give their plain colour.
  void DrawSky(vtkRenderer* renderer, const water_plan& plan);

  // Closes the pixels of the bound reflection texture that no visible water looks up.
  void DrawMask(vtkRenderer* renderer, const water_plan& plan, vtkWaterSceneDepth& sceneDepth);

  // Fills the bound framebuffer, its viewport set to the cells of the reflection texture, a pixel
  // each: black where no visible water looks anything up, else white. false: it cannot.
  bool DrawCells(
    vtkRenderer* renderer, const water_plan& plan, int cell_px, vtkWaterSceneDepth& sceneDepth);

  // Closes the pixels of the bound reflection texture that are in cells that no visible water looks
  // up.
  void DrawClosedCells(vtkRenderer* renderer, const water_visibility& seen);

  // Draws the picture again as seen through the water, for an eye that is submerged.
  void DrawFog(vtkRenderer* renderer, const water_plan& plan, vtkWaterBackdrop& backdrop,
    const double deepColor[3], const double extinction[3]);

  // Shows a texture in the lower left quarter of the renderer's viewport.
  void DrawCorner(vtkRenderer* renderer, vtkTextureObject* reflection);

  void ReleaseGraphicsResources();

private:
  void DrawCovers(vtkOpenGLRenderWindow* window, const water_plan& plan,
    vtkWaterSceneDepth& sceneDepth, const int rect_px[4], int cell_px);

  std::unique_ptr<vtkOpenGLQuadHelper> Sky;
  std::unique_ptr<vtkOpenGLQuadHelper> Mask;
  vtkSmartPointer<vtkOpenGLVertexArrayObject> CoverArray;
  std::unique_ptr<vtkOpenGLQuadHelper> Fog;
  std::unique_ptr<vtkOpenGLQuadHelper> Corner;
};

#endif
