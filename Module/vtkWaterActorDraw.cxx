// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterActorDraw.cxx: the part of vtkWaterActor that takes part in a frame and draws the
// surface: in the picture, and in the mirrored views of other waters. See
// Documentation/decisions/008-shader-slots.md and 011-water-in-water.md.
#include "vtkCellArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkWaterActorInternals.h"
#include "vtkWaterBoundPicture.h"
#include "vtkWaterCompat.h"
#include "vtkWaterFrame.h"
#include "vtkWaterGL.h"
#include "vtkWaterGather.h"
#include "vtkWaterGpuQueries.h"
#include "vtkWaterMeshTraits.h"
#include "vtkWaterOcclusion.h"
#include "vtkWaterReflection.h"
#include "vtkWaterReflectionPass.h"
#include "vtkWaterRenderPassKeys.h"
#include "vtkWaterSecondaryLookup.h"
#include "vtkWaterShaderHook.h"
#include "water_horizon.h"
#include "water_plan.h"
#include "water_secondary.h"
#include "water_sky.h"

#include <algorithm>
#include <memory>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
void vtkWaterActor::SetAllocatedRenderTime(double seconds, vtkViewport* viewport)
{
  this->Superclass::SetAllocatedRenderTime(seconds, viewport);

  // The renderer calls this once per frame and eye for a prop that survived culling, before it
  // draws anything.
  auto* renderer = vtkOpenGLRenderer::SafeDownCast(viewport);
  if (renderer && vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) &&
    !vtkWaterFrame::GetHook()->IsInMirroredView())
  {
    vtkWaterFrame::Of(renderer).Allot(*this->Internal);
  }
}

//------------------------------------------------------------------------------
bool vtkWaterActor::Prepare(vtkViewport* viewport, bool isDrawn)
{
  vtkOpenGLRenderer* renderer = vtkWaterFrame::FindMainView(viewport);
  if (!renderer || this->Internal->IsProbing)
  {
    return false;
  }
  vtkWaterFrame& frame = vtkWaterFrame::Of(renderer);
  if (!vtkWaterRenderPassKeys::IsBakingShadows(this))
  {
    const std::string text = frame.MendFailures(*this->Internal);
    if (!text.empty())
    {
      vtkErrorMacro(<< text);
    }
  }
  if (isDrawn)
  {
    frame.Prepare(*this->Internal);
  }
  return isDrawn && frame.IsUnseen(*this->Internal);
}

//------------------------------------------------------------------------------
int vtkWaterActor::RenderOpaqueGeometry(vtkViewport* viewport)
{
  return this->Prepare(viewport, this->HasOpaqueGeometry() != 0)
    ? 0
    : this->Superclass::RenderOpaqueGeometry(viewport);
}

//------------------------------------------------------------------------------
int vtkWaterActor::RenderTranslucentPolygonalGeometry(vtkViewport* viewport)
{
  this->Prepare(viewport, this->HasTranslucentPolygonalGeometry() != 0);
  return this->Superclass::RenderTranslucentPolygonalGeometry(viewport);
}

