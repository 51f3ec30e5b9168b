// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterDivides: where the land of a mesh divides lakes at different levels (water_shore.h).
#ifndef vtkWaterDivides_h
#define vtkWaterDivides_h

#include "vtkType.h"

#include <cstddef>
#include <unordered_map>
#include <unordered_set>

struct vtkWaterDivides
{
  // Dry points beside two lakes, and their beds: neither lake's level is theirs.
  std::unordered_map<vtkIdType, double> Beds;
  // Cells at the shore with wet corners at different levels: if land separates these corners on
  // both sides, no triangle may join them.
  std::unordered_set<vtkIdType> Cells;

  void Clear()
  {
    this->Beds.clear();
    this->Cells.clear();
  }
  std::size_t GetCount() const { return this->Beds.size() + this->Cells.size(); }
};

#endif
