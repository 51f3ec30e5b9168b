// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterVolumeCuts.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkVolume.h"
#include "vtkWaterAccess.h"
#include "vtkWaterProps.h"
#include "water_types.h"

#include <utility>

//------------------------------------------------------------------------------
vtkWaterVolumeCuts::vtkWaterVolumeCuts(const water_plan& plan, const std::vector<vtkProp*>& props)
{
  this->Plane->SetNormal(plan.clip_plane_world);
  this->Plane->Push(-plan.clip_plane_world[3]); // from the world's origin
  for (vtkProp* prop : props)
  {
    vtkWaterProps::ForEachVolume(prop, [this](vtkProp* volume) { this->Add(volume); });
  }
  // once nothing can fail any more. Swapped silently: to set planes would say that the mapper has
  // changed, in every frame
  for (const Cut& cut : this->Cuts)
  {
    cut.Planes->Register(cut.Mapper); // a reference of the mapper's own: it may drop it meanwhile
    vtkWaterAccess::AbstractMapper::ClippingPlanesOf(cut.Mapper) = cut.Planes;
  }
}

//------------------------------------------------------------------------------
void vtkWaterVolumeCuts::Add(vtkProp* prop)
{
  auto* volume = vtkVolume::SafeDownCast(prop);
  auto* mapper =
    volume ? vtkFixedPointVolumeRayCastMapper::SafeDownCast(volume->GetMapper()) : nullptr;
  if (!mapper)
  {
    return;
  }
  vtkPlaneCollection* planes = vtkWaterAccess::AbstractMapper::ClippingPlanesOf(mapper);
  Cut cut{ mapper, vtkSmartPointer<vtkPlaneCollection>::New(), planes };
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    cut.Planes->AddItem(planes->GetItem(i));
  }
  cut.Planes->AddItem(this->Plane);
  this->Cuts.push_back(std::move(cut));
}

//------------------------------------------------------------------------------
vtkWaterVolumeCuts::~vtkWaterVolumeCuts()
{
  for (const Cut& cut : this->Cuts)
  {
    vtkPlaneCollection*& planes = vtkWaterAccess::AbstractMapper::ClippingPlanesOf(cut.Mapper);
    if (planes == cut.Planes)
    {
      planes = cut.Own;
      cut.Planes->UnRegister(cut.Mapper);
    }
    else if (cut.Own) // an observer has set others, which stay
    {
      cut.Own->UnRegister(cut.Mapper);
    }
  }
}
