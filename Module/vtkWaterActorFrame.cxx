// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterActorFrame.cxx: the part of vtkWaterActor that takes part in a frame: when its mirrored
// view is drawn, and with which other sheets it shares it.
// See Documentation/decisions/002-host.md and 009-skips.md.
#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkPlane.h"
#include "vtkPropCollection.h"
#include "vtkWaterAccess.h"
#include "vtkWaterActor.h"
#include "vtkWaterCompat.h"
#include "vtkWaterGL.h"
#include "vtkWaterGather.h"
#include "vtkWaterOcclusion.h"
#include "vtkWaterProperty.h"
#include "vtkWaterReflectionPass.h"
#include "vtkWaterShaderHook.h"
#include "vtkWaterSurfaceShader.h"
#include "water_plan.h"
#include "water_quality.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// What a renderer draws in this frame, in order.
struct Props
{
  explicit Props(vtkRenderer* renderer)
    : Begin(vtkWaterAccess::Renderer::PropsOf(renderer))
    , End(this->Begin ? this->Begin + vtkWaterAccess::Renderer::PropCountOf(renderer) : nullptr)
  {
  }

  vtkProp** Find(vtkProp* prop) const { return std::find(this->Begin, this->End, prop); }
  bool Has(vtkProp* prop) const { return this->Find(prop) != this->End; }

  vtkProp** Begin;
  vtkProp** End;
};

// Waves count from there.
bool HaveSameOrigin(vtkWaterActor* a, vtkWaterActor* b)
{
  double origins[2][3];
  vtkWaterGather::ReadPlaneOrigin(a, origins[0]);
  vtkWaterGather::ReadPlaneOrigin(b, origins[1]);
  return std::equal(origins[0], origins[0] + 3, origins[1]);
}
}

//------------------------------------------------------------------------------
void vtkWaterActor::DrawLast(vtkRenderer* renderer)
{
  const Props props(renderer);
  vtkProp** self = props.Find(this);
  const bool isClear = vtkWaterSurfaceShader::IsClear(this);
  // opaque waters before clear ones, through which they are seen
  vtkProp** last = props.End;
  while (!isClear && last > self && vtkWaterSurfaceShader::IsClear(last[-1]))
  {
    --last;
  }
  auto mayFollow = [isClear](vtkProp* prop) {
    return isClear ? vtkWaterSurfaceShader::IsClear(prop) : prop->IsA("vtkWaterActor") != 0;
  };
  if (self == props.End || std::all_of(self, last, mayFollow))
  {
    return;
  }
  std::rotate(self, self + 1, last);
  // The renderer is in the middle of allotting times, by place; it has done this one.
  vtkProp* next = *self;
  const double mine = this->GetRenderTimeMultiplier();
  next->SetAllocatedRenderTime(
    mine > 0.0 ? this->AllocatedRenderTime * next->GetRenderTimeMultiplier() / mine : 0.0,
    renderer);
}

//------------------------------------------------------------------------------
bool vtkWaterActor::CanBeLate(vtkOpenGLRenderer* renderer)
{
  const int wanted = vtkWaterReflectionPass::HIDDEN_WATER | vtkWaterReflectionPass::PIXELS;
  return (this->OwnPass->GetSkips() & wanted) && !this->ComposedPass && !renderer->GetPass() &&
    !renderer->GetUseSSAO() && !renderer->GetUseShadows() && !renderer->GetUseHiddenLineRemoval() &&
    this->HasOpaqueGeometry() && Props(renderer).Has(this);
}

//------------------------------------------------------------------------------
bool vtkWaterActor::CanShareWith(vtkOpenGLRenderer* renderer, vtkWaterActor* other)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  if ((vtkWaterSurfaceShader::IsClear(this) || vtkWaterSurfaceShader::IsClear(other)) &&
    !camera->GetParallelProjection() &&
    (this->IsDisplaced() || this->Plane->FunctionValue(camera->GetPosition()) < 0.0))
  {
    return false; // which of them is the eye in?
  }
  vtkWaterProperty* mine = this->WaterProperty;
  vtkWaterProperty* its = other->WaterProperty;
  const bool isCalm = !mine->NeedsRays() && !its->NeedsRays();
  return !other->ComposedPass && !other->HasSheetError() &&
    vtkWaterGather::AreCoplanar(this, other) && this->OwnPass->DrawsAs(other->OwnPass) &&
    mine->GetReflectionSource() == its->GetReflectionSource() &&
    this->HasOpaqueGeometry() == other->HasOpaqueGeometry() &&
    this->IsDisplaced() == other->IsDisplaced() &&
    (isCalm || (mine == its && HaveSameOrigin(this, other)));
}

