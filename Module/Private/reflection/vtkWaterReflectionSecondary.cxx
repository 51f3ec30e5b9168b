// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterReflectionSecondary.cxx: the part of vtkWaterReflection that lets the other waters in its
// mirrored view reflect the scene: which of them do, their secondary views, and what they look up.
// See Documentation/decisions/011-water-in-water.md.
#include "vtkActor.h"
#include "vtkRenderer.h"
#include "vtkSetGet.h"
#include "vtkWaterPropRecords.h"
#include "vtkWaterReflection.h"
#include "water_plane.h"

#include <algorithm>
#include <cmath>

namespace
{
// After so many mirrored views in which nothing looks it up, a secondary view is given up.
constexpr int kMostIdle = 8;

// May two waters look up the same secondary view?
bool CanShare(const vtkWaterSnapshot& water, const vtkWaterSnapshot& other)
{
  return water_plane_is_identical(&water.Plane, &other.Plane) &&
    std::equal(water.Origin, water.Origin + 3, other.Origin) && water.IsRough() == other.IsRough();
}

// Does it reflect a scene, wherever it is seen?
bool ReflectsScene(vtkWaterSource& water, const vtkWaterSnapshot& snapshot)
{
  const water_look& look = snapshot.Look.Optics;
  return !water.HasSheetError() && !snapshot.Look.Has.has_environment &&
    !(look.constant_reflectance && look.reflectance == 0.0);
}
}

//------------------------------------------------------------------------------
bool vtkWaterReflection::MayHaveSecondary(const Frame& frame) const
{
  return this->Settings.secondary_reflections && !frame.Primary && !this->Ranks.AreSeveral();
}

//------------------------------------------------------------------------------
std::vector<std::vector<vtkWaterSource*>> vtkWaterReflection::FindSecondary(
  const Frame& frame) const
{
  const bool mayShare = (this->Settings.skips & WATER_MAY_SKIP_SHARED) != 0;
  std::vector<std::vector<vtkWaterSource*>> groups;
  for (size_t i = 0; i < this->Reasons.size(); ++i)
  {
    vtkWaterSource* water = this->Reasons[i] == WATER_CULL_NONE && !frame.Records->IsPlain(i)
      ? vtkWaterSource::Of(this->Gathered.DrawnProps[i])
      : nullptr;
    if (!water || !ReflectsScene(*water, *water->Take(frame.Renderer)))
    {
      continue;
    }
    const auto found =
      std::find_if(groups.begin(), groups.end(), [&](const std::vector<vtkWaterSource*>& group) {
        return mayShare &&
          CanShare(*group.front()->Take(frame.Renderer), *water->Take(frame.Renderer));
      });
    if (found != groups.end())
    {
      found->push_back(water);
    }
    else
    {
      groups.push_back({ water });
    }
  }
  return groups;
}

//------------------------------------------------------------------------------
vtkWaterReflection::SecondaryView& vtkWaterReflection::EnsureSecondary(
  const std::vector<vtkWaterSource*>& waters)
{
  const vtkProp* first = waters.front()->GetProp();
  auto found = std::find_if(this->Secondary.begin(), this->Secondary.end(),
    [first](const SecondaryView& view) { return view.Waters.front() == first; });
  if (found == this->Secondary.end())
  {
    found = this->Secondary.insert(found, SecondaryView());
    found->Reflection = std::make_shared<vtkWaterReflection>();
  }
  found->Waters.clear();
  for (vtkWaterSource* water : waters)
  {
    found->Waters.push_back(water->GetProp());
  }
  found->IdleCount = 0;
  return *found;
}

//------------------------------------------------------------------------------
void vtkWaterReflection::DropSecondary(vtkRenderer* renderer)
{
  for (auto it = this->Secondary.begin(); it != this->Secondary.end();)
  {
    if (it->IdleCount <= kMostIdle)
    {
      ++it;
      continue;
    }
    it->Reflection->ReleaseGraphicsResources(renderer->GetRenderWindow());
    it = this->Secondary.erase(it);
  }
}

