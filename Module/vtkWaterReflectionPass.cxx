// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterReflectionPass.h"

#include "vtkCamera.h"
#include "vtkHardwareSelector.h"
#include "vtkInformationIntegerKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkTextureObject.h"
#include "vtkWaterActor.h"
#include "vtkWaterCompat.h"
#include "vtkWaterErrors.h"
#include "vtkWaterGather.h"
#include "vtkWaterMirror.h"
#include "vtkWaterShading.h"
#include "water_plan.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkWaterReflectionPass);
vtkInformationKeyMacro(vtkWaterReflectionPass, NOT_REFLECTED, Integer);

static_assert(static_cast<int>(vtkWaterReflectionPass::OUT_OF_VIEW) == WATER_SKIP_OUT_OF_VIEW &&
    static_cast<int>(vtkWaterReflectionPass::NUMBER_OF_FATES) == WATER_FATE_COUNT,
  "the public fates mirror the core's");
static_assert(
  static_cast<int>(vtkWaterReflectionPass::NO_REFLECTANCE) == WATER_NO_REFLECT_NO_REFLECTANCE &&
    static_cast<int>(vtkWaterReflectionPass::NUMBER_OF_DECISIONS) == WATER_DECISION_COUNT,
  "the public decisions mirror the core's");

namespace
{
constexpr int kMaximumDefaultSamples = 8; // more is slow and not seen in a reflection
}

//------------------------------------------------------------------------------
struct vtkWaterReflectionPass::Internals
{
  struct View // what belongs to one renderer
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    vtkWaterMirror Mirror;
  };

  std::map<vtkRenderer*, View> Views;
  vtkSmartPointer<vtkWaterShading> Shading = vtkWaterShading::GetShared();
  vtkWaterGather Gather;
  std::vector<water_fate> Fates;
  int FateCounts[WATER_FATE_COUNT] = {};
  water_plan Plan = water_plan();
  vtkWeakPointer<vtkRenderer> PlannedFor;
  unsigned long PlannedFrame = 0;

  View& GetView(vtkRenderer* renderer)
  {
    for (auto it = this->Views.begin(); it != this->Views.end();)
    {
      it = it->second.Renderer || it->first == renderer ? std::next(it) : this->Views.erase(it);
    }
    View& view = this->Views[renderer];
    view.Renderer = renderer;
    return view;
  }

  View* GetPlannedView()
  {
    auto found = this->Views.find(this->PlannedFor);
    return found == this->Views.end() ? nullptr : &found->second;
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
void vtkWaterReflectionPass::SetClipMargin(double margin)
{
  vtkWaterSetInRange(ClipMargin, margin, 0.0, std::numeric_limits<double>::max());
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
void vtkWaterReflectionPass::SetDecision(int decision)
{
  this->Internal->Plan.decision = static_cast<water_decision>(decision);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::RenderReflection(
  vtkRenderer* renderer, const std::vector<vtkWaterActor*>& waters, const int viewport_px[2])
{
  Internals& internal = *this->Internal;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  internal.Shading->Keys.HoldUntilEndOfFrame(renderer);

  // gather
  vtkWaterGather& gather = internal.Gather;
  gather.Read(renderer, waters, viewport_px);
  window->MakeCurrent(); // bringing pipelines up to date may have rendered another window
  gather.scene.texture_scale = this->TextureScale;
  gather.scene.clip_margin = this->ClipMargin;
  gather.scene.max_texture_px = vtkTextureObject::GetMaximumTextureSize(window);

  // plan
  internal.Fates.assign(gather.props.size(), WATER_DRAW);
  const water_status status = water_plan_make(&gather.scene, &internal.Plan, internal.Fates.data());
  internal.PlannedFor = renderer;
  internal.PlannedFrame = internal.Shading->Keys.GetEndedFrames(renderer);
  std::string error;
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
      }
    }
    const int samples = this->MultiSamples >= 0
      ? this->MultiSamples
      : std::min(window->GetMultiSamples(), kMaximumDefaultSamples);
    const char* failure = internal.GetView(renderer).Mirror.Draw(
      renderer, internal.Shading, internal.Plan, drawn, samples > 1 ? samples : 0);
    if (failure)
    {
      internal.Plan.decision = WATER_NO_REFLECT_FAILED;
      error = std::string(failure) + ". The water shows its plain colour.";
    }
    else
    {
      ++this->NumberOfReflectionRenders;
    }
  }
  for (vtkWaterActor* water : waters)
  {
    water->ReportError(vtkWaterActor::PLAN, error);
  }
}

//------------------------------------------------------------------------------
bool vtkWaterReflectionPass::IsFresh(vtkRenderer* renderer) const
{
  const Internals& internal = *this->Internal;
  if (internal.PlannedFor != renderer ||
    internal.PlannedFrame != internal.Shading->Keys.GetEndedFrames(renderer))
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
const water_plan* vtkWaterReflectionPass::GetFreshPlan(vtkRenderer* renderer) const
{
  return this->Internal->Plan.decision == WATER_REFLECT && this->IsFresh(renderer)
    ? &this->Internal->Plan
    : nullptr;
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterReflectionPass::GetTexture(vtkRenderer* renderer)
{
  vtkWaterMirror& mirror = this->Internal->GetView(renderer).Mirror;
  return this->GetFreshPlan(renderer)
    ? mirror.GetColor()
    : mirror.GetBlank(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::RenderCorner(vtkRenderer* renderer)
{
  if (this->GetFreshPlan(renderer))
  {
    vtkWaterMirror& mirror = this->Internal->GetView(renderer).Mirror;
    mirror.GetScreen().DrawCorner(renderer, mirror.GetColor());
  }
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::Render(const vtkRenderState* s)
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
    this->RenderReflection(renderer, waters, size);
  }

  if (!this->DelegatePass)
  {
    this->DelegatePass = vtkSmartPointer<vtkRenderStepsPass>::New();
  }
  this->DelegatePass->Render(s);
  this->NumberOfRenderedProps = this->DelegatePass->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->DelegatePass)
  {
    this->DelegatePass->ReleaseGraphicsResources(window);
  }
  for (auto it = this->Internal->Views.begin(); it != this->Internal->Views.end();)
  {
    vtkRenderer* renderer = it->second.Renderer;
    if (!renderer || !window || renderer->GetRenderWindow() == window ||
      !renderer->GetRenderWindow())
    {
      it->second.Mirror.ReleaseGraphicsResources(window);
      it = this->Internal->Views.erase(it);
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
  if (this->DelegatePass)
  {
    os << "\n";
    this->DelegatePass->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << "(none)\n";
  }
  os << indent << "TextureScale: " << this->TextureScale << "\n";
  os << indent << "MultiSamples: " << this->MultiSamples << "\n";
  os << indent << "ClipMargin: " << this->ClipMargin << "\n";
  os << indent << "ShowReflection: " << (this->ShowReflection ? "on" : "off") << "\n";
  os << indent << "NumberOfReflectionRenders: " << this->NumberOfReflectionRenders << "\n";
  os << indent << "Last plan: " << this->GetDecisionAsString() << "\n";
  const water_plan& plan = this->Internal->Plan;
  if (plan.decision == WATER_REFLECT)
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
