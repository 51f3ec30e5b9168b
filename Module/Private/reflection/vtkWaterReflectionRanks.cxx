// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterReflectionRanks.cxx: the part of vtkWaterReflection that agrees with the other ranks of a
// sort-last renderer. Each of them comes here as often, with the same decisions so far: how often
// it sends does not depend on what it sees. See Documentation/decisions/023-ranks.md.
#include "vtkOpenGLRenderer.h"
#include "vtkProp.h"
#include "vtkWaterReflection.h"
#include "vtkWaterShaderHook.h"

#include <algorithm>
#include <exception>

namespace
{
using Numbers = std::vector<double>;

void AddSea(const vtkWaterLook& look, Numbers& numbers)
{
  const water_sea& sea = look.Sea;
  numbers.insert(numbers.end(),
    { static_cast<double>(sea.model), static_cast<double>(sea.spreading), sea.wind_speed,
      sea.wind_dir_rad, sea.fetch, sea.depth, sea.peak_enhancement, sea.spreading_power,
      look.SeaChoppiness, look.WhitecapJacobian, look.OldFoam.life_s,
      static_cast<double>(look.Cascades.count) });
  for (size_t i = 0; i < look.Cascades.count; ++i)
  {
    const water_tile& tile = look.Cascades.tiles[i];
    numbers.insert(numbers.end(),
      { static_cast<double>(tile.size), tile.length, tile.period,
        static_cast<double>(tile.seed >> 32), static_cast<double>(tile.seed & 0xffffffffu),
        tile.k_low, tile.k_high });
  }
}

void AddNormalMaps(const vtkWaterLook& look, Numbers& numbers)
{
  numbers.push_back(static_cast<double>(look.NormalMaps.size()));
  for (const vtkWaterNormalMaps::Layer& layer : look.NormalMaps)
  {
    const water_normal_map& map = layer.Map;
    numbers.insert(numbers.end(), { map.size, map.speed, map.direction_rad, map.strength });
  }
}

void AddFeatures(const water_feature_look& has, Numbers& numbers)
{
#define WATER_ADD_FEATURE(member, what) numbers.push_back(has.member ? 1.0 : 0.0);
  WATER_FEATURE_LOOK_LIST(WATER_ADD_FEATURE)
#undef WATER_ADD_FEATURE
  numbers.push_back(static_cast<double>(has.lookup));
}

// What shaders get of a look; not what the rank's part of a mesh adds.
void AddLook(const vtkWaterLook& look, Numbers& numbers)
{
  for (const double* triple : { look.DeepColor, look.Extinction, look.Medium.absorption,
         look.Medium.scattering, look.SlopeVariance, look.MeanSlopes, look.FoamColor })
  {
    numbers.insert(numbers.end(), triple, triple + 3);
  }
  numbers.insert(numbers.end(),
    { look.MetresPerUnit, look.NaturalDepth, look.Optics.index_of_refraction,
      look.Optics.reflectance, look.Optics.constant_reflectance ? 1.0 : 0.0, look.DataOpacity,
      look.Opacity, look.HasDeepColor ? 1.0 : 0.0, look.HasOwnView ? 1.0 : 0.0, look.ShoreSoftness,
      look.HasShoreSoftness ? 1.0 : 0.0, look.DomePortRadius, look.WaveNumber, look.WaveHeightMax,
      look.WaveReach, static_cast<double>(look.WaveGridSize), look.Caustics, look.LightShafts,
      look.RollsOff ? 1.0 : 0.0, look.FoamDepth, look.FoamJacobian,
      static_cast<double>(look.Lookup), look.OffsetScale, static_cast<double>(look.RayTraceSteps),
      static_cast<double>(look.RayTraceProbes), static_cast<double>(look.RayTraceRays),
      static_cast<double>(look.RayTraceLayers), look.RayTraceFootprint,
      static_cast<double>(look.Output), look.Environment ? 1.0 : 0.0 });
  AddFeatures(look.Has, numbers);
  AddSea(look, numbers);
  AddNormalMaps(look, numbers);
}

// All that must be the same on all ranks, lest they draw different waters or part company.
double DigestOf(
  const std::vector<vtkWaterSnapshotPointer>& waters, const water_scene& scene, bool hasRegion)
{
  uint64_t digest = WATER_RANKS_DIGEST_BEGIN;
  for (const vtkWaterSnapshotPointer& water : waters)
  {
    const water_plane& plane = water->Plane;
    const double* origin = water->Origin;
    Numbers numbers = { plane.normal[0], plane.normal[1], plane.normal[2], plane.offset, origin[0],
      origin[1], origin[2], water->Time, water->FlowPeriod, water->FlowLikeness };
    AddLook(water->Look, numbers);
    digest = water_ranks_digest(digest, numbers.data(), numbers.size());
    digest = water_ranks_digest_waves(digest, water->Waves.data(), water->Waves.size());
  }
  digest = water_ranks_digest_settings(digest, &scene.settings);
  const double divided = hasRegion ? 1.0 : 0.0;
  digest = water_ranks_digest(digest, &divided, 1);
  return water_ranks_digest_number(digest);
}
}

