// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterReflectionPass.cxx: the pass in a chain of passes: the reflections, then its delegate.
// What is set is in vtkWaterReflectionPassSettings.cxx, what renders them in Private/reflection.
#include "vtkWaterReflectionPass.h"

#include "vtkCamera.h"
#include "vtkHardwareSelector.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkWaterCompat.h"
#include "vtkWaterFrame.h"
#include "vtkWaterPasses.h"
#include "vtkWaterPropKeys.h"
#include "vtkWaterReflection.h"
#include "vtkWaterSource.h"
#include "water_plane.h"

#include <cstdlib>
#include <cstring>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkWaterReflectionPass);
vtkInformationKeyMacro(vtkWaterReflectionPass, NOT_REFLECTED, Integer);
vtkInformationKeyRestrictedMacro(vtkWaterReflectionPass, STAND_IN, ObjectBase, "vtkProp");

namespace
{
// The first water of a list of props, and all that share its plane.
std::vector<vtkWaterSource*> FindWaters(vtkProp** props, int count)
{
  std::vector<vtkWaterSource*> waters;
  water_plane first = water_plane();
  double origin[3];
  for (int i = 0; i < count; ++i)
  {
    vtkWaterSource* water = vtkWaterSource::Of(props[i]);
    if (!water)
    {
      continue;
    }
    water_plane plane;
    water->ReadPlane(&plane, origin);
    if (waters.empty())
    {
      first = plane;
      waters.push_back(water);
    }
    else if (water_plane_is_identical(&first, &plane))
    {
      waters.push_back(water);
    }
  }
  return waters;
}
}

//------------------------------------------------------------------------------
vtkInformationIntegerKey* vtkWaterPropKeys::NotReflected()
{
  return vtkWaterReflectionPass::NOT_REFLECTED();
}

//------------------------------------------------------------------------------
vtkInformationObjectBaseKey* vtkWaterPropKeys::StandIn()
{
  return vtkWaterReflectionPass::STAND_IN();
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkWaterPasses::DelegateOf(vtkRenderPass* waterPass)
{
  return static_cast<vtkWaterReflectionPass*>(waterPass)->GetDelegatePass();
}

//------------------------------------------------------------------------------
vtkWaterReflectionPass::vtkWaterReflectionPass()
  : Reflection(std::make_shared<vtkWaterReflection>())
{
  const char* debug = std::getenv("VTK_WATER_DEBUG");
  this->ShowReflection = debug && std::strcmp(debug, "1") == 0;
}

//------------------------------------------------------------------------------
vtkWaterReflectionPass::~vtkWaterReflectionPass() = default;

//------------------------------------------------------------------------------
vtkWaterReflection& vtkWaterReflectionPass::GetReflection()
{
  return *this->Reflection;
}

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
    this->HasCycle = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkWaterReflectionPass::GetDelegatePass()
{
  return this->DelegatePass;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::KeepBackground(vtkRenderer* renderer)
{
  vtkWaterKeptBackground& kept = this->Reflection->Background;
  kept = vtkWaterKeptBackground();
  if (renderer)
  {
    kept.IsKept = true;
    vtkWaterSkyReader::ReadBackground(renderer, kept.Sky, kept.Textures);
  }
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetController(vtkMultiProcessController* controller)
{
  if (this->GetController() != controller)
  {
    this->Reflection->Ranks.SetController(controller);
    this->Modified();
    const int started = vtkWaterRanks::GetStartedCount();
    if (this->Reflection->Ranks.GetProcessCount() == 1 && started > 1)
    {
      vtkErrorMacro("the controller has 1 process, but MPI has started "
        << started << ": this rank reflects its own part of the scene alone. Set a controller of "
        << "all ranks that share the scene, from the MPI that started them, or nullptr for a rank "
        << "that renders alone.");
    }
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkWaterReflectionPass::GetController() const
{
  return this->Reflection->Ranks.GetController();
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterReflectionPass::GetNumberOfPixelsJoined() const
{
  return this->Reflection->GetReport().JoinedPixels;
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkWaterReflectionPass::FindDelegate()
{
  if (this->DelegatePass)
  {
    return this->DelegatePass;
  }
  if (!this->DefaultDelegate)
  {
    this->DefaultDelegate = vtkSmartPointer<vtkRenderStepsPass>::New();
  }
  return this->DefaultDelegate;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::Render(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  if (!this->Rendering.insert(renderer).second)
  {
    if (!this->HasCycle)
    {
      vtkErrorMacro("DelegatePass leads back to this pass; the chain must end in another pass. "
                    "Nothing is rendered at its end.");
    }
    this->HasCycle = true; // until another delegate is set
    return;
  }
  this->RenderReflectionAndDelegate(s);
  this->Rendering.erase(renderer);
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
    this->Reflection->Decline(WATER_NO_REFLECT_SELECTING);
    return;
  }
  if (!s->GetFrameBuffer() &&
    renderer->GetActiveCamera()->GetStereo() != renderer->GetRenderWindow()->GetStereoRender())
  {
    // only the camera's Render lets it know of stereo, and passes do not call it
    renderer->GetActiveCamera()->Render(renderer);
  }
  this->RenderReflection(s);
  const vtkSmartPointer<vtkRenderPass> delegate = this->FindDelegate();
  delegate->Render(s);
  this->NumberOfRenderedProps = delegate->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::RenderReflection(const vtkRenderState* s)
{
  const std::vector<vtkWaterSource*> waters = FindWaters(s->GetPropArray(), s->GetPropArrayCount());
  if (waters.empty())
  {
    return;
  }
  for (vtkWaterSource* water : waters)
  {
    water->SetComposedPass(this);
  }
  vtkRenderer* renderer = s->GetRenderer();
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
  vtkWaterFrame::Of(renderer).RenderComposed(*this->Reflection, waters, size);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->IsVisiting)
  {
    return; // the chain of delegates leads back to this pass
  }
  this->IsVisiting = true;
  // without a window: a renderer gets its first one; VTK's passes assert that there is one
  for (vtkRenderPass* delegate : { this->DelegatePass.Get(), this->DefaultDelegate.Get() })
  {
    if (delegate && window)
    {
      delegate->ReleaseGraphicsResources(window);
    }
  }
  this->IsVisiting = false;
  this->Reflection->ReleaseGraphicsResources(window);
  if (window)
  {
    this->Superclass::ReleaseGraphicsResources(window);
  }
}

VTK_ABI_NAMESPACE_END
