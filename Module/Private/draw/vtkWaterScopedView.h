// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterScopedView: what the mirrored view changes for its own time, and puts back.
#ifndef vtkWaterScopedView_h
#define vtkWaterScopedView_h

#include "vtkCamera.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWaterAccess.h"
#include "vtkWaterGL.h"
#include "vtkWaterShaderHook.h"

#include <vector>

// Everything that the mirrored view sets, as it was, when it goes out of scope.
struct vtkWaterScopedState
{
  explicit vtkWaterScopedState(vtkOpenGLState* state)
    : State(state)
    , Viewport(state)
    , Scissor(state)
    , ClearColor(state)
    , ColorMask(state)
    , DepthMask(state)
    , DepthFunc(state)
    , BlendFunc(state)
    , DepthTest(state, GL_DEPTH_TEST)
    , Blend(state, GL_BLEND)
    , CullFace(state, GL_CULL_FACE)
    , ScissorTest(state, GL_SCISSOR_TEST)
  {
    state->PushFramebufferBindings();
  }
  ~vtkWaterScopedState() { this->State->PopFramebufferBindings(); }

  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglClearColor ClearColor;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunc;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunc;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
};

// The renderer looks through another camera while an object of this class lives; nobody is told.
// The renderer holds a reference on the camera in its slot, whoever puts it there: a user who sets
// another one from an observer meanwhile gets that.
struct vtkWaterScopedCamera
{
  vtkWaterScopedCamera(vtkRenderer* renderer, vtkCamera* camera)
    : Renderer(renderer)
    , Slot(vtkWaterAccess::Renderer::ActiveCameraOf(renderer))
    , User(this->Slot)
    , Mirrored(camera)
  {
    camera->Register(renderer);
    this->Slot = camera;
  }
  ~vtkWaterScopedCamera()
  {
    if (this->Slot == this->Mirrored)
    {
      this->Slot = this->User;
      this->Mirrored->UnRegister(this->Renderer);
    }
    else
    {
      this->User->UnRegister(this->Renderer);
    }
  }

  vtkRenderer* Renderer;
  vtkCamera*& Slot;
  vtkCamera* User;
  vtkSmartPointer<vtkCamera> Mirrored;
};

struct vtkWaterScopedMirroredView
{
  vtkWaterScopedMirroredView(vtkWaterShaderHook* hook, const vtkWaterShaderHook::View& view)
    : Hook(hook)
  {
    hook->BeginMirroredView(view);
  }
  ~vtkWaterScopedMirroredView() { this->Hook->EndMirroredView(); }

  vtkWaterShaderHook* Hook;
};

// Drawing adds to a prop's estimated render time, from which VTK chooses levels of detail and
// allots time; the mirrored view must not make props look slower than they are.
struct vtkWaterScopedRenderTimes
{
  vtkWaterScopedRenderTimes(vtkRenderer* renderer, const std::vector<vtkProp*>& props)
    : Renderer(renderer)
    , Props(props)
  {
    for (vtkProp* prop : props)
    {
      this->Before.push_back(prop->GetEstimatedRenderTime(renderer));
    }
  }
  ~vtkWaterScopedRenderTimes()
  {
    for (size_t i = 0; i < this->Props.size(); ++i)
    {
      const double added = this->Props[i]->GetEstimatedRenderTime(this->Renderer) - this->Before[i];
      this->Props[i]->AddEstimatedRenderTime(-added, this->Renderer);
    }
  }

  vtkRenderer* Renderer;
  const std::vector<vtkProp*>& Props;
  std::vector<double> Before;
};

#endif
