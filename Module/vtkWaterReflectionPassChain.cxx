// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterReflectionPassChain.cxx: the part of vtkWaterReflectionPass that stands in a chain of
// passes: the reflection, then its delegate.
#include "vtkCamera.h"
#include "vtkHardwareSelector.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkTextureObject.h"
#include "vtkWaterActor.h"
#include "vtkWaterCompat.h"
#include "vtkWaterReflectionPass.h"
#include "vtkWaterReflectionPassInternals.h"

VTK_ABI_NAMESPACE_BEGIN

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
  // without a window: a renderer gets its first one; VTK's passes assert that there is one
  for (vtkRenderPass* delegate : { this->DelegatePass.Get(), this->DefaultDelegate.Get() })
  {
    if (delegate && window)
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
  if (window)
  {
    this->Superclass::ReleaseGraphicsResources(window);
  }
}

VTK_ABI_NAMESPACE_END