//------------------------------------------------------------------------------
void vtkWaterActor::FindSheets(vtkOpenGLRenderer* renderer)
{
  const vtkMTimeType frame = vtkWaterShaderHook::GetOfThread()->Keys.GetFrame(renderer);
  if (frame != 0 && this->SheetsFrame == frame && this->Leader)
  {
    return; // another sheet of this frame was first
  }
  this->Leader = this;
  this->SheetsFrame = frame;
  this->Sheets.assign(1, this);
  const bool canBeLate = this->CanBeLate(renderer);
  this->IsLate = canBeLate && this->IsWorthWaiting(renderer, { this });
  const Props props(renderer);
  if (!(this->OwnPass->GetSkips() & vtkWaterReflectionPass::SHARED_VIEWS) || this->ComposedPass ||
    !props.Has(this))
  {
    return;
  }
  // in the order of the scene, which drawing does not change
  std::vector<vtkWaterActor*> sheets;
  vtkPropCollection* all = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  all->InitTraversal(it);
  while (vtkProp* prop = all->GetNextProp(it))
  {
    auto* water = vtkWaterActor::SafeDownCast(prop);
    if (water && (water == this || (this->CanShareWith(renderer, water) && props.Has(water))))
    {
      sheets.push_back(water);
    }
  }
  if (sheets.size() < 2)
  {
    return;
  }
  const bool isLate = canBeLate && this->IsWorthWaiting(renderer, sheets);
  for (vtkWaterActor* water : sheets)
  {
    water->Leader = sheets.front();
    water->SheetsFrame = frame;
    water->Sheets.clear();
    water->IsLate = isLate;
  }
  sheets.front()->Sheets.assign(sheets.begin(), sheets.end());
}

//------------------------------------------------------------------------------
vtkWaterReflectionPass* vtkWaterActor::GetPassInCharge(vtkRenderer* renderer)
{
  const vtkMTimeType frame = vtkWaterShaderHook::GetOfThread()->Keys.GetFrame(renderer);
  const bool isLed = this->Leader && this->Leader != this && frame != 0 &&
    this->SheetsFrame == frame && !this->ComposedPass;
  return isLed ? this->Leader->OwnPass.Get() : this->GetReflectionPass();
}

//------------------------------------------------------------------------------
void vtkWaterActor::RenderSharedReflection(
  vtkOpenGLRenderer* renderer, const int viewport_px[2], bool isLate)
{
  vtkWaterActor* leader = this->Leader ? this->Leader.Get() : this;
  std::vector<vtkWaterActor*> sheets;
  for (const auto& sheet : leader->Sheets)
  {
    if (sheet)
    {
      sheets.push_back(sheet);
    }
  }
  vtkWaterReflectionPass::Moment moment;
  moment.IsHidden = isLate && this->AreSheetsHidden(renderer, sheets);
  // other waters hide, too, and need not say when they move
  moment.HasSceneDepth =
    isLate && std::count_if(Props(renderer).Begin, Props(renderer).End, [](vtkProp* prop) {
      return prop->IsA("vtkWaterActor") != 0;
    }) == static_cast<std::ptrdiff_t>(sheets.size());
  moment.Budget = this->FindBudget(renderer, sheets);
  leader->OwnPass->RenderReflection(renderer, sheets, viewport_px, moment);
  for (vtkWaterActor* water : sheets)
  {
    if (water != leader)
    {
      water->OwnPass->SetDecision(WATER_NO_REFLECT_SHARED);
    }
  }
}

