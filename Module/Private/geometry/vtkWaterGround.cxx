// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterGround.h"

#include "vtkActor.h"
#include "vtkAssemblyPath.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWaterProps.h"
#include "water_plane.h"

#include <algorithm>
#include <functional>

namespace
{
constexpr vtkIdType kFewCells = 20000; // their faces are looked at, and not their points alone

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
}

//------------------------------------------------------------------------------
bool vtkWaterGround::IsUnder(
  const water_plane& plane, const double bounds[6], const std::vector<vtkRenderer*>& scene)
{
  water_plane unit;
  if (water_plane_normalise(&plane, &unit) != WATER_OK)
  {
    return false;
  }
  // not the level: what is known of the ground holds for all
  std::vector<double> key(unit.normal, unit.normal + 3);
  key.insert(key.end(), bounds, bounds + 6);
  ForEachProp(
    scene, [&key](vtkProp* prop) { key.push_back(static_cast<double>(prop->GetRedrawMTime())); });
  const bool isNew = key != this->Key;
  if (isNew)
  {
    this->Key = std::move(key);
    if (water_ground_begin(&plane, bounds, &this->Ground) == WATER_OK)
    {
      ForEachProp(scene, [this](vtkProp* prop) { this->Add(prop); });
    }
  }
  if (isNew || this->Level != -unit.offset)
  {
    this->Level = -unit.offset;
    this->FindWet();
  }
  return water_ground_is_under(&this->Ground, this->Level);
}

//------------------------------------------------------------------------------
void vtkWaterGround::FindWet()
{
  this->Wet.clear();
  bool isDry = false; // a cell of it
  for (int y = 0; y < WATER_GROUND_CELLS; ++y)
  {
    for (int x = 0; x < WATER_GROUND_CELLS; ++x)
    {
      double parts[24];
      const int count = water_ground_wet(&this->Ground, this->Level, x, y, parts);
      this->Wet.insert(this->Wet.end(), parts, parts + 12 * count);
      isDry = isDry || count == 0;
    }
  }
  if (!isDry)
  {
    this->Wet.clear(); // one rectangle is drawn in less time
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
  water_ground_add_bounds(bounds, &this->Ground);
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
        this->AddPoints(vtkDataSet::SafeDownCast(it->GetCurrentDataObject()), node->GetMatrix());
      }
    }
    else
    {
      this->AddPoints(vtkDataSet::SafeDownCast(data), node->GetMatrix());
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterGround::AddPoints(vtkDataSet* data, vtkMatrix4x4* matrix)
{
  const vtkIdType count = data ? data->GetNumberOfPoints() : 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    double point[4];
    data->GetPoint(i, point);
    this->AddPoint(point, matrix);
  }
  if (count > 0 && data->GetNumberOfCells() <= kFewCells)
  {
    this->AddFaces(data, matrix); // a beach may be one quadrilateral
  }
}

//------------------------------------------------------------------------------
void vtkWaterGround::AddPoint(double point[4], vtkMatrix4x4* matrix)
{
  point[3] = 1.0;
  if (matrix)
  {
    matrix->MultiplyPoint(point, point);
  }
  water_ground_add_point(point, &this->Ground);
}

//------------------------------------------------------------------------------
void vtkWaterGround::AddFaces(vtkDataSet* data, vtkMatrix4x4* matrix)
{
  vtkNew<vtkGenericCell> cell;
  const int across = water_ground_across(static_cast<double>(data->GetNumberOfCells()));
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    data->GetCell(i, cell);
    const vtkIdType corners = cell->GetCellDimension() == 2 ? cell->GetNumberOfPoints() : 0;
    std::vector<double> weights(static_cast<size_t>(std::max<vtkIdType>(corners, 1)));
    for (int j = 0; j < across * across && corners >= 3; ++j)
    {
      double place[3] = { (j % across + 0.5) / across, (j / across + 0.5) / across, 0.0 };
      int part = 0;
      double point[4];
      if (corners == 3 && place[0] + place[1] > 1.0)
      {
        continue; // out of the triangle
      }
      cell->EvaluateLocation(part, place, point, weights.data());
      this->AddPoint(point, matrix);
    }
  }
}
