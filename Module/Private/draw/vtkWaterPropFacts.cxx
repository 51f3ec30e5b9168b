// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterPropFacts.h"

#include "vtkCommand.h"
#include "vtkWaterAccess.h"

#include <utility>

//------------------------------------------------------------------------------
vtkWaterScopedFacts::vtkWaterScopedFacts(vtkProp* prop, const vtkWaterPropFacts& facts)
{
  vtkMapper* mapper = facts.IsUpToDate ? static_cast<vtkActor*>(prop)->GetMapper() : nullptr;
  // who observes a draw may change the data then
  if (mapper && !mapper->HasObserver(vtkCommand::StartEvent) &&
    !mapper->HasObserver(vtkCommand::EndEvent))
  {
    this->Mapper = mapper;
    this->WasStatic = std::exchange(vtkWaterAccess::Mapper::StaticOf(mapper), 1);
  }
  if (facts.IsOpaque)
  {
    this->Actor = static_cast<vtkActor*>(prop);
    this->WasForced = std::exchange(vtkWaterAccess::Actor::ForceOpaqueOf(this->Actor), true);
  }
}

//------------------------------------------------------------------------------
vtkWaterScopedFacts::~vtkWaterScopedFacts()
{
  // what the user has set meanwhile stays
  if (this->Mapper && vtkWaterAccess::Mapper::StaticOf(this->Mapper))
  {
    vtkWaterAccess::Mapper::StaticOf(this->Mapper) = this->WasStatic;
  }
  if (this->Actor && vtkWaterAccess::Actor::ForceOpaqueOf(this->Actor))
  {
    vtkWaterAccess::Actor::ForceOpaqueOf(this->Actor) = this->WasForced;
  }
}
