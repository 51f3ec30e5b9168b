// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterTarget.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"
#include "vtkWaterFramebuffers.h"
#include "vtkWaterGL.h"

#include <algorithm>

namespace
{
constexpr int kAllLevels = 1000;

void Blit(vtkOpenGLFramebufferObject* from, vtkOpenGLFramebufferObject* to, int width, int height,
  GLbitfield buffers)
{
  from->Bind(vtkOpenGLFramebufferObject::GetReadMode());
  from->ActivateReadBuffer(0);
  to->Bind(vtkOpenGLFramebufferObject::GetDrawMode());
  to->ActivateDrawBuffer(0);
  to->GetContext()->GetState()->vtkglBlitFramebuffer(
    0, 0, width, height, 0, 0, width, height, buffers, GL_NEAREST);
}
}

//------------------------------------------------------------------------------
bool vtkWaterTarget::MakeTextures(
  vtkOpenGLRenderWindow* window, int width, int height, bool isFloat)
{
  this->Color = vtkSmartPointer<vtkTextureObject>::New();
  this->Color->SetContext(window);
  this->Color->SetMinificationFilter(vtkTextureObject::Linear);
  this->Color->SetMagnificationFilter(vtkTextureObject::Linear);
  this->Color->SetMaxLevel(kAllLevels);
  this->Depth = vtkSmartPointer<vtkTextureObject>::New();
  this->Depth->SetContext(window);
  this->Depth->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Depth->SetMagnificationFilter(vtkTextureObject::Nearest);
  for (vtkTextureObject* texture : { this->Color.Get(), this->Depth.Get() })
  {
    texture->SetWrapS(vtkTextureObject::ClampToEdge);
    texture->SetWrapT(vtkTextureObject::ClampToEdge);
  }
  if (isFloat)
  {
    this->Color->SetInternalFormat(GL_RGBA16F);
  }
  // Fixed32, like the window's own depth: volume mappers blit it, which requires equal formats.
  return this->Color->Allocate2D(width, height, 4, isFloat ? VTK_FLOAT : VTK_UNSIGNED_CHAR) &&
    this->Depth->AllocateDepth(width, height, vtkTextureObject::Fixed32);
}

//------------------------------------------------------------------------------
bool vtkWaterTarget::MakeFramebuffers(
  vtkOpenGLRenderWindow* window, int width, int height, int samples, bool isFloat)
{
  this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Color);
  this->Framebuffer->AddDepthAttachment(this->Depth);
  this->Framebuffer->ActivateBuffer(0);
  const bool isComplete = vtkWaterFramebuffers::IsComplete();
  if (!isComplete || samples == 0)
  {
    return isComplete;
  }
  this->SampledFramebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->SampledFramebuffer->SetContext(window);
  return this->SampledFramebuffer->PopulateFramebuffer(
    width, height, true, 1, isFloat ? VTK_FLOAT : VTK_UNSIGNED_CHAR, true, 32, samples);
}

//------------------------------------------------------------------------------
bool vtkWaterTarget::Ensure(
  vtkOpenGLRenderWindow* window, int width, int height, int wanted, bool isFloat)
{
  int samples = 0;
  if (wanted > 0)
  {
    glGetIntegerv(GL_MAX_SAMPLES, &samples);
    samples = std::min(samples, wanted); // as VTK's windows do
  }
  if (this->Framebuffer && this->Framebuffer->GetContext() == window && this->Width == width &&
    this->Height == height && this->Samples == samples && this->IsFloat == isFloat)
  {
    return true;
  }
  this->ReleaseGraphicsResources(nullptr);
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  const bool isMade = this->MakeTextures(window, width, height, isFloat) &&
    this->MakeFramebuffers(window, width, height, samples, isFloat);
  state->PopFramebufferBindings();
  if (!isMade)
  {
    this->ReleaseGraphicsResources(nullptr);
    return false;
  }
  this->Width = width;
  this->Height = height;
  this->Samples = samples;
  this->IsFloat = isFloat;
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterTarget::MakeLevels()
{
  this->Color->Activate();
  glGenerateMipmap(GL_TEXTURE_2D);
  this->Color->Deactivate();
}

//------------------------------------------------------------------------------
vtkOpenGLFramebufferObject* vtkWaterTarget::GetFramebuffer()
{
  return this->SampledFramebuffer ? this->SampledFramebuffer : this->Framebuffer;
}

//------------------------------------------------------------------------------
vtkOpenGLFramebufferObject* vtkWaterTarget::GetResolved()
{
  return this->Framebuffer;
}

//------------------------------------------------------------------------------
bool vtkWaterTarget::Bind()
{
  this->GetFramebuffer()->Bind();
  this->GetFramebuffer()->ActivateBuffer(0);
  return this->GetFramebuffer()->StartNonOrtho(this->Width, this->Height);
}

//------------------------------------------------------------------------------
void vtkWaterTarget::Resolve()
{
  if (!this->SampledFramebuffer)
  {
    return;
  }
  Blit(this->SampledFramebuffer, this->Framebuffer, this->Width, this->Height,
    GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

//------------------------------------------------------------------------------
void vtkWaterTarget::CopyFrom(vtkWaterTarget& other, unsigned int buffers, bool isResolved)
{
  Blit(isResolved ? other.GetResolved() : other.GetFramebuffer(), this->GetFramebuffer(),
    this->Width, this->Height, buffers);
}

//------------------------------------------------------------------------------
void vtkWaterTarget::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkOpenGLFramebufferObject* framebuffer :
    { this->Framebuffer.Get(), this->SampledFramebuffer.Get() })
  {
    if (framebuffer && window)
    {
      framebuffer->ReleaseGraphicsResources(window);
    }
  }
  for (vtkTextureObject* texture : { this->Color.Get(), this->Depth.Get() })
  {
    if (texture && window)
    {
      texture->ReleaseGraphicsResources(window);
    }
  }
  // without a window the destructors free what is left, through VTK's resource callbacks
  this->Framebuffer = nullptr;
  this->SampledFramebuffer = nullptr;
  this->Color = nullptr;
  this->Depth = nullptr;
  this->Width = this->Height = this->Samples = 0;
}