//------------------------------------------------------------------------------
double vtkWaterActor::FindBudget(
  vtkOpenGLRenderer* renderer, const std::vector<vtkWaterActor*>& sheets)
{
  vtkWaterReflectionPass* pass = sheets.front()->OwnPass;
  if (pass->GetQuality() == vtkWaterReflectionPass::FIXED ||
    pass->GetQuality() == vtkWaterReflectionPass::TARGET_ERROR)
  {
    return 0.0;
  }
  const bool isByRate = pass->GetQuality() == vtkWaterReflectionPass::UPDATE_RATE;
  const double budget = isByRate
    ? water_quality_budget(renderer->GetRenderWindow()->GetDesiredUpdateRate())
    : pass->GetTimeBudget();
  // what was seen in the last frame of all that go by a budget, and which of them are ours
  std::vector<double> areas;
  std::vector<bool> areOurs;
  const Props props(renderer);
  std::for_each(props.Begin, props.End, [&](vtkProp* prop) {
    auto* water = vtkWaterActor::SafeDownCast(prop);
    if (water && water->OwnPass->GetQuality() == pass->GetQuality())
    {
      areas.push_back(static_cast<double>(
        water->OwnPass->GetOcclusion(renderer)->GetSamples(renderer->GetRenderWindow())));
      areOurs.push_back(std::find(sheets.begin(), sheets.end(), water) != sheets.end());
    }
  });
  std::vector<double> shares(areas.size(), 0.0);
  water_quality_share(areas.data(), areas.size(), budget, shares.data());
  double sum = 0.0;
  for (size_t i = 0; i < shares.size(); ++i)
  {
    sum += areOurs[i] ? shares[i] : 0.0;
  }
  return sum > 0.0 ? sum : budget; // nothing is known of the first frame
}

//------------------------------------------------------------------------------
bool vtkWaterActor::IsWorthWaiting(
  vtkOpenGLRenderer* renderer, const std::vector<vtkWaterActor*>& sheets)
{
  // What was seen in the last frame is the best guess at what is seen in this one. A wrong guess
  // costs time and shows nothing.
  vtkIdType visible = 0;
  for (vtkWaterActor* water : sheets)
  {
    const vtkIdType samples =
      water->OwnPass->GetOcclusion(renderer)->GetSamples(renderer->GetRenderWindow());
    if (samples < 0)
    {
      return false;
    }
    visible += samples;
  }
  return sheets.front()->OwnPass->ShouldWait(renderer, static_cast<double>(visible));
}

//------------------------------------------------------------------------------
bool vtkWaterActor::AreSheetsHidden(
  vtkOpenGLRenderer* renderer, const std::vector<vtkWaterActor*>& sheets)
{
  // Asking GL what is seen waits for all that was drawn. It is worth that only if the answer is
  // likely to be no, and it likely is what it was in the last frame.
  auto wasHidden = [renderer](vtkWaterActor* water) {
    return water->OwnPass->GetOcclusion(renderer)->GetSamples(renderer->GetRenderWindow()) == 0;
  };
  if (!(this->OwnPass->GetSkips() & vtkWaterReflectionPass::HIDDEN_WATER) ||
    !std::all_of(sheets.begin(), sheets.end(), wasHidden))
  {
    return false;
  }
  vtkOpenGLState* state = renderer->GetState();
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  auto isHidden = [renderer](vtkWaterActor* water) {
    water->GetBounds(); // lays the sheet where it is now; without cullers nobody has asked yet
    water->IsProbing = true;
    water->Superclass::RenderOpaqueGeometry(renderer);
    water->IsProbing = false;
    return water->OwnPass->GetOcclusion(renderer)->WaitForSamples() == 0;
  };
  return std::all_of(sheets.begin(), sheets.end(), isHidden);
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetAllocatedRenderTime(double seconds, vtkViewport* viewport)
{
  this->Superclass::SetAllocatedRenderTime(seconds, viewport);

  // The renderer calls this once per frame and eye for a prop that survived culling, before it
  // draws anything: the moment to draw the mirrored view, or to put it off until the scene before
  // the water is there.
  auto* renderer = vtkOpenGLRenderer::SafeDownCast(viewport);
  vtkWaterShaderHook* shading = vtkWaterShaderHook::GetOfThread();
  if (!renderer || !vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) ||
    shading->IsInMirroredView())
  {
    return;
  }
  if (renderer->GetSelector())
  {
    this->GetReflectionPass()->SetDecision(WATER_NO_REFLECT_SELECTING);
    return;
  }
  if (this->HasSheetError())
  {
    this->OwnPass->SetDecision(WATER_NO_REFLECT_FAILED);
    return;
  }
  const bool isComposed = vtkWaterReflectionPass::SafeDownCast(renderer->GetPass()) ||
    (this->ComposedPass && renderer->GetPass());
  if (!isComposed)
  {
    this->ComposedPass = nullptr;
    // the key is on all props from the beginning of the frame, or they build their shaders twice
    shading->Keys.HoldUntilEndOfFrame(renderer);
    this->FindSheets(renderer);
  }
  if (this->HasOpaqueGeometry())
  {
    this->DrawLast(renderer);
  }
  if (isComposed || this->IsLate)
  {
    return; // the pass draws before its delegate, if it takes charge of this water
  }
  if (renderer->GetUseImageBasedLighting() ||
    this->GetPassInCharge(renderer)->IsFresh(renderer, this))
  {
    return; // the textures of image-based light are loaded later: drawn nested
  }
  if (renderer->GetLightFollowCamera())
  {
    renderer->UpdateLightsGeometryToFollowCamera();
  }
  renderer->UpdateLights();
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  this->RenderSharedReflection(renderer, size, false);
}

