// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterShoreCells.h"

#include "vtkWaterCellChunks.h"
#include "vtkWaterPolygons.h"

#include <algorithm>

namespace
{
constexpr size_t kChunks = 2048; // that one thread looks at
}

//------------------------------------------------------------------------------
void vtkWaterShoreCells::ClassifyCells(
  vtkCellArray* polygons, vtkIdType begin, vtkIdType end, std::vector<vtkIdType>& cut)
{
  vtkWaterForCells(
    polygons, begin, end, [&](vtkIdType cell, const vtkIdType* points, vtkIdType count) {
      vtkIdType wet = 0;
      for (vtkIdType i = 0; i < count; ++i)
      {
        wet += this->Depths[points[i]] > 0.0 ? 1 : 0;
      }
      const bool isDry = wet == 0 || count < 3;
      const Kind kind = isDry ? Dry : (wet == count ? Wet : Cut);
      this->Kinds[static_cast<size_t>(cell)] = kind;
      if (kind == Cut)
      {
        cut.push_back(cell);
      }
    });
}

//------------------------------------------------------------------------------
void vtkWaterShoreCells::ClassifyChunks(
  vtkCellArray* polygons, size_t begin, size_t end, std::vector<vtkIdType>& cut)
{
  for (size_t chunk = begin; chunk < end; ++chunk)
  {
    const int water = this->Chunks->FindWater(chunk, this->Depths);
    const vtkIdType first = this->Chunks->BeginOf(chunk);
    const vtkIdType last = this->Chunks->BeginOf(chunk + 1);
    if (water < 0)
    {
      this->ClassifyCells(polygons, first, last, cut);
      continue;
    }
    std::fill(this->Kinds.begin() + first, this->Kinds.begin() + last, water > 0 ? Wet : Dry);
  }
}

//------------------------------------------------------------------------------
void vtkWaterShoreCells::Classify(
  vtkCellArray* polygons, const double* depths, vtkWaterCellChunks* chunks)
{
  const vtkIdType cells = polygons->GetNumberOfCells();
  const size_t count = chunks->GetCount();
  this->Depths = depths;
  this->Chunks = chunks;
  this->Kinds.resize(static_cast<size_t>(cells));
  std::vector<std::vector<vtkIdType>> cut(
    std::max((count + kChunks - 1) / kChunks, static_cast<size_t>(vtkWaterBlockCount(cells))));
  if (count == 0)
  {
    vtkWaterForBlocks(cells, [&](vtkIdType block, vtkIdType begin, vtkIdType end) {
      this->ClassifyCells(polygons, begin, end, cut[static_cast<size_t>(block)]);
    });
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>((count + kChunks - 1) / kChunks), 1,
    [&](vtkIdType first, vtkIdType last) {
      for (auto block = static_cast<size_t>(first); block < static_cast<size_t>(last); ++block)
      {
        const size_t begin = block * kChunks;
        this->ClassifyChunks(polygons, begin, std::min(begin + kChunks, count), cut[block]);
      }
    });
  this->CutCells.clear();
  for (const std::vector<vtkIdType>& ofBlock : cut)
  {
    this->CutCells.insert(this->CutCells.end(), ofBlock.begin(), ofBlock.end());
  }
}
