// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterReflectionPass.h"

#include "vtkCamera.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRenderStepsPass.h"
#include "vtkTextureObject.h"
#include "vtkTimerLog.h"
#include "vtkWaterActor.h"
#include "vtkWaterCompat.h"
#include "vtkWaterErrors.h"
#include "vtkWaterGL.h"
#include "vtkWaterReflectionPassInternals.h"
#include "vtkWaterShaderHook.h"
#include "vtkWaterShadows.h"
#include "water_plan.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkWaterReflectionPass);
vtkInformationKeyMacro(vtkWaterReflectionPass, NOT_REFLECTED, Integer);
vtkInformationKeyRestrictedMacro(vtkWaterReflectionPass, STAND_IN, ObjectBase, "vtkProp");

static_assert(static_cast<int>(vtkWaterReflectionPass::REFUSED) == WATER_CULL_REFUSED &&
    static_cast<int>(vtkWaterReflectionPass::NUMBER_OF_FATES) == WATER_CULL_REASON_COUNT,
  "the public fates mirror the core's");
static_assert(static_cast<int>(vtkWaterReflectionPass::SHARED) == WATER_NO_REFLECT_SHARED &&
    static_cast<int>(vtkWaterReflectionPass::NUMBER_OF_DECISIONS) == WATER_DECISION_COUNT,
  "the public decisions mirror the core's");
static_assert(static_cast<int>(vtkWaterReflectionPass::PIXELS) == WATER_MAY_SKIP_PIXELS &&
    static_cast<int>(vtkWaterReflectionPass::SKIP_ALL) == WATER_MAY_SKIP_ALL,
  "the public skips mirror the core's");

namespace
{
constexpr int kMaximumDefaultSamples = 8; // more is slow and not seen in a reflection

// Is GL executed by the processor? As Mesa's and Google's renderers of that kind call themselves;
// unless the environment says what to take it for.
bool IsSoftware()
{
  if (const char* said = std::getenv("VTK_WATER_SOFTWARE"))
  {
    return std::string(said) == "1";
  }
  const char* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string renderer = name ? name : "";
  return renderer.find("llvmpipe") != std::string::npos ||
    renderer.find("softpipe") != std::string::npos ||
    renderer.find("SwiftShader") != std::string::npos;
}
}

//------------------------------------------------------------------------------
vtkWaterReflectionPass::vtkWaterReflectionPass()
  : Internal(std::make_unique<Internals>())
{
  const char* debug = std::getenv("VTK_WATER_DEBUG");
  this->ShowReflection = debug && std::string(debug) == "1";
}

//------------------------------------------------------------------------------
vtkWaterReflectionPass::~vtkWaterReflectionPass() = default;

