// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterReflectionPass.h"

#include "vtkCamera.h"
#include "vtkHardwareSelector.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkTextureObject.h"
#include "vtkTimerLog.h"
#include "vtkWaterActor.h"
#include "vtkWaterCompat.h"
#include "vtkWaterErrors.h"
#include "vtkWaterGather.h"
#include "vtkWaterMirror.h"
#include "vtkWaterOcclusion.h"
#include "vtkWaterShading.h"
#include "vtkWaterSignature.h"
#include "water_plan.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <set>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkWaterReflectionPass);
vtkInformationKeyMacro(vtkWaterReflectionPass, NOT_REFLECTED, Integer);
vtkInformationKeyRestrictedMacro(vtkWaterReflectionPass, STAND_IN, ObjectBase, "vtkProp");

static_assert(static_cast<int>(vtkWaterReflectionPass::TOO_SMALL) == WATER_SKIP_TOO_SMALL &&
    static_cast<int>(vtkWaterReflectionPass::NUMBER_OF_FATES) == WATER_FATE_COUNT,
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
}

//------------------------------------------------------------------------------
struct vtkWaterReflectionPass::Internals
{
  struct View // what belongs to one eye of a renderer
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    vtkWaterMirror Mirror;
    water_plan MapPlan = water_plan(); // what the mirror shows was drawn by it
    vtkWaterSignature MapSignature;
    bool MapHasLevels = false;
    vtkWaterOcclusion Occlusion;
  };
  using Eye = std::pair<vtkRenderer*, bool>; // is it the second of two?

  std::map<Eye, std::shared_ptr<View>> Views; // shared: a view in use outlives its release
  vtkWaterGather Gather;
  std::vector<water_fate> Fates;
  int FateCounts[WATER_FATE_COUNT] = {};
  water_plan Plan = water_plan();
  vtkWeakPointer<vtkRenderer> PlannedFor;
  bool PlannedForSecondEye = false;
  std::vector<vtkWaterActor*> PlannedWaters; // compared only
  vtkMTimeType PlannedFrame = 0;
  std::set<vtkRenderer*> Rendering; // in the middle of Render
  bool HasCycle = false;
  bool IsVisiting = false; // the chain of delegates

  static bool IsSecondEye(vtkRenderer* renderer)
  {
    vtkCamera* camera = renderer->GetActiveCamera();
    return camera->GetStereo() && !camera->GetLeftEye();
  }

  std::shared_ptr<View> GetView(vtkRenderer* renderer)
  {
    const Eye eye(renderer, IsSecondEye(renderer));
    for (auto it = this->Views.begin(); it != this->Views.end();)
    {
      it = it->second->Renderer || it->first == eye ? std::next(it) : this->Views.erase(it);
    }
    std::shared_ptr<View>& view = this->Views[eye];
    if (!view)
    {
      view = std::make_shared<View>();
    }
    view->Renderer = renderer;
    return view;
  }

  View* GetPlannedView()
  {
    auto found = this->Views.find(Eye(this->PlannedFor, this->PlannedForSecondEye));
    return found == this->Views.end() ? nullptr : found->second.get();
  }

  // What the instruments of the planned view say, with the context that they measured in: another
  // window's may be current.
  template <typename Value, typename Question>
  Value Ask(Value none, Question question)
  {
    View* view = this->GetPlannedView();
    vtkRenderer* renderer = view ? view->Renderer.Get() : nullptr;
    auto* window =
      vtkOpenGLRenderWindow::SafeDownCast(renderer ? renderer->GetRenderWindow() : nullptr);
    if (!window)
    {
      return none;
    }
    window->PushContext();
    const Value value = question(view->Mirror.GetInstruments());
    window->PopContext();
    return value;
  }
};

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
void vtkWaterReflectionPass::SetDelegatePass(vtkRenderPass* pass)
{
  if (pass == this)
  {
    vtkErrorMacro("DelegatePass is the pass itself; it must be another pass. It stays as it was.");
  }
  else if (this->DelegatePass != pass)
  {
    this->DelegatePass = pass;
    this->Internal->HasCycle = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkWaterReflectionPass::GetDelegatePass()
{
  return this->DelegatePass;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetTextureScale(double scale)
{
  vtkWaterSetInRange(TextureScale, scale, 1.0 / 64.0, 16.0);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetMultiSamples(int samples)
{
  vtkWaterSetInRange(MultiSamples, samples, -1, 32);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetColorPrecision(int precision)
{
  vtkWaterSetInRange(ColorPrecision, precision, AUTOMATIC, HALF_FLOAT);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetClipMargin(double margin)
{
  vtkWaterSetInRange(ClipMargin, margin, 0.0, std::numeric_limits<double>::max());
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetSkips(int skips)
{
  vtkWaterSetInRange(Skips, skips, SKIP_NONE, SKIP_ALL);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetMinimumPropSize(double pixels)
{
  vtkWaterSetInRange(MinimumPropSize, pixels, 0.0, std::numeric_limits<double>::max());
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetReflectanceError(double share)
{
  vtkWaterSetInRange(ReflectanceError, share, 0.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetGuardBand(double band)
{
  if (!(band == 0.0 || (band >= 1.0 && band <= 2.0)))
  {
    vtkErrorMacro("GuardBand is " << band
                                  << "; it must lie in [1, 2], or be 0 (by the waves' slope). "
                                  << "It stays " << this->GuardBand << ".");
  }
  else if (this->GuardBand != band)
  {
    this->GuardBand = band;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterReflectionPass::GetReflectionTexture()
{
  Internals::View* view = this->Internal->GetPlannedView();
  return view ? view->Mirror.GetColor() : nullptr;
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterReflectionPass::GetReflectionDepthTexture()
{
  Internals::View* view = this->Internal->GetPlannedView();
  return view ? view->Mirror.GetDepth() : nullptr;
}

//------------------------------------------------------------------------------
int vtkWaterReflectionPass::GetFateCount(int fate) const
{
  return fate >= 0 && fate < WATER_FATE_COUNT ? this->Internal->FateCounts[fate] : 0;
}

//------------------------------------------------------------------------------
const char* vtkWaterReflectionPass::GetFateAsString(int fate)
{
  return water_fate_text(static_cast<water_fate>(fate));
}

//------------------------------------------------------------------------------
int vtkWaterReflectionPass::GetDecision() const
{
  return this->Internal->Plan.decision;
}

//------------------------------------------------------------------------------
const char* vtkWaterReflectionPass::GetDecisionAsString() const
{
  return water_decision_text(this->Internal->Plan.decision);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetInstrumentation(bool instrumentation)
{
  // no modification: it changes nothing that is rendered
  this->Instrumentation = instrumentation;
  if (!instrumentation)
  {
    this->LastGatherTime = this->LastPlanTime = vtkMath::Nan();
  }
}

//------------------------------------------------------------------------------
double vtkWaterReflectionPass::GetLastReflectionTime()
{
  return this->Internal->Ask(vtkMath::Nan(), [](vtkWaterInstruments& instruments) {
    return instruments.GetTime(vtkWaterInstruments::REFLECTION);
  });
}

//------------------------------------------------------------------------------
double vtkWaterReflectionPass::GetLastSurfaceTime()
{
  return this->Internal->Ask(vtkMath::Nan(), [](vtkWaterInstruments& instruments) {
    return instruments.GetTime(vtkWaterInstruments::SURFACE);
  });
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterReflectionPass::GetNumberOfTrianglesReflected()
{
  return this->Internal->Ask(
    vtkIdType(-1), [](vtkWaterInstruments& instruments) { return instruments.GetTriangles(); });
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterReflectionPass::GetNumberOfFragmentsReflected()
{
  return this->Internal->Ask(
    vtkIdType(-1), [](vtkWaterInstruments& instruments) { return instruments.GetFragments(); });
}

//------------------------------------------------------------------------------
vtkWaterInstruments* vtkWaterReflectionPass::GetInstruments(vtkRenderer* renderer)
{
  vtkWaterInstruments* instruments = &this->Internal->GetView(renderer)->Mirror.GetInstruments();
  instruments->SetOn(this->Instrumentation);
  return instruments;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetDecision(int decision)
{
  this->Internal->Plan.decision = static_cast<water_decision>(decision);
  this->Internal->Plan.has_view = false;
}

//------------------------------------------------------------------------------
bool vtkWaterReflectionPass::DrawsAs(vtkWaterReflectionPass* other) const
{
  return this->TextureScale == other->TextureScale && this->MultiSamples == other->MultiSamples &&
    this->ColorPrecision == other->ColorPrecision && this->ClipMargin == other->ClipMargin &&
    this->GuardBand == other->GuardBand && this->Skips == other->Skips &&
    this->MinimumPropSize == other->MinimumPropSize &&
    this->ReflectanceError == other->ReflectanceError;
}

//------------------------------------------------------------------------------
vtkWaterOcclusion* vtkWaterReflectionPass::GetOcclusion(vtkRenderer* renderer)
{
  return &this->Internal->GetView(renderer)->Occlusion;
}

//------------------------------------------------------------------------------
bool vtkWaterReflectionPass::DoesMaskPay(vtkRenderer* renderer, double visible_px)
{
  return water_plan_mask_pays(&this->Internal->GetView(renderer)->MapPlan, visible_px);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::RenderReflection(vtkRenderer* renderer,
  const std::vector<vtkWaterActor*>& waters, const int viewport_px[2], const Moment& moment)
{
  // drawing runs the user's observers, who may drop any of these
  const vtkSmartPointer<vtkWaterReflectionPass> self = this;
  const std::vector<vtkSmartPointer<vtkWaterActor>> held(waters.begin(), waters.end());
  Internals& internal = *this->Internal;
  vtkWaterShading* shading = vtkWaterShading::GetOfThread();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  shading->Keys.HoldUntilEndOfFrame(renderer);

  // gather
  const double begun = this->Instrumentation ? vtkTimerLog::GetUniversalTime() : 0.0;
  vtkWaterGather& gather = internal.Gather;
  gather.Read(renderer, waters, viewport_px);
  window->MakeCurrent(); // bringing pipelines up to date may have rendered another window
  gather.scene.texture_scale = this->TextureScale;
  gather.scene.clip_margin = this->ClipMargin;
  gather.scene.guard_band = this->GuardBand;
  gather.scene.skips = static_cast<unsigned>(this->Skips);
  gather.scene.prop_px_min = this->MinimumPropSize;
  gather.scene.reflectance_error = this->ReflectanceError;
  gather.scene.is_hidden = moment.IsHidden;
  gather.scene.has_scene_depth = moment.HasSceneDepth;
  gather.scene.max_texture_px = vtkTextureObject::GetMaximumTextureSize(window);

  // plan
  const double gathered = this->Instrumentation ? vtkTimerLog::GetUniversalTime() : 0.0;
  internal.Fates.assign(gather.props.size(), WATER_DRAW);
  const water_status status = water_plan_make(&gather.scene, &internal.Plan, internal.Fates.data());
  if (this->Instrumentation)
  {
    this->LastGatherTime = 1000.0 * (gathered - begun);
    this->LastPlanTime = 1000.0 * (vtkTimerLog::GetUniversalTime() - gathered);
    this->GetInstruments(renderer);
  }
  internal.PlannedFor = renderer;
  internal.PlannedForSecondEye = Internals::IsSecondEye(renderer);
  internal.PlannedWaters = waters;
  internal.PlannedFrame = shading->Keys.GetFrame(renderer);
  vtkWaterError error;
  if (status != WATER_OK)
  {
    error = vtkWaterDescribe(status, waters.front(), &gather, &internal.Plan);
  }
  std::fill(internal.FateCounts, internal.FateCounts + WATER_FATE_COUNT, 0);

  // draw
  if (internal.Plan.decision == WATER_REFLECT)
  {
    std::vector<vtkProp*> drawn;
    for (size_t i = 0; i < internal.Fates.size(); ++i)
    {
      ++internal.FateCounts[internal.Fates[i]];
      if (internal.Fates[i] == WATER_DRAW)
      {
        drawn.push_back(gather.vtkProps[i]);
        if (drawn.back()->IsA("vtkLODProp3D"))
        {
          // It chooses its level here, which the renderer has not come to yet, and never does for
          // a prop that only the mirror sees.
          drawn.back()->SetAllocatedRenderTime(waters.front()->GetAllocatedRenderTime(), renderer);
        }
      }
    }
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
    water_plan_reuse(&view->MapPlan, signature.IsSameAs(view->MapSignature),
      static_cast<unsigned>(this->Skips), &internal.Plan);
    const char* failure = nullptr;
    if (internal.Plan.decision == WATER_REFLECT)
    {
      view->MapPlan = water_plan();
      view->MapHasLevels = false;
      failure = view->Mirror.Draw(renderer, shading, internal.Plan, drawn,
        samples > 1 ? samples : 0, isFloat, (this->Skips & PIECES) != 0);
    }
    if (internal.GetPlannedView() != view.get())
    {
      view->Mirror.ReleaseGraphicsResources(window); // was wanted in the middle of it
      this->SetDecision(WATER_NOT_PLANNED);
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
        view->MapPlan = internal.Plan;
        view->MapSignature = signature;
      }
      if (gather.IsRough && !view->MapHasLevels)
      {
        view->Mirror.MakeLevels();
        view->MapHasLevels = true;
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
    internal.PlannedFrame != vtkWaterShading::GetOfThread()->Keys.GetFrame(renderer) ||
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
const water_plan* vtkWaterReflectionPass::GetFreshPlan(
  vtkRenderer* renderer, vtkWaterActor* water) const
{
  return this->Internal->Plan.has_view && this->IsFresh(renderer, water) ? &this->Internal->Plan
                                                                         : nullptr;
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterReflectionPass::GetTexture(vtkRenderer* renderer, vtkWaterActor* water)
{
  vtkWaterMirror& mirror = this->Internal->GetView(renderer)->Mirror;
  const water_plan* plan = this->GetFreshPlan(renderer, water);
  return plan && water_plan_has_map(plan)
    ? mirror.GetColor()
    : mirror.GetBlank(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
}

//------------------------------------------------------------------------------
vtkWaterScreen* vtkWaterReflectionPass::GetScreen(vtkRenderer* renderer)
{
  return &this->Internal->GetView(renderer)->Mirror.GetScreen();
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::RenderCorner(vtkRenderer* renderer, vtkWaterActor* water)
{
  const water_plan* plan = this->GetFreshPlan(renderer, water);
  if (plan && water_plan_has_map(plan))
  {
    vtkWaterMirror& mirror = this->Internal->GetView(renderer)->Mirror;
    mirror.GetScreen().DrawCorner(renderer, mirror.GetColor());
  }
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::Render(const vtkRenderState* s)
{
  Internals& internal = *this->Internal;
  vtkRenderer* renderer = s->GetRenderer();
  if (!internal.Rendering.insert(renderer).second)
  {
    if (!internal.HasCycle)
    {
      vtkErrorMacro("DelegatePass leads back to this pass; the chain must end in another pass. "
                    "Nothing is rendered at its end.");
    }
    internal.HasCycle = true; // until another delegate is set
    return;
  }
  this->RenderReflectionAndDelegate(s);
  internal.Rendering.erase(renderer);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::RenderReflectionAndDelegate(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  if (vtkHardwareSelector* selector = renderer->GetSelector())
  {
    // VTK leaves selection to the renderer's own path, which a pass replaces
    renderer->GetActiveCamera()->Render(renderer);
    this->NumberOfRenderedProps =
      selector->Render(renderer, s->GetPropArray(), s->GetPropArrayCount());
    this->SetDecision(WATER_NO_REFLECT_SELECTING);
    return;
  }
  if (!s->GetFrameBuffer() &&
    renderer->GetActiveCamera()->GetStereo() != renderer->GetRenderWindow()->GetStereoRender())
  {
    // only the camera's Render lets it know of stereo, and passes do not call it
    renderer->GetActiveCamera()->Render(renderer);
  }

  const std::vector<vtkWaterActor*> waters =
    vtkWaterGather::FindWaters(s->GetPropArray(), s->GetPropArrayCount());
  if (!waters.empty())
  {
    for (vtkWaterActor* water : waters)
    {
      water->ComposedPass = this;
    }
    int size[2];
    if (s->GetFrameBuffer())
    {
      s->GetWindowSize(size);
    }
    else
    {
      int origin[2];
      renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
    }
    if (renderer->GetLightFollowCamera())
    {
      renderer->UpdateLightsGeometryToFollowCamera();
    }
    static_cast<vtkOpenGLRenderer*>(renderer)->UpdateLights();
    this->RenderReflection(renderer, waters, size, Moment());
  }

  vtkSmartPointer<vtkRenderPass> delegate = this->DelegatePass;
  if (!delegate)
  {
    if (!this->DefaultDelegate)
    {
      this->DefaultDelegate = vtkSmartPointer<vtkRenderStepsPass>::New();
    }
    delegate = this->DefaultDelegate;
  }
  delegate->Render(s);
  this->NumberOfRenderedProps = delegate->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& internal = *this->Internal;
  if (internal.IsVisiting)
  {
    return; // the chain of delegates leads back to this pass
  }
  internal.IsVisiting = true;
  for (vtkRenderPass* delegate : { this->DelegatePass.Get(), this->DefaultDelegate.Get() })
  {
    if (delegate)
    {
      delegate->ReleaseGraphicsResources(window);
    }
  }
  internal.IsVisiting = false;
  for (auto it = internal.Views.begin(); it != internal.Views.end();)
  {
    vtkRenderer* renderer = it->second->Renderer;
    if (!renderer || !window || renderer->GetRenderWindow() == window ||
      !renderer->GetRenderWindow())
    {
      const std::shared_ptr<Internals::View> view = it->second;
      it = internal.Views.erase(it);
      internal.PlannedFrame = renderer == internal.PlannedFor ? 0 : internal.PlannedFrame;
      if (!view->Mirror.GetIsDrawing()) // else RenderReflection does it
      {
        view->Mirror.ReleaseGraphicsResources(window);
      }
      if (window)
      {
        view->Occlusion.ReleaseGraphicsResources();
      }
    }
    else
    {
      ++it;
    }
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DelegatePass: ";
  if (!this->DelegatePass)
  {
    os << "(none)\n";
  }
  else if (this->Internal->IsVisiting)
  {
    os << "leads back to this pass\n";
  }
  else
  {
    os << "\n";
    this->Internal->IsVisiting = true;
    this->DelegatePass->PrintSelf(os, indent.GetNextIndent());
    this->Internal->IsVisiting = false;
  }
  os << indent << "TextureScale: " << this->TextureScale << "\n";
  os << indent << "MultiSamples: " << this->MultiSamples << "\n";
  os << indent << "ColorPrecision: " << this->ColorPrecision << "\n";
  os << indent << "ClipMargin: " << this->ClipMargin << "\n";
  os << indent << "GuardBand: " << this->GuardBand << "\n";
  os << indent << "Skips: " << this->Skips << "\n";
  os << indent << "MinimumPropSize: " << this->MinimumPropSize << "\n";
  os << indent << "ReflectanceError: " << this->ReflectanceError << "\n";
  os << indent << "Instrumentation: " << (this->Instrumentation ? "on" : "off") << "\n";
  if (this->Instrumentation)
  {
    const vtkIndent next = indent.GetNextIndent();
    os << next << "LastGatherTime: " << this->LastGatherTime << " ms\n";
    os << next << "LastPlanTime: " << this->LastPlanTime << " ms\n";
    os << next << "LastReflectionTime: " << this->GetLastReflectionTime() << " ms\n";
    os << next << "LastSurfaceTime: " << this->GetLastSurfaceTime() << " ms\n";
    os << next << "TrianglesReflected: " << this->GetNumberOfTrianglesReflected() << "\n";
    os << next << "FragmentsReflected: " << this->GetNumberOfFragmentsReflected() << "\n";
  }
  os << indent << "ShowReflection: " << (this->ShowReflection ? "on" : "off") << "\n";
  os << indent << "NumberOfReflectionRenders: " << this->NumberOfReflectionRenders << "\n";
  os << indent << "Last plan: " << this->GetDecisionAsString() << "\n";
  const water_plan& plan = this->Internal->Plan;
  if (water_plan_has_map(&plan))
  {
    const vtkIndent next = indent.GetNextIndent();
    os << next << "Texture: " << plan.texture_px[0] << " x " << plan.texture_px[1]
       << " pixels, drawn in " << plan.texture_rect_px[2] << " x " << plan.texture_rect_px[3]
       << " at (" << plan.texture_rect_px[0] << ", " << plan.texture_rect_px[1] << ")\n";
    os << next << "Seen from " << (plan.side == WATER_BELOW ? "below" : "above") << "\n";
    for (int fate = 0; fate < WATER_FATE_COUNT; ++fate)
    {
      os << next << "Props " << GetFateAsString(fate) << ": " << this->GetFateCount(fate) << "\n";
    }
  }
}
VTK_ABI_NAMESPACE_END
