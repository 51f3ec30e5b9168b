// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterMirroredView.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkTextureObject.h"
#include "vtkWaterAccess.h"
#include "vtkWaterGL.h"
#include "vtkWaterGather.h"
#include "vtkWaterHiddenLines.h"
#include "vtkWaterSceneDepth.h"
#include "vtkWaterScopedView.h"
#include "vtkWaterScopedWidgets.h"
#include "vtkWaterShaderHook.h"
#include "vtkWaterShadows.h"
#include "vtkWaterVolumeCuts.h"

#include <algorithm>
#include <new>

namespace
{
void SetViewportAndScissor(vtkOpenGLState* state, const water_plan& plan)
{
  const int* rect = plan.texture_rect_px;
  state->vtkglViewport(0, 0, plan.texture_px[0], plan.texture_px[1]);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(rect[0], rect[1], rect[2], rect[3]);
}

// A draw runs the user's observers, who may throw.
class ScopedDraw
{
public:
  ScopedDraw(bool& isDrawing, vtkWaterGpuQueries& queries, vtkOpenGLRenderWindow* window)
    : IsDrawing(isDrawing)
    , Queries(queries)
  {
    this->IsDrawing = true;
    this->Queries.Begin(vtkWaterGpuQueries::REFLECTION, window);
  }
  ~ScopedDraw()
  {
    this->Queries.End(vtkWaterGpuQueries::REFLECTION);
    this->IsDrawing = false;
  }

private:
  ScopedDraw(const ScopedDraw&) = delete;
  void operator=(const ScopedDraw&) = delete;

  bool& IsDrawing;
  vtkWaterGpuQueries& Queries;
};

// What a draw leaves out is there again afterwards, even if an observer throws in it.
class ScopedCuts
{
public:
  ScopedCuts(vtkWaterClipDistance& clipDistance, vtkWaterClusters& clusters, vtkWaterBlocks& blocks)
    : ClipDistance(clipDistance)
    , Clusters(clusters)
    , Blocks(blocks)
  {
  }
  ~ScopedCuts()
  {
    this->ClipDistance.Off();
    this->Clusters.TakeBack();
    this->Blocks.TakeBack();
  }

private:
  ScopedCuts(const ScopedCuts&) = delete;
  void operator=(const ScopedCuts&) = delete;

  vtkWaterClipDistance& ClipDistance;
  vtkWaterClusters& Clusters;
  vtkWaterBlocks& Blocks;
};

void SetUpOpaque(vtkOpenGLState* state, const water_plan& plan)
{
  SetViewportAndScissor(state, plan);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}
}

