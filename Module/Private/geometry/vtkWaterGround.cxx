// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterGround.h"

#include "vtkActor.h"
#include "vtkAssemblyPath.h"
#include "vtkCellType.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWaterProps.h"
#include "water_plane.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace
{
constexpr vtkIdType kFewCells = 20000; // their faces are looked at, and not their points alone

void ToWorld(double point[3], vtkMatrix4x4* matrix)
{
  if (matrix)
  {
    const double local[4] = { point[0], point[1], point[2], 1.0 };
    double world[4];
    matrix->MultiplyPoint(local, world);
    std::copy(world, world + 3, point);
  }
}

// Props that are a part of the scene that water covers.
void ForEachProp(const std::vector<vtkRenderer*>& scene, const std::function<void(vtkProp*)>& what)
{
  for (vtkRenderer* renderer : scene)
  {
    vtkPropCollection* props = renderer->GetViewProps();
    vtkCollectionSimpleIterator it;
    props->InitTraversal(it);
    while (vtkProp* prop = props->GetNextProp(it))
    {
      if (prop->GetVisibility() && prop->GetUseBounds() && !prop->IsA("vtkSkybox") &&
        !vtkWaterProps::HoldsWater(prop))
      {
        what(prop);
      }
    }
  }
}

// What is known of the ground holds for scenes of the same key. The water's level is not part of
// it.
std::vector<double> KeyOf(
  const water_plane& plane, const double bounds[6], const std::vector<vtkRenderer*>& scene)
{
  std::vector<double> key;
  water_plane unit;
  if (water_plane_normalise(&plane, &unit) == WATER_OK)
  {
    key.assign(unit.normal, unit.normal + 3);
    key.insert(key.end(), bounds, bounds + 6);
    ForEachProp(
      scene, [&key](vtkProp* prop) { key.push_back(static_cast<double>(prop->GetRedrawMTime())); });
  }
  return key;
}

using SeePoint = std::function<void(const double point[3])>;

// Places on the faces of a data set, so many that one lies in each cell that a face covers.
void ForEachSample(
  const water_ground& ground, vtkDataSet* data, vtkMatrix4x4* matrix, const SeePoint& see)
{
  vtkNew<vtkGenericCell> cell;
  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> corners; // of triangles: a polygon's own parameters reach beyond it
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    data->GetCell(i, cell);
    corners->Reset();
    if (cell->GetCellDimension() == 2)
    {
      cell->Triangulate(0, ids, corners);
    }
    for (vtkIdType first = 0; first + 2 < corners->GetNumberOfPoints(); first += 3)
    {
      double corner[3][3];
      for (int k = 0; k < 3; ++k)
      {
        corners->GetPoint(first + k, corner[k]);
        ToWorld(corner[k], matrix);
      }
      const int across = water_ground_across(&ground, corner);
      for (int j = 0; j < across * across; ++j)
      {
        const double u = (j % across + 0.5) / across;
        const double v = (j / across + 0.5) / across;
        double point[3];
        for (int k = 0; k < 3 && u + v <= 1.0; ++k)
        {
          point[k] =
            corner[0][k] + u * (corner[1][k] - corner[0][k]) + v * (corner[2][k] - corner[0][k]);
        }
        if (u + v <= 1.0)
        {
          see(point);
        }
      }
    }
  }
}

// The points of a data set and, of few cells, places on its faces: a beach may be one
// quadrilateral.
void ForEachPoint(
  const water_ground& ground, vtkDataSet* data, vtkMatrix4x4* matrix, const SeePoint& see)
{
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double point[3];
    data->GetPoint(i, point);
    ToWorld(point, matrix);
    see(point);
  }
  if (data->GetNumberOfCells() <= kFewCells)
  {
    ForEachSample(ground, data, matrix, see);
  }
}
}

//------------------------------------------------------------------------------
void vtkWaterGround::Read(
  const water_plane& plane, const double bounds[6], const std::vector<vtkRenderer*>& scene)
{
  if (water_ground_begin(&plane, bounds, &this->Ground) == WATER_OK)
  {
    ForEachProp(scene, [this](vtkProp* prop) { this->Add(prop); });
  }
}

//------------------------------------------------------------------------------
void vtkWaterGround::Forget()
{
  this->State = UNKNOWN;
  this->Surfaces.clear();
}

