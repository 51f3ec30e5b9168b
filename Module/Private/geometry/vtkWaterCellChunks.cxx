// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterCellChunks.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"
#include "vtkWaterPolygons.h"

#include <algorithm>
#include <limits>

namespace
{
constexpr size_t kMost = 32;      // cells of a chunk: more, and few chunks are far from all shores
constexpr size_t kLeast = 8;      // on average: else looking at chunks takes as long as at cells
constexpr vtkIdType kShared = 16; // one thread adds to points of several blocks: not to many
}

//------------------------------------------------------------------------------
void vtkWaterCellChunks::Update(vtkPolyData* mesh)
{
  std::array<vtkMTimeType, 4> now{};
  if (mesh)
  {
    vtkCellArray* cells = mesh->GetPolys();
    now = { reinterpret_cast<vtkMTimeType>(cells), vtkWaterCellsTime(cells),
      static_cast<vtkMTimeType>(cells->GetNumberOfConnectivityIds()),
      static_cast<vtkMTimeType>(mesh->GetNumberOfPoints()) };
  }
  const bool comesAgain = mesh && now == this->Seen;
  this->Seen = now;
  if (!comesAgain)
  {
    this->Begins.clear();
    this->Blocks = vtkWaterCellBlocks();
    this->IsFound = false;
  }
  else if (!this->IsFound)
  {
    this->Find(mesh);
    this->FindBlocks(mesh);
    this->IsFound = true;
  }
}

//------------------------------------------------------------------------------
void vtkWaterCellChunks::Find(vtkPolyData* mesh)
{
  const vtkWaterCellLists lists(mesh->GetPolys());
  const auto cells = static_cast<size_t>(mesh->GetNumberOfPolys());
  const auto points = static_cast<size_t>(mesh->GetNumberOfPoints());
  constexpr auto most = static_cast<size_t>(std::numeric_limits<int32_t>::max());
  const auto isTooFew = [](const vtkIdType*, vtkIdType size) { return size < 3; };
  if (!lists.Starts || points > most ||
    static_cast<size_t>(mesh->GetPolys()->GetNumberOfConnectivityIds()) > most ||
    vtkWaterHasCell(mesh->GetPolys(), isTooFew)) // those have no water, whatever their points have
  {
    return;
  }
  const size_t count = water_chunks_split(lists.Starts, lists.Corners, cells, kMost, nullptr);
  if (count * kLeast > cells)
  {
    return;
  }
  this->Begins.resize(count + 1);
  water_chunks_split(lists.Starts, lists.Corners, cells, kMost, this->Begins.data());
  std::vector<int32_t> last(points);
  const auto list = [&](int32_t* listed) {
    return water_chunks_list(lists.Starts, lists.Corners, this->Begins.data(), count, last.data(),
      points, this->PointEnds.data(), listed);
  };
  this->PointEnds.resize(count + 1);
  this->Points.resize(list(nullptr));
  list(this->Points.data());
  std::vector<int32_t> seen(count);
  const auto link = [&](water_chunk_link* links) {
    return water_chunks_link(lists.Starts, lists.Corners, this->Begins.data(), count, last.data(),
      points, seen.data(), links);
  };
  this->Links.resize(link(nullptr));
  link(this->Links.data());
  this->Kinds.resize(count);
}

//------------------------------------------------------------------------------
void vtkWaterCellChunks::FindBlocks(vtkPolyData* mesh)
{
  constexpr uint16_t none = std::numeric_limits<uint16_t>::max();
  vtkCellArray* cells = mesh->GetPolys();
  const vtkIdType count = cells->GetNumberOfCells();
  if (vtkWaterBlockCount(count) >= none)
  {
    return;
  }
  this->Blocks.FirstBlocks.assign(static_cast<size_t>(mesh->GetNumberOfPoints()), none);
  vtkWaterForEachCell(cells, [&](vtkIdType cell, const vtkIdType* points, vtkIdType size) {
    const auto own = static_cast<uint16_t>(cell / vtkWaterBlockSize);
    bool isShared = false;
    for (vtkIdType i = 0; i < size; ++i)
    {
      uint16_t& first = this->Blocks.FirstBlocks[static_cast<size_t>(points[i])];
      first = std::min(first, own);
      isShared = isShared || first < own;
    }
    if (isShared)
    {
      this->Blocks.SharedCells.push_back(cell);
    }
  });
  if (static_cast<vtkIdType>(this->Blocks.SharedCells.size()) > count / kShared)
  {
    this->Blocks = vtkWaterCellBlocks();
  }
}

//------------------------------------------------------------------------------
void vtkWaterCellChunks::Judge(const char* cells)
{
  water_chunks_judge(this->Begins.data(), this->GetCount(), this->Links.data(), this->Links.size(),
    cells, this->Kinds.data());
}

//------------------------------------------------------------------------------
void vtkWaterCellChunks::Join(int64_t* parents, size_t points) const
{
  water_chunks_join(this->Links.data(), this->Links.size(), this->Kinds.data(), parents, points);
}