//------------------------------------------------------------------------------
void vtkWaterMirroredView::DrawBackground(
  vtkRenderer* renderer, const water_plan& plan, const Draft& draft)
{
  this->Background.DrawSky(renderer, plan, draft.Sky);
  if (this->Visible)
  {
    try
    {
      this->ClosedCells.Draw(renderer, *this->Visible);
    }
    catch (const std::bad_alloc&)
    {
      this->Shortage.What = "no memory for the mask of pixels that no visible water reflects";
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterMirroredView::DrawTranslucent(
  vtkRenderer* renderer, const water_plan& plan, Draft& draft)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  const vtkWaterVolumeCuts cuts(plan, draft.Others);
  const vtkWaterScopedWidgets scopedWidgets(renderer, draft.Others);
  this->HasLayer = draft.HasMarchedRays &&
    vtkWaterTranslucentLayer::IsNeeded(draft.Blended, draft.Others) &&
    this->Layer.Keep(window, this->Target);
  if (this->HasLayer)
  {
    this->Target.Bind();
    SetViewportAndScissor(state, plan);
  }
  this->Translucent.DrawPolygons(renderer, draft.Blended, this->Target.GetFramebuffer());
  this->Translucent.DrawVolumes(renderer, draft.Others);
  state->vtkglDisable(GL_SCISSOR_TEST);
  this->Target.Resolve();
  this->HasLayer = this->HasLayer && this->Layer.Bind();
  if (this->HasLayer)
  {
    SetViewportAndScissor(state, plan);
    this->Layer.Draw(renderer, draft.Hook, plan, draft.Blended, this->Translucent);
  }
}

//------------------------------------------------------------------------------
const char* vtkWaterMirroredView::DrawProps(
  vtkRenderer* renderer, const water_plan& plan, Draft& draft)
{
  vtkWaterShaderHook::View view;
  view.Plan = &plan;
  view.Eye = vtkWaterGather::ReadCamera(renderer); // before it is the mirrored one
  view.Props = &draft.Props;
  view.Sky = &draft.Sky;
  view.Secondary = draft.Secondary;
  view.Clusters = draft.CanCut ? &this->Clusters : nullptr;
  view.Blocks = &this->Blocks;
  view.ClipDistance = &this->ClipDistance;
  this->SetCamera(renderer, plan);
  vtkWaterScopedCamera scopedCamera(renderer, this->Camera);
  vtkWaterScopedMirroredView scopedView(draft.Hook, view);
  vtkWaterScopedRenderTimes scopedTimes(renderer, draft.Props);
  if (draft.IsDepth)
  {
    auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
    window->GetState()->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  }
  vtkWaterShadows::Draw(
    renderer, draft.Shadows, draft.Props, [&]() { this->DrawOpaque(renderer, plan, draft); });
  if (draft.IsDepth)
  {
    this->Target.Resolve();
    return draft.Ranks ? this->JoinHeights(plan, draft) : nullptr;
  }
  if (draft.Ranks)
  {
    return this->JoinOpaque(renderer, plan, draft);
  }
  this->DrawTranslucent(renderer, plan, draft);
  this->DrawPeel(renderer, plan, draft);
  return nullptr;
}

//------------------------------------------------------------------------------
const char* vtkWaterMirroredView::Draw(vtkRenderer* renderer, const water_plan& plan, Draft& draft)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  if (!this->Target.Ensure(
        window, plan.texture_px[0], plan.texture_px[1], plan.samples, plan.is_half_float))
  {
    return "the GPU gave no framebuffer for the reflection texture";
  }
  vtkOpenGLRenderUtilities::MarkDebugEvent("water: mirrored view begins");
  this->Clusters.BeginView(plan, this->Visible, plan.samples, &this->ClipDistance);
  this->Blocks.BeginView(this->Visible);
  this->HasLayer = false;
  this->HasPeel = false;
  const char* failure = nullptr;
  {
    const ScopedDraw scopedDraw(this->IsDrawing, this->GpuQueries, window);
    vtkWaterScopedState scopedState(state);
    if (this->Target.Bind())
    {
      SetUpOpaque(state, plan);
      this->DrawBackground(renderer, plan, draft);
      failure = this->DrawProps(renderer, plan, draft);
    }
    else
    {
      failure = "the framebuffer of the reflection texture is not complete";
    }
  }
  vtkOpenGLRenderUtilities::MarkDebugEvent("water: mirrored view ends");
  return failure;
}

//------------------------------------------------------------------------------
const water_visibility* vtkWaterMirroredView::FindVisible(
  vtkRenderer* renderer, const water_plan& plan, bool isWanted)
{
  this->Visible = nullptr;
  this->Shortage = vtkWaterShortage();
  if (isWanted)
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    vtkWaterSceneDepth sceneDepth;
    sceneDepth.Find(window->GetState());
    try
    {
      this->Visible =
        sceneDepth.IsThere() ? this->Visibility.Find(renderer, plan, sceneDepth) : nullptr;
    }
    catch (const std::bad_alloc&)
    {
      this->Shortage.What = "no memory for the test of hidden water";
    }
  }
  return this->Visible;
}

//------------------------------------------------------------------------------
void vtkWaterMirroredView::SetCamera(vtkRenderer* renderer, const water_plan& plan)
{
  if (!this->Camera)
  {
    this->Camera.TakeReference(renderer->MakeCamera());
    vtkNew<vtkMatrix4x4> projection;
    this->Camera->SetExplicitProjectionTransformMatrix(projection);
    this->Camera->SetUseExplicitProjectionTransformMatrix(true);
  }
  vtkCamera* user = renderer->GetActiveCamera();
  this->Camera->SetPosition(plan.mirrored_position);
  this->Camera->SetFocalPoint(plan.mirrored_focal_point);
  this->Camera->SetViewUp(plan.mirrored_view_up);
  // shaders and volume rays still read these two, although the projection is explicit
  this->Camera->SetParallelProjection(user->GetParallelProjection());
  this->Camera->SetClippingRange(user->GetClippingRange());
  double* projection = &this->Camera->GetExplicitProjectionTransformMatrix()->Element[0][0];
  std::copy(plan.mirrored.view_to_clip, plan.mirrored.view_to_clip + 16, projection);
  // mappers that shift and scale coordinates by the camera ask it for how much
  this->Camera->UpdateIdealShiftScale(renderer->GetTiledAspectRatio());
  // lights and key matrices are refreshed by the camera's time; a matrix changed in place does not
  // count, and the main view may have been set up since
  this->Camera->Modified();
}

