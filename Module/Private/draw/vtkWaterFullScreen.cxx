// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterFullScreen.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkWaterBackdrop.h"
#include "vtkWaterCoverFS.h"
#include "vtkWaterCoverVS.h"
#include "vtkWaterFogFS.h"
#include "vtkWaterGL.h"
#include "vtkWaterMaskFS.h"
#include "vtkWaterSceneDepth.h"
#include "vtkWaterSkyFS.h"
#include "vtkWaterUniforms.h"
#include "vtkWaterViewFS.h"
#include "water_visibility.h"

#include <algorithm>
#include <array>
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

// Draws write depths alone, whatever is there, while an object of this class lives.
struct ScopedDepthsOnly
{
  explicit ScopedDepthsOnly(vtkOpenGLState* state)
    : DepthTest(state, GL_DEPTH_TEST)
    , DepthMask(state)
    , DepthFunc(state)
    , ColorMask(state)
  {
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglDepthFunc(GL_ALWAYS);
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  }

  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunc;
  vtkOpenGLState::ScopedglColorMask ColorMask;
};
}

//------------------------------------------------------------------------------
bool vtkWaterFullScreen::Ready(std::unique_ptr<vtkOpenGLQuadHelper>& quad,
  vtkOpenGLRenderWindow* window, const char* fragmentShader)
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

//------------------------------------------------------------------------------
vtkWaterFullScreen::vtkWaterFullScreen() = default;

//------------------------------------------------------------------------------
vtkWaterFullScreen::~vtkWaterFullScreen() = default;

//------------------------------------------------------------------------------
void vtkWaterFullScreen::DrawSky(vtkRenderer* renderer, const water_plan& plan)
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
  {
    // all of it: drivers have a way for that which is faster than for a part
    vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
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
  vtkWaterUniforms::SetMatrix3(program, "waterReflectionNdcToEye", plan.reflection_ndc_to_eye);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDepthMask(GL_FALSE);
  this->Sky->Render();
}

//------------------------------------------------------------------------------
void vtkWaterFullScreen::DrawCovers(vtkOpenGLRenderWindow* window, const water_plan& plan,
  vtkWaterSceneDepth& sceneDepth, const int rect_px[4], int cell_px)
{
  vtkShaderProgram* program = this->Mask->Program;
  program->SetUniformi("waterSceneDepth", sceneDepth.Activate(window));
  const int* size = sceneDepth.GetSize();
  const int corner[2] = { sceneDepth.GetOrigin()[0] + size[0] - 1, sceneDepth.GetOrigin()[1] };
  const int last[2] = { size[0] - 1, size[1] - 1 };
  int viewport[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const float count[2] = { static_cast<float>(viewport[2]), static_cast<float>(viewport[3]) };
  water_visibility_walk walk;
  water_visibility_walk_of(plan.texture_px, rect_px, size, cell_px, &walk);
  const float first[2] = { static_cast<float>(walk.first[0]), static_cast<float>(walk.first[1]) };
  const float step[2] = { static_cast<float>(walk.step[0]), static_cast<float>(walk.step[1]) };
  const float pixel[2] = { static_cast<float>(walk.pixel[0]), static_cast<float>(walk.pixel[1]) };
  program->SetUniform2i("waterSceneCorner", corner);
  program->SetUniform2i("waterLastPixel", last);
  program->SetUniform2f("waterPixel", pixel);
  program->SetUniform2f("waterCellCount", count);
  program->SetUniform2f("waterWalkFirst", first);
  program->SetUniform2f("waterWalkStep", step);
  program->SetUniform2i("waterWalkSize", walk.size);
  vtkWaterUniforms::Set4(program, "waterHeightClip", plan.plane_clip);
  vtkWaterUniforms::Set(program, "waterRounding", plan.mask_rounding);
  this->Mask->Render();
  sceneDepth.Deactivate();
}

//------------------------------------------------------------------------------
void vtkWaterFullScreen::DrawMask(
  vtkRenderer* renderer, const water_plan& plan, vtkWaterSceneDepth& sceneDepth)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if (!Ready(this->Mask, window, vtkWaterMaskFS))
  {
    return;
  }
  const ScopedDepthsOnly depthsOnly(window->GetState());
  const int whole[4] = { 0, 0, plan.texture_px[0], plan.texture_px[1] };
  glDepthRange(0.0, 0.0); // VTK keeps no record of it
  this->DrawCovers(window, plan, sceneDepth, whole, 1);
  glDepthRange(0.0, 1.0);
}

//------------------------------------------------------------------------------
bool vtkWaterFullScreen::DrawCells(
  vtkRenderer* renderer, const water_plan& plan, int cell_px, vtkWaterSceneDepth& sceneDepth)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if (!Ready(this->Mask, window, vtkWaterMaskFS))
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglClearColor(1.0f, 1.0f, 1.0f, 1.0f);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  this->DrawCovers(window, plan, sceneDepth, plan.texture_rect_px, cell_px);
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterFullScreen::DrawClosedCells(vtkRenderer* renderer, const water_visibility& seen)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  std::vector<std::array<float, 4>> boxes(
    static_cast<size_t>(seen.size[1]) * (static_cast<size_t>(seen.size[0]) + 1) / 2);
  boxes.resize(
    water_visibility_closed(&seen, reinterpret_cast<float(*)[4]>(boxes.data()))); // float[4] each
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(vtkWaterCoverVS, vtkWaterCoverFS, "");
  if (!program || boxes.empty())
  {
    return;
  }
  std::vector<float> corners;
  std::vector<GLuint> triangles;
  for (const std::array<float, 4>& box : boxes)
  {
    const auto first = static_cast<GLuint>(corners.size() / 3);
    for (const int corner : { 0, 1, 2, 3 })
    {
      corners.insert(corners.end(), { box[corner & 1 ? 2 : 0], box[corner & 2 ? 3 : 1], 0.0f });
    }
    for (const GLuint corner : { 0u, 1u, 2u, 2u, 1u, 3u })
    {
      triangles.push_back(first + corner);
    }
  }
  if (!this->CoverArray)
  {
    this->CoverArray = vtkSmartPointer<vtkOpenGLVertexArrayObject>::New();
  }
  const ScopedDepthsOnly depthsOnly(window->GetState());
  vtkOpenGLRenderUtilities::RenderTriangles(corners.data(),
    static_cast<unsigned int>(corners.size() / 3), triangles.data(),
    static_cast<unsigned int>(triangles.size()), nullptr, program, this->CoverArray);
}

//------------------------------------------------------------------------------
void vtkWaterFullScreen::DrawFog(vtkRenderer* renderer, const water_plan& plan,
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
  vtkWaterUniforms::Set4(program, "waterHeightClip", plan.surface_clip);
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
void vtkWaterFullScreen::DrawCorner(vtkRenderer* renderer, vtkTextureObject* reflection)
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
void vtkWaterFullScreen::ReleaseGraphicsResources()
{
  this->Sky.reset();
  this->Mask.reset();
  if (this->CoverArray)
  {
    this->CoverArray->ReleaseGraphicsResources();
  }
  this->CoverArray = nullptr;
  this->Fog.reset();
  this->Corner.reset();
}
