// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterClosedCells: closes the cells of the reflection texture that no visible water looks up:
// nothing that is drawn later passes the depth test there.
#ifndef vtkWaterClosedCells_h
#define vtkWaterClosedCells_h

#include "vtkSmartPointer.h"
#include "water_visibility.h"

class vtkOpenGLVertexArrayObject;
class vtkRenderer;

class vtkWaterClosedCells
{
public:
  // Closes them in the reflection texture, which is bound.
  void Draw(vtkRenderer* renderer, const water_visibility& seen);

  void ReleaseGraphicsResources();

private:
  vtkSmartPointer<vtkOpenGLVertexArrayObject> Array;
};

#endif