//------------------------------------------------------------------------------
void vtkWaterMirroredView::DrawProp(vtkRenderer* renderer, const Draft& draft, size_t number)
{
  draft.Hook->SetMayBeCut(draft.Known[number].MayBeCut);
  const ScopedCuts scopedCuts(this->ClipDistance, this->Clusters, this->Blocks);
  const vtkWaterScopedFacts scopedFacts(draft.Props[number], draft.Known[number]);
  const vtkWaterScopedWidgets scopedWidgets(renderer, draft.Props[number]);
  draft.Props[number]->RenderOpaqueGeometry(renderer);
}

//------------------------------------------------------------------------------
void vtkWaterMirroredView::DrawPeel(vtkRenderer* renderer, const water_plan& plan, Draft& draft)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  this->HasPeel = draft.WantsPeel && this->Peel.Begin(window, this->Target);
  if (!this->HasPeel)
  {
    return;
  }
  SetUpOpaque(window->GetState(), plan);
  this->Background.DrawSky(renderer, plan, draft.Sky);
  this->Clusters.ForgetDepths(); // what the first things hide is what is drawn now
  draft.Hook->BeginPeel();
  vtkWaterShadows::Draw(renderer, draft.Shadows, draft.Props, [&]() {
    const auto draw = [this, renderer, &draft](size_t i) { this->DrawProp(renderer, draft, i); };
    if (vtkWaterHiddenLines::AreRemoved(renderer))
    {
      vtkWaterHiddenLines::Draw(renderer, draft.Props, draw);
      return;
    }
    for (size_t i = 0; i < draft.Props.size(); ++i)
    {
      draw(i);
    }
  });
  draft.Hook->SetMayBeCut(true);
  draft.Hook->EndPeel();
  window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
  this->Peel.End(window);
}

//------------------------------------------------------------------------------
void vtkWaterMirroredView::DrawOpaque(
  vtkRenderer* renderer, const water_plan& plan, const Draft& draft)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const auto draw = [this, renderer, &draft](size_t i) { this->DrawProp(renderer, draft, i); };
  this->GpuQueries.BeginCounting(window);
  const size_t count = draft.Props.size();
  size_t next = 0;
  if (vtkWaterHiddenLines::AreRemoved(renderer))
  {
    vtkWaterHiddenLines::Draw(renderer, draft.Props, draw);
    next = count;
  }
  else if (draft.CanCut && plan.is_software)
  {
    const size_t leading = this->Clusters.BeginLeading(draft.Props);
    if (this->Clusters.IsReversed())
    {
      vtkOpenGLState::ScopedglDepthFunc depthFunc(window->GetState());
      window->GetState()->vtkglDepthFunc(GL_LESS);
      for (size_t i = leading; i-- > 0;)
      {
        draw(i);
      }
    }
    else
    {
      for (size_t i = 0; i < leading; ++i)
      {
        draw(i);
      }
    }
    this->Clusters.EndLeading();
    if (leading > 0)
    {
      glFlush(); // they are drawn while the others are handed over
    }
    next = leading;
  }
  for (; next < count; ++next)
  {
    draw(next);
  }
  draft.Hook->SetMayBeCut(true);
  this->GpuQueries.EndCounting();
}

//------------------------------------------------------------------------------
void vtkWaterMirroredView::MakeLevels()
{
  this->Target.MakeLevels();
  if (this->HasLayer)
  {
    this->Layer.MakeLevels();
  }
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterMirroredView::GetBlank(vtkOpenGLRenderWindow* window)
{
  if (!this->Blank || this->Blank->GetContext() != window)
  {
    this->Blank = vtkSmartPointer<vtkTextureObject>::New();
    this->Blank->SetContext(window);
    this->Blank->Allocate2D(1, 1, 4, VTK_UNSIGNED_CHAR);
  }
  return this->Blank;
}

//------------------------------------------------------------------------------
void vtkWaterMirroredView::ReleaseGraphicsResources(vtkWindow* window)
{
  if (auto* rendered = vtkRenderWindow::SafeDownCast(window))
  {
    rendered->MakeCurrent(); // shared props that went before may have left another's context
  }
  this->Target.ReleaseGraphicsResources(window);
  this->Clusters.ReleaseGraphicsResources();
  if (window)
  {
    this->GpuQueries.ReleaseGraphicsResources();
  }
  this->Background.ReleaseGraphicsResources();
  this->Fog.ReleaseGraphicsResources();
  this->ClosedCells.ReleaseGraphicsResources();
  if (this->Blank && window)
  {
    this->Blank->ReleaseGraphicsResources(window);
  }
  this->Blank = nullptr;
  this->Translucent.ReleaseGraphicsResources(window);
  this->Layer.ReleaseGraphicsResources(window);
  this->Peel.ReleaseGraphicsResources(window);
  this->RankSamples.ReleaseGraphicsResources(window);
  this->HasLayer = this->HasPeel = false;
}
