// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterReflectionRanks.cxx: the part of vtkWaterReflection that agrees with the other ranks of a
// sort-last renderer. Each of them comes here as often, with the same decisions so far: how often
// it sends does not depend on what it sees. See Documentation/decisions/023-ranks.md.
#include "vtkOpenGLRenderer.h"
#include "vtkProp.h"
#include "vtkWaterReflection.h"

#include <algorithm>

namespace
{
// All that must be the same on all ranks, lest they draw different waters or part company.
double DigestOf(const std::vector<vtkWaterSnapshotPointer>& waters, const water_scene& scene)
{
  uint64_t digest = WATER_RANKS_DIGEST_BEGIN;
  for (const vtkWaterSnapshotPointer& water : waters)
  {
    const vtkWaterLook& look = water->Look;
    digest = water_ranks_digest(digest, water->Plane.normal, 3);
    digest = water_ranks_digest(digest, water->Origin, 3);
    digest = water_ranks_digest(digest, look.DeepColor, 3);
    digest = water_ranks_digest(digest, look.Extinction, 3);
    const double numbers[] = { water->Plane.offset, water->Time,
      static_cast<double>(water->Features), static_cast<double>(water->Waves.size()),
      look.Optics.index_of_refraction, look.Optics.reflectance,
      look.Optics.constant_reflectance ? 1.0 : 0.0, look.Opacity, look.WaveHeightMax, look.SlopeRMS,
      look.Caustics, look.FoamDepth, look.FoamJacobian, static_cast<double>(look.Lookup),
      static_cast<double>(look.RayTraceSteps), static_cast<double>(look.RayTraceRays),
      static_cast<double>(look.Output) };
    digest = water_ranks_digest(digest, numbers, sizeof numbers / sizeof numbers[0]);
  }
  digest = water_ranks_digest_settings(digest, &scene.settings);
  return water_ranks_digest_number(digest);
}
}

//------------------------------------------------------------------------------
bool vtkWaterReflection::JoinScene(Attempt& attempt)
{
  water_scene& scene = this->Gathered.Scene;
  water_rank_view mine = water_rank_view();
  mine.sheet_count = static_cast<double>(attempt.Waters.size());
  mine.digest = DigestOf(attempt.Waters, scene);
  mine.prop_count = static_cast<double>(scene.prop_count);
  mine.max_texture_px = scene.max_texture_px;
  mine.is_software = scene.is_software ? 1.0 : 0.0;
  mine.measured_ms = attempt.MeasuredMs;
  std::copy_n(scene.surface_bounds, 6, mine.surface_bounds);
  water_ranks_view joined = water_ranks_view();
  if (!this->Ranks.JoinViews(mine, scene, this->RankProps, joined, attempt.Error))
  {
    return false;
  }
  attempt.FirstProp = joined.first_prop;
  attempt.MeasuredMs = joined.measured_ms;
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterReflection::RenderNothing(
  const Frame& frame, const std::vector<vtkWaterSource*>& waters, const vtkWaterError& error)
{
  std::vector<const vtkProp*> declined;
  for (vtkWaterSource* water : waters)
  {
    declined.push_back(water->GetProp());
  }
  this->OwnEye = vtkWaterGather::ReadCamera(frame.Renderer);
  this->SetPlanned(frame, declined); // or a draw would ask for the view again, on this rank alone
  this->Decline(WATER_NO_REFLECT_FAILED);
  for (vtkWaterSource* water : waters)
  {
    water->Report(frame.Renderer, error);
  }
}

//------------------------------------------------------------------------------
bool vtkWaterReflection::IsUnchangedOnAll(const Attempt& attempt, bool isUnchanged)
{
  // by what this rank would do: a view that it has lost is not there to be used again
  water_plan plan = this->Plan;
  std::vector<water_cull_reason> reasons = this->Reasons;
  water_plan_revise(
    &this->Gathered.Scene, &attempt.Drawn->DrawnPlan, isUnchanged, nullptr, &plan, reasons.data());
  std::vector<int> claims = { plan.decision == WATER_REUSE ? 1 : 0 };
  this->Ranks.HoldOnAll(claims);
  return claims[0] != 0;
}

//------------------------------------------------------------------------------
bool vtkWaterReflection::JoinDrawn(const Frame& frame, Attempt& attempt, bool wantsAgain)
{
  const bool isLost = attempt.Drawn.get() != this->GetPlannedView(); // in the middle of its draw
  std::vector<int> claims = { attempt.Failure ? 0 : 1, isLost || attempt.IsAborted ? 0 : 1,
    wantsAgain ? 0 : 1 };
  this->Ranks.HoldOnAll(claims);
  if (!claims[2])
  {
    return true; // what one rank's driver refused is left out of a second view, of all ranks
  }
  attempt.IsAborted = !claims[1];
  if (!claims[0] && !attempt.Failure)
  {
    attempt.Failure = "another rank could not draw its part of the reflection";
  }
  if (claims[0] && claims[1])
  {
    const int* rect = this->Plan.texture_rect_px;
    static_cast<vtkOpenGLRenderer*>(frame.Renderer)->GetRenderWindow()->MakeCurrent();
    attempt.Failure = attempt.Drawn->Mirrored.Join(this->Ranks, this->Plan);
    this->Report.JoinedPixels = static_cast<vtkIdType>(rect[2]) * rect[3];
  }
  return false;
}
