// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMeshPlacement: asks the core whether a mesh of the user's lies in the water's plane
// (water_placement.h), once for each state of the three.
#ifndef vtkWaterMeshPlacement_h
#define vtkWaterMeshPlacement_h

#include "vtkType.h"
#include "vtkWaterMeshPlace.h"
#include "water_placement.h"

#include <string>

class vtkMapper;
class vtkMatrix4x4;
class vtkPolyData;

class vtkWaterMeshPlacement
{
public:
  // What is wrong with a surface, in words, the first time that it is; empty: nothing, or it has
  // been said since all was well.
  std::string Check(vtkMapper* mapper, vtkMatrix4x4* meshToWorld, const water_plane& unit);

  // The polygons that a mapper shows as they are; nullptr: they are not known.
  static vtkPolyData* FindMesh(vtkMapper* mapper);

  static water_placement_verdict Judge(
    vtkPolyData* mesh, vtkMatrix4x4* meshToWorld, const water_plane& unit);

private:
  vtkPolyData* Mesh = nullptr; // compared only
  vtkMTimeType MeshTime = 0;
  vtkWaterMeshPlace Place{};
  bool IsSaid = false;
};

#endif
