// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSeen.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"
#include "vtkWaterGL.h"
#include "vtkWaterSceneDepth.h"
#include "vtkWaterScreen.h"

namespace
{
constexpr size_t kRGBA = 4;
}

//------------------------------------------------------------------------------
bool vtkWaterSeen::Ensure(vtkRenderer* renderer)
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
const water_seen* vtkWaterSeen::Find(vtkRenderer* renderer, const water_plan& plan,
  vtkWaterScreen& screen, vtkWaterSceneDepth& sceneDepth)
{
  water_seen_begin(plan.texture_px, plan.texture_rect_px, &this->Seen);
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
    isFound = screen.DrawCells(renderer, plan, this->Seen.cell_px, sceneDepth);
    if (isFound)
    {
      this->Pixels.resize(kRGBA * static_cast<size_t>(width) * static_cast<size_t>(height));
      GLint alignment = 0;
      glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
      glPixelStorei(GL_PACK_ALIGNMENT, 1);
      glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, this->Pixels.data());
      glPixelStorei(GL_PACK_ALIGNMENT, alignment);
    }
  }
  state->PopFramebufferBindings();
  if (!isFound)
  {
    return nullptr;
  }
  this->Counts.resize(static_cast<size_t>(width + 1) * static_cast<size_t>(height + 1));
  this->Seen.counts = this->Counts.data();
  water_seen_sum(&this->Seen, this->Pixels.data(), kRGBA);
  return &this->Seen;
}

//------------------------------------------------------------------------------
void vtkWaterSeen::ReleaseGraphicsResources(vtkWindow* window)
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
