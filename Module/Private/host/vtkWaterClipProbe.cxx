// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterClipProbe.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkWaterClipDistance.h"
#include "vtkWaterClipProbeVS.h"
#include "vtkWaterCoverFS.h"
#include "vtkWaterDebug.h"
#include "vtkWaterFramebuffers.h"
#include "vtkWaterGL.h"
#include "vtkWaterQueryResult.h"

#include <algorithm>
#include <array>

namespace
{
constexpr int kWidth = 4;  // px, the left half of which is cut away
constexpr int kHeight = 2; // rows: the clip is on, and off

// All that the probe sets, as it was, when it goes out of scope.
struct ScopedProbe
{
  explicit ScopedProbe(vtkOpenGLState* state)
    : State(state)
    , Viewport(state)
    , ClearColor(state)
    , ColorMask(state)
    , Blend(state, GL_BLEND)
    , CullFace(state, GL_CULL_FACE)
    , ScissorTest(state, GL_SCISSOR_TEST)
    , WasClipped(glIsEnabled(GL_CLIP_DISTANCE0) == GL_TRUE)
  {
    state->PushFramebufferBindings();
    state->vtkglDisable(GL_BLEND);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglClearColor(1.0, 1.0, 1.0, 1.0);
  }
  ~ScopedProbe()
  {
    vtkWaterClipDistance().Set(this->WasClipped); // DrawRows leaves it off
    this->State->PopFramebufferBindings();
  }

  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglClearColor ClearColor;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
  bool WasClipped;
};

// Draws black over white, into what is bound.
void DrawRows(vtkOpenGLState* state, vtkShaderProgram* program)
{
  // x, y, and the distance: that of a plane in the middle, then that of the main view, of no plane
  float corners[kHeight][12] = { { -1, -1, -1, 1, -1, 1, -1, 1, -1, 1, 1, 1 },
    { -1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1 } };
  GLuint triangles[6] = { 0, 1, 2, 2, 1, 3 };
  vtkNew<vtkOpenGLVertexArrayObject> array;
  vtkWaterClipDistance clipDistance;
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  for (int row = 0; row < kHeight; ++row)
  {
    state->vtkglViewport(0, row, kWidth, 1);
    clipDistance.Set(row == 0);
    vtkOpenGLRenderUtilities::RenderTriangles(
      corners[row], 4, triangles, 6, nullptr, program, array);
  }
}

bool IsCutRight(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLState* state = window->GetState();
  const ScopedProbe scoped(state);
  vtkNew<vtkTextureObject> color;
  vtkNew<vtkOpenGLFramebufferObject> framebuffer;
  color->SetContext(window);
  framebuffer->SetContext(window);
  if (!color->Allocate2D(kWidth, kHeight, 4, VTK_UNSIGNED_CHAR))
  {
    return false;
  }
  framebuffer->Bind();
  framebuffer->AddColorAttachment(0, color);
  framebuffer->ActivateDrawBuffer(0);
  framebuffer->ActivateReadBuffer(0);
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(vtkWaterClipProbeVS, vtkWaterCoverFS, "");
  if (!program || !vtkWaterFramebuffers::IsComplete())
  {
    return false;
  }
  DrawRows(state, program);
  std::array<unsigned int, kWidth * kHeight> pixels{}; // RGBA each
  glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  const unsigned int cut = 0xffffffff;
  return pixels == std::array<unsigned int, kWidth * kHeight>{ cut, cut, 0, 0, 0, 0, 0, 0 };
}
}

//------------------------------------------------------------------------------
bool vtkWaterClipProbe::Works(vtkOpenGLRenderWindow* window, vtkObject* told)
{
  std::vector<Answer>& answers = this->Answers;
  answers.erase(std::remove_if(answers.begin(), answers.end(),
                  [](const Answer& answer) { return !answer.Window; }),
    answers.end());
  auto found = std::find_if(answers.begin(), answers.end(),
    [window](const Answer& answer) { return answer.Window == window; });
  if (found == answers.end())
  {
    if (vtkWaterQueryResult::IsAnyAwaited())
    {
      return false; // and would count the probe
    }
    Answer answer;
    answer.Window = window;
    answer.IsRight = IsCutRight(window);
    found = answers.insert(answers.end(), answer);
  }
  if (!found->IsRight && !found->IsSaid)
  {
    found->IsSaid = vtkWaterDebug::Say(told,
      "this driver does not clip correctly by clip distances; in this window the mirrored view is "
      "clipped in the fragment shader, which is slower.");
  }
  return found->IsRight;
}
