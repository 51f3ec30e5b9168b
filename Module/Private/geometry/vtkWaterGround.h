// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterGround: has a scene ground under all of its water? Asked once for what the scene shows.
// Ranks look at the ground of their own parts, and join what they know.
#ifndef vtkWaterGround_h
#define vtkWaterGround_h

#include "vtkDataSet.h"   // for members
#include "vtkMatrix4x4.h" // for members
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "water_ground.h"
#include "water_types.h"

#include <vector>

class vtkProp;
class vtkRenderer;

class vtkWaterGround
{
public:
  // Of a scene that this process has alone.
  //
  // plane   of any scale
  // bounds  of the scene, in world
  // scene   renderers whose props are looked at, waters left out
  bool IsUnder(
    const water_plane& plane, const double bounds[6], const std::vector<vtkRenderer*>& scene);

  // Of the scene of all ranks, as last joined; false: not yet.
  bool IsUnderOfRanks(const water_plane& plane);

  // Does the last join hold for this rank's part of the scene, too?
  //
  // bounds  of the scene of all ranks
  // scene   this rank's
  // ranks   vtkWaterRanks::GetStamp: what other ranks have joined does not hold
  bool IsJoined(const water_plane& plane, const double bounds[6],
    const std::vector<vtkRenderer*>& scene, vtkMTimeType ranks) const;

  // What this rank's part adds: WATER_GROUND_NUMBERS numbers. Parameters as above.
  std::vector<double> ReadPart(const water_plane& plane, const double bounds[6],
    const std::vector<vtkRenderer*>& scene, vtkMTimeType ranks);

  // Joins what the parts of all ranks add, one after the other. Returns what this rank's part then
  // adds: WATER_GROUND_BELOW_NUMBERS numbers.
  std::vector<double> Join(
    const water_plane& plane, const double bounds[6], const std::vector<double>& parts);

  // Joins those of all ranks, which ends it.
  void JoinBelow(const std::vector<double>& parts);

  // Corners of the parts of the scene that are not known to be dry, four of x, y, z each, as last
  // asked; empty: all of it is wet.
  const std::vector<double>& GetWet() const { return this->Wet; }

  // Is the bed of a tank or a pool under the water? As last asked.
  bool GetIsFlat() const { return this->IsFlat; }

private:
  enum Knowledge
  {
    UNKNOWN, // or what was read of it was ended by an exception
    OF_ONE,
    OF_PART, // of ranks, while they join it
    OF_RANKS
  };

  void Forget();
  void Read(
    const water_plane& plane, const double bounds[6], const std::vector<vtkRenderer*>& scene);
  bool Judge(const water_plane& plane);
  void Add(vtkProp* prop);
  void FindWet();
  bool AddData(vtkDataSet* data, vtkMatrix4x4* matrix); // returns whether it may be a bed
  void SeeFaces(vtkDataSet* data, vtkMatrix4x4* matrix);
  void SeePoints(vtkDataSet* data, vtkMatrix4x4* matrix);

  std::vector<double> Key; // what the ground is of
  Knowledge State = UNKNOWN;
  vtkMTimeType Ranks = 0; // that join it
  bool IsNew = false;     // not judged yet
  water_ground Ground = water_ground();
  water_footprint Footprint = water_footprint(); // of the thing that is looked at
  water_relief Relief = water_relief();          // of the same; of ranks: of all surfaces
  // Of ranks: the surfaces of this rank, until they are joined.
  struct Surface
  {
    vtkSmartPointer<vtkDataSet> Data;
    vtkSmartPointer<vtkMatrix4x4> Matrix;
  };
  std::vector<Surface> Surfaces;
  double Level = 0.0; // height of the water along the normal
  std::vector<double> Wet;
  bool IsFlat = false;
};

#endif
