// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterRenderPassKeys.h"

#include "vtkCallbackCommand.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWaterAccess.h"
#include "vtkWaterReflectionPass.h"

#include <algorithm>
#include <limits>

namespace
{
using Passes = std::vector<vtkSmartPointer<vtkObjectBase>>;

Passes GetPasses(vtkProp* prop)
{
  Passes passes;
  vtkInformation* keys = prop->GetPropertyKeys();
  if (keys && keys->Has(vtkOpenGLRenderPass::RenderPasses()))
  {
    const int count = keys->Length(vtkOpenGLRenderPass::RenderPasses());
    for (int i = 0; i < count; ++i)
    {
      passes.emplace_back(keys->Get(vtkOpenGLRenderPass::RenderPasses(), i));
    }
  }
  return passes;
}

void SetPasses(vtkProp* prop, const Passes& passes)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  // one by one: Append counts a reference twice, and only this Remove takes back both
  for (vtkObjectBase* pass : GetPasses(prop))
  {
    keys->Remove(vtkOpenGLRenderPass::RenderPasses(), pass);
  }
  for (vtkObjectBase* pass : passes)
  {
    keys->Append(vtkOpenGLRenderPass::RenderPasses(), pass);
  }
}

vtkProp* GetStandIn(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys && keys->Has(vtkWaterReflectionPass::STAND_IN())
    ? vtkProp::SafeDownCast(keys->Get(vtkWaterReflectionPass::STAND_IN()))
    : nullptr;
}

template <typename Function>
void ForEachProp(vtkPropCollection* props, Function function)
{
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    function(prop);
    if (vtkProp* drawn = GetStandIn(prop))
    {
      function(drawn);
    }
    if (prop->IsA("vtkAxesActor"))
    {
      // the one prop with parts that does not hand its keys on to them
      vtkNew<vtkPropCollection> parts;
      prop->GetActors(parts);
      ForEachProp(parts, function);
    }
  }
}

// A prop that stands in for itself would never die: it holds its keys, and they hold it.
void DropOwnStandIns(vtkPropCollection* props)
{
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    if (GetStandIn(prop) == prop)
    {
      prop->GetPropertyKeys()->Remove(vtkWaterReflectionPass::STAND_IN());
    }
  }
}

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
}

//------------------------------------------------------------------------------
vtkWaterRenderPassKeys::vtkWaterRenderPassKeys(vtkOpenGLRenderPass* key)
  : Key(key)
  , Elsewhere(vtkSmartPointer<vtkCallbackCommand>::New())
{
  this->Elsewhere->SetClientData(this);
  this->Elsewhere->SetCallback([](vtkObject* caller, unsigned long, void* clientData, void*) {
    auto* self = static_cast<vtkWaterRenderPassKeys*>(clientData);
    if (self && static_cast<vtkRenderer*>(caller)->GetRenderWindow() != self->LastWindow)
    {
      self->LastWindow = nullptr;
    }
  });
}

//------------------------------------------------------------------------------
vtkWaterRenderPassKeys::~vtkWaterRenderPassKeys()
{
  this->Elsewhere->SetClientData(nullptr); // renderers have it until they go
  for (auto& held : this->HeldFrames)
  {
    this->EndFrame(held.second);
  }
}

//------------------------------------------------------------------------------
bool vtkWaterRenderPassKeys::Has(vtkProp* prop) const
{
  const Passes passes = GetPasses(prop);
  return std::find(passes.begin(), passes.end(), this->Key) != passes.end();
}

//------------------------------------------------------------------------------
void vtkWaterRenderPassKeys::Add(vtkProp* prop)
{
  if (this->Has(prop))
  {
    return;
  }
  if (!prop->GetPropertyKeys())
  {
    // silently: a key for a frame is no change of the prop
    vtkWaterAccess::Prop::PropertyKeysOf(prop) = vtkInformation::New();
  }
  prop->GetPropertyKeys()->Append(vtkOpenGLRenderPass::RenderPasses(), this->Key);
}

