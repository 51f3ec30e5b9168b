// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPolygons: a data set's surface as polygons alone, and a walk over them that copies
// nothing.
#ifndef vtkWaterPolygons_h
#define vtkWaterPolygons_h

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkDataSet;
class vtkPolyData;

// The first cell with a point that the data set does not have; empty: there is none. VTK's filters
// do not check this, and crash.
std::string vtkWaterFindWrongPoint(vtkDataSet* input);

// The polygons of a data set's surface, and nothing else: strips become triangles.
void vtkWaterPolygonsOf(vtkDataSet* input, vtkPolyData* mesh);

// Calls function(cell, points, count) for every cell, in order.
template <typename Function>
void vtkWaterForEachCell(vtkCellArray* cells, Function function)
{
  auto walk = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
  const vtkIdType number = cells->GetNumberOfCells();
  for (vtkIdType cell = 0; cell < number; ++cell)
  {
    const vtkIdType* points = nullptr;
    vtkIdType count = 0;
    walk->GetCellAtId(cell, count, points);
    function(cell, points, count);
  }
}

#endif
