// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMirroredRanks.cxx: the part of vtkWaterMirroredView that makes one view of what the ranks
// of a sort-last renderer draw. See Documentation/decisions/023-ranks.md.
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"
#include "vtkWaterGL.h"
#include "vtkWaterMirroredView.h"
#include "vtkWaterRankPixels.h"
#include "vtkWaterRankSamples.h"
#include "vtkWaterScopedWidgets.h"
#include "vtkWaterTranslucent.h"
#include "vtkWaterVolumeCuts.h"

#include <algorithm>

namespace
{
const char* const kUnreachable =
  "the other ranks cannot be reached for their part of the reflection texture";
const char* const kNoSamples = "the GPU gave no framebuffer for the samples of the reflection";

// What is translucent, or a volume, and where.
water_rank_drawn FindBlended(
  const std::vector<vtkProp*>& blended, const std::vector<vtkProp*>& others)
{
  water_rank_drawn facts = water_rank_drawn_begin();
  facts.has_blended = vtkWaterTranslucentLayer::IsNeeded(blended, others) ? 1.0 : 0.0;
  for (vtkProp* prop : blended)
  {
    const double* bounds = prop->GetBounds();
    if (bounds)
    {
      water_rank_drawn_add(bounds, &facts);
    }
  }
  return facts;
}

// The ranks from front to back, as the mirrored camera sees what they blend.
std::vector<size_t> FindOrder(const water_plan& plan, const vtkWaterRanks::Drawing& drawing)
{
  const size_t count = drawing.Bounds.size();
  std::vector<size_t> order(count);
  std::vector<size_t> blockers(count);
  water_rank_pixels_order(reinterpret_cast<const double(*)[6]>(drawing.Bounds.data()), count,
    plan.mirrored_position, plan.mirrored_focal_point, plan.mirrored.parallel, order.data(),
    blockers.data());
  return order;
}
}

// What a rank has read before it says so to the others.
struct vtkWaterMirroredView::RankParts
{
  vtkWaterRankPixels Opaque; // of all ranks
  vtkWaterRankPixels Layer;  // what it blends itself
  vtkWaterRankPixels Depths; // and where that is
  vtkWaterRankPixels Peel;   // what it has behind the first things of all
};

//------------------------------------------------------------------------------
const char* vtkWaterMirroredView::JoinOpaque(
  vtkRenderer* renderer, const water_plan& plan, Draft& draft)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  water_rank_drawn facts = FindBlended(draft.Blended, draft.Others);
  const int* rect = plan.texture_rect_px;
  const unsigned int type = this->Target.HasHalfFloats() ? GL_HALF_FLOAT : GL_UNSIGNED_BYTE;
  window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
  const bool hasSamples = plan.samples > 0 && plan.samples <= WATER_RANK_SAMPLES_MAX; // of all
  vtkOpenGLFramebufferObject* drawn = this->Target.GetFramebuffer();
  vtkWaterRankSamples::Picture picture;
  vtkWaterRankPixels pixels;
  if (hasSamples)
  {
    picture = vtkWaterRankSamples::PictureOf(drawn, rect);
    facts.has_failed = this->RankSamples.Read(window, picture, type, pixels) ? 0.0 : 1.0;
  }
  else
  {
    this->Target.Resolve();
    pixels.Read(this->Target.GetResolved(), type, rect);
  }
  const vtkWaterRanks::Drawing drawing = draft.Agree(facts);
  if (drawing.Result != WATER_RANKS_DRAWN)
  {
    return facts.has_failed == 0.0 ? nullptr : kNoSamples;
  }
  if (!pixels.KeepNearest(*draft.Ranks))
  {
    return kUnreachable;
  }
  if (!hasSamples)
  {
    pixels.Upload(this->Target.GetColor(), this->Target.GetDepth());
  }
  else
  {
    this->RankSamples.Write(window, pixels, picture.Samples, rect, drawn);
    this->Target.Resolve();
  }
  return drawing.HasBlended || draft.WantsPeel ? this->JoinMore(renderer, plan, draft, drawing)
                                               : nullptr;
}

//------------------------------------------------------------------------------
const char* vtkWaterMirroredView::JoinHeights(const water_plan& plan, const Draft& draft)
{
  vtkWaterRankPixels pixels;
  pixels.ReadDepths(this->Target.GetResolved(), plan.texture_rect_px);
  if (draft.Agree(water_rank_drawn_begin()).Result != WATER_RANKS_DRAWN)
  {
    return nullptr;
  }
  if (!pixels.KeepNearest(*draft.Ranks))
  {
    return kUnreachable;
  }
  pixels.UploadDepths(this->Target.GetDepth());
  return nullptr;
}

