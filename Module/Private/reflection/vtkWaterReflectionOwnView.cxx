// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterReflectionOwnView.cxx: the part of vtkWaterReflection that renders the own view of clear
// water (water_beyond.h), in the same five steps as the mirrored view and after it. What is
// gathered is the same.
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp.h"
#include "vtkWaterPropRecords.h"
#include "vtkWaterReflection.h"
#include "vtkWaterShaderHook.h"
#include "vtkWaterShadows.h"

#include <algorithm>

//------------------------------------------------------------------------------
water_scene vtkWaterReflection::ReadOwnScene(
  const Frame& frame, std::vector<water_prop>& props) const
{
  water_scene scene = this->Gathered.Scene;
  scene.is_beyond = true;
  for (size_t i = 0; i < scene.prop_count; ++i)
  {
    vtkProp* prop = frame.Records->GetProp(i);
    const bool isReflected = (this->Gathered.Props[i].flags & WATER_PROP_NOT_REFLECTED) == 0;
    if (isReflected && prop == frame.Records->GetDrawn(i))
    {
      continue;
    }
    if (props.empty())
    {
      props = this->Gathered.Props;
    }
    // its bounds were not read: they are not worth it for the few there are
    const uint32_t visible = prop->GetVisibility() ? WATER_PROP_VISIBLE : 0;
    props[i].flags &= ~static_cast<uint32_t>(WATER_PROP_VISIBLE);
    props[i].flags |= visible | WATER_PROP_NO_BOUNDS;
  }
  scene.props = props.empty() ? scene.props : props.data();
  return scene;
}

//------------------------------------------------------------------------------
void vtkWaterReflection::ReleaseOwnView(View& view, vtkWindow* window)
{
  if (view.Own && !view.Own->Drawn.GetIsDrawing()) // else who draws it does it
  {
    view.Own->Drawn.ReleaseGraphicsResources(window);
    view.Own = nullptr;
  }
}

//------------------------------------------------------------------------------
vtkWaterError vtkWaterReflection::RenderOwnView(const Frame& frame, Attempt& attempt)
{
  vtkWaterError error;
  View& view = *attempt.Drawn;
  this->Report.OwnViewDecision = WATER_NOT_PLANNED;
  const bool isWanted = !this->Ranks.AreSeveral() && !frame.Primary &&
    std::any_of(attempt.Waters.begin(), attempt.Waters.end(),
      [](const vtkWaterSnapshotPointer& water) { return water->WantsOwnView(); });
  if (!isWanted)
  {
    this->ReleaseOwnView(view, frame.Renderer->GetRenderWindow());
    return error;
  }
  if (this->GetPlannedView() != &view || attempt.IsAborted ||
    this->Report.Decision == WATER_NO_REFLECT_FAILED)
  {
    return error; // the plain colour is shown
  }
  std::vector<water_prop> props;
  water_scene scene = this->ReadOwnScene(frame, props);
  std::vector<water_cull_reason> reasons(scene.prop_count, WATER_CULL_NONE);
  water_plan plan;
  // what is wrong with the scene is told by the mirrored view's plan
  (void)water_plan_make(&scene, &plan, reasons.data());
  const bool isAsked = water_plan_has_reflection(&this->Plan);
  if (plan.decision == WATER_REFLECT && !isAsked && frame.AreHidden && frame.AreHidden())
  {
    scene.is_hidden = true;
    (void)water_plan_make(&scene, &plan, reasons.data());
  }
  if (plan.decision == WATER_REFLECT)
  {
    error = this->DrawOwnView(frame, attempt, { plan, reasons, true }, scene, plan, reasons);
  }
  this->Report.OwnViewDecision = plan.decision;
  this->HasOwnView = water_plan_has_reflection(&plan);
  return error;
}

//------------------------------------------------------------------------------
vtkWaterError vtkWaterReflection::DrawOwnView(const Frame& frame, Attempt& attempt,
  const Choice& choice, const water_scene& scene, water_plan& plan,
  std::vector<water_cull_reason>& reasons)
{
  vtkWaterError error;
  View& view = *attempt.Drawn;
  auto* window = static_cast<vtkOpenGLRenderWindow*>(frame.Renderer->GetRenderWindow());
  if (!view.Own)
  {
    view.Own = std::make_unique<OwnView>();
  }
  OwnView& own = *view.Own;
  vtkWaterMirroredView::Draft draft;
  draft.Hook = frame.Hook;
  draft.Sky = this->Gathered.Sky;
  draft.CanCut = (this->Settings.skips & WATER_MAY_SKIP_CLUSTERS) != 0;
  draft.Shadows = vtkWaterShadows::Find(frame.Renderer);
  FindDrawn(frame, attempt, choice, draft.Props);
  vtkWaterSignature signature;
  this->Sign(frame, choice, draft, signature);
  water_plan_revise(
    &scene, &own.DrawnPlan, signature.IsSameAs(own.DrawnSignature), nullptr, &plan, reasons.data());
  if (plan.decision != WATER_REFLECT)
  {
    return Describe(own.Drawn.GetShortage());
  }
  this->SortDrawn(frame, choice, draft);
  own.DrawnPlan = water_plan();
  if (draft.Shadows)
  {
    vtkWaterShadows::Bake(frame.Renderer, draft.Shadows);
  }
  (void)own.Drawn.FindVisible(frame.Renderer, plan, false); // all of it is looked at
  const char* failure = own.Drawn.Draw(frame.Renderer, plan, draft);
  if (this->GetPlannedView() != &view)
  {
    own.Drawn.ReleaseGraphicsResources(window); // was wanted in the middle of it
    plan.decision = WATER_NOT_PLANNED;
  }
  else if (failure)
  {
    plan.decision = WATER_NO_REFLECT_FAILED;
    error.Kind = std::string("own view of refraction: ") + failure;
    error.Text =
      error.Kind + ". The water shows what the picture has of the scene below (RefractionSource).";
  }
  else if (window->GetAbortRender() || frame.Hook->Failures.TakeMirrored())
  {
    plan.decision = WATER_NOT_PLANNED; // what was refused is left out of the next one
  }
  else
  {
    ++this->Report.OwnViewRenderCount;
    own.DrawnPlan = plan;
    own.DrawnSignature = signature;
    error = Describe(own.Drawn.GetShortage());
  }
  return error;
}