//------------------------------------------------------------------------------
bool vtkWaterGround::IsUnder(
  const water_plane& plane, const double bounds[6], const std::vector<vtkRenderer*>& scene)
{
  const std::vector<double> key = KeyOf(plane, bounds, scene);
  if (key != this->Key || this->State != OF_ONE)
  {
    this->Forget();
    this->Read(plane, bounds, scene);
    this->Key = key;
    this->State = OF_ONE;
    this->IsNew = true;
  }
  return this->Judge(plane);
}

//------------------------------------------------------------------------------
bool vtkWaterGround::IsUnderOfRanks(const water_plane& plane)
{
  return this->State == OF_RANKS && this->Judge(plane);
}

//------------------------------------------------------------------------------
bool vtkWaterGround::IsJoined(const water_plane& plane, const double bounds[6],
  const std::vector<vtkRenderer*>& scene, vtkMTimeType ranks) const
{
  return this->State == OF_RANKS && this->Ranks == ranks &&
    KeyOf(plane, bounds, scene) == this->Key;
}

//------------------------------------------------------------------------------
std::vector<double> vtkWaterGround::ReadPart(const water_plane& plane, const double bounds[6],
  const std::vector<vtkRenderer*>& scene, vtkMTimeType ranks)
{
  this->Forget();
  this->State = OF_PART; // until it is joined
  this->Ranks = ranks;
  water_relief_begin(&this->Relief);
  this->Read(plane, bounds, scene);
  this->Key = KeyOf(plane, bounds, scene);
  std::vector<double> numbers(WATER_GROUND_NUMBERS);
  water_ground_write(&this->Ground, &this->Relief, numbers.data());
  return numbers;
}

//------------------------------------------------------------------------------
std::vector<double> vtkWaterGround::Join(
  const water_plane& plane, const double bounds[6], const std::vector<double>& parts)
{
  water_relief_begin(&this->Relief);
  if (water_ground_begin(&plane, bounds, &this->Ground) == WATER_OK)
  {
    for (size_t i = 0; i + WATER_GROUND_NUMBERS <= parts.size(); i += WATER_GROUND_NUMBERS)
    {
      water_ground_join(parts.data() + i, &this->Ground, &this->Relief);
    }
    for (const Surface& surface : this->Surfaces)
    {
      this->SeePoints(surface.Data, surface.Matrix);
    }
  }
  this->Surfaces.clear();
  const double* below = this->Relief.below[0];
  return std::vector<double>(below, below + WATER_GROUND_BELOW_NUMBERS);
}

//------------------------------------------------------------------------------
void vtkWaterGround::JoinBelow(const std::vector<double>& parts)
{
  for (size_t i = 0; i + WATER_GROUND_BELOW_NUMBERS <= parts.size();
       i += WATER_GROUND_BELOW_NUMBERS)
  {
    water_relief_join_below(parts.data() + i, &this->Relief);
  }
  water_ground_take_relief(&this->Relief, &this->Ground);
  this->State = OF_RANKS;
  this->IsNew = true;
}

//------------------------------------------------------------------------------
bool vtkWaterGround::Judge(const water_plane& plane)
{
  water_plane unit;
  if (water_plane_normalise(&plane, &unit) != WATER_OK)
  {
    return false;
  }
  if (this->IsNew || this->Level != -unit.offset)
  {
    this->IsNew = false;
    this->Level = -unit.offset;
    this->FindWet();
    this->IsFlat = water_ground_is_flat(&this->Ground, this->Level);
  }
  return water_ground_is_under(&this->Ground, this->Level);
}

