// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterPolygons.h"

#include "vtkDataSetSurfaceFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

//------------------------------------------------------------------------------
void vtkWaterPolygonsOf(vtkDataSet* input, vtkPolyData* mesh)
{
  mesh->ShallowCopy(input);
  if (!vtkPolyData::SafeDownCast(input))
  {
    vtkNew<vtkDataSetSurfaceFilter> outside;
    outside->SetInputData(input);
    outside->Update();
    mesh->ShallowCopy(outside->GetOutput());
  }
  if (mesh->GetNumberOfPolys() != mesh->GetNumberOfCells())
  {
    vtkNew<vtkTriangleFilter> polygons;
    polygons->SetInputData(mesh);
    polygons->PassLinesOff();
    polygons->PassVertsOff();
    polygons->Update();
    mesh->ShallowCopy(polygons->GetOutput());
  }
}
