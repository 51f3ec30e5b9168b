// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterCellChunks: the chunks of a mesh's cells (water_chunks.h), found when the mesh comes for
// the second time: finding them takes as long as they save in some steps.
#ifndef vtkWaterCellChunks_h
#define vtkWaterCellChunks_h

#include "vtkType.h"
#include "water_chunks.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkPolyData;

// What vtkWaterForBlocks' blocks of a mesh's cells have in common.
struct vtkWaterCellBlocks
{
  std::vector<uint16_t> FirstBlocks;  // of each point: that has it
  std::vector<vtkIdType> SharedCells; // with a point that a block before their own has, in order
};

class vtkWaterCellChunks
{
public:
  // mesh  of polygons alone; nullptr: one that will not come again
  void Update(vtkPolyData* mesh);

  // 0: there are none, or they would save nothing.
  size_t GetCount() const { return this->Begins.empty() ? 0 : this->Begins.size() - 1; }

  vtkIdType BeginOf(size_t chunk) const { return this->Begins[chunk]; }
  vtkIdType FirstPointOf(size_t chunk) const
  {
    return this->Points[static_cast<size_t>(this->PointEnds[chunk])];
  }

  // Are the points of a chunk under water? 1: all are, 0: none is, -1: some are.
  int FindWater(size_t chunk, const double* depths) const
  {
    const int32_t begin = this->PointEnds[chunk];
    return water_chunks_water(
      depths, this->Points.data() + begin, static_cast<size_t>(this->PointEnds[chunk + 1] - begin));
  }

  // cells  as of water_chunks_judge
  void Judge(const char* cells);
  water_chunk_kind KindOf(size_t chunk) const
  {
    return static_cast<water_chunk_kind>(this->Kinds[chunk]);
  }

  // nullptr: they are not known, or share too many points.
  const vtkWaterCellBlocks* GetBlocks() const
  {
    return this->Blocks.FirstBlocks.empty() ? nullptr : &this->Blocks;
  }

  // Joins the regions of those that are inside.
  void Join(int64_t* parents, size_t points) const;

private:
  void Find(vtkPolyData* mesh);
  void FindBlocks(vtkPolyData* mesh);

  std::array<vtkMTimeType, 4> Seen{}; // the last mesh's cells
  bool IsFound = false;               // that it has chunks, or has none
  std::vector<int64_t> Begins;
  std::vector<int32_t> PointEnds; // of each chunk, in the list of points
  std::vector<int32_t> Points;
  std::vector<water_chunk_link> Links;
  std::vector<unsigned char> Kinds;
  vtkWaterCellBlocks Blocks;
};

#endif
