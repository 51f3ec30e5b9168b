// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMeshHeights: how high the points of a surface's mesh lie over the water's plane
// (water_flatness.h), asked once for each state of the three.
#ifndef vtkWaterMeshHeights_h
#define vtkWaterMeshHeights_h

#include "vtkType.h"
#include "vtkWaterMeshPlace.h"
#include "water_types.h"

class vtkMapper;
class vtkMatrix4x4;
class vtkPointSet;

// Of the mesh that a surface is.
struct vtkWaterMesh
{
  double HeightMax = 0.0;        // of water_flatness_judge
  bool HasVertexHeights = false; // the two below are set
  double Height[4] = {};         // of water_flatness_heights
  double Bounds[6] = {};         // in its own coordinates
  double ToWorld[16] = {};
  double Reach = 0.0;    // the height of its highest point, over the plane or under it
  double SlopeRMS = 0.0; // of its triangles against the plane
  bool IsSloped = false; // that turns rays
};

class vtkWaterMeshHeights
{
public:
  // Of a mesh that is drawn where its data says. Of mappers without points nothing is known:
  // the height may be any.
  const vtkWaterMesh& Read(vtkMapper* mapper, vtkMatrix4x4* meshToWorld, const water_plane& unit);

private:
  static vtkWaterMesh Measure(
    vtkPointSet* data, vtkMatrix4x4* meshToWorld, const water_plane& unit);

  void* Points = nullptr; // compared only
  vtkMTimeType PointsTime = 0;
  vtkWaterMeshPlace Place{};
  vtkWaterMesh Mesh;
};

#endif
