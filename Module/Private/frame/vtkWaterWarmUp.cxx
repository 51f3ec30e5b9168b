// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterWarmUp.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkWaterFrame.h"
#include "vtkWaterGL.h"
#include "vtkWaterRenderPassKeys.h"
#include "vtkWaterShaderHook.h"
#include "vtkWaterSource.h"

//------------------------------------------------------------------------------
// A command whose owner is gone removes itself at its next event. The owner cannot do so when it is
// deleted: that may be by the renderer while it goes through its observers, such as one that held
// the last reference to the water.
class vtkWaterWarmUp::Command : public vtkCommand
{
public:
  static Command* New() { return new Command; }

  void Execute(vtkObject* renderer, unsigned long, void*) override
  {
    if (this->Owner)
    {
      this->Owner->EndFrame(static_cast<vtkRenderer*>(renderer));
    }
    else
    {
      renderer->RemoveObserver(this);
    }
  }

  vtkWaterWarmUp* Owner = nullptr;
};

//------------------------------------------------------------------------------
vtkWaterWarmUp::vtkWaterWarmUp(vtkWaterSource& water)
  : Water(water)
  , Observer(vtkSmartPointer<Command>::New())
{
  this->Observer->Owner = this;
}

//------------------------------------------------------------------------------
vtkWaterWarmUp::~vtkWaterWarmUp()
{
  this->Observer->Owner = nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterWarmUp::Expect()
{
  vtkProp* prop = this->Water.GetProp();
  for (int i = 0; !this->IsDone && i < prop->GetNumberOfConsumers(); ++i)
  {
    auto* renderer = vtkOpenGLRenderer::SafeDownCast(prop->GetConsumer(i));
    if (renderer && !renderer->HasObserver(vtkCommand::EndEvent, this->Observer))
    {
      renderer->AddObserver(vtkCommand::EndEvent, this->Observer);
      this->Renderers.emplace_back(renderer);
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterWarmUp::SetIsDone()
{
  this->IsDone = true;
  for (vtkRenderer* renderer : this->Renderers)
  {
    if (renderer)
    {
      renderer->RemoveObserver(this->Observer);
    }
  }
  this->Renderers.clear();
}

//------------------------------------------------------------------------------
void vtkWaterWarmUp::EndFrame(vtkRenderer* anyRenderer)
{
  vtkActor* prop = this->Water.GetProp();
  vtkOpenGLRenderer* renderer = vtkWaterFrame::FindMainView(anyRenderer);
  if (!renderer || !renderer->HasViewProp(prop) || !prop->GetVisibility() ||
    !prop->HasOpaqueGeometry() || this->Water.HasSheetError() ||
    !vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()))
  {
    return;
  }
  if (!vtkWaterFrame::Of(renderer).IsSoftware())
  {
    vtkOpenGLState* state = renderer->GetState();
    const vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
    const vtkOpenGLState::ScopedglScissor scissor(state);
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglScissor(0, 0, 0, 0); // no pixel is drawn
    vtkWaterShaderHook* hook = vtkWaterFrame::GetHook();
    const bool hadKey = vtkWaterRenderPassKeys::Has(prop, hook);
    this->IsDrawing = true;
    this->Water.Probe(renderer);
    this->IsDrawing = false;
    if (!hadKey)
    {
      vtkWaterRenderPassKeys::Remove(prop, hook); // no frame is there to do it
    }
  }
  this->SetIsDone();
}
