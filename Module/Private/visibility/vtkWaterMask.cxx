// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterMask.h"

#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkWaterCoverFS.h"
#include "vtkWaterCoverVS.h"
#include "vtkWaterGL.h"
#include "vtkWaterMaskFS.h"
#include "vtkWaterSceneDepth.h"
#include "vtkWaterUniforms.h"
#include "water_visibility.h"

#include <array>
#include <vector>

namespace
{
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
void vtkWaterMask::DrawCovers(vtkShaderProgram* program, vtkOpenGLRenderWindow* window,
  const water_plan& plan, vtkWaterSceneDepth& sceneDepth, const int rect_px[4], int cell_px)
{
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
  this->Mask.Draw();
  sceneDepth.Deactivate();
}

//------------------------------------------------------------------------------
void vtkWaterMask::DrawMask(
  vtkRenderer* renderer, const water_plan& plan, vtkWaterSceneDepth& sceneDepth)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkShaderProgram* program = this->Mask.Ready(window, vtkWaterMaskFS);
  if (!program)
  {
    return;
  }
  const ScopedDepthsOnly depthsOnly(window->GetState());
  const int whole[4] = { 0, 0, plan.texture_px[0], plan.texture_px[1] };
  glDepthRange(0.0, 0.0); // VTK keeps no record of it
  this->DrawCovers(program, window, plan, sceneDepth, whole, 1);
  glDepthRange(0.0, 1.0);
}

//------------------------------------------------------------------------------
bool vtkWaterMask::DrawCells(
  vtkRenderer* renderer, const water_plan& plan, int cell_px, vtkWaterSceneDepth& sceneDepth)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkShaderProgram* program = this->Mask.Ready(window, vtkWaterMaskFS);
  if (!program)
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
  this->DrawCovers(program, window, plan, sceneDepth, plan.texture_rect_px, cell_px);
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterMask::DrawClosedCells(vtkRenderer* renderer, const water_visibility& seen)
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
void vtkWaterMask::ReleaseGraphicsResources()
{
  this->Mask.ReleaseGraphicsResources();
  if (this->CoverArray)
  {
    this->CoverArray->ReleaseGraphicsResources();
  }
  this->CoverArray = nullptr;
}
