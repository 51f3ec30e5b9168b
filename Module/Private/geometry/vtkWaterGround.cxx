// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterGround.h"

#include "vtkActor.h"
#include "vtkAssemblyPath.h"
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
  std::vector<double> key(origin, origin + 3);
  key.insert(key.end(), plane.normal, plane.normal + 3);
  key.insert(key.end(), bounds, bounds + 6);
  ForEachProp(
    scene, [&key](vtkProp* prop) { key.push_back(static_cast<double>(prop->GetRedrawMTime())); });
  if (key == this->Key)
  {
    return this->IsKnownUnder;
  }
  this->Key = std::move(key);
  const bool isGood = water_ground_begin(&plane, origin, bounds, &this->Ground) == WATER_OK;
  if (isGood)
  {
    ForEachProp(scene, [this](vtkProp* prop) { this->Add(prop); });
  }
  this->IsKnownUnder = isGood && water_ground_is_under(&this->Ground);
  return this->IsKnownUnder;
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
    water_ground_add_point(point, &this->Ground);
  }
}
