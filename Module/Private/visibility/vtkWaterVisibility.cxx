// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterVisibility.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"
#include "vtkWaterGL.h"
#include "vtkWaterMask.h"
#include "vtkWaterSceneDepth.h"

namespace
{
constexpr size_t kRGBA = 4;
}

//------------------------------------------------------------------------------
bool vtkWaterVisibility::Ensure(vtkRenderer* renderer)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const auto width = static_cast<unsigned int>(this->Seen.size[0]);
  const auto height = static_cast<unsigned int>(this->Seen.size[1]);
  if (this->Framebuffer && this->Framebuffer->GetContext() == window &&
    this->Color->GetWidth() >= width && this->Color->GetHeight() >= height)
  {
    return true;
  }
  this->ReleaseGraphicsResources(nullptr);
  this->Color = vtkSmartPointer<vtkTextureObject>::New();
  this->Color->SetContext(window);
  this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Framebuffer->SetContext(window);
  if (!this->Color->Allocate2D(width, height, kRGBA, VTK_UNSIGNED_CHAR))
  {
    return false;
  }
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Color);
  this->Framebuffer->ActivateBuffer(0);
  const char* reason = nullptr;
  return vtkOpenGLFramebufferObject::GetFrameBufferStatus(
    vtkOpenGLFramebufferObject::GetBothMode(), reason);
}

//------------------------------------------------------------------------------
const water_visibility* vtkWaterVisibility::Find(
  vtkRenderer* renderer, const water_plan& plan, vtkWaterMask& mask, vtkWaterSceneDepth& sceneDepth)
{
  water_visibility_begin(plan.texture_px, plan.texture_rect_px, &this->Seen);
  const auto width = static_cast<size_t>(this->Seen.size[0]);
  const auto height = static_cast<size_t>(this->Seen.size[1]);
  size_t stride = 1;
  if (plan.is_software)
  {
    this->Pixels.resize(width * height);
    this->ReadDepths(renderer, plan, sceneDepth);
  }
  else
  {
    stride = kRGBA;
    this->Pixels.resize(kRGBA * width * height);
    if (!this->ReadCells(renderer, plan, mask, sceneDepth))
    {
      return nullptr;
    }
  }
  this->Counts.resize((width + 1) * (height + 1));
  this->Seen.counts = this->Counts.data();
  water_visibility_sum(&this->Seen, this->Pixels.data(), stride);
  return &this->Seen;
}

//------------------------------------------------------------------------------
bool vtkWaterVisibility::ReadCells(
  vtkRenderer* renderer, const water_plan& plan, vtkWaterMask& mask, vtkWaterSceneDepth& sceneDepth)
{
  const int width = this->Seen.size[0];
  const int height = this->Seen.size[1];
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  bool isFound = false;
  if (this->Ensure(renderer))
  {
    vtkOpenGLState::ScopedglViewport viewport(state);
    vtkOpenGLState::ScopedglScissor scissor(state);
    vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
    this->Framebuffer->Bind();
    this->Framebuffer->ActivateBuffer(0);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglViewport(0, 0, width, height);
    isFound = mask.DrawCells(renderer, plan, this->Seen.cell_px, sceneDepth);
    if (isFound)
    {
      GLint alignment = 0;
      glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
      glPixelStorei(GL_PACK_ALIGNMENT, 1);
      glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, this->Pixels.data());
      glPixelStorei(GL_PACK_ALIGNMENT, alignment);
    }
  }
  state->PopFramebufferBindings();
  return isFound;
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
  water_visibility_mark(&this->Seen, size, plan.plane_clip, plan.mask_rounding, rows,
    this->Depths.data(), this->Row.data(), this->Pixels.data());
}

//------------------------------------------------------------------------------
void vtkWaterVisibility::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Framebuffer && window)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Color->ReleaseGraphicsResources(window);
  }
  // without a window the destructors free what is left, through VTK's resource callbacks
  this->Framebuffer = nullptr;
  this->Color = nullptr;
}
