// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterScreen.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkWaterBackdrop.h"
#include "vtkWaterFogFS.h"
#include "vtkWaterGL.h"
#include "vtkWaterMaskFS.h"
#include "vtkWaterSceneDepth.h"
#include "vtkWaterSkyFS.h"
#include "vtkWaterUniforms.h"
#include "vtkWaterViewFS.h"

#include <algorithm>
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

// Draws a full-screen quad over the current viewport with a fragment shader; false when it does not
// compile.
bool Ready(std::unique_ptr<vtkOpenGLQuadHelper>& quad, vtkOpenGLRenderWindow* window,
  const char* fragmentShader)
{
  if (!quad)
  {
    quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, fragmentShader, nullptr);
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(quad->Program);
  }
  return quad->Program && quad->Program->GetCompiled();
}
}

//------------------------------------------------------------------------------
vtkWaterScreen::vtkWaterScreen() = default;

//------------------------------------------------------------------------------
vtkWaterScreen::~vtkWaterScreen() = default;

//------------------------------------------------------------------------------
void vtkWaterScreen::DrawSky(vtkRenderer* renderer, const water_plan& plan)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  const double* bottom = renderer->GetBackground();
  const float alpha = static_cast<float>(renderer->GetBackgroundAlpha());
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglClearDepth(1.0);
  state->vtkglClearColor(static_cast<float>(bottom[0]), static_cast<float>(bottom[1]),
    static_cast<float>(bottom[2]), alpha);
  state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (!renderer->GetGradientBackground() || renderer->GetTexturedBackground() ||
    !Ready(this->Sky, window, vtkWaterSkyFS))
  {
    return;
  }
  const double* top = renderer->GetBackground2();
  vtkShaderProgram* program = this->Sky->Program;
  const float bottomAlpha[4] = { static_cast<float>(bottom[0]), static_cast<float>(bottom[1]),
    static_cast<float>(bottom[2]), alpha };
  const float topAlpha[4] = { static_cast<float>(top[0]), static_cast<float>(top[1]),
    static_cast<float>(top[2]), alpha };
  program->SetUniform4f("waterSkyBottom", bottomAlpha);
  program->SetUniform4f("waterSkyTop", topAlpha);
  vtkWaterUniforms::SetMatrix3(program, "waterMapNdcToEye", plan.map_ndc_to_eye);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDepthMask(GL_FALSE);
  this->Sky->Render();
}

//------------------------------------------------------------------------------
void vtkWaterScreen::DrawMask(
  vtkRenderer* renderer, const water_plan& plan, vtkWaterSceneDepth& sceneDepth)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if (!Ready(this->Mask, window, vtkWaterMaskFS))
  {
    return;
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglDepthFunc depthFunc(state);
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_ALWAYS);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  vtkShaderProgram* program = this->Mask->Program;
  program->SetUniformi("waterSceneDepth", sceneDepth.Activate(window));
  const int corner[2] = { sceneDepth.GetOrigin()[0] + plan.texture_px[0] - 1,
    sceneDepth.GetOrigin()[1] };
  program->SetUniform2i("waterSceneCorner", corner);
  vtkWaterUniforms::Set4(program, "waterHeightClip", plan.plane_clip);
  vtkWaterUniforms::Set(program, "waterRounding", plan.mask_rounding);
  glDepthRange(0.0, 0.0); // VTK keeps no record of it
  this->Mask->Render();
  glDepthRange(0.0, 1.0);
  sceneDepth.Deactivate();
}

//------------------------------------------------------------------------------
void vtkWaterScreen::DrawFog(vtkRenderer* renderer, const water_plan& plan,
  vtkWaterBackdrop& backdrop, const double deepColor[3], const double extinction[3])
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if (!Ready(this->Fog, window, vtkWaterFogFS))
  {
    return;
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDepthMask(GL_FALSE);
  vtkShaderProgram* program = this->Fog->Program;
  backdrop.GetColor()->Activate();
  backdrop.GetDepth()->Activate();
  vtkWaterUniforms::Set(program, "waterSceneColor", backdrop.GetColor());
  vtkWaterUniforms::Set(program, "waterSceneDepth", backdrop.GetDepth());
  vtkWaterUniforms::SetMatrix3(program, "waterNdcToRay", plan.ndc_to_ray);
  vtkWaterUniforms::SetMatrix4x3(program, "waterDirToEye", plan.dir_to_eye);
  vtkWaterUniforms::Set4(program, "waterHeightClip", plan.plane_clip);
  vtkWaterUniforms::Set(program, "waterSide", plan.side == WATER_BELOW ? -1.0 : 1.0);
  vtkWaterUniforms::Set4(program, "waterClipW", plan.clip_w);
  vtkWaterUniforms::Set3(program, "waterDeepColor", deepColor);
  vtkWaterUniforms::Set3(program, "waterExtinction", extinction);
  {
    vtkOpenGLState::ScopedglColorMask colorMask(state);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    const ScopedFirstBuffer first;
    this->Fog->Render();
  }
  backdrop.GetDepth()->Deactivate();
  backdrop.GetColor()->Deactivate();
}

//------------------------------------------------------------------------------
void vtkWaterScreen::DrawCorner(vtkRenderer* renderer, vtkTextureObject* reflection)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  int width;
  int height;
  int x;
  int y;
  renderer->GetTiledSizeAndOrigin(&width, &height, &x, &y);
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  state->vtkglViewport(x, y, width / 2, height / 2);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDepthMask(GL_FALSE);
  if (Ready(this->Corner, window, vtkWaterViewFS))
  {
    reflection->Activate();
    this->Corner->Program->SetUniformi("waterReflection", reflection->GetTextureUnit());
    this->Corner->Render();
    reflection->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkWaterScreen::ReleaseGraphicsResources()
{
  this->Sky.reset();
  this->Mask.reset();
  this->Fog.reset();
  this->Corner.reset();
}