//------------------------------------------------------------------------------
bool vtkWaterReflection::JoinScene(const std::vector<vtkWaterSource*>& waters, Attempt& attempt)
{
  water_scene& scene = this->Gathered.Scene;
  water_rank_view mine = water_rank_view();
  mine.sheet_count = static_cast<double>(attempt.Waters.size());
  mine.digest = DigestOf(attempt.Waters, scene, this->Ranks.HasRegion());
  mine.prop_count = static_cast<double>(scene.prop_count);
  mine.max_texture_px = scene.max_texture_px;
  mine.max_samples = scene.max_samples;
  mine.is_software = scene.is_software ? 1.0 : 0.0;
  mine.measured_ms = attempt.MeasuredMs;
  std::copy_n(scene.surface_bounds, 6, mine.surface_bounds);
  const bool hasError = std::any_of(
    waters.begin(), waters.end(), [](vtkWaterSource* water) { return water->HasSheetError(); });
  mine.has_error = hasError || !attempt.Error.Text.empty() ? 1.0 : 0.0;
  mine.has_waves = scene.has_waves ? 1.0 : 0.0;
  mine.slope_rms = scene.slope_rms;
  mine.slope_max = scene.slope_max;
  mine.wave_height_max = scene.wave_height_max;
  mine.is_averaged = this->Gathered.IsAveraged ? 1.0 : 0.0;
  mine.has_marched_rays = this->Gathered.HasMarchedRays ? 1.0 : 0.0;
  mine.wants_peel = this->Gathered.WantsPeel ? 1.0 : 0.0;
  mine.farthest_rank = this->Ranks.GetFarthest();
  water_ranks_view joined = water_ranks_view();
  if (!this->Ranks.JoinViews(mine, scene, this->RankProps, joined, attempt.Error))
  {
    return false;
  }
  attempt.FirstProp = joined.first_prop;
  attempt.MeasuredMs = joined.measured_ms;
  this->Gathered.IsAveraged = joined.is_averaged;
  this->Gathered.HasMarchedRays = joined.has_marched_rays;
  this->Gathered.WantsPeel = joined.wants_peel;
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
const vtkWaterRanks::Drawing& vtkWaterReflection::JoinDrawn(
  const Frame& frame, Attempt& attempt, const water_rank_drawn& drawn)
{
  water_rank_drawn mine = drawn;
  const bool isLost = attempt.Drawn.get() != this->GetPlannedView(); // in the middle of its draw
  const bool isAborted = isLost || frame.Renderer->GetRenderWindow()->GetAbortRender() != 0;
  mine.is_aborted = isAborted ? 1.0 : 0.0;
  mine.wants_again =
    frame.Hook->Failures.TakeMirrored() && !attempt.IsSecond && !isAborted ? 1.0 : 0.0;
  const bool isFirst = attempt.Drawing.Bounds.empty();
  attempt.Drawing = this->Ranks.JoinDrawn(mine);
  const bool isGoingOn = attempt.Drawing.Result == WATER_RANKS_DRAWN;
  const bool isMoreToCome = attempt.Drawing.HasBlended || attempt.Draft.WantsPeel;
  attempt.AgreementsDue = isFirst && isGoingOn && isMoreToCome ? 1 : 0;
  return attempt.Drawing;
}

//------------------------------------------------------------------------------
bool vtkWaterReflection::FinishDrawn(const Frame& frame, Attempt& attempt, const water_plan& plan)
{
  while (attempt.AgreementsDue > 0) // the others wait for what this rank could not do
  {
    water_rank_drawn mine = water_rank_drawn();
    mine.has_failed = 1.0;
    this->JoinDrawn(frame, attempt, mine);
  }
  const vtkWaterRanks::Drawing& drawing = attempt.Drawing;
  attempt.IsAborted = drawing.Result == WATER_RANKS_ABORTED;
  if (drawing.Result == WATER_RANKS_FAILED && !attempt.Failure)
  {
    attempt.FailureText = drawing.Bounds.empty()
      ? "the other ranks cannot be reached"
      : "rank " + std::to_string(drawing.BadRank) + " could not draw its part of the reflection";
    attempt.Failure = attempt.FailureText.c_str();
  }
  if (drawing.Result == WATER_RANKS_DRAWN)
  {
    const int* rect = plan.texture_rect_px;
    this->Report.JoinedPixels += static_cast<vtkIdType>(rect[2]) * rect[3];
  }
  // what one rank's driver refused is left out of a second view, of all ranks
  return drawing.Result == WATER_RANKS_DRAW_AGAIN;
}

//------------------------------------------------------------------------------
bool vtkWaterReflection::GatherOrFail(
  const Frame& frame, const std::vector<vtkWaterSource*>& waters, Attempt& attempt)
{
  vtkWaterError own;
  try
  {
    this->Gather(frame, waters, attempt);
  }
  catch (const std::exception& thrown)
  {
    own.Kind = std::string("reading the scene was ended by an exception (") + thrown.what() + ")";
    own.Text = own.Kind + ". The water shows its plain colour.";
  }
  attempt.Error = own;
  const bool isJoined = this->JoinScene(waters, attempt);
  attempt.Error = own.Text.empty() ? attempt.Error : own;
  return isJoined;
}

//------------------------------------------------------------------------------
void vtkWaterReflection::DrawOrFail(const Frame& frame, Attempt& attempt)
{
  attempt.Draft.Ranks = &this->Ranks;
  attempt.Draft.Agree = [this, &frame, &attempt](
                          const water_rank_drawn& mine) -> const vtkWaterRanks::Drawing& {
    return this->JoinDrawn(frame, attempt, mine);
  };
  try
  {
    this->Draw(frame, attempt);
  }
  catch (const std::exception& thrown)
  {
    attempt.FailureText =
      std::string("the draw of the reflection was ended by an exception (") + thrown.what() + ")";
    attempt.Failure = attempt.FailureText.c_str();
  }
}
