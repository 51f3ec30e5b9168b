// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterReflectionSteps.cxx: the part of vtkWaterReflection that renders a mirrored view, in five
// steps: gather, plan, revise, draw, commit.
#include "vtkCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp.h"
#include "vtkTimerLog.h"
#include "vtkWaterErrors.h"
#include "vtkWaterGL.h"
#include "vtkWaterPropRecords.h"
#include "vtkWaterReflection.h"
#include "vtkWaterShaderHook.h"
#include "vtkWaterShadows.h"
#include "water_target.h"

#include <algorithm>
#include <cstddef>
#include <functional>

//------------------------------------------------------------------------------
bool vtkWaterReflection::Render(const Frame& frame, const std::vector<vtkWaterSource*>& waters)
{
  vtkWaterError error;
  // drawing runs the user's observers, who may drop any of these
  const std::shared_ptr<vtkWaterReflection> self = this->shared_from_this();
  std::vector<vtkSmartPointer<vtkProp>> held;
  for (vtkWaterSource* water : waters)
  {
    held.emplace_back(water->GetProp());
  }
  if (!this->RenderView(frame, waters, error))
  {
    return false;
  }
  for (vtkWaterSource* water : waters)
  {
    water->Report(frame.Renderer, error);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterReflection::RenderView(
  const Frame& frame, const std::vector<vtkWaterSource*>& waters, vtkWaterError& error)
{
  this->Report.JoinedPixels = 0;
  this->HasOwnView = this->HasSunView = this->HasSkyView = false;
  if (frame.RanksError)
  {
    this->RenderNothing(frame, waters, *frame.RanksError);
    return false;
  }
  frame.Hook->Failures.TakeMirrored(); // of another view
  bool isAgain = false;
  do
  {
    Attempt attempt;
    attempt.IsSecond = isAgain;
    if (!this->Ranks.AreSeveral())
    {
      this->Gather(frame, waters, attempt);
    }
    else if (!this->GatherOrFail(frame, waters, attempt))
    {
      this->RenderNothing(frame, waters, attempt.Error);
      return false;
    }
    isAgain = this->PlanAndDraw(frame, attempt);
    if (!isAgain)
    {
      error = this->Commit(frame, attempt);
      const vtkWaterError ofOthers = this->RenderOtherViews(frame, attempt);
      error = error.Text.empty() ? ofOthers : error;
    }
  } while (isAgain);
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterReflection::PlanAndDraw(const Frame& frame, Attempt& attempt)
{
  const bool areSeveral = this->Ranks.AreSeveral();
  this->ChooseQuality(frame, attempt);
  this->MakePlan(frame, attempt);
  if (this->Plan.decision == WATER_REFLECT && frame.AreHidden && frame.AreHidden())
  {
    this->Gathered.Scene.is_hidden = true;
    this->MakePlan(frame, attempt);
  }
  const bool isReflecting = this->Plan.decision == WATER_REFLECT;
  if (isReflecting)
  {
    this->RenderSecondary(frame, attempt);
    if (!attempt.Held.empty() && !this->HasPropsOf(*frame.Records))
    {
      this->Decline(WATER_NOT_PLANNED);
      this->Plan.decision = WATER_NO_REFLECT_FAILED;
      return !attempt.IsSecond;
    }
    this->Revise(frame, attempt);
    areSeveral ? this->DrawOrFail(frame, attempt) : this->Draw(frame, attempt);
  }
  if (this->Plan.decision == WATER_REFLECT && areSeveral)
  {
    return this->FinishDrawn(frame, attempt, this->Plan);
  }
  // what was refused in this view is left out of a second one
  attempt.IsAborted = frame.Renderer->GetRenderWindow()->GetAbortRender() != 0;
  return isReflecting && frame.Hook->Failures.TakeMirrored() && !attempt.IsSecond &&
    !attempt.IsAborted;
}

//------------------------------------------------------------------------------
void vtkWaterReflection::Gather(
  const Frame& frame, const std::vector<vtkWaterSource*>& waters, Attempt& attempt)
{
  if (frame.Hints.HasSceneDepth)
  {
    glFlush(); // the picture is drawn while the reflection is planned
  }
  const double begun = this->Settings.IsInstrumented ? vtkTimerLog::GetUniversalTime() : 0.0;
  for (vtkWaterSource* water : waters)
  {
    attempt.Waters.push_back(water->Take(frame.Renderer));
  }
  vtkWaterFrameHints hints = frame.Hints;
  hints.Background = &this->Background;
  this->Gathered.Read(frame.Renderer, attempt.Waters, frame.Viewport_px, this->Settings, hints);
  if (frame.Primary)
  {
    this->Gathered.ReadAsSecondary(frame.Renderer, *frame.Primary);
  }
  vtkWaterShaderFailures& failures = frame.Hook->Failures;
  std::function<bool(vtkProp*)> isRefused; // none is, as a rule
  if (!failures.AreNone())
  {
    isRefused = [&failures](vtkProp* prop) { return failures.Has(prop); };
  }
  this->Gathered.ReadProps(frame.Renderer, *attempt.Waters.front(), isRefused, *frame.Records);
  if (!frame.Primary && WantOwnView(attempt))
  {
    this->MarkOwnProps(frame);
  }
  this->OwnEye = this->Gathered.Scene.eye;
  attempt.Drawn = this->GetView(frame.Renderer);
  attempt.MeasuredMs = this->Measure(*attempt.Drawn);
  if (this->Settings.IsInstrumented)
  {
    this->Report.GatherTime = 1000.0 * (vtkTimerLog::GetUniversalTime() - begun);
  }
}

//------------------------------------------------------------------------------
double vtkWaterReflection::Measure(View& view)
{
  const water_quality_mode mode = this->Settings.quality;
  if (mode != WATER_QUALITY_TIME_BUDGET && mode != WATER_QUALITY_UPDATE_RATE)
  {
    return 0.0;
  }
  // a view that was used again took no time
  const bool wasRendered = this->Report.Decision == WATER_REFLECT;
  vtkWaterGpuQueries& queries = view.Mirrored.GetGpuQueries();
  double time = queries.GetTime(vtkWaterGpuQueries::SURFACE) +
    (wasRendered ? queries.GetTime(vtkWaterGpuQueries::REFLECTION) : 0.0);
  for (const SecondaryView& secondary : this->Secondary)
  {
    const bool wasLookedUp = secondary.IdleCount == 0;
    time += wasLookedUp ? secondary.Reflection->MeasureSecondary() : 0.0;
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkWaterReflection::ChooseQuality(const Frame& frame, Attempt& attempt)
{
  View& view = *attempt.Drawn;
  water_scene& scene = this->Gathered.Scene;
  water_quality_request request = water_quality_request();
  request.mode = this->Settings.quality;
  request.texture_scale = this->Settings.texture_scale;
  request.target_error_px = this->Settings.target_error_px;
  request.budget_ms = frame.Hints.BudgetMs;
  if (request.mode == WATER_QUALITY_TARGET_ERROR)
  {
    water_quality_roughness(&scene, &view.DrawnPlan, this->Gathered.WaveNumber, &request.roughness);
  }
  else
  {
    request.measured_ms = attempt.MeasuredMs;
  }
  water_quality_choose(&request, &view.Quality, &this->Quality);
  scene.settings.texture_scale = this->Quality.texture_scale;
  if (this->Gathered.IsAveraged && this->Quality.step == WATER_QUALITY_NO_STEP)
  {
    scene.settings.texture_scale = water_target_fine_scale(
      scene.viewport_px, scene.settings.texture_scale, scene.max_texture_px);
  }
  this->Report.QualityStep = this->Quality.step;
  this->Report.TextureScale = scene.settings.texture_scale;
}

//------------------------------------------------------------------------------
void vtkWaterReflection::MakePlan(const Frame& frame, Attempt& attempt)
{
  const double begun = this->Settings.IsInstrumented ? vtkTimerLog::GetUniversalTime() : 0.0;
  const size_t own = this->Gathered.Props.size();
  this->Reasons.assign(this->Gathered.Scene.prop_count, WATER_CULL_NONE);
  water_status status = water_plan_make(&this->Gathered.Scene, &this->Plan, this->Reasons.data());
  if (this->Reasons.size() != own) // of those of all ranks
  {
    const auto first = this->Reasons.begin() + static_cast<std::ptrdiff_t>(attempt.FirstProp);
    this->Reasons = std::vector<water_cull_reason>(first, first + static_cast<std::ptrdiff_t>(own));
    this->Gathered.Scene.props = this->Gathered.Props.data();
    this->Gathered.Scene.prop_count = own;
  }
  if (status == WATER_BAD_PROP_BOUNDS)
  {
    this->Plan.bad_index -= attempt.FirstProp;
    status = this->Plan.bad_index < own ? status : WATER_OK; // said by the rank that has it
  }
  if (status != WATER_OK)
  {
    attempt.Error = vtkWaterDescribe(status, *attempt.Waters.front(), &this->Gathered, &this->Plan);
  }
  else if (this->Gathered.HasEmptySkybox)
  {
    attempt.Error = vtkWaterDescribeEmptySkybox();
  }
  if (this->Settings.IsInstrumented)
  {
    this->Report.PlanTime = 1000.0 * (vtkTimerLog::GetUniversalTime() - begun);
  }
  this->Report.Decision = this->Plan.decision;
  this->HasView = this->Plan.has_view;
  this->GetGpuQueries(frame.Renderer); // turns them on or off
  std::vector<const vtkProp*> planned;
  for (const vtkWaterSnapshotPointer& water : attempt.Waters)
  {
    planned.push_back(water->Actor);
  }
  this->SetPlanned(frame, planned);
  std::fill_n(this->Report.ReasonCounts, static_cast<int>(WATER_CULL_REASON_COUNT), 0);
}

//------------------------------------------------------------------------------
void vtkWaterReflection::SetPlanned(const Frame& frame, const std::vector<const vtkProp*>& waters)
{
  this->PlannedFor = frame.Renderer;
  this->PlannedForSecondEye = IsSecondEye(frame.Renderer);
  this->PlannedFrame = frame.Number;
  this->PlannedWaters = waters;
}

//------------------------------------------------------------------------------
void vtkWaterReflection::Revise(const Frame& frame, Attempt& attempt)
{
  vtkRenderer* renderer = frame.Renderer;
  View& view = *attempt.Drawn;
  attempt.Draft.Hook = frame.Hook;
  attempt.Draft.Sky = this->Gathered.Sky;
  attempt.Draft.Secondary = this->MayHaveSecondary(frame) ? this : nullptr;
  attempt.Draft.HasMarchedRays = this->Gathered.HasMarchedRays;
  attempt.Draft.WantsPeel = this->Gathered.WantsPeel;
  if (attempt.Draft.WantsPeel)
  {
    frame.Hook->WantPeel();
  }
  attempt.Draft.CanCut = (this->Settings.skips & WATER_MAY_SKIP_CLUSTERS) != 0;
  attempt.Draft.Shadows = vtkWaterShadows::Find(renderer);
  const Choice choice = { this->Plan, this->Reasons, false };
  FindDrawn(frame, attempt, choice, attempt.Draft.Props);
  this->CountReasons();
  this->Sign(frame, choice, attempt.Draft, attempt.Signature);
  this->SignSecondary(frame, attempt);
  bool isUnchanged = attempt.Signature.IsSameAs(view.DrawnSignature);
  if (this->Ranks.AreSeveral())
  {
    isUnchanged = this->IsUnchangedOnAll(attempt, isUnchanged);
  }
  const water_visibility* visible = view.Mirrored.FindVisible(
    renderer, this->Plan, water_plan_wants_visibility(&view.DrawnPlan, &this->Plan));
  water_plan_revise(&this->Gathered.Scene, &view.DrawnPlan, isUnchanged, visible, &this->Plan,
    this->Reasons.data());
  this->Report.Decision = this->Plan.decision;
  if (visible)
  {
    FindDrawn(frame, attempt, choice, attempt.Draft.Props);
    this->CountReasons();
  }
}

//------------------------------------------------------------------------------
void vtkWaterReflection::Draw(const Frame& frame, Attempt& attempt)
{
  if (this->Plan.decision != WATER_REFLECT)
  {
    return; // the last one shows the same
  }
  attempt.AgreementsDue = 1;
  this->SortDrawn(frame, { this->Plan, this->Reasons, false }, attempt.Draft);
  attempt.Drawn->DrawnPlan = water_plan();
  attempt.Drawn->HasLevels = false;
  if (attempt.Draft.Shadows)
  {
    vtkWaterShadows::Bake(frame.Renderer, attempt.Draft.Shadows);
  }
  attempt.Failure = attempt.Drawn->Mirrored.Draw(frame.Renderer, this->Plan, attempt.Draft);
}

//------------------------------------------------------------------------------
vtkWaterError vtkWaterReflection::Describe(const vtkWaterShortage& shortage)
{
  vtkWaterError error;
  if (shortage.What)
  {
    error.Kind = shortage.What;
    error.Text = error.Kind +
      (shortage.TriangleCount > 0 ? " (" + std::to_string(shortage.TriangleCount) + " triangles)"
                                  : "") +
      ". The reflection is drawn without culling; the next frame tries again.";
  }
  return error;
}

//------------------------------------------------------------------------------
vtkWaterError vtkWaterReflection::Commit(const Frame& frame, Attempt& attempt)
{
  // the picture's own plans say what is wrong with the waters and the props
  vtkWaterError error = frame.Primary ? vtkWaterError() : attempt.Error;
  if (!water_plan_has_reflection(&this->Plan))
  {
    return error;
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(frame.Renderer->GetRenderWindow());
  View& view = *attempt.Drawn;
  const bool isDrawn = this->Plan.decision == WATER_REFLECT;
  if (this->GetPlannedView() != &view)
  {
    view.Mirrored.ReleaseGraphicsResources(window); // was wanted in the middle of it
    this->Decline(WATER_NOT_PLANNED);
  }
  else if (isDrawn && (attempt.IsAborted || window->GetAbortRender()))
  {
    this->Decline(WATER_NOT_PLANNED); // mappers draw nothing from then on
  }
  else if (attempt.Failure)
  {
    this->Decline(WATER_NO_REFLECT_FAILED);
    error.Kind = attempt.Failure;
    error.Text = error.Kind +
      (frame.Primary ? ", in the secondary view of a water that appears in this reflection. That "
                       "water reflects the sky there."
                     : ". The water shows its plain colour.");
  }
  else
  {
    if (isDrawn)
    {
      ++this->Report.RenderCount;
      view.DrawnPlan = this->Plan;
      view.DrawnSignature = attempt.Signature;
      view.DrawnTime.Modified();
    }
    if (error.Text.empty())
    {
      error = attempt.SecondaryError;
    }
    if (error.Text.empty())
    {
      error = Describe(view.Mirrored.GetShortage()); // also of a view that is used again
    }
  }
  return error;
}
