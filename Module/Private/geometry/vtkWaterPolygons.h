// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPolygons: a data set's surface as polygons alone, and a walk over them and
// their points that copies little.
#ifndef vtkWaterPolygons_h
#define vtkWaterPolygons_h

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDoubleArray.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <string>

class vtkDataSet;
class vtkPolyData;

// The first cell with a point that the data set does not have, or what else its cells or
// dimensions have that lies beyond its arrays; empty: nothing. VTK's filters do not check this, and
// crash.
std::string vtkWaterFindWrongPoint(vtkDataSet* input);

// The polygons of a data set's surface, and nothing else: strips become triangles.
void vtkWaterPolygonsOf(vtkDataSet* input, vtkPolyData* mesh);

// The places of points, each read in full precision. Several threads may read.
class vtkWaterPlaces
{
public:
  explicit vtkWaterPlaces(vtkPoints* points)
    : Array(points->GetData())
  {
    auto* doubles = vtkArrayDownCast<vtkDoubleArray>(this->Array);
    this->Doubles = doubles ? doubles->GetPointer(0) : nullptr;
  }

  void Get(vtkIdType point, double place[3]) const
  {
    if (this->Doubles) // a virtual call for each point costs as much as what is done with it
    {
      const double* own = this->Doubles + 3 * point;
      place[0] = own[0]; // std::copy_n calls a function, which takes longer
      place[1] = own[1];
      place[2] = own[2];
      return;
    }
    this->Array->GetTuple(point, place);
  }

  // Rows of 3, if that is how they are stored; else nullptr.
  const double* GetDoubles() const { return this->Doubles; }

private:
  vtkDataArray* Array;
  const double* Doubles;
};

// The cells as lists of 64 bits, if that is how they are stored; else nullptr.
struct vtkWaterCellLists
{
  explicit vtkWaterCellLists(vtkCellArray* cells)
  {
    if (cells && cells->IsStorage64Bit())
    {
      this->Starts = reinterpret_cast<const int64_t*>(cells->GetOffsetsArray64()->GetPointer(0));
      this->Corners =
        reinterpret_cast<const int64_t*>(cells->GetConnectivityArray64()->GetPointer(0));
    }
  }

  const int64_t* Starts = nullptr; // one more than there are cells
  const int64_t* Corners = nullptr;
};

// When cells were changed last. vtkCellArray::GetMTime does not ask its arrays.
inline vtkMTimeType vtkWaterCellsTime(vtkCellArray* cells)
{
  return std::max({ cells->GetMTime(), cells->GetOffsetsArray()->GetMTime(),
    cells->GetConnectivityArray()->GetMTime() });
}

// Calls function(cell, points, count) for the cells from begin up to end, in order.
template <typename Function>
void vtkWaterForCells(vtkCellArray* cells, vtkIdType begin, vtkIdType end, Function function)
{
#ifdef VTK_USE_64BIT_IDS
  if (begin < end && cells->IsStorage64Bit())
  {
    static_assert(sizeof(vtkTypeInt64) == sizeof(vtkIdType), "both are of 64 bits");
    const vtkTypeInt64* starts = cells->GetOffsetsArray64()->GetPointer(0);
    const vtkTypeInt64* all = cells->GetConnectivityArray64()->GetPointer(0);
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      function(cell, reinterpret_cast<const vtkIdType*>(all + starts[cell]),
        static_cast<vtkIdType>(starts[cell + 1] - starts[cell]));
    }
    return;
  }
#endif
  auto walk = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    const vtkIdType* points = nullptr;
    vtkIdType count = 0;
    walk->GetCellAtId(cell, count, points);
    function(cell, points, count);
  }
}

// The same for all cells.
template <typename Function>
void vtkWaterForEachCell(vtkCellArray* cells, Function function)
{
  vtkWaterForCells(cells, 0, cells->GetNumberOfCells(), function);
}

// Calls function(block, begin, end) for blocks of about equal size, in several threads. The blocks
// depend on the number of cells or points alone, so sums over them do not depend on the threads.
constexpr vtkIdType vtkWaterBlockSize = 1 << 16;
inline vtkIdType vtkWaterBlockCount(vtkIdType number)
{
  return (number + vtkWaterBlockSize - 1) / vtkWaterBlockSize;
}
template <typename Function>
void vtkWaterForBlocks(vtkIdType number, Function function)
{
  vtkSMPTools::For(0, vtkWaterBlockCount(number), 1, [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType block = first; block < last; ++block)
    {
      const vtkIdType begin = block * vtkWaterBlockSize;
      function(block, begin, std::min(begin + vtkWaterBlockSize, number));
    }
  });
}

// Is there a cell for which predicate(points, count) holds? Several threads look.
template <typename Predicate>
bool vtkWaterHasCell(vtkCellArray* cells, Predicate predicate)
{
  std::atomic<bool> isFound{ false };
  vtkWaterForBlocks(cells->GetNumberOfCells(), [&](vtkIdType, vtkIdType begin, vtkIdType end) {
    bool isHere = false;
    vtkWaterForCells(cells, begin, end, [&](vtkIdType, const vtkIdType* points, vtkIdType count) {
      isHere = isHere || predicate(points, count);
    });
    if (isHere)
    {
      isFound = true;
    }
  });
  return isFound;
}

#endif