//------------------------------------------------------------------------------
vtkWaterGpuQueries* vtkWaterReflectionPass::GetInstruments(vtkRenderer* renderer)
{
  vtkWaterGpuQueries* instruments = &this->Internal->GetView(renderer)->Mirror.GetInstruments();
  instruments->SetOn(
    this->Instrumentation || this->Quality == TIME_BUDGET || this->Quality == UPDATE_RATE);
  return instruments;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetDecision(int decision)
{
  this->Internal->Plan.decision = static_cast<water_decision>(decision);
  this->Internal->Plan.has_view = false;
}

//------------------------------------------------------------------------------
vtkWaterOcclusion* vtkWaterReflectionPass::GetOcclusion(vtkRenderer* renderer)
{
  return &this->Internal->GetView(renderer)->Occlusion;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::GetRayLimits(int* steps, int* probes) const
{
  *steps = this->Internal->MostSteps;
  *probes = this->Internal->MostProbes;
}

//------------------------------------------------------------------------------
bool vtkWaterReflectionPass::ShouldWait(vtkRenderer* renderer, double visible_px)
{
  return water_plan_should_wait(
    &this->Internal->GetView(renderer)->DrawnPlan, visible_px, static_cast<unsigned>(this->Skips));
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::ChooseQuality(vtkRenderer* renderer, double budget_ms)
{
  Internals& internal = *this->Internal;
  const std::shared_ptr<Internals::View> view = internal.GetView(renderer);
  water_scene& scene = internal.Gather.scene;
  int step = 0;
  if (this->Quality == TARGET_ERROR)
  {
    water_roughness roughness;
    water_quality_roughness(&scene, &view->DrawnPlan, internal.Gather.WaveNumber, &roughness);
    water_quality_for_error(this->TargetError, &roughness, &view->ErrorStep);
    step = view->ErrorStep;
  }
  else if (this->Quality != FIXED &&
    !(this->Quality == UPDATE_RATE && water_quality_is_still(budget_ms)))
  {
    // a view that was used again took no time
    const bool isRendered = internal.Plan.decision == WATER_REFLECT;
    vtkWaterGpuQueries& instruments = view->Mirror.GetInstruments();
    const double measured = instruments.GetTime(vtkWaterGpuQueries::SURFACE) +
      (isRendered ? instruments.GetTime(vtkWaterGpuQueries::REFLECTION) : 0.0);
    water_quality_for_budget(&view->Quality, 0, budget_ms, measured);
    step = view->Quality.step;
  }
  water_quality quality;
  water_quality_of_step(step, &quality);
  this->QualityStep = this->Quality == FIXED ? -1 : step;
  this->TextureScaleInUse = this->Quality == FIXED ? this->TextureScale : quality.texture_scale;
  scene.texture_scale = this->TextureScaleInUse;
  internal.MostSteps = this->Quality == FIXED ? VTK_INT_MAX : quality.ray_steps;
  internal.MostProbes = this->Quality == FIXED ? VTK_INT_MAX : quality.ray_probes;
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkWaterReflectionPass::FindDrawn(vtkRenderer* renderer, vtkWaterActor* water)
{
  Internals& internal = *this->Internal;
  std::vector<vtkProp*> drawn;
  std::fill(internal.ReasonCounts, internal.ReasonCounts + WATER_CULL_REASON_COUNT, 0);
  for (size_t i = 0; i < internal.Reasons.size(); ++i)
  {
    ++internal.ReasonCounts[internal.Reasons[i]];
    if (internal.Reasons[i] == WATER_CULL_NONE)
    {
      drawn.push_back(internal.Gather.vtkProps[i]);
      if (drawn.back()->IsA("vtkLODProp3D"))
      {
        // It chooses its level here, which the renderer has not come to yet, and never does for a
        // prop that only the mirror sees.
        drawn.back()->SetAllocatedRenderTime(water->GetAllocatedRenderTime(), renderer);
      }
    }
  }
  return drawn;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::RenderReflection(vtkRenderer* renderer,
  const std::vector<vtkWaterActor*>& waters, const int viewport_px[2], const Moment& moment)
{
  // drawing runs the user's observers, who may drop any of these
  const vtkSmartPointer<vtkWaterReflectionPass> self = this;
  const std::vector<vtkSmartPointer<vtkWaterActor>> held(waters.begin(), waters.end());
  Internals& internal = *this->Internal;
  vtkWaterShaderHook* shading = vtkWaterShaderHook::GetOfThread();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  shading->Keys.HoldUntilEndOfFrame(renderer);
  shading->Refusals.TakeMirrored(); // of another view

  if (moment.HasSceneDepth)
  {
    glFlush(); // the picture is drawn while the reflection is planned
  }

  // gather
  const double begun = this->Instrumentation ? vtkTimerLog::GetUniversalTime() : 0.0;
  vtkWaterGather& gather = internal.Gather;
  gather.Read(renderer, waters, viewport_px);
  window->MakeCurrent(); // bringing pipelines up to date may have rendered another window
  this->ChooseQuality(renderer, moment.Budget);
  gather.scene.clip_margin = this->ClipMargin;
  gather.scene.guard_band = this->GuardBand;
  gather.scene.skips = static_cast<unsigned>(this->Skips);
  gather.scene.prop_px_min = this->MinimumPropSize;
  gather.scene.reflectance_error = this->ReflectanceError;
  gather.scene.is_hidden = moment.IsHidden;
  gather.scene.has_scene_depth = moment.HasSceneDepth;
  gather.scene.is_software = IsSoftware();
  gather.scene.max_texture_px = vtkTextureObject::GetMaximumTextureSize(window);

  // plan
  const double gathered = this->Instrumentation ? vtkTimerLog::GetUniversalTime() : 0.0;
  internal.Reasons.assign(gather.props.size(), WATER_CULL_NONE);
  const water_status status =
    water_plan_make(&gather.scene, &internal.Plan, internal.Reasons.data());
  if (this->Instrumentation)
  {
    this->LastGatherTime = 1000.0 * (gathered - begun);
    this->LastPlanTime = 1000.0 * (vtkTimerLog::GetUniversalTime() - gathered);
  }
  this->GetInstruments(renderer); // turns them on or off
  internal.PlannedFor = renderer;
  internal.PlannedForSecondEye = Internals::IsSecondEye(renderer);
  internal.PlannedWaters = waters;
  internal.PlannedFrame = shading->Keys.GetFrame(renderer);
  vtkWaterError error;
  if (status != WATER_OK)
  {
    error = vtkWaterDescribe(status, waters.front(), &gather, &internal.Plan);
  }
  std::fill(internal.ReasonCounts, internal.ReasonCounts + WATER_CULL_REASON_COUNT, 0);

  // draw
  if (internal.Plan.decision == WATER_REFLECT)
  {
    std::vector<vtkProp*> drawn = this->FindDrawn(renderer, waters.front());
    const int samples = this->MultiSamples >= 0
      ? this->MultiSamples
      : std::min(window->GetMultiSamples(), kMaximumDefaultSamples);
    const std::shared_ptr<Internals::View> view = internal.GetView(renderer);
    const bool mayToneMap = renderer->GetPass() &&
      (renderer->GetPass() != this ||
        (this->DelegatePass && !this->DelegatePass->IsA("vtkRenderStepsPass")));
    const bool isFloat =
      this->ColorPrecision == HALF_FLOAT || (this->ColorPrecision == AUTOMATIC && mayToneMap);
    vtkWaterSignature signature;
    signature.Read(renderer, drawn);
    signature.Add(static_cast<vtkMTimeType>(samples));
    signature.Add(isFloat ? 1 : 0);
    signature.Add(gather.HasMarchedRays ? 1 : 0);
    vtkShadowMapPass* shadows = vtkWaterShadows::Find(renderer);
    if (shadows)
    {
      signature.AddShadows(renderer, shadows);
    }
    water_plan_reuse(&view->DrawnPlan, signature.IsSameAs(view->DrawnSignature),
      static_cast<unsigned>(this->Skips), &internal.Plan);
    const char* failure = nullptr;
    if (internal.Plan.decision == WATER_REFLECT)
    {
      view->Mirror.FindVisibility(renderer, internal.Plan);
      if (const water_visibility* seen = view->Mirror.GetVisibility())
      {
        water_visibility_cull(seen, &internal.Plan.mirrored, gather.props.data(),
          gather.props.size(), static_cast<unsigned>(this->Skips), internal.Reasons.data());
        drawn = this->FindDrawn(renderer, waters.front());
      }
      view->DrawnPlan = water_plan();
      view->HasLevels = false;
      if (shadows)
      {
        vtkWaterShadows::Bake(renderer, shadows);
      }
      vtkWaterMirroredView::Settings settings;
      settings.Samples = samples > 1 ? samples : 0;
      settings.IsFloat = isFloat;
      settings.HasMarchedRays = gather.HasMarchedRays;
      settings.CanCut = (this->Skips & PIECES) != 0;
      settings.Shadows = shadows;
      failure = view->Mirror.Draw(renderer, shading, internal.Plan, drawn, settings);
    }
    if (shading->Refusals.TakeMirrored() && !moment.IsAgain && !window->GetAbortRender())
    {
      Moment again = moment;
      again.IsAgain = true;
      this->RenderReflection(renderer, waters, viewport_px, again); // without what was refused
      return;
    }
    if (internal.GetPlannedView() != view.get())
    {
      view->Mirror.ReleaseGraphicsResources(window); // was wanted in the middle of it
      this->SetDecision(WATER_NOT_PLANNED);
    }
    else if (internal.Plan.decision == WATER_REFLECT && window->GetAbortRender())
    {
      this->SetDecision(WATER_NOT_PLANNED); // mappers draw nothing from then on
    }
    else if (failure)
    {
      this->SetDecision(WATER_NO_REFLECT_FAILED);
      error.Kind = failure;
      error.Text = error.Kind + ". The water shows its plain colour.";
    }
    else
    {
      if (internal.Plan.decision == WATER_REFLECT)
      {
        ++this->NumberOfReflectionRenders;
        view->DrawnPlan = internal.Plan;
        view->DrawnSignature = signature;
      }
      if (gather.IsRough && !view->HasLevels)
      {
        view->Mirror.MakeLevels();
        view->HasLevels = true;
      }
    }
  }
  for (vtkWaterActor* water : waters)
  {
    water->ReportError(renderer, error);
  }
}

//------------------------------------------------------------------------------
bool vtkWaterReflectionPass::IsFresh(vtkRenderer* renderer, vtkWaterActor* water) const
{
  const Internals& internal = *this->Internal;
  const auto& waters = internal.PlannedWaters;
  if (internal.PlannedFor != renderer || internal.PlannedFrame == 0 ||
    internal.PlannedFrame != vtkWaterShaderHook::GetOfThread()->Keys.GetFrame(renderer) ||
    std::find(waters.begin(), waters.end(), water) == waters.end())
  {
    return false;
  }
  const water_camera eye = vtkWaterGather::ReadCamera(renderer);
  const water_camera& planned = internal.Gather.scene.eye;
  // bit by bit: a camera with NaN is the same camera, not a new one for every draw
  return std::memcmp(eye.world_to_view, planned.world_to_view, sizeof eye.world_to_view) == 0 &&
    std::memcmp(eye.view_to_clip, planned.view_to_clip, sizeof eye.view_to_clip) == 0;
}

//------------------------------------------------------------------------------
bool vtkWaterReflectionPass::IsUnseen(vtkRenderer* renderer, vtkWaterActor* water) const
{
  const water_plan& plan = this->Internal->Plan;
  return (plan.decision == WATER_NO_REFLECT_HIDDEN ||
           plan.decision == WATER_NO_REFLECT_OUT_OF_VIEW ||
           plan.decision == WATER_NO_REFLECT_FACING_AWAY) &&
    !plan.has_view && this->IsFresh(renderer, water);
}

//------------------------------------------------------------------------------
const water_plan* vtkWaterReflectionPass::GetFreshPlan(
  vtkRenderer* renderer, vtkWaterActor* water) const
{
  return this->Internal->Plan.has_view && this->IsFresh(renderer, water) ? &this->Internal->Plan
                                                                         : nullptr;
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterReflectionPass::GetTexture(vtkRenderer* renderer, vtkWaterActor* water)
{
  vtkWaterMirroredView& mirror = this->Internal->GetView(renderer)->Mirror;
  const water_plan* plan = this->GetFreshPlan(renderer, water);
  return plan && water_plan_has_reflection(plan)
    ? mirror.GetColor()
    : mirror.GetBlank(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
}

//------------------------------------------------------------------------------
vtkWaterTranslucentLayer* vtkWaterReflectionPass::GetLayer(vtkRenderer* renderer)
{
  return this->Internal->GetView(renderer)->Mirror.GetLayer();
}

//------------------------------------------------------------------------------
vtkWaterFullScreen* vtkWaterReflectionPass::GetScreen(vtkRenderer* renderer)
{
  return &this->Internal->GetView(renderer)->Mirror.GetScreen();
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::RenderCorner(vtkRenderer* renderer, vtkWaterActor* water)
{
  const water_plan* plan = this->GetFreshPlan(renderer, water);
  if (plan && water_plan_has_reflection(plan))
  {
    vtkWaterMirroredView& mirror = this->Internal->GetView(renderer)->Mirror;
    mirror.GetScreen().DrawCorner(renderer, mirror.GetColor());
  }
}

VTK_ABI_NAMESPACE_END