//------------------------------------------------------------------------------
int vtkWaterActor::RenderOverlay(vtkViewport* viewport)
{
  auto* renderer = vtkOpenGLRenderer::SafeDownCast(viewport);
  if (renderer && !renderer->GetSelector() && this->GetReflectionPass()->GetShowReflection())
  {
    vtkWaterFrame& frame = vtkWaterFrame::Of(renderer);
    frame.GetReflection(*this->Internal).DrawCorner(renderer, frame.GetNumber(), this);
  }
  return this->Superclass::RenderOverlay(viewport);
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::Probe(vtkRenderer* renderer)
{
  this->Self->GetBounds(); // lays the sheet where it is now; without cullers nobody has asked yet
  this->IsProbing = true;
  this->Self->Superclass::RenderOpaqueGeometry(renderer);
  this->IsProbing = false;
}

//------------------------------------------------------------------------------
vtkMapper* vtkWaterActor::Internals::CutMapper(vtkMapper* mapper) const
{
  return this->IsDrawing && mapper == this->Self->Mapper ? this->OtherMapper.Get() : mapper;
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::DrawSurface(
  vtkWaterSurfaceShader& surface, vtkRenderer* renderer, vtkMapper* mapper)
{
  if (!mapper)
  {
    return; // nothing of an endless sheet is seen
  }
  vtkWaterShaderHook* hook = vtkWaterFrame::GetHook();
  vtkOpenGLState* probed =
    this->IsProbing ? static_cast<vtkOpenGLRenderer*>(renderer)->GetState() : nullptr;
  hook->BeginSurface(&surface, probed);
  this->Self->Superclass::Render(
    renderer, surface.GetIsRefused() ? this->CutMapper(mapper) : mapper);
  if (!hook->EndSurface() && !surface.GetIsRefused())
  {
    surface.SetIsRefused();
    vtkErrorWithObjectMacro(
      this->Self, "The driver rejects the water's shader. The water shows its plain colour.");
    hook->BeginSurface(&surface, probed);
    this->Self->Superclass::Render(renderer, this->CutMapper(mapper));
    hook->EndSurface();
  }
}

//------------------------------------------------------------------------------
water_buffer_use vtkWaterActor::Internals::JudgeBuffer(const vtkWaterSnapshot& water,
  const vtkWaterSurfaceShader::Inputs& inputs, water_feature_set features, bool isSoftware,
  vtkMapper* mapper)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(inputs.Renderer->GetRenderWindow());
  vtkProperty* property = this->Self->GetProperty();
  vtkPolyData* mesh = vtkWaterMeshTraits::FindPolygons(mapper);
  water_buffer_input input = water_buffer_input();
  input.is_on = this->GetOwnReflection().Settings.MayBuffer;
  input.is_software = isSoftware;
  input.is_plain_draw = !inputs.IsWarmUp && !inputs.Ranks && !this->IsProbing &&
    this->Self->HasOpaqueGeometry() && water.Look.Opacity >= 1.0 &&
    property->GetRepresentation() == VTK_SURFACE && !this->Self->GetTexture() &&
    property->GetNumberOfTextures() == 0 && !this->Surface.GetIsRefused() &&
    !vtkWaterRenderPassKeys::HasOthers(this->Self, vtkWaterFrame::GetHook()) &&
    vtkWaterMeshTraits::HasTrianglesOnly(mesh, mapper, property);
  input.features = features;
  input.plan = inputs.Plan;
  std::copy_n(water.Sheet, 4, input.sheet);
  int viewport[4];
  inputs.Renderer->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  std::copy_n(viewport + 2, 2, input.viewport_px);
  input.samples = vtkWaterBoundPicture().Samples;
  if (mesh)
  {
    // polygons become fans of triangles
    vtkCellArray* polygons = mesh->GetPolys();
    input.triangle_count = static_cast<double>(
      polygons->GetNumberOfConnectivityIds() - 2 * polygons->GetNumberOfCells());
  }
  const water_buffer_use use = water_buffer_judge(&input);
  const bool canServe =
    !this->Surface.Buffer.GetHasFailed() && vtkWaterSurfaceBuffer::CanServe(window);
  return use == WATER_BUFFER_IN_USE && !canServe ? WATER_BUFFER_TARGET : use;
}

//------------------------------------------------------------------------------
bool vtkWaterActor::Internals::DrawBuffered(
  vtkRenderer* renderer, vtkMapper* mapper, vtkWaterOcclusion& occlusion)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  int viewport[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  {
    const vtkWaterSurfaceBuffer::Keeping keeping(
      this->Surface.Buffer, window, viewport, vtkWaterMeshTraits::ShowsScalars(mapper));
    if (!keeping.GetIsReady())
    {
      return false;
    }
    vtkWaterShaderHook* hook = vtkWaterFrame::GetHook();
    hook->BeginSurface(&this->Surface, nullptr);
    this->Self->Superclass::Render(renderer, mapper);
    if (!hook->EndSurface())
    {
      return false;
    }
  }
  occlusion.End(); // what is drawn now are no samples of the surface
  return this->Surface.ShadeBuffer(mapper);
}

namespace
{
// The surface leaves its depth, and transparent black, if another rank's picture shows it.
class ScopedHole
{
public:
  ScopedHole(vtkRenderer* renderer, vtkProp* water, bool isShown)
    : Blend(StateOf(renderer), GL_BLEND)
    , BlendFunc(StateOf(renderer))
  {
    if (!isShown && !renderer->GetSelector() && !vtkWaterRenderPassKeys::IsBakingShadows(water))
    {
      vtkOpenGLState* state = StateOf(renderer);
      state->vtkglEnable(GL_BLEND);
      state->vtkglBlendFuncSeparate(GL_ZERO, GL_ZERO, GL_ZERO, GL_ZERO);
    }
  }

private:
  ScopedHole(const ScopedHole&) = delete;
  void operator=(const ScopedHole&) = delete;

  static vtkOpenGLState* StateOf(vtkRenderer* renderer)
  {
    return static_cast<vtkOpenGLRenderer*>(renderer)->GetState();
  }

  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunc;
};

// What the reflection texture of a water's draw has.
water_feature_texture TextureOf(
  const vtkWaterSurfaceShader::Inputs& inputs, const vtkWaterSnapshot& water)
{
  water_feature_texture texture = water_feature_texture();
  texture.has_layer = inputs.Translucent.Color != nullptr;
  texture.has_peel = inputs.PeelColor && water.WantsPeel();
  texture.is_enclosed = inputs.Plan && inputs.Plan->is_enclosed;
  texture.has_sky_view = inputs.Plan && inputs.SkyView.Color;
  return texture;
}

// The features of a water with what its reflection texture has, and with what draws it.
water_feature_set FeaturesWith(
  const vtkWaterSurfaceShader::Inputs& inputs, const vtkWaterSnapshot& water, bool isSoftware)
{
  const water_feature_texture texture = TextureOf(inputs, water);
  const bool hasSamples = inputs.Renderer->GetRenderWindow()->GetMultiSamples() > 1;
  water_feature_set features = water_features_with_texture(water.Features, &texture);
  features = hasSamples ? water_features_with_samples(features) : features;
  const bool hasLayerBelow = water.WantsOwnView() && inputs.OwnView.Translucent.Color;
  features = hasLayerBelow ? water_features_with_below_layer(features) : features;
  if (inputs.Ranks && inputs.Ranks->HasRegion() && !water.Look.Has.is_opaque)
  {
    features = water_features_with_rank_region(features);
  }
  const bool hasOwnSky = vtkWaterSurfaceShader::HasOwnSky(water);
  if (inputs.Plan)
  {
    features =
      water_sky_features(features, hasOwnSky, inputs.Plan->side == WATER_BELOW, &inputs.Plan->sky);
  }
  else if (inputs.IsWarmUp) // built for when it is in view
  {
    water_sky sky;
    vtkWaterSkyTextures textures;
    vtkWaterSkyReader::Read(inputs.Renderer, sky, textures);
    features = water_sky_features(features, hasOwnSky, false, &sky);
  }
  return isSoftware ? features : water_features_on_hardware(features);
}

// The same in the mirrored view of another water.
//
// isLookedUp  a secondary view is; else it reflects the sky alone
water_feature_set SecondaryFeaturesWith(const vtkWaterSurfaceShader::Inputs& inputs,
  const vtkWaterSnapshot& water, const water_sky& sky, bool isLookedUp, bool isSoftware)
{
  const water_feature_texture texture = TextureOf(inputs, water);
  water_feature_set features = isLookedUp
    ? water_features_with_texture(water_features_secondary_view(&water.Look.Has), &texture)
    : water_features_secondary(&water.Look.Has);
  features = water.Hulls ? water_features_with_hulls(features) : features;
  features = water_sky_features(features, vtkWaterSurfaceShader::HasOwnSky(water), false, &sky);
  features = water.Mesh.HasVertexHeights ? water_features_with_mesh(features) : features;
  features |= water.Features & WATER_FEATURE_SHORE;
  return isSoftware ? features : water_features_on_hardware(features);
}
}

//------------------------------------------------------------------------------
void vtkWaterActor::RenderSecondary(vtkRenderer* renderer, vtkMapper* mapper)
{
  vtkWaterShaderHook* hook = vtkWaterFrame::GetHook();
  const vtkWaterShaderHook::View& view = hook->GetMirroredView();
  if (std::find(view.Props->begin(), view.Props->end(), this) == view.Props->end())
  {
    return; // no endless mirror, whatever drew this water
  }
  vtkWaterRenderPassKeys::Add(this, hook);
  const vtkWaterSnapshotPointer water = this->Internal->Take(renderer);
  vtkWaterSurfaceShader::Inputs inputs;
  inputs.Renderer = static_cast<vtkOpenGLRenderer*>(renderer);
  inputs.IsSecondary = true;
  water_plan plan;
  const bool isLookedUp = view.Secondary && view.Secondary->Find(this, inputs);
  if (!isLookedUp)
  {
    const water_scene scene =
      vtkWaterGather::ReadSecondary(renderer, *water, view.Eye, view.Plan->sky);
    water_secondary_plan(&scene, view.Plan, &plan);
    inputs.Plan = plan.has_view ? &plan : nullptr;
    inputs.Sky = *view.Sky;
  }
  vtkWaterSecondarySurface& secondary =
    isLookedUp ? this->Internal->SecondaryOfScene : this->Internal->Secondary;
  vtkWaterSurfaceShader& surface = secondary.Surface;
  water_horizon_depths(view.Plan->mirrored.view_to_clip, false, inputs.HorizonDepths);
  if (surface.UpdateFeatures(SecondaryFeaturesWith(
        inputs, *water, view.Plan->sky, isLookedUp, vtkWaterFrame::Of(renderer).IsSoftware())))
  {
    this->GetProperty()->Modified(); // the mapper builds the other shader
  }
  vtkMapper* drawn = water->IsEndless ? this->Internal->LayHorizon(*water, renderer,
                                          view.Plan->mirrored, view.Plan->clip_plane_world, mapper)
                                      : secondary.Follow(mapper);
  surface.Begin(water, inputs);
  this->Internal->DrawSurface(surface, renderer, drawn);
  surface.End();
}

//------------------------------------------------------------------------------
// Long because a draw has many steps, whose order matters.
void vtkWaterActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
  Internals& internal = *this->Internal;
  vtkWaterShaderHook* hook = vtkWaterFrame::GetHook();
  if (hook->IsInMirroredView())
  {
    this->RenderSecondary(renderer, mapper);
    return;
  }
  if (vtkWaterRenderPassKeys::IsBakingShadows(this) && internal.IsClear())
  {
    return; // clear water lets the light through
  }
  vtkWaterRenderPassKeys::Add(this, hook);
  vtkWaterFrame& frame = vtkWaterFrame::Of(renderer);
  const vtkWaterSnapshotPointer water = internal.Take(renderer);
  vtkWaterReflection& own = internal.GetOwnReflection();
  const std::shared_ptr<void> held[2] = { own.Hold(renderer),
    frame.GetReflection(internal).Hold(renderer) };
  vtkWaterSurfaceShader::Inputs inputs = frame.GetInputs(internal);
  if (renderer->GetSelector() || internal.HasSheetError() || internal.IsProbing)
  {
    inputs.Plan = nullptr; // plain
  }
  inputs.IsWarmUp = internal.WarmUp.GetIsDrawing();
  water_grid_view view;
  const bool isDisplaced =
    water->IsDisplaced() && vtkWaterGather::ReadView(renderer, *water, &view);
  inputs.View = isDisplaced ? &view : nullptr;
  inputs.RowDir = internal.Grid.GetRowDir();
  inputs.IsAtRest = !isDisplaced;
  const water_camera eye = vtkWaterGather::ReadCamera(renderer);
  water_horizon_depths(eye.view_to_clip, isDisplaced, inputs.HorizonDepths);
  vtkMapper* drawn = isDisplaced ? internal.LayGrid(*water, view, mapper)
                                 : internal.LayHorizon(*water, renderer, eye, nullptr, mapper);
  const water_feature_set features = FeaturesWith(inputs, *water, frame.IsSoftware());
  const water_buffer_use use =
    internal.JudgeBuffer(*water, inputs, features, frame.IsSoftware(), drawn);
  const water_feature_set used =
    use == WATER_BUFFER_IN_USE ? water_features_with_buffer(features) : features;
  if (internal.Surface.UpdateFeatures(used))
  {
    this->GetProperty()->Modified(); // the mapper builds the other shader
  }
  inputs.AddsFog = inputs.Plan && water->IsClear() &&
    (inputs.Plan->is_submerged || inputs.Plan->is_awash) && frame.BeginFog(*inputs.Plan);
  vtkWaterGpuQueries* queries = own.GetGpuQueries(renderer);
  vtkWaterOcclusion* occlusion = own.GetOcclusion(renderer);
  queries->Begin(vtkWaterGpuQueries::SURFACE, renderer->GetRenderWindow());
  internal.Surface.Begin(water, inputs);
  if (!inputs.IsWarmUp)
  {
    occlusion->Begin(renderer->GetRenderWindow());
  }
  own.SetBufferUse(use);
  if (use == WATER_BUFFER_IN_USE && !internal.DrawBuffered(renderer, drawn, *occlusion))
  {
    own.SetBufferUse(WATER_BUFFER_TARGET);
    internal.Surface.UpdateFeatures(features);
    this->GetProperty()->Modified();
  }
  if (!internal.Surface.GetIsBuffered())
  {
    // the plain colour is not divided
    const bool isDivided = inputs.Plan && (used & WATER_FEATURE_RANK_REGION) != 0;
    const bool isShown = isDivided || frame.GetReflection(internal).Ranks.ShowsWater();
    const ScopedHole hole(renderer, this, isShown);
    internal.DrawSurface(internal.Surface, renderer, drawn);
  }
  occlusion->End();
  internal.Surface.End();
  if (!renderer->GetSelector() && !vtkWaterRenderPassKeys::IsBakingShadows(this))
  {
    internal.WarmUp.SetIsDone();
  }
  queries->End(vtkWaterGpuQueries::SURFACE);
  queries->SayMissing(this);
}
VTK_ABI_NAMESPACE_END