//------------------------------------------------------------------------------
bool vtkWaterMirroredView::DrawOwnLayer(
  vtkRenderer* renderer, const water_plan& plan, Draft& draft, RankParts& parts)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const int* rect = plan.texture_rect_px;
  const bool hasOwn = vtkWaterTranslucentLayer::IsNeeded(draft.Blended, draft.Others);
  // floats: nothing computes with half ones
  const unsigned int type = this->Target.HasHalfFloats() ? GL_FLOAT : GL_UNSIGNED_BYTE;
  parts.Opaque.Read(this->Target.GetResolved(), type, rect);
  // samples that are not of all ranks are not those of the joined depth
  const bool hasSamples = plan.samples > 0 && plan.samples <= WATER_RANK_SAMPLES_MAX &&
    vtkWaterTranslucent::HasSamples(renderer);
  if ((hasOwn || draft.HasMarchedRays) &&
    !(this->Layer.KeepDepth(window, this->Target, hasSamples, draft.HasMarchedRays) &&
      this->Layer.Bind()))
  {
    return false;
  }
  vtkOpenGLFramebufferObject* drawn = nullptr;
  if (hasOwn)
  {
    vtkOpenGLState* state = window->GetState();
    state->vtkglViewport(0, 0, plan.texture_px[0], plan.texture_px[1]);
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglScissor(rect[0], rect[1], rect[2], rect[3]);
    const vtkWaterVolumeCuts cuts(plan, draft.Others);
    const vtkWaterScopedWidgets scopedWidgets(renderer, draft.Others);
    this->Layer.DrawColors(renderer, draft.Blended, this->Translucent);
    if (draft.HasMarchedRays)
    {
      this->Layer.DrawDepths(renderer, draft.Hook, plan, draft.Blended);
    }
    state->vtkglDisable(GL_SCISSOR_TEST);
    drawn = this->Layer.Resolve();
  }
  parts.Layer.ReadLayer(drawn, type, rect);
  if (draft.HasMarchedRays)
  {
    parts.Depths.ReadDepths(drawn, parts.Opaque);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterMirroredView::DrawOwnPeel(
  vtkRenderer* renderer, const water_plan& plan, Draft& draft, RankParts& parts)
{
  this->DrawPeel(renderer, plan, draft); // behind what is nearest on all ranks
  if (this->HasPeel)
  {
    parts.Peel.Read(this->Peel.GetFramebuffer(),
      this->Target.HasHalfFloats() ? GL_HALF_FLOAT : GL_UNSIGNED_BYTE, plan.texture_rect_px);
  }
  return this->HasPeel;
}

//------------------------------------------------------------------------------
bool vtkWaterMirroredView::JoinLayers(
  const Draft& draft, const std::vector<size_t>& order, RankParts& parts)
{
  if (!parts.Layer.BlendInOrder(*draft.Ranks, order))
  {
    return false;
  }
  if (draft.HasMarchedRays)
  {
    if (!parts.Depths.KeepNearest(*draft.Ranks))
    {
      return false;
    }
    parts.Layer.Upload(this->Layer.GetColor(), nullptr);
    parts.Depths.UploadDepths(this->Layer.GetDepth(), parts.Opaque);
    this->HasLayer = true;
  }
  parts.Opaque.Blend(parts.Layer);
  parts.Opaque.Upload(this->Target.GetColor(), nullptr);
  return true;
}

//------------------------------------------------------------------------------
const char* vtkWaterMirroredView::JoinMore(vtkRenderer* renderer, const water_plan& plan,
  Draft& draft, const vtkWaterRanks::Drawing& drawing)
{
  RankParts parts;
  const bool isDrawn = (!drawing.HasBlended || this->DrawOwnLayer(renderer, plan, draft, parts)) &&
    (!draft.WantsPeel || this->DrawOwnPeel(renderer, plan, draft, parts));
  water_rank_drawn facts = water_rank_drawn();
  facts.has_failed = isDrawn ? 0.0 : 1.0;
  const std::vector<size_t> order = FindOrder(plan, drawing);
  if (draft.Agree(facts).Result != WATER_RANKS_DRAWN)
  {
    return isDrawn ? nullptr
                   : "the GPU gave no framebuffer for translucent props, or for the second "
                     "layer (RayTraceLayers)";
  }
  if (drawing.HasBlended && !this->JoinLayers(draft, order, parts))
  {
    return kUnreachable;
  }
  if (draft.WantsPeel)
  {
    if (!parts.Peel.KeepNearest(*draft.Ranks))
    {
      return kUnreachable;
    }
    parts.Peel.Upload(this->Peel.GetColor(), this->Peel.GetDepth());
  }
  return nullptr;
}
