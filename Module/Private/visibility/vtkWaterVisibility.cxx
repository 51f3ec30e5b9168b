// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterVisibility.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkWaterGL.h"
#include "vtkWaterSceneDepth.h"

//------------------------------------------------------------------------------
const water_visibility* vtkWaterVisibility::Find(
  vtkRenderer* renderer, const water_plan& plan, const vtkWaterSceneDepth& sceneDepth)
{
  water_visibility_begin(plan.texture_px, plan.texture_rect_px, &this->Seen);
  const auto width = static_cast<size_t>(this->Seen.size[0]);
  const auto height = static_cast<size_t>(this->Seen.size[1]);
  this->Cells.resize(width * height);
  this->ReadDepths(renderer, plan, sceneDepth);
  this->Counts.resize((width + 1) * (height + 1));
  this->Seen.counts = this->Counts.data();
  water_visibility_sum(&this->Seen, this->Cells.data());
  return &this->Seen;
}

//------------------------------------------------------------------------------
void vtkWaterVisibility::ReadDepths(
  vtkRenderer* renderer, const water_plan& plan, const vtkWaterSceneDepth& sceneDepth)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  const int* origin = sceneDepth.GetOrigin();
  const int* size = sceneDepth.GetSize();
  int rows[2];
  water_visibility_rows(&this->Seen, size, rows);
  this->Row.resize(static_cast<size_t>(size[0]));
  this->Depths.resize(static_cast<size_t>(size[0]) * static_cast<size_t>(rows[1]));
  GLint drawn = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn);
  state->PushReadFramebufferBinding();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<unsigned int>(drawn));
  glReadPixels(origin[0], origin[1] + rows[0], size[0], rows[1], GL_DEPTH_COMPONENT, GL_FLOAT,
    this->Depths.data());
  state->PopReadFramebufferBinding();
  water_visibility_mark(&this->Seen, size, plan.is_endless, plan.plane_clip, plan.height_rounding,
    rows, this->Depths.data(), this->Row.data(), this->Cells.data());
}
