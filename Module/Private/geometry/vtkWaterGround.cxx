// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterGround.h"

#include "vtkActor.h"
#include "vtkAssemblyPath.h"
#include "vtkBoundingBox.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWaterProps.h"
#include "water_plane.h"

#include <algorithm>
#include <functional>

namespace
{
constexpr vtkIdType kMostPoints = 100000; // of a mesh; more are gone through in steps

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
bool vtkWaterGround::IsUnder(const water_plane& plane, const double origin[3],
  const double bounds[6], const std::vector<vtkRenderer*>& scene)
{
  water_plane unit;
  if (water_plane_normalise(&plane, &unit) != WATER_OK)
  {
    return false;
  }
  std::vector<double> key(origin, origin + 3);
  key.insert(key.end(), unit.normal, unit.normal + 3);
  key.insert(key.end(), bounds, bounds + 6);
  ForEachProp(
    scene, [&key](vtkProp* prop) { key.push_back(static_cast<double>(prop->GetRedrawMTime())); });
  if (key == this->Key)
  {
    return this->IsKnownUnder;
  }
  this->Key = std::move(key);
  Axes axes;
  std::copy_n(origin, 3, axes.Origin);
  std::copy_n(unit.normal, 3, axes.Up);
  water_plane_axes(unit.normal, axes.X, axes.Y);
  double rectangle[4];
  this->IsKnownUnder = false;
  if (water_sheet_bounds(origin, axes.X, axes.Y, bounds, rectangle) == WATER_OK)
  {
    water_ground_begin(rectangle, &this->Ground);
    ForEachProp(scene, [this, &axes](vtkProp* prop) { this->Add(prop, axes); });
    this->IsKnownUnder = water_ground_is_under(&this->Ground);
  }
  return this->IsKnownUnder;
}

//------------------------------------------------------------------------------
void vtkWaterGround::Add(vtkProp* prop, const Axes& axes)
{
  const double* bounds = vtkWaterProps::GetBounds(prop);
  if (!bounds || !vtkMath::AreBoundsInitialized(bounds))
  {
    return;
  }
  double own[6]; // along the plane's axes
  if (water_sheet_bounds(axes.Origin, axes.X, axes.Y, bounds, own) != WATER_OK)
  {
    return;
  }
  const vtkBoundingBox box(bounds);
  for (int i = 0; i < 8; ++i)
  {
    double corner[3];
    box.GetCorner(i, corner);
    vtkMath::Subtract(corner, axes.Origin, corner);
    const double height = vtkMath::Dot(corner, axes.Up);
    own[4] = i == 0 ? height : std::min(own[4], height);
    own[5] = i == 0 ? height : std::max(own[5], height);
  }
  water_ground_add_bounds(own, &this->Ground);
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
        this->AddPoints(
          vtkDataSet::SafeDownCast(it->GetCurrentDataObject()), node->GetMatrix(), axes);
      }
    }
    else
    {
      this->AddPoints(vtkDataSet::SafeDownCast(data), node->GetMatrix(), axes);
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterGround::AddPoints(vtkDataSet* data, vtkMatrix4x4* matrix, const Axes& axes)
{
  const vtkIdType count = data ? data->GetNumberOfPoints() : 0;
  const vtkIdType step = std::max<vtkIdType>(1, count / kMostPoints);
  for (vtkIdType i = 0; i < count; i += step)
  {
    double point[4];
    data->GetPoint(i, point);
    point[3] = 1.0;
    if (matrix)
    {
      matrix->MultiplyPoint(point, point);
    }
    vtkMath::Subtract(point, axes.Origin, point);
    water_ground_add_point(vtkMath::Dot(point, axes.X), vtkMath::Dot(point, axes.Y),
      vtkMath::Dot(point, axes.Up), &this->Ground);
  }
}