//------------------------------------------------------------------------------
void vtkWaterReflection::RenderSecondary(const Frame& frame, Attempt& attempt)
{
  const bool isAsked = this->Settings.secondary_reflections && !frame.Primary;
  if (isAsked && this->Ranks.AreSeveral() && !this->IsSecondarySaid)
  {
    vtkWarningWithObjectMacro(attempt.Waters.front()->Actor,
      "SecondaryReflections is on, but the reflection pass has a controller of several ranks: "
      "other "
      "waters in its reflection reflect the sky alone.");
  }
  this->IsSecondarySaid = isAsked && this->Ranks.AreSeveral();
  for (SecondaryView& secondary : this->Secondary)
  {
    ++secondary.IdleCount;
  }
  if (!this->MayHaveSecondary(frame))
  {
    this->DropSecondary(frame.Renderer);
    return;
  }
  const std::vector<std::vector<vtkWaterSource*>> groups = this->FindSecondary(frame);
  for (size_t i = 0; !groups.empty() && i < this->Gathered.DrawnProps.size(); ++i)
  {
    attempt.Held.emplace_back(this->Gathered.DrawnProps[i]); // the user's observers may drop them
  }
  Frame secondary = frame;
  secondary.Primary = &this->Plan;
  secondary.AreHidden = nullptr;
  secondary.Hints.HasSceneDepth = false;
  for (const std::vector<vtkWaterSource*>& waters : groups)
  {
    const std::shared_ptr<vtkWaterReflection> view = this->EnsureSecondary(waters).Reflection;
    const bool isTimed = this->GetGpuQueries(frame.Renderer)->GetIsOn();
    view->Settings = this->Settings;
    view->Settings.texture_scale = 1.0; // of the mirrored view's size, which has its own
    view->Settings.quality = WATER_QUALITY_FIXED;
    view->Settings.IsInstrumented = isTimed;
    view->Background = this->Background;
    vtkWaterError error;
    view->RenderView(secondary, waters, error);
    this->Report.SecondaryRenderCount += view->Report.Decision == WATER_REFLECT ? 1 : 0;
    if (attempt.SecondaryError.Text.empty())
    {
      attempt.SecondaryError = error;
    }
  }
  this->DropSecondary(frame.Renderer);
}

//------------------------------------------------------------------------------
bool vtkWaterReflection::HasPropsOf(const vtkWaterPropRecords& records) const
{
  const std::vector<vtkProp*>& props = this->Gathered.DrawnProps;
  bool areSame = records.GetCount() == props.size();
  for (size_t i = 0; areSame && i < props.size(); ++i)
  {
    areSame = records.GetDrawn(i) == props[i];
  }
  return areSame;
}

//------------------------------------------------------------------------------
void vtkWaterReflection::SignSecondary(const Frame& frame, Attempt& attempt) const
{
  vtkWaterSignature& signature = attempt.Signature;
  for (size_t i = 0; frame.Primary && i < attempt.Waters.size(); ++i)
  {
    // what decides how it is looked up: the mirrored view that shows it is drawn again with it
    const vtkWaterLook& look = attempt.Waters[i]->Look;
    signature.Add(static_cast<vtkMTimeType>(look.RayTraceSteps));
    signature.Add(static_cast<vtkMTimeType>(look.RayTraceProbes));
    signature.Add(static_cast<vtkMTimeType>(look.RayTraceRays));
    signature.AddNumber(look.RayTraceFootprint);
  }
  for (const SecondaryView& secondary : this->Secondary)
  {
    if (secondary.IdleCount > 0)
    {
      continue;
    }
    vtkWaterReflection& reflection = *secondary.Reflection;
    View* view = reflection.GetPlannedView();
    const bool isLookedUp = view && water_plan_has_reflection(&reflection.Plan);
    signature.Add(isLookedUp ? view->DrawnTime.GetMTime() : 0);
    signature.Add(static_cast<vtkMTimeType>(this->Quality.ray_steps));
    signature.Add(static_cast<vtkMTimeType>(this->Quality.ray_probes));
  }
}

//------------------------------------------------------------------------------
bool vtkWaterReflection::Find(const vtkProp* water, vtkWaterSurfaceShader::Inputs& inputs)
{
  for (const SecondaryView& secondary : this->Secondary)
  {
    const auto& waters = secondary.Waters;
    if (secondary.IdleCount > 0 || std::find(waters.begin(), waters.end(), water) == waters.end())
    {
      continue;
    }
    vtkWaterReflection& reflection = *secondary.Reflection;
    View* view = reflection.GetPlannedView(); // none: it was released in the middle of the draw
    if (!view || !reflection.HasView || !water_plan_has_reflection(&reflection.Plan))
    {
      return false;
    }
    inputs.Plan = &reflection.Plan;
    reflection.FillInputs(*view, true, inputs);
    inputs.MostSteps = this->Quality.ray_steps;
    inputs.MostProbes = this->Quality.ray_probes;
    return inputs.Reflection != nullptr;
  }
  return false;
}

//------------------------------------------------------------------------------
double vtkWaterReflection::MeasureSecondary()
{
  View* view = this->Report.Decision == WATER_REFLECT ? this->GetPlannedView() : nullptr;
  const double time =
    view ? view->Mirrored.GetGpuQueries().GetTime(vtkWaterGpuQueries::REFLECTION) : 0.0;
  return std::isfinite(time) ? time : 0.0;
}

//------------------------------------------------------------------------------
double vtkWaterReflection::AskTime()
{
  double time = this->Ask(std::numeric_limits<double>::quiet_NaN(),
    [](vtkWaterGpuQueries& queries) { return queries.GetTime(vtkWaterGpuQueries::REFLECTION); });
  for (const SecondaryView& secondary : this->Secondary)
  {
    const double its = secondary.IdleCount == 0 ? secondary.Reflection->AskTime() : 0.0;
    time += std::isfinite(its) ? its : 0.0;
  }
  return time;
}
