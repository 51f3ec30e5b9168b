// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterGround: has a scene ground under all of its water? Asked once for what the scene shows.
#ifndef vtkWaterGround_h
#define vtkWaterGround_h

#include "vtkType.h"
#include "water_ground.h"
#include "water_types.h"

#include <vector>

class vtkDataSet;
class vtkMatrix4x4;
class vtkProp;
class vtkRenderer;

class vtkWaterGround
{
public:
  // plane   of any scale
  // bounds  of the scene, in world
  // scene   renderers whose props are looked at, waters left out
  bool IsUnder(
    const water_plane& plane, const double bounds[6], const std::vector<vtkRenderer*>& scene);

  // Corners of the parts of the scene that are not known to be dry, four of x, y, z each, as of
  // IsUnder; empty: all of it is wet.
  const std::vector<double>& GetWet() const { return this->Wet; }

  // Is the bed of a tank or a pool under the water? As of IsUnder.
  bool GetIsFlat() const { return this->IsFlat; }

private:
  void Add(vtkProp* prop);
  void FindWet();
  bool AddData(vtkDataSet* data, vtkMatrix4x4* matrix); // returns whether it may be a bed
  void SeeRelief(vtkDataSet* data, vtkMatrix4x4* matrix);

  std::vector<double> Key; // what the answer is of
  water_ground Ground = water_ground();
  water_footprint Footprint = water_footprint(); // of the thing that is looked at
  water_relief Relief = water_relief();          // of the same
  double Level = 0.0;                            // height of the water along the normal
  std::vector<double> Wet;
  bool IsFlat = false;
};

#endif
