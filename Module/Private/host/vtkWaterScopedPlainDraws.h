// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterScopedPlainDraws: draws write colours, all of them, in a viewport of their own, while an
// object of this class lives.
#ifndef vtkWaterScopedPlainDraws_h
#define vtkWaterScopedPlainDraws_h

#include "vtkOpenGLState.h"
#include "vtkWaterGL.h"

#include <initializer_list>

struct vtkWaterScopedPlainDraws
{
  explicit vtkWaterScopedPlainDraws(vtkOpenGLState* state)
    : State(state)
    , Viewport(state)
    , ScissorTest(state, GL_SCISSOR_TEST)
    , DepthTest(state, GL_DEPTH_TEST)
    , StencilTest(state, GL_STENCIL_TEST)
    , Blend(state, GL_BLEND)
    , CullFace(state, GL_CULL_FACE)
    , BlendFunc(state)
    , ColorMask(state)
  {
    for (GLenum test : { GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_BLEND, GL_CULL_FACE })
    {
      state->vtkglDisable(test);
    }
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }

  void SetSize(const int size_px[2]) { this->State->vtkglViewport(0, 0, size_px[0], size_px[1]); }

  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable StencilTest;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunc;
  vtkOpenGLState::ScopedglColorMask ColorMask;
};

#endif
