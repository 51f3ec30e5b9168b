// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterShoreCells: which polygons of a mesh are under water, by the depths at their points.
#ifndef vtkWaterShoreCells_h
#define vtkWaterShoreCells_h

#include "vtkType.h"

#include <vector>

class vtkCellArray;

struct vtkWaterShoreCells
{
  enum Kind : char
  {
    Dry,
    Wet,
    Cut // by the shore
  };

  // depths  of points, finite, below 0 on land; kept, not copied
  void Classify(vtkCellArray* polygons, const double* depths);

  const double* Depths = nullptr;
  std::vector<Kind> Kinds;
  std::vector<vtkIdType> CutCells; // in order
};

#endif
