// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterTranslucent.h"

#include "vtkDualDepthPeelingPass.h"
#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTranslucentPass.h"
#include "vtkVersionMacros.h"
#include "vtkVolumetricPass.h"

#include <algorithm>

//------------------------------------------------------------------------------
bool vtkWaterTranslucent::HasPolygons(const std::vector<vtkProp*>& props)
{
  return std::any_of(props.begin(), props.end(),
    [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry() != 0; });
}

//------------------------------------------------------------------------------
vtkWaterTranslucent::Blendings vtkWaterTranslucent::GetBlending(vtkRenderer* renderer)
{
  if (renderer->GetUseDepthPeeling())
  {
    return renderer->GetUseDepthPeelingForVolumes() ? PEELING_WITH_VOLUMES : PEELING;
  }
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 5, 0)
  if (!renderer->GetUseOIT())
  {
    return PLAIN;
  }
#endif
  // vtkTranslucentPass, of which chains are made, blends in the order of drawing
  return renderer->GetPass() ? PLAIN : ORDER_INDEPENDENT;
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkWaterTranslucent::GetPass(vtkRenderer* renderer)
{
  const Blendings blending = GetBlending(renderer);
  if (this->Pass && this->Blending != blending)
  {
    this->Pass->ReleaseGraphicsResources(renderer->GetRenderWindow());
    this->Pass = nullptr;
  }
  if (!this->Pass)
  {
    this->Blending = blending;
    vtkNew<vtkTranslucentPass> translucent;
    if (blending == PLAIN)
    {
      this->Pass = translucent.Get();
    }
    else if (blending == ORDER_INDEPENDENT)
    {
      auto pass = vtkSmartPointer<vtkOrderIndependentTranslucentPass>::New();
      pass->SetTranslucentPass(translucent);
      this->Pass = pass;
    }
    else
    {
      auto pass = vtkSmartPointer<vtkDualDepthPeelingPass>::New();
      pass->SetTranslucentPass(translucent);
      if (blending == PEELING_WITH_VOLUMES)
      {
        pass->SetVolumetricPass(vtkNew<vtkVolumetricPass>());
      }
      this->Pass = pass;
    }
  }
  if (auto* peeling = vtkDualDepthPeelingPass::SafeDownCast(this->Pass))
  {
    peeling->SetMaximumNumberOfPeels(renderer->GetMaximumNumberOfPeels());
    peeling->SetOcclusionRatio(renderer->GetOcclusionRatio());
  }
  return this->Pass;
}

//------------------------------------------------------------------------------
void vtkWaterTranslucent::DrawPolygons(
  vtkRenderer* renderer, std::vector<vtkProp*>& props, vtkOpenGLFramebufferObject* framebuffer)
{
  this->HasPeeled = false;
  if (HasPolygons(props))
  {
    vtkRenderState state(renderer);
    state.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
    state.SetFrameBuffer(framebuffer);
    this->GetPass(renderer)->Render(&state);
    this->HasPeeled = this->Blending == PEELING_WITH_VOLUMES;
  }
}

//------------------------------------------------------------------------------
bool vtkWaterTranslucent::LeavesAlpha() const
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return true;
#else
  return this->Blending != ORDER_INDEPENDENT; // which blends alpha with its square
#endif
}

//------------------------------------------------------------------------------
void vtkWaterTranslucent::DrawVolumes(vtkRenderer* renderer, const std::vector<vtkProp*>& props)
{
  if (this->HasPeeled)
  {
    return; // with the translucent geometry
  }
  for (vtkProp* prop : props)
  {
    prop->RenderVolumetricGeometry(renderer);
  }
}

//------------------------------------------------------------------------------
void vtkWaterTranslucent::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Pass && window)
  {
    this->Pass->ReleaseGraphicsResources(window);
  }
  this->Pass = nullptr;
}
