// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterBackground.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkWaterGL.h"
#include "vtkWaterSkyFS.h"
#include "vtkWaterSkyReader.h"
#include "vtkWaterUniforms.h"
#include "vtkWaterViewFS.h"

//------------------------------------------------------------------------------
void vtkWaterBackground::DrawSky(
  vtkRenderer* renderer, const water_plan& plan, const vtkWaterSkyTextures& textures)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  const double* bottom = plan.sky.bottom;
  const double* top = plan.sky.top;
  const double alpha = plan.is_enclosed ? 0.0 : plan.sky.alpha;
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglClearDepth(1.0);
  state->vtkglClearColor(static_cast<float>(bottom[0]), static_cast<float>(bottom[1]),
    static_cast<float>(bottom[2]), static_cast<float>(alpha));
  {
    // all of it: drivers have a way for that which is faster than for a part
    vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
  vtkShaderProgram* program =
    plan.sky.screen != WATER_SCREEN_COLOR ? this->Sky.Ready(window, vtkWaterSkyFS) : nullptr;
  if (!program)
  {
    return;
  }
  const double bottomAlpha[4] = { bottom[0], bottom[1], bottom[2], alpha };
  const double topAlpha[4] = { top[0], top[1], top[2], alpha };
  vtkWaterUniforms::Set4(program, "waterSkyBottom", bottomAlpha);
  vtkWaterUniforms::Set4(program, "waterSkyTop", topAlpha);
  vtkWaterUniforms::SetMatrix3(program, "waterReflectionNdcToEye", plan.reflection_ndc_to_eye);
  vtkWaterUniforms::Set(program, "waterScreen", static_cast<int>(plan.sky.screen));
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  const double border[2] = { 0.5 / size[0], 0.5 / size[1] };
  vtkWaterUniforms::Set2(program, "waterScreenBorder", border);
  vtkTexture* picture = textures.Screen;
  if (picture)
  {
    picture->Render(renderer);
    vtkWaterUniforms::Set(program, "waterScreenPicture", picture->GetTextureUnit());
  }
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDepthMask(GL_FALSE);
  this->Sky.Draw();
  if (picture)
  {
    picture->PostRender(renderer);
  }
}

//------------------------------------------------------------------------------
void vtkWaterBackground::DrawCorner(vtkRenderer* renderer, vtkTextureObject* reflection)
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
  if (vtkShaderProgram* program = this->Corner.Ready(window, vtkWaterViewFS))
  {
    reflection->Activate();
    program->SetUniformi("waterReflection", reflection->GetTextureUnit());
    this->Corner.Draw();
    reflection->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkWaterBackground::ReleaseGraphicsResources()
{
  this->Sky.ReleaseGraphicsResources();
  this->Corner.ReleaseGraphicsResources();
}
