// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFrame.cxx: when a frame begins and ends, and what a water does in it; which sheets share
// a mirrored view is in vtkWaterFrameGroups.cxx.
#include "vtkWaterFrame.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkPropCollection.h"
#include "vtkRenderPass.h"
#include "vtkWaterFrameThread.h"
#include "vtkWaterGL.h"
#include "vtkWaterPasses.h"
#include "vtkWaterProps.h"
#include "vtkWaterReflection.h"
#include "vtkWaterRenderPassKeys.h"
#include "vtkWaterRendererClass.h"
#include "vtkWaterSea.h"
#include "vtkWaterShaderHook.h"
#include "vtkWaterSource.h"
#include "water_plan.h"

#include <algorithm>
#include <limits>

namespace
{
bool IsPeeling(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys && keys->Has(vtkOpenGLActor::GLDepthMaskOverride());
}
}

//------------------------------------------------------------------------------
vtkWaterFrame::~vtkWaterFrame()
{
  if (this->Renderer && this->RanksObserver)
  {
    this->Renderer->RemoveObserver(this->RanksObserver);
  }
  this->End();
}

//------------------------------------------------------------------------------
vtkWaterFrame& vtkWaterFrame::Of(vtkRenderer* renderer)
{
  std::unique_ptr<vtkWaterFrame>& frame = vtkWaterFrameThread::Get().Frames[renderer];
  if (!frame || !frame->Renderer) // or it was of another renderer, at the same place
  {
    frame = std::make_unique<vtkWaterFrame>();
    frame->Renderer = vtkOpenGLRenderer::SafeDownCast(renderer);
  }
  return *frame;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkWaterFrame::NumberOf(vtkRenderer* renderer)
{
  const auto& frames = vtkWaterFrameThread::Get().Frames;
  const auto found = frames.find(renderer);
  return found != frames.end() ? found->second->GetNumber() : 0;
}

//------------------------------------------------------------------------------
vtkWaterShaderHook* vtkWaterFrame::GetHook()
{
  return vtkWaterFrameThread::Get().Hook;
}

//------------------------------------------------------------------------------
vtkOpenGLRenderer* vtkWaterFrame::FindMainView(vtkViewport* viewport)
{
  auto* renderer = vtkOpenGLRenderer::SafeDownCast(viewport);
  return renderer && !renderer->GetSelector() && !GetHook()->IsInMirroredView() ? renderer
                                                                                : nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterFrame::Begin(vtkWaterSource& water)
{
  vtkWaterFrameThread& thread = vtkWaterFrameThread::Get();
  thread.Prune();
  if (this->GetNumber())
  {
    return; // another water of this frame was first
  }
  vtkRenderer* renderer = this->Renderer;
  this->End(); // somebody removed the observer
  this->Records.Begin(renderer, thread.Hook);
  thread.Hook->Records = &this->Records;
  const std::vector<vtkProp*>& others = this->Records.GetOthers();
  std::for_each(others.begin(), others.end(), vtkWaterProps::DropOwnStandIn);
  thread.SwitchTo(renderer, others);
  // before any prop asks for its shader
  thread.Hook->CanClip = this->ClipsWell(water.GetProp());
  this->Number.Modified();
  const auto addKey = [&](vtkProp* prop) {
    if (prop->GetVisibility() && !vtkWaterRenderPassKeys::Has(prop, thread.Hook))
    {
      vtkWaterRenderPassKeys::Add(prop, thread.Hook);
      this->Keyed.emplace_back(prop);
    }
  };
  for (vtkProp* prop : others)
  {
    vtkWaterProps::ForEachOf(prop, addKey);
  }
  this->Observer = vtkSmartPointer<vtkCallbackCommand>::New();
  this->Observer->SetClientData(this);
  this->Observer->SetCallback([](vtkObject* caller, unsigned long event, void* frame, void*) {
    auto* self = static_cast<vtkWaterFrame*>(frame);
    self->End();
    if (event == vtkCommand::EndEvent && self->Records.AreElsewhere())
    {
      auto* ended = static_cast<vtkRenderer*>(caller);
      vtkWaterFrameThread::PrepareForNewWindows(ended, self->Records.FindOthers(ended));
    }
  });
  // before the user's observers, which may abort the event; a frame that begins has ended the last
  const float first = std::numeric_limits<float>::max();
  renderer->AddObserver(vtkCommand::StartEvent, this->Observer, first);
  renderer->AddObserver(vtkCommand::EndEvent, this->Observer, first);
}

//------------------------------------------------------------------------------
void vtkWaterFrame::End()
{
  // what dies with its last reference may run the user's code, so all else comes first
  const auto snapshots = std::move(this->Snapshots);
  this->Snapshots.clear();
  if (GetHook()->Records == &this->Records)
  {
    GetHook()->Records = nullptr;
  }
  const auto held = this->Records.End();
  const auto props = std::move(this->Keyed);
  this->Keyed.clear();
  for (vtkProp* prop : props)
  {
    vtkWaterRenderPassKeys::Remove(prop, GetHook());
  }
  // the callback of an observer may be this one's
  const vtkSmartPointer<vtkCallbackCommand> observer = this->Observer;
  this->Observer = nullptr;
  if (this->Renderer && observer)
  {
    this->Renderer->RemoveObserver(observer);
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkWaterFrame::GetNumber() const
{
  return this->Renderer && this->Observer &&
      this->Renderer->HasObserver(vtkCommand::EndEvent, this->Observer)
    ? this->Number.GetMTime()
    : 0;
}

//------------------------------------------------------------------------------
bool vtkWaterFrame::IsSoftware()
{
  vtkRenderWindow* window = this->Renderer->GetRenderWindow();
  if (window != this->SoftwareWindow)
  {
    this->SoftwareWindow = window;
    this->IsSoftwareWindow = vtkWaterRendererClass::IsSoftware();
  }
  return this->IsSoftwareWindow;
}

//------------------------------------------------------------------------------
bool vtkWaterFrame::ClipsWell(vtkProp* water)
{
  return vtkWaterFrameThread::Get().ClipProbe.Works(
    static_cast<vtkOpenGLRenderWindow*>(this->Renderer->GetRenderWindow()), water);
}

//------------------------------------------------------------------------------
void vtkWaterFrame::Allot(vtkWaterSource& water)
{
  vtkWaterReflection* composed = water.GetComposedReflection();
  vtkRenderPass* pass = this->Renderer->GetPass();
  if (this->Renderer->GetSelector())
  {
    (composed ? *composed : water.GetOwnReflection()).Decline(WATER_NO_REFLECT_SELECTING);
    return;
  }
  vtkWaterReflection& reflection = composed ? *composed : water.GetOwnReflection();
  if (reflection.Ranks.AreSeveral())
  {
    this->Begin(water);
    this->Agree(reflection);
    water.GetProp()->GetBounds(); // lays the sheet over the scene of all ranks
  }
  else
  {
    water.SetSceneBounds(nullptr);
  }
  if (IsLeftOut(water))
  {
    water.GetOwnReflection().Decline(WATER_NO_REFLECT_FAILED);
    return;
  }
  const bool isComposed = pass && (pass->IsA("vtkWaterReflectionPass") || composed);
  bool isLate = false;
  if (!isComposed)
  {
    water.SetComposedPass(nullptr);
    // the key is on all props from the beginning of the frame, or they build their shaders twice
    this->Begin(water);
    isLate = this->EnsureGroup(water).IsLate;
    this->BeginSea(water);
  }
  if (water.GetProp()->HasOpaqueGeometry())
  {
    this->DrawLast(water);
  }
  if (!isComposed && !isLate) // else the pass draws before its delegate, or the water before itself
  {
    this->RenderBeforeFrame(water);
  }
}

//------------------------------------------------------------------------------
void vtkWaterFrame::BeginSea(vtkWaterSource& water)
{
  if (this->IsSoftware())
  {
    return;
  }
  const vtkWaterSnapshotPointer snapshot = water.Take(this->Renderer);
  if (snapshot->Features & WATER_FEATURE_SEA)
  {
    snapshot->Sea->Begin(static_cast<vtkOpenGLRenderWindow*>(this->Renderer->GetRenderWindow()),
      snapshot->Look.Cascades, snapshot->Look.Sea, snapshot->Time, snapshot->GetSeaFields());
  }
}

//------------------------------------------------------------------------------
void vtkWaterFrame::RenderBeforeFrame(vtkWaterSource& water)
{
  if (this->Renderer->GetUseImageBasedLighting() || this->IsFresh(water))
  {
    return; // the textures of image-based light are loaded later: drawn nested
  }
  if (this->Renderer->GetLightFollowCamera())
  {
    this->Renderer->UpdateLightsGeometryToFollowCamera();
  }
  this->Renderer->UpdateLights();
  int size[2];
  int origin[2];
  this->Renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  this->RenderShared(water, size, false);
}

//------------------------------------------------------------------------------
void vtkWaterFrame::Prepare(vtkWaterSource& water)
{
  if (vtkWaterRenderPassKeys::IsBakingShadows(water.GetProp()) || IsLeftOut(water) ||
    this->IsFresh(water) || IsPeeling(water.GetProp())) // whose framebuffers must stay bound
  {
    return;
  }
  water.SetComposedPass(nullptr); // it was taken out of the chain
  this->Begin(water);
  const bool isLate = this->EnsureGroup(water).IsLate;
  if (this->IsFresh(water))
  {
    return;
  }
  int drawn[4]; // the size of what is being drawn into, whoever set it up
  this->Renderer->GetState()->vtkglGetIntegerv(GL_VIEWPORT, drawn);
  if (isLate && this->CanBeLate(water))
  {
    this->RenderShared(water, drawn + 2, true);
    return;
  }
  vtkWaterForeignKeysSuspended suspended(GetHook(), this->Renderer);
  this->RenderShared(water, drawn + 2, false);
}

//------------------------------------------------------------------------------
void vtkWaterFrame::RenderComposed(vtkWaterReflection& reflection,
  const std::vector<vtkWaterSource*>& waters, const int viewport_px[2])
{
  this->Begin(*waters.front());
  vtkWaterReflection::Frame frame;
  frame.Renderer = this->Renderer;
  frame.Number = this->GetNumber();
  frame.Hook = GetHook();
  frame.Records = &this->Records;
  std::copy_n(viewport_px, 2, frame.Viewport_px);
  frame.Hints.IsSoftware = this->IsSoftware();
  frame.Hints.MayToneMap = vtkWaterPasses::MayKeepFloats(this->Renderer->GetPass());
  frame.RanksError = this->Agree(reflection) ? nullptr : &this->RanksError;
  this->AreAgreed = reflection.Render(frame, waters) && this->AreAgreed;
}

//------------------------------------------------------------------------------
bool vtkWaterFrame::IsFresh(vtkWaterSource& water)
{
  return this->GetReflection(water).IsFresh(this->Renderer, this->GetNumber(), water.GetProp());
}

//------------------------------------------------------------------------------
bool vtkWaterFrame::IsUnseen(vtkWaterSource& water)
{
  return this->GetReflection(water).IsUnseen(this->Renderer, this->GetNumber(), water.GetProp());
}

//------------------------------------------------------------------------------
vtkWaterSurfaceShader::Inputs vtkWaterFrame::GetInputs(vtkWaterSource& water)
{
  return this->GetReflection(water).GetInputs(this->Renderer, this->GetNumber(), water.GetProp());
}

//------------------------------------------------------------------------------
bool vtkWaterFrame::BeginFog(const water_plan& plan)
{
  const vtkMTimeType number = this->GetNumber();
  if (number == this->FogNumber && std::equal(plan.dir_to_eye, plan.dir_to_eye + 12, this->FogEye))
  {
    return false;
  }
  this->FogNumber = number;
  std::copy(plan.dir_to_eye, plan.dir_to_eye + 12, this->FogEye);
  return true;
}

//------------------------------------------------------------------------------
std::string vtkWaterFrame::MendFailures(vtkWaterSource& water)
{
  vtkWaterShaderFailures& failures = GetHook()->Failures;
  failures.Judge();
  if (water.GetProp()->HasOpaqueGeometry() && failures.HaveLost())
  {
    vtkRenderer* renderer = this->Renderer;
    const vtkWaterDrawnProps props(renderer);
    std::for_each(props.Begin, props.End, [&failures, renderer](vtkProp* prop) {
      if (failures.TakeLost(prop))
      {
        prop->RenderOpaqueGeometry(renderer);
      }
    });
  }
  return failures.TakeText();
}
