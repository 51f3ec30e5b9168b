// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterShoreCells: which polygons of a mesh are under water, by the depths at their points.
#ifndef vtkWaterShoreCells_h
#define vtkWaterShoreCells_h

#include "vtkType.h"

#include <cstddef>
#include <vector>

class vtkCellArray;
class vtkWaterCellChunks;

struct vtkWaterShoreCells
{
  enum Kind : char
  {
    Dry,
    Wet,
    Cut // by the shore
  };

  // depths  of points, finite, below 0 on land; kept, not copied
  // chunks  of the polygons; kept, too
  void Classify(vtkCellArray* polygons, const double* depths, vtkWaterCellChunks* chunks);

  const double* Depths = nullptr;
  vtkWaterCellChunks* Chunks = nullptr;
  std::vector<Kind> Kinds;
  std::vector<vtkIdType> CutCells; // in order

private:
  // Of some cells; adds those that are cut.
  void ClassifyCells(
    vtkCellArray* polygons, vtkIdType begin, vtkIdType end, std::vector<vtkIdType>& cut);
  void ClassifyChunks(
    vtkCellArray* polygons, size_t begin, size_t end, std::vector<vtkIdType>& cut);
};

#endif
