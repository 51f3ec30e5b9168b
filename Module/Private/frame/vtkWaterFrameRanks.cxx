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
#include "water_ground.h"
#include "water_ranks.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <iterator>
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

namespace
{
vtkWaterError ErrorOf(const std::exception& thrown)
{
  vtkWaterError error;
  error.Kind = std::string("reading the scene was ended by an exception (") + thrown.what() + ")";
  error.Text = error.Kind + ". The water shows its plain colour.";
  return error;
}

// A scene that cannot be asked is read again, which says why to all ranks.
bool IsGroundJoined(vtkWaterSource& water)
{
  try
  {
    return water.IsGroundJoined();
  }
  catch (const std::exception&)
  {
    return false;
  }
}

// Which waters choose their extent, as a number that ranks compare.
double DigestOfAutomatic(const std::vector<vtkWaterSource*>& waters)
{
  std::vector<double> numbers;
  for (vtkWaterSource* water : waters)
  {
    numbers.push_back(water->HasAutomaticExtent() ? 1.0 : 0.0);
  }
  return water_ranks_digest_number(
    water_ranks_digest(WATER_RANKS_DIGEST_BEGIN, numbers.data(), numbers.size()));
}
}

//------------------------------------------------------------------------------
bool vtkWaterFrame::JoinGrounds(const std::vector<vtkWaterSource*>& waters, vtkWaterError& error)
{
  std::vector<vtkWaterSource*> choosing;
  std::copy_if(waters.begin(), waters.end(), std::back_inserter(choosing),
    [](vtkWaterSource* water) { return water->HasAutomaticExtent(); });
  if (choosing.empty())
  {
    return true;
  }
  std::vector<int> areJoined;
  for (vtkWaterSource* water : choosing)
  {
    areJoined.push_back(IsGroundJoined(*water) ? 1 : 0);
  }
  this->RanksAsked.HoldOnAll(areJoined);
  for (size_t i = 0; i < choosing.size(); ++i)
  {
    if (areJoined[i])
    {
      continue;
    }
    // a rank that cannot read its part says so: the others wait for it
    std::vector<double> all;
    vtkWaterSource& water = *choosing[i];
    const auto join = [&](size_t count, const std::function<std::vector<double>()>& read) {
      std::vector<double> part(count);
      vtkWaterError own;
      try
      {
        part = read();
      }
      catch (const std::exception& thrown)
      {
        own = ErrorOf(thrown);
      }
      const bool isJoined = this->RanksAsked.JoinGrounds(part, !own.Text.empty(), all, error);
      error = isJoined || own.Text.empty() ? error : own;
      return isJoined;
    };
    if (!join(WATER_GROUND_NUMBERS, [&]() { return water.ReadGroundPart(); }) ||
      !join(WATER_GROUND_BELOW_NUMBERS, [&]() { return water.JoinGround(all); }))
    {
      return false;
    }
    water.JoinGroundBelow(all);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterFrame::Ask(vtkWaterError& error)
{
  const std::vector<vtkWaterSource*> waters = this->FindWatersOfRanks();
  water_rank_frame mine = water_rank_frame();
  mine.water_count = static_cast<double>(waters.size());
  mine.is_gone = this->Asking.expired() ? 1.0 : 0.0;
  mine.automatic = DigestOfAutomatic(waters);
  vtkWaterError own;
  try
  {
    vtkWaterSheet::FindSceneBounds({ this->Renderer }, mine.scene_bounds);
  }
  catch (const std::exception& thrown) // the others wait for this rank
  {
    mine.has_error = 1.0;
    own = ErrorOf(thrown);
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
  return isAgreed && this->JoinGrounds(waters, error);
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