//------------------------------------------------------------------------------
void vtkWaterGround::FindWet()
{
  this->Wet.clear();
  water_blocks blocks;
  if (!water_ground_find_blocks(&this->Ground, this->Level, &blocks))
  {
    return; // one rectangle is drawn in less time
  }
  for (int y = 0; y < WATER_GROUND_CELLS; ++y)
  {
    for (int x = 0; x < WATER_GROUND_CELLS; ++x)
    {
      double parts[96];
      int count = 0;
      if (water_blocks_begins(&blocks, x, y))
      {
        count = water_ground_block(&this->Ground, this->Level, &blocks, x, y, parts);
      }
      else if (blocks.cell[y][x] == WATER_CELL_PART)
      {
        count = water_ground_wet(&this->Ground, this->Level, x, y, parts);
      }
      this->Wet.insert(this->Wet.end(), parts, parts + 12 * count);
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterGround::Add(vtkProp* prop)
{
  const double* bounds = vtkWaterProps::GetBounds(prop);
  if (!bounds || !vtkMath::AreBoundsInitialized(bounds))
  {
    return;
  }
  int dataCount = 0;
  int bedCount = 0; // of those that may be a bed
  const auto look = [&](vtkDataSet* data, vtkMatrix4x4* matrix) {
    ++dataCount;
    bedCount += this->AddData(data, matrix) ? 1 : 0;
  };
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkAssemblyNode* node = path->GetLastNode();
    auto* actor = vtkActor::SafeDownCast(node->GetViewProp());
    vtkMapper* mapper = actor && actor->GetVisibility() ? actor->GetMapper() : nullptr;
    if (!mapper || mapper->GetNumberOfInputPorts() == 0 ||
      mapper->GetNumberOfInputConnections(0) == 0)
    {
      continue;
    }
    vtkDataObject* data = mapper->GetInputDataObject(0, 0);
    if (auto* blocks = vtkCompositeDataSet::SafeDownCast(data))
    {
      const auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
      for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
      {
        look(vtkDataSet::SafeDownCast(it->GetCurrentDataObject()), node->GetMatrix());
      }
    }
    else
    {
      look(vtkDataSet::SafeDownCast(data), node->GetMatrix());
    }
  }
  if (dataCount == 0 || bedCount > 0)
  {
    water_ground_add_bounds(bounds, &this->Ground);
  }
}

//------------------------------------------------------------------------------
bool vtkWaterGround::AddData(vtkDataSet* data, vtkMatrix4x4* matrix)
{
  water_footprint_begin(&this->Footprint);
  const vtkIdType count = data ? data->GetNumberOfPoints() : 0;
  if (count > 0)
  {
    ForEachPoint(this->Ground, data, matrix, [this](const double point[3]) {
      water_ground_see_point(&this->Ground, point, &this->Footprint);
    });
  }
  const bool isSurface =
    water_footprint_shape_of(&this->Footprint) == WATER_FOOTPRINT_SURFACE && count > 0;
  const bool isPart = this->State == OF_PART;
  if (isSurface && isPart)
  {
    vtkNew<vtkMatrix4x4> copy;
    if (matrix)
    {
      copy->DeepCopy(matrix);
    }
    this->Surfaces.push_back({ data, copy });
    this->SeeFaces(data, matrix);
  }
  else if (isSurface)
  {
    water_relief_begin(&this->Relief);
    this->SeeFaces(data, matrix);
    this->SeePoints(data, matrix);
  }
  const bool hasRelief = isSurface && !isPart; // else it is known once it is joined
  return water_ground_add_thing(
    &this->Footprint, hasRelief ? &this->Relief : nullptr, &this->Ground);
}

//------------------------------------------------------------------------------
void vtkWaterGround::SeeFaces(vtkDataSet* data, vtkMatrix4x4* matrix)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    const int type = data->GetCellType(i);
    if (type != VTK_TRIANGLE && type != VTK_QUAD && type != VTK_PIXEL)
    {
      continue; // what has other faces is known by its points
    }
    data->GetCellPoints(i, ids);
    double corners[4][3];
    for (int k = 0; k < ids->GetNumberOfIds() && k < 4; ++k)
    {
      const int at = type == VTK_PIXEL && k > 1 ? 5 - k : k; // around the cell
      data->GetPoint(ids->GetId(k), corners[at]);
      ToWorld(corners[at], matrix);
    }
    for (int first = 1; first + 1 < ids->GetNumberOfIds(); ++first) // a fan, as it is drawn
    {
      double face[3][3];
      std::copy_n(corners[0], 3, face[0]);
      std::copy_n(corners[first], 3, face[1]);
      std::copy_n(corners[first + 1], 3, face[2]);
      water_ground_see_face(&this->Ground, face, &this->Relief);
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterGround::SeePoints(vtkDataSet* data, vtkMatrix4x4* matrix)
{
  const auto see = [this](const double point[3]) {
    water_ground_see_relief(&this->Ground, point, &this->Relief);
  };
  ForEachPoint(this->Ground, data, matrix, see);
}
