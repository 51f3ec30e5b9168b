// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterClosedCells.h"

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
void vtkWaterClosedCells::Draw(vtkRenderer* renderer, const water_visibility& seen)
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
  if (!this->Array)
  {
    this->Array = vtkSmartPointer<vtkOpenGLVertexArrayObject>::New();
  }
  const ScopedDepthsOnly depthsOnly(window->GetState());
  vtkOpenGLRenderUtilities::RenderTriangles(corners.data(),
    static_cast<unsigned int>(corners.size() / 3), triangles.data(),
    static_cast<unsigned int>(triangles.size()), nullptr, program, this->Array);
}

//------------------------------------------------------------------------------
void vtkWaterClosedCells::ReleaseGraphicsResources()
{
  if (this->Array)
  {
    this->Array->ReleaseGraphicsResources();
  }
  this->Array = nullptr;
}