//------------------------------------------------------------------------------
void vtkWaterRenderPassKeys::Remove(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  if (keys && keys->Has(vtkOpenGLRenderPass::RenderPasses()))
  {
    keys->Remove(vtkOpenGLRenderPass::RenderPasses(), this->Key);
    if (keys->Length(vtkOpenGLRenderPass::RenderPasses()) == 0)
    {
      keys->Remove(vtkOpenGLRenderPass::RenderPasses());
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterRenderPassKeys::WatchOtherWindows(vtkProp* prop, vtkRenderWindow* window)
{
  // also those without water, in which nothing else tells that they have drawn it
  for (int i = 0; i < prop->GetNumberOfConsumers(); ++i)
  {
    auto* renderer = vtkRenderer::SafeDownCast(prop->GetConsumer(i));
    if (renderer && renderer->GetRenderWindow() && renderer->GetRenderWindow() != window &&
      !renderer->HasObserver(vtkCommand::StartEvent, this->Elsewhere))
    {
      renderer->AddObserver(vtkCommand::StartEvent, this->Elsewhere);
      this->LastWindow = nullptr; // it may have drawn already
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterRenderPassKeys::HoldUntilEndOfFrame(vtkRenderer* renderer)
{
  for (auto it = this->HeldFrames.begin(); it != this->HeldFrames.end();)
  {
    if (it->second.Renderer)
    {
      ++it;
      continue;
    }
    HeldFrame dead = std::move(it->second); // a renderer that died took its observer along
    it = this->HeldFrames.erase(it);
    this->EndFrame(dead);
  }
  if (this->GetFrame(renderer))
  {
    return; // another water of this frame was first
  }
  DropOwnStandIns(renderer->GetViewProps());
  vtkRenderWindow* window = renderer->GetRenderWindow();
  ForEachProp(
    renderer->GetViewProps(), [&](vtkProp* prop) { this->WatchOtherWindows(prop, window); });
  if (this->LastWindow != window)
  {
    ForEachProp(
      renderer->GetViewProps(), [window](vtkProp* prop) { ReleaseFromOtherWindows(prop, window); });
    window->MakeCurrent();
    this->LastWindow = window;
  }
  HeldFrame& held = this->HeldFrames[renderer];
  this->EndFrame(held); // somebody removed the observer
  held.Renderer = renderer;
  held.Frame.Modified();
  ForEachProp(renderer->GetViewProps(), [&](vtkProp* prop) {
    if (prop->GetVisibility() && !this->Has(prop))
    {
      this->Add(prop);
      held.Props.emplace_back(prop);
    }
  });
  held.Observer = vtkSmartPointer<vtkCallbackCommand>::New();
  held.Observer->SetClientData(this);
  held.Observer->SetCallback([](vtkObject* caller, unsigned long event, void* clientData, void*) {
    auto* self = static_cast<vtkWaterRenderPassKeys*>(clientData);
    auto* ended = static_cast<vtkRenderer*>(caller);
    auto found = self->HeldFrames.find(ended);
    if (found != self->HeldFrames.end())
    {
      self->EndFrame(found->second);
    }
    if (event == vtkCommand::EndEvent)
    {
      ForEachProp(ended->GetViewProps(),
        [ended](vtkProp* prop) { ReleaseForNewWindows(prop, ended->GetRenderWindow()); });
    }
  });
  // before the user's observers, which may abort the event; a frame that begins has ended the last
  const float first = std::numeric_limits<float>::max();
  renderer->AddObserver(vtkCommand::StartEvent, held.Observer, first);
  renderer->AddObserver(vtkCommand::EndEvent, held.Observer, first);
}

//------------------------------------------------------------------------------
void vtkWaterRenderPassKeys::EndFrame(HeldFrame& held)
{
  // what dies with its last reference may run the user's code, so all else comes first
  const auto props = std::move(held.Props);
  held.Props.clear();
  for (vtkProp* prop : props)
  {
    this->Remove(prop);
  }
  if (held.Renderer && held.Observer)
  {
    held.Renderer->RemoveObserver(held.Observer);
  }
  held.Observer = nullptr;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkWaterRenderPassKeys::GetFrame(vtkRenderer* renderer) const
{
  auto found = this->HeldFrames.find(renderer);
  return found != this->HeldFrames.end() && found->second.Renderer && found->second.Observer &&
      renderer->HasObserver(vtkCommand::EndEvent, found->second.Observer)
    ? found->second.Frame.GetMTime()
    : 0;
}

//------------------------------------------------------------------------------
vtkRenderWindow* vtkWaterRenderPassKeys::GetWindow() const
{
  return this->LastWindow;
}

//------------------------------------------------------------------------------
bool vtkWaterRenderPassKeys::IsBakingShadows(vtkProp* prop)
{
  const Passes passes = GetPasses(prop);
  return std::any_of(passes.begin(), passes.end(),
    [](vtkObjectBase* pass) { return pass->IsA("vtkShadowMapBakerPass"); });
}

//------------------------------------------------------------------------------
vtkWaterForeignKeysSuspended::vtkWaterForeignKeysSuspended(
  vtkOpenGLRenderPass* key, vtkRenderer* renderer)
{
  const Passes alone{ key };
  ForEachProp(renderer->GetViewProps(), [&](vtkProp* prop) {
    Passes passes = GetPasses(prop);
    if (!passes.empty() && passes != alone)
    {
      SetPasses(prop, alone);
      this->Saved.push_back(SavedKeys{ prop, std::move(passes) });
    }
  });
}

//------------------------------------------------------------------------------
vtkWaterForeignKeysSuspended::~vtkWaterForeignKeysSuspended()
{
  for (SavedKeys& saved : this->Saved)
  {
    SetPasses(saved.Prop, saved.Passes);
  }
}
