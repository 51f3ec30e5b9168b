// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMask: closes what no visible water looks up: pixels of the reflection texture, or cells
// of them.
#ifndef vtkWaterMask_h
#define vtkWaterMask_h

#include "vtkSmartPointer.h"
#include "vtkWaterQuad.h"
#include "water_visibility.h"

class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkRenderer;
class vtkShaderProgram;
class vtkWaterSceneDepth;

class vtkWaterMask
{
public:
  // Closes the pixels of the bound reflection texture that no visible water looks up.
  void DrawMask(vtkRenderer* renderer, const water_plan& plan, vtkWaterSceneDepth& sceneDepth);

  // Fills the bound framebuffer, its viewport set to the cells of the reflection texture, a pixel
  // each: black where no visible water looks anything up, else white. false: it cannot.
  bool DrawCells(
    vtkRenderer* renderer, const water_plan& plan, int cell_px, vtkWaterSceneDepth& sceneDepth);

  // Closes the pixels of the bound reflection texture that are in cells that no visible water looks
  // up.
  void DrawClosedCells(vtkRenderer* renderer, const water_visibility& seen);

  void ReleaseGraphicsResources();

private:
  void DrawCovers(vtkShaderProgram* program, vtkOpenGLRenderWindow* window, const water_plan& plan,
    vtkWaterSceneDepth& sceneDepth, const int rect_px[4], int cell_px);

  vtkWaterQuad Mask;
  vtkSmartPointer<vtkOpenGLVertexArrayObject> CoverArray;
};

#endif
