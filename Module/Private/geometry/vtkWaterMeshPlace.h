// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMeshPlace: where a mesh lies in the world and against the water's plane; compared, to
// know whether what was asked of it still holds.
#ifndef vtkWaterMeshPlace_h
#define vtkWaterMeshPlace_h

#include "vtkMatrix4x4.h"
#include "water_types.h"

#include <algorithm>
#include <array>

using vtkWaterMeshPlace = std::array<double, 20>; // matrix and plane

inline vtkWaterMeshPlace vtkWaterMeshPlaceOf(vtkMatrix4x4* meshToWorld, const water_plane& unit)
{
  vtkWaterMeshPlace place;
  std::copy_n(&meshToWorld->Element[0][0], 16, place.begin());
  std::copy_n(unit.normal, 3, place.begin() + 16);
  place[19] = unit.offset;
  return place;
}

#endif
