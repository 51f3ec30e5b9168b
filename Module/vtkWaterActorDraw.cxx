// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterActorDraw.cxx: the part of vtkWaterActor that draws the surface: in the picture, and in
// the mirrored views of other waters. See Documentation/decisions/008-stages.md and
// 011-water-in-water.md.
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProperty.h"
#include "vtkWaterActor.h"
#include "vtkWaterCompat.h"
#include "vtkWaterGather.h"
#include "vtkWaterGpuQueries.h"
#include "vtkWaterGrid.h"
#include "vtkWaterOcclusion.h"
#include "vtkWaterReflectionPass.h"
#include "vtkWaterSecondarySurface.h"
#include "vtkWaterShaderHook.h"
#include "vtkWaterSurfaceShader.h"
#include "water_plan.h"
#include "water_secondary.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
int vtkWaterActor::RenderOpaqueGeometry(vtkViewport* viewport)
{
  this->MendRefusals(vtkOpenGLRenderer::SafeDownCast(viewport));
  if (this->HasOpaqueGeometry())
  {
    this->RenderReflectionIfStale(viewport);
    auto* renderer = vtkOpenGLRenderer::SafeDownCast(viewport);
    if (renderer && !renderer->GetSelector() &&
      !vtkWaterShaderHook::GetOfThread()->IsInMirroredView() &&
      this->GetPassInCharge(renderer)->IsUnseen(renderer, this))
    {
      return 0;
    }
  }
  return this->Superclass::RenderOpaqueGeometry(viewport);
}

//------------------------------------------------------------------------------
int vtkWaterActor::RenderTranslucentPolygonalGeometry(vtkViewport* viewport)
{
  this->MendRefusals(vtkOpenGLRenderer::SafeDownCast(viewport));
  if (this->HasTranslucentPolygonalGeometry())
  {
    this->RenderReflectionIfStale(viewport);
  }
  return this->Superclass::RenderTranslucentPolygonalGeometry(viewport);
}

//------------------------------------------------------------------------------
int vtkWaterActor::RenderOverlay(vtkViewport* viewport)
{
  auto* renderer = vtkOpenGLRenderer::SafeDownCast(viewport);
  if (renderer && !renderer->GetSelector() && this->GetReflectionPass()->GetShowReflection())
  {
    this->GetPassInCharge(renderer)->RenderCorner(renderer, this);
  }
  return this->Superclass::RenderOverlay(viewport);
}

//------------------------------------------------------------------------------
void vtkWaterActor::DrawSurface(
  vtkWaterSurfaceShader* surface, vtkRenderer* renderer, vtkMapper* mapper)
{
  vtkWaterShaderHook* shading = vtkWaterShaderHook::GetOfThread();
  vtkOpenGLState* probed =
    this->IsProbing ? static_cast<vtkOpenGLRenderer*>(renderer)->GetState() : nullptr;
  shading->BeginSurface(surface, probed);
  this->Superclass::Render(renderer, mapper);
  if (!shading->EndSurface() && !surface->GetIsRefused())
  {
    surface->SetIsRefused();
    vtkErrorMacro("The driver refuses the water's shader. The water shows its plain colour.");
    shading->BeginSurface(surface, probed);
    this->Superclass::Render(renderer, mapper);
    shading->EndSurface();
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::RenderSecondary(vtkRenderer* renderer, vtkMapper* mapper)
{
  vtkWaterShaderHook* shading = vtkWaterShaderHook::GetOfThread();
  const vtkWaterShaderHook::View& view = shading->GetMirroredView();
  if (std::find(view.Props->begin(), view.Props->end(), this) == view.Props->end())
  {
    return; // no endless mirror, whatever drew this water
  }
  shading->Keys.Add(this);
  vtkWaterSurfaceShader* surface = &this->Secondary->Surface;
  water_plan plan;
  const water_scene scene = vtkWaterGather::ReadSecondary(renderer, this, view.Eye);
  water_secondary_plan(&scene, view.Plan, &plan);
  vtkWaterSurfaceShader::Frame frame = vtkWaterSurfaceShader::Frame();
  frame.Renderer = static_cast<vtkOpenGLRenderer*>(renderer);
  frame.Plan = plan.has_view ? &plan : nullptr;
  frame.IsFlat = this->UsesOwnSheet() && this->GetIsIdentity();
  frame.IsSecondary = true;
  if (surface->UpdateStages(vtkWaterSurfaceShader::GetSecondaryStages(this)))
  {
    this->GetProperty()->Modified(); // the mapper builds the other shader
  }
  surface->Begin(this, frame);
  this->DrawSurface(surface, renderer, this->Secondary->Follow(mapper));
  surface->End();
}

//------------------------------------------------------------------------------
void vtkWaterActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
  vtkWaterShaderHook* shading = vtkWaterShaderHook::GetOfThread();
  if (shading->IsInMirroredView())
  {
    this->RenderSecondary(renderer, mapper);
    return;
  }
  if (vtkWaterRenderPassKeys::IsBakingShadows(this) && vtkWaterSurfaceShader::IsClear(this))
  {
    return; // clear water lets the light through
  }
  shading->Keys.Add(this);
  vtkWaterReflectionPass* pass = this->GetPassInCharge(renderer);
  const bool isPlain = renderer->GetSelector() || this->HasSheetError() || this->IsProbing;
  vtkWaterSurfaceShader::Frame frame;
  frame.Renderer = static_cast<vtkOpenGLRenderer*>(renderer);
  frame.Plan = isPlain ? nullptr : pass->GetFreshPlan(renderer, this);
  frame.Screen = pass->GetScreen(renderer);
  frame.Reflection = pass->GetTexture(renderer, this);
  frame.ReflectionDepth = frame.Plan ? pass->GetReflectionDepthTexture() : nullptr;
  frame.Layer = pass->GetLayer(renderer);
  pass->GetRayLimits(&frame.MostSteps, &frame.MostProbes);
  water_grid_view view;
  const bool isDisplaced = this->IsDisplaced() && vtkWaterGather::ReadView(renderer, this, &view);
  frame.View = isDisplaced ? &view : nullptr;
  frame.RowDir = this->Grid->GetRowDir();
  frame.IsFlat = this->UsesOwnSheet() && this->GetIsIdentity() && !isDisplaced;
  vtkMapper* drawn = isDisplaced ? this->LayGrid(view, mapper) : mapper;
  if (this->Surface->UpdateStages(frame.Layer ? vtkWaterSurfaceShader::GetLayeredStages(this)
                                              : vtkWaterSurfaceShader::GetStages(this)))
  {
    this->GetProperty()->Modified(); // the mapper builds the other shader
  }
  frame.AddsFog = frame.Plan && vtkWaterSurfaceShader::IsClear(this) &&
    (frame.Plan->is_submerged || frame.Plan->is_awash) && shading->BeginFog(renderer, *frame.Plan);
  vtkWaterGpuQueries* instruments = this->OwnPass->GetInstruments(renderer);
  instruments->Begin(vtkWaterGpuQueries::SURFACE, renderer->GetRenderWindow());
  this->Surface->Begin(this, frame);
  vtkWaterOcclusion* occlusion = this->OwnPass->GetOcclusion(renderer);
  occlusion->Begin(renderer->GetRenderWindow());
  this->DrawSurface(this->Surface.get(), renderer, drawn);
  occlusion->End();
  this->Surface->End();
  instruments->End(vtkWaterGpuQueries::SURFACE);
}
VTK_ABI_NAMESPACE_END
