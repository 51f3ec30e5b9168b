// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterFrameThread.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWaterProps.h"

#include <functional>

namespace
{
// VTK's mappers and textures free what they hold for another window in the middle of their draw,
// with that window's context current, and only some of its windows make the drawing one current
// again (vtkOpenGLRenderWindow::PopContext does nothing): what follows goes into the other window,
// or crashes. So it is done before.
void ReleaseFromOtherWindows(vtkProp* prop, vtkRenderWindow* window)
{
  for (int i = 0; i < prop->GetNumberOfConsumers(); ++i)
  {
    auto* renderer = vtkRenderer::SafeDownCast(prop->GetConsumer(i));
    if (renderer && renderer->GetRenderWindow() && renderer->GetRenderWindow() != window)
    {
      prop->ReleaseGraphicsResources(renderer->GetRenderWindow());
    }
  }
}

// An OSMesa window frees all of its props when it is initialised, after it has made its context
// current, and then sets that one up (vtkOSOpenGLRenderWindow::WindowInitialize): what they hold
// for another window makes that one's current, and it is set up in its place, for good. So a prop
// holds nothing when the first frame of such a window may be next.
void ReleaseForNewWindows(vtkProp* prop, vtkRenderWindow* window)
{
  for (int i = 0; i < prop->GetNumberOfConsumers(); ++i)
  {
    auto* renderer = vtkRenderer::SafeDownCast(prop->GetConsumer(i));
    vtkRenderWindow* other = renderer ? renderer->GetRenderWindow() : nullptr;
    if (other && other != window && other->GetNeverRendered() &&
      other->IsA("vtkOSOpenGLRenderWindow"))
    {
      prop->ReleaseGraphicsResources(window);
    }
  }
}

void ForEachOf(const std::vector<vtkProp*>& props, const std::function<void(vtkProp*)>& function)
{
  for (vtkProp* prop : props)
  {
    vtkWaterProps::ForEachOf(prop, function);
  }
}
}

//------------------------------------------------------------------------------
vtkWaterFrameThread& vtkWaterFrameThread::Get()
{
  static thread_local vtkWaterFrameThread thread;
  return thread;
}

//------------------------------------------------------------------------------
vtkWaterFrameThread::vtkWaterFrameThread()
  : Elsewhere(vtkSmartPointer<vtkCallbackCommand>::New())
{
  this->Elsewhere->SetClientData(this);
  this->Elsewhere->SetCallback([](vtkObject* caller, unsigned long, void* clientData, void*) {
    auto* self = static_cast<vtkWaterFrameThread*>(clientData);
    if (self && static_cast<vtkRenderer*>(caller)->GetRenderWindow() != self->LastWindow)
    {
      self->SetLastWindow(nullptr);
    }
  });
}

//------------------------------------------------------------------------------
vtkWaterFrameThread::~vtkWaterFrameThread()
{
  this->Elsewhere->SetClientData(nullptr); // renderers have it until they go
}

//------------------------------------------------------------------------------
void vtkWaterFrameThread::SetLastWindow(vtkRenderWindow* window)
{
  this->LastWindow = window;
  this->Hook->Window = vtkOpenGLRenderWindow::SafeDownCast(window);
}

//------------------------------------------------------------------------------
void vtkWaterFrameThread::Prune()
{
  for (auto it = this->Frames.begin(); it != this->Frames.end();)
  {
    if (it->second->IsAlive())
    {
      ++it;
      continue;
    }
    const std::unique_ptr<vtkWaterFrame> dead = std::move(it->second);
    it = this->Frames.erase(it);
  }
}

//------------------------------------------------------------------------------
void vtkWaterFrameThread::WatchOtherWindows(vtkProp* prop, vtkRenderWindow* window)
{
  // also those without water, in which nothing else tells that they have drawn it
  for (int i = 0; i < prop->GetNumberOfConsumers(); ++i)
  {
    auto* renderer = vtkRenderer::SafeDownCast(prop->GetConsumer(i));
    if (renderer && renderer->GetRenderWindow() && renderer->GetRenderWindow() != window &&
      !renderer->HasObserver(vtkCommand::StartEvent, this->Elsewhere))
    {
      renderer->AddObserver(vtkCommand::StartEvent, this->Elsewhere);
      this->SetLastWindow(nullptr); // it may have drawn already
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterFrameThread::SwitchTo(vtkRenderer* renderer, const std::vector<vtkProp*>& props)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  ForEachOf(props, [this, window](vtkProp* prop) { this->WatchOtherWindows(prop, window); });
  if (this->LastWindow != window)
  {
    ForEachOf(props, [window](vtkProp* prop) { ReleaseFromOtherWindows(prop, window); });
    window->MakeCurrent();
    this->SetLastWindow(window);
  }
}

//------------------------------------------------------------------------------
void vtkWaterFrameThread::PrepareForNewWindows(
  vtkRenderer* renderer, const std::vector<vtkProp*>& props)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  ForEachOf(props, [window](vtkProp* prop) { ReleaseForNewWindows(prop, window); });
}
