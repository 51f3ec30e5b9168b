// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterFog.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkWaterBackdrop.h"
#include "vtkWaterFogFS.h"
#include "vtkWaterGL.h"
#include "vtkWaterHazeFS.h"
#include "vtkWaterNoShaftsFS.h"
#include "vtkWaterShaftsFS.h"
#include "vtkWaterUniforms.h"
#include "water_types.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{
// Draws go into the first of the bound draw buffers alone while an object of this class lives: the
// others have what full-screen draws know nothing of.
struct ScopedFirstBuffer
{
  ScopedFirstBuffer()
  {
    GLint count = 1;
    glGetIntegerv(GL_MAX_DRAW_BUFFERS, &count);
    for (GLint i = 0; i < count; ++i)
    {
      GLint buffer = GL_NONE;
      glGetIntegerv(static_cast<GLenum>(GL_DRAW_BUFFER0 + i), &buffer);
      this->Buffers.push_back(static_cast<GLenum>(buffer));
    }
    this->HasMore = std::any_of(this->Buffers.begin() + 1, this->Buffers.end(),
      [](GLenum buffer) { return buffer != GL_NONE; });
    if (this->HasMore)
    {
      glDrawBuffers(1, this->Buffers.data());
    }
  }
  ~ScopedFirstBuffer()
  {
    if (this->HasMore)
    {
      glDrawBuffers(static_cast<GLsizei>(this->Buffers.size()), this->Buffers.data());
    }
  }

  std::vector<GLenum> Buffers;
  bool HasMore;
};

// Draws depths alone: the farthest before the background's, where the background is.
void DrawFarDepth(vtkOpenGLState* state, vtkWaterQuad& quad)
{
  constexpr double kFarthest = 1.0 - 1.0 / 16777216.0; // of buffers with 24 bits, and of floats
  GLdouble range[2];
  glGetDoublev(GL_DEPTH_RANGE, range);
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  vtkOpenGLState::ScopedglDepthFunc depthFunc(state);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LESS);
  glDepthRange(kFarthest, kFarthest);
  quad.Draw();
  glDepthRange(range[0], range[1]);
}
}

//------------------------------------------------------------------------------
void vtkWaterFog::Draw(vtkRenderer* renderer, const water_plan& plan, vtkWaterBackdrop& backdrop,
  const double deepColor[3], const double extinction[3], bool hasShafts, Cover cover,
  const std::function<void(vtkShaderProgram*)>& setLight)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  static const std::string hazy = std::string(vtkWaterFogFS) + vtkWaterHazeFS;
  static const std::string sources[2] = { hazy + vtkWaterNoShaftsFS, hazy + vtkWaterShaftsFS };
  vtkWaterQuad& quad = hasShafts ? this->ShaftQuad : this->Quad;
  vtkShaderProgram* program = quad.Ready(window, sources[hasShafts ? 1 : 0].c_str());
  if (!program)
  {
    return;
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunc(state);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  if (cover == PROPS)
  {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_DST_ALPHA, GL_ZERO, GL_ZERO, GL_ONE);
  }
  state->vtkglDepthMask(GL_FALSE);
  vtkWaterUniforms::Set(program, "waterSceneColor", backdrop.GetColor());
  vtkWaterUniforms::Set(program, "waterSceneDepth", backdrop.GetDepth());
  vtkWaterUniforms::SetMatrix3(program, "waterNdcToRay", plan.ndc_to_ray);
  vtkWaterUniforms::SetMatrix4x3(program, "waterDirToEye", plan.dir_to_eye);
  vtkWaterUniforms::Set4(program, "waterHeightClip", plan.surface_clip);
  vtkWaterUniforms::Set(program, "waterSide", plan.side == WATER_BELOW ? -1.0 : 1.0);
  vtkWaterUniforms::Set4(program, "waterClipW", plan.clip_w);
  vtkWaterUniforms::Set3(program, "waterDeepColor", deepColor);
  vtkWaterUniforms::Set3(program, "waterExtinction", extinction);
  setLight(program);
  {
    vtkOpenGLState::ScopedglColorMask colorMask(state);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, cover == ALL_AND_OPAQUE ? GL_TRUE : GL_FALSE);
    const ScopedFirstBuffer first;
    quad.Draw();
  }
  if (cover == ALL_WITH_DEPTH)
  {
    DrawFarDepth(state, quad);
  }
}

//------------------------------------------------------------------------------
void vtkWaterFog::ReleaseGraphicsResources()
{
  this->Quad.ReleaseGraphicsResources();
  this->ShaftQuad.ReleaseGraphicsResources();
}
