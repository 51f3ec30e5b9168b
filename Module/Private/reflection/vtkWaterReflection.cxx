// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterReflection.cxx: what is kept from frame to frame, and what others ask of it; the five
// steps are in vtkWaterReflectionSteps.cxx.
#include "vtkWaterReflection.h"

#include "vtkCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cstring>

namespace
{
// What a view keeps apart of translucent props; nothing: null pointers.
vtkWaterSurfaceShader::Layer LayerOf(vtkWaterMirroredView& view)
{
  vtkWaterTranslucentLayer* layer = view.GetLayer();
  return layer
    ? vtkWaterSurfaceShader::Layer{ layer->GetOpaque(), layer->GetColor(), layer->GetDepth() }
    : vtkWaterSurfaceShader::Layer();
}
}

//------------------------------------------------------------------------------
vtkWaterReflection::UserSettings::UserSettings()
  : water_settings()
{
  this->texture_scale = 1.0;
  this->skips = WATER_MAY_SKIP_ALL;
  this->multi_samples = -1;
  this->target_error_px = 1.0;
  this->time_budget_ms = 10.0;
}

//------------------------------------------------------------------------------
void vtkWaterReflection::ForgetTimes()
{
  const FrameReport none;
  this->Report.GatherTime = none.GatherTime;
  this->Report.PlanTime = none.PlanTime;
}

//------------------------------------------------------------------------------
void vtkWaterReflection::Decline(water_decision decision)
{
  this->Report.Decision = decision;
  this->HasView = false;
}

//------------------------------------------------------------------------------
bool vtkWaterReflection::IsSecondEye(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  return camera->GetStereo() && !camera->GetLeftEye();
}

//------------------------------------------------------------------------------
vtkWaterReflection::ViewPointer vtkWaterReflection::GetView(vtkRenderer* renderer)
{
  const Eye eye(renderer, IsSecondEye(renderer));
  for (auto it = this->Views.begin(); it != this->Views.end();)
  {
    it = it->second->Renderer || it->first == eye ? std::next(it) : this->Views.erase(it);
  }
  ViewPointer& view = this->Views[eye];
  if (!view)
  {
    view = std::make_shared<View>();
  }
  view->Renderer = renderer;
  return view;
}

//------------------------------------------------------------------------------
vtkWaterReflection::View* vtkWaterReflection::GetPlannedView()
{
  auto found = this->Views.find(Eye(this->PlannedFor, this->PlannedForSecondEye));
  return found == this->Views.end() ? nullptr : found->second.get();
}

//------------------------------------------------------------------------------
vtkOpenGLRenderWindow* vtkWaterReflection::GetWindowOf(View* view) const
{
  vtkRenderer* renderer = view ? view->Renderer.Get() : nullptr;
  return vtkOpenGLRenderWindow::SafeDownCast(renderer ? renderer->GetRenderWindow() : nullptr);
}

//------------------------------------------------------------------------------
bool vtkWaterReflection::IsFresh(
  vtkRenderer* renderer, vtkMTimeType frame, const vtkProp* water) const
{
  const auto& waters = this->PlannedWaters;
  if (this->PlannedFor != renderer || this->PlannedFrame == 0 || this->PlannedFrame != frame ||
    std::find(waters.begin(), waters.end(), water) == waters.end())
  {
    return false;
  }
  const water_camera eye = vtkWaterGather::ReadCamera(renderer);
  const water_camera& planned = this->OwnEye;
  // bit by bit: a camera with NaN is the same camera, not a new one for every draw
  return std::memcmp(eye.world_to_view, planned.world_to_view, sizeof eye.world_to_view) == 0 &&
    std::memcmp(eye.view_to_clip, planned.view_to_clip, sizeof eye.view_to_clip) == 0;
}

//------------------------------------------------------------------------------
bool vtkWaterReflection::IsUnseen(
  vtkRenderer* renderer, vtkMTimeType frame, const vtkProp* water) const
{
  return water_decision_is_unseen(this->Report.Decision) && !this->HasView &&
    this->IsFresh(renderer, frame, water);
}

//------------------------------------------------------------------------------
const water_plan* vtkWaterReflection::GetFreshPlan(
  vtkRenderer* renderer, vtkMTimeType frame, const vtkProp* water) const
{
  return this->HasView && this->IsFresh(renderer, frame, water) ? &this->Plan : nullptr;
}

