// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterShoreCells.h"

#include "vtkWaterPolygons.h"

//------------------------------------------------------------------------------
void vtkWaterShoreCells::Classify(vtkCellArray* polygons, const double* depths)
{
  const vtkIdType cells = polygons->GetNumberOfCells();
  this->Depths = depths;
  this->Kinds.resize(static_cast<size_t>(cells));
  std::vector<std::vector<vtkIdType>> cut(static_cast<size_t>(vtkWaterBlockCount(cells)));
  vtkWaterForBlocks(cells, [&](vtkIdType block, vtkIdType begin, vtkIdType end) {
    std::vector<vtkIdType>& here = cut[static_cast<size_t>(block)];
    vtkWaterForCells(
      polygons, begin, end, [&](vtkIdType cell, const vtkIdType* points, vtkIdType count) {
        vtkIdType wet = 0;
        for (vtkIdType i = 0; i < count; ++i)
        {
          wet += depths[points[i]] > 0.0 ? 1 : 0;
        }
        const bool isDry = wet == 0 || count < 3;
        const Kind kind = isDry ? Dry : (wet == count ? Wet : Cut);
        this->Kinds[static_cast<size_t>(cell)] = kind;
        if (kind == Cut)
        {
          here.push_back(cell);
        }
      });
  });
  this->CutCells.clear();
  for (const std::vector<vtkIdType>& ofBlock : cut)
  {
    this->CutCells.insert(this->CutCells.end(), ofBlock.begin(), ofBlock.end());
  }
}