//------------------------------------------------------------------------------
void vtkWaterActor::RenderReflectionIfStale(vtkViewport* viewport)
{
  auto* renderer = vtkOpenGLRenderer::SafeDownCast(viewport);
  vtkInformation* keys = this->GetPropertyKeys();
  vtkWaterShaderHook* shading = vtkWaterShaderHook::GetOfThread();
  if (!renderer || renderer->GetSelector() || shading->IsInMirroredView() || this->IsProbing ||
    vtkWaterRenderPassKeys::IsBakingShadows(this) || this->HasSheetError() ||
    this->GetPassInCharge(renderer)->IsFresh(renderer, this))
  {
    return;
  }
  if (keys && keys->Has(vtkOpenGLActor::GLDepthMaskOverride()))
  {
    return; // in the middle of depth peeling, whose framebuffers must stay bound
  }
  this->ComposedPass = nullptr; // it was taken out of the chain
  shading->Keys.HoldUntilEndOfFrame(renderer);
  this->FindSheets(renderer);
  if (this->GetPassInCharge(renderer)->IsFresh(renderer, this))
  {
    return;
  }
  int drawn[4]; // the size of what is being drawn into, whoever set it up
  renderer->GetState()->vtkglGetIntegerv(GL_VIEWPORT, drawn);
  if (this->IsLate && this->CanBeLate(renderer))
  {
    this->RenderSharedReflection(renderer, drawn + 2, true);
    return;
  }
  vtkWaterForeignKeysSuspended suspended(shading, renderer);
  this->RenderSharedReflection(renderer, drawn + 2, false);
}

//------------------------------------------------------------------------------
void vtkWaterActor::MendRefusals(vtkOpenGLRenderer* renderer)
{
  vtkWaterShaderHook* shading = vtkWaterShaderHook::GetOfThread();
  if (!renderer || renderer->GetSelector() || shading->IsInMirroredView() || this->IsProbing ||
    vtkWaterRenderPassKeys::IsBakingShadows(this))
  {
    return;
  }
  shading->Refusals.Settle();
  if (this->HasOpaqueGeometry() && shading->Refusals.HaveLost())
  {
    const Props props(renderer);
    std::for_each(props.Begin, props.End, [shading, renderer](vtkProp* prop) {
      if (shading->Refusals.TakeLost(prop))
      {
        prop->RenderOpaqueGeometry(renderer);
      }
    });
  }
  const std::string text = shading->Refusals.TakeText();
  if (!text.empty())
  {
    vtkErrorMacro(<< text);
  }
}
VTK_ABI_NAMESPACE_END
