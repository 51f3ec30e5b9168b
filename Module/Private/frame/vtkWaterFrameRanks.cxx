// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFrameRanks.cxx: the part of vtkWaterFrame that asks the other ranks of a sort-last
// renderer, once a frame, whether they show the same waters. See
// Documentation/decisions/023-ranks.md.
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPropCollection.h"
#include "vtkSetGet.h"
#include "vtkWaterFrame.h"
#include "vtkWaterReflection.h"
#include "vtkWaterShaderHook.h"
#include "vtkWaterSheet.h"
#include "vtkWaterSource.h"

#include <algorithm>
#include <exception>
#include <string>

//------------------------------------------------------------------------------
std::vector<vtkWaterSource*> vtkWaterFrame::FindWatersOfRanks() const
{
  std::vector<vtkWaterSource*> waters;
  vtkPropCollection* props = this->Renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    vtkWaterSource* water = prop->GetVisibility() ? vtkWaterSource::Of(prop) : nullptr;
    if (water)
    {
      vtkWaterReflection* composed = water->GetComposedReflection();
      if ((composed ? *composed : water->GetOwnReflection()).Ranks.AreSeveral())
      {
        waters.push_back(water);
      }
    }
  }
  return waters;
}

//------------------------------------------------------------------------------
bool vtkWaterFrame::Ask(vtkWaterError& error)
{
  const std::vector<vtkWaterSource*> waters = this->FindWatersOfRanks();
  water_rank_frame mine = water_rank_frame();
  mine.water_count = static_cast<double>(waters.size());
  mine.is_gone = this->Asking.expired() ? 1.0 : 0.0;
  vtkWaterError own;
  try
  {
    vtkWaterSheet::FindSceneBounds({ this->Renderer }, mine.scene_bounds);
  }
  catch (const std::exception& thrown) // the others wait for this rank
  {
    mine.has_error = 1.0;
    own.Kind = std::string("reading the scene was ended by an exception (") + thrown.what() + ")";
    own.Text = own.Kind + ". The water shows its plain colour.";
  }
  double bounds[6];
  bool areGone = false;
  const bool isAgreed = this->RanksAsked.JoinFrames(mine, bounds, &areGone, error);
  error = own.Text.empty() ? error : own;
  if (areGone)
  {
    this->RanksAsked.SetController(nullptr);
  }
  for (vtkWaterSource* water : waters)
  {
    water->SetSceneBounds(bounds);
  }
  return isAgreed;
}

//------------------------------------------------------------------------------
bool vtkWaterFrame::IsLeftOut(vtkWaterSource& water)
{
  vtkWaterReflection* composed = water.GetComposedReflection();
  return water.HasSheetError() &&
    !(composed ? *composed : water.GetOwnReflection()).Ranks.AreSeveral();
}

//------------------------------------------------------------------------------
bool vtkWaterFrame::Agree(vtkWaterReflection& reflection)
{
  if (reflection.Ranks.IsMute())
  {
    this->RanksError = reflection.Ranks.DescribeMute();
    return false;
  }
  if (!reflection.Ranks.AreSeveral())
  {
    return true;
  }
  const vtkMTimeType number = this->GetNumber();
  if (number != 0 && this->AgreedNumber == number)
  {
    return this->AreAgreed;
  }
  this->AgreedNumber = number;
  this->RanksError = vtkWaterError();
  this->Asking = reflection.weak_from_this();
  this->RanksAsked = reflection.Ranks;
  this->AreAgreed = this->Ask(this->RanksError);
  if (!this->RanksObserver)
  {
    this->RanksObserver = vtkSmartPointer<vtkCallbackCommand>::New();
    this->RanksObserver->SetClientData(this);
    this->RanksObserver->SetCallback([](vtkObject*, unsigned long, void* frame, void*) {
      static_cast<vtkWaterFrame*>(frame)->SayNoWater();
    });
    // after what brings the ranks' cameras together, which sends by the same controller
    this->Renderer->AddObserver(vtkCommand::StartEvent, this->RanksObserver, -1.0f);
  }
  return this->AreAgreed;
}

//------------------------------------------------------------------------------
bool vtkWaterFrame::HasRanks() const
{
  // the others do not know that a water is deleted here
  const std::shared_ptr<vtkWaterReflection> reflection = this->Asking.lock();
  return (reflection ? reflection->Ranks : this->RanksAsked).AreSeveral();
}

//------------------------------------------------------------------------------
void vtkWaterFrame::SayNoWater()
{
  if (!this->HasRanks() || this->Renderer->GetSelector() || GetHook()->IsInMirroredView() ||
    !this->FindWatersOfRanks().empty())
  {
    return; // a water of the frame asks
  }
  const std::string said = this->RanksError.Kind;
  this->RanksError = vtkWaterError();
  if (!this->Ask(this->RanksError) && this->RanksError.Kind != said)
  {
    vtkErrorWithObjectMacro(this->Renderer, << this->RanksError.Text);
  }
}