//------------------------------------------------------------------------------
vtkWaterSurfaceShader::Inputs vtkWaterReflection::GetInputs(
  vtkRenderer* renderer, vtkMTimeType frame, const vtkProp* water)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const ViewPointer view = this->GetView(renderer);
  vtkWaterSurfaceShader::Inputs inputs;
  inputs.Renderer = static_cast<vtkOpenGLRenderer*>(renderer);
  inputs.Fog = &view->Mirrored.GetFog();
  inputs.Plan = this->GetFreshPlan(renderer, frame, water);
  // whether the water is hidden may be asked before its first mirrored view is drawn
  const bool hasTexture =
    inputs.Plan && water_plan_has_reflection(inputs.Plan) && view->Mirrored.GetColor();
  this->FillInputs(*view, hasTexture, inputs);
  if (!hasTexture)
  {
    inputs.Reflection = view->Mirrored.GetBlank(window);
  }
  if (this->HasOwnView && view->Own && this->IsFresh(renderer, frame, water))
  {
    OtherView& own = *view->Own;
    inputs.OwnView = { own.Drawn.GetColor(), own.Drawn.GetDepth(), own.DrawnPlan.reflection_scale,
      LayerOf(own.Drawn) };
  }
  if (this->HasSunView && view->Sun && this->IsFresh(renderer, frame, water))
  {
    OtherView& sun = *view->Sun;
    inputs.SunView = { sun.Drawn.GetDepth(), sun.DrawnPlan.sun_view_depth,
      sun.DrawnPlan.sun_view_bottom };
  }
  if (this->HasSkyView && view->Sky && this->IsFresh(renderer, frame, water))
  {
    OtherView& sky = *view->Sky;
    inputs.SkyView = { sky.Drawn.GetColor(), sky.Drawn.GetDepth(), &sky.DrawnPlan };
  }
  inputs.Ranks = this->Ranks.AreSeveral() ? &this->Ranks : nullptr;
  return inputs;
}

//------------------------------------------------------------------------------
void vtkWaterReflection::FillInputs(
  View& view, bool hasTexture, vtkWaterSurfaceShader::Inputs& inputs)
{
  vtkWaterMirroredView& mirrored = view.Mirrored;
  if (hasTexture && this->Gathered.IsRough && !view.HasLevels)
  {
    // as late as that: software renderers wait for the mirrored view here, and would not begin
    // with the picture
    mirrored.MakeLevels();
    view.HasLevels = true;
  }
  inputs.Reflection = mirrored.GetColor();
  inputs.ReflectionDepth = mirrored.GetDepth();
  inputs.Translucent = LayerOf(mirrored);
  if (vtkWaterPeel* peel = mirrored.GetPeel())
  {
    inputs.PeelColor = peel->GetColor();
    inputs.PeelDepth = peel->GetDepth();
  }
  inputs.Sky = this->Gathered.Sky;
  inputs.MostSteps = this->Quality.ray_steps;
  inputs.MostProbes = this->Quality.ray_probes;
}

//------------------------------------------------------------------------------
void vtkWaterReflection::DrawCorner(vtkRenderer* renderer, vtkMTimeType frame, const vtkProp* water)
{
  const water_plan* plan = this->GetFreshPlan(renderer, frame, water);
  if (plan && water_plan_has_reflection(plan))
  {
    vtkWaterMirroredView& mirrored = this->GetView(renderer)->Mirrored;
    mirrored.GetBackground().DrawCorner(renderer, mirrored.GetColor());
  }
}

//------------------------------------------------------------------------------
vtkWaterOcclusion* vtkWaterReflection::GetOcclusion(vtkRenderer* renderer)
{
  return &this->GetView(renderer)->Occlusion;
}

//------------------------------------------------------------------------------
vtkWaterGpuQueries* vtkWaterReflection::GetGpuQueries(vtkRenderer* renderer)
{
  vtkWaterGpuQueries* queries = &this->GetView(renderer)->Mirrored.GetGpuQueries();
  queries->SetOn(this->Settings.IsInstrumented ||
    this->Settings.quality == WATER_QUALITY_TIME_BUDGET ||
    this->Settings.quality == WATER_QUALITY_UPDATE_RATE);
  return queries;
}

//------------------------------------------------------------------------------
bool vtkWaterReflection::ShouldWait(vtkRenderer* renderer, double visible_px, bool isSoftware)
{
  return water_plan_should_wait(
    &this->GetView(renderer)->DrawnPlan, visible_px, isSoftware, this->Settings.skips);
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterReflection::GetColor()
{
  View* view = this->GetPlannedView();
  return view ? view->Mirrored.GetColor() : nullptr;
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterReflection::GetDepth()
{
  View* view = this->GetPlannedView();
  return view ? view->Mirrored.GetDepth() : nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterReflection::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const SecondaryView& secondary : this->Secondary)
  {
    secondary.Reflection->ReleaseGraphicsResources(window);
  }
  for (auto it = this->Views.begin(); it != this->Views.end();)
  {
    vtkRenderer* renderer = it->second->Renderer;
    if (renderer && window && renderer->GetRenderWindow() && renderer->GetRenderWindow() != window)
    {
      ++it;
      continue;
    }
    const ViewPointer view = it->second;
    it = this->Views.erase(it);
    this->PlannedFrame = renderer == this->PlannedFor ? 0 : this->PlannedFrame;
    ReleaseOther(view->Own, window);
    ReleaseOther(view->Sun, window);
    ReleaseOther(view->Sky, window);
    if (!view->Mirrored.GetIsDrawing()) // else Commit does it
    {
      view->Mirrored.ReleaseGraphicsResources(window);
    }
    if (window)
    {
      view->Occlusion.ReleaseGraphicsResources();
    }
  }
}
