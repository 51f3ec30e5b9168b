// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterRankSamples.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkWaterFramebuffers.h"
#include "vtkWaterGL.h"
#include "vtkWaterPutSampleFS.h"
#include "vtkWaterRankPixels.h"
#include "vtkWaterScopedSamples.h"
#include "vtkWaterTakeSampleFS.h"
#include "vtkWaterUniforms.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkWaterRankSamples::Picture vtkWaterRankSamples::PictureOf(
  vtkOpenGLFramebufferObject* framebuffer, const int rect[4])
{
  Picture picture;
  vtkTextureObject* color = framebuffer->GetColorAttachmentAsTextureObject(0);
  vtkTextureObject* depth = framebuffer->GetDepthAttachmentAsTextureObject();
  if (color && depth)
  {
    picture.Color = color->GetHandle();
    picture.Depth = depth->GetHandle();
    // as many as the driver gives, which may be more than were asked for
    framebuffer->GetContext()->GetState()->PushFramebufferBindings();
    framebuffer->Bind();
    glGetIntegerv(GL_SAMPLES, &picture.Samples);
    framebuffer->GetContext()->GetState()->PopFramebufferBindings();
  }
  std::copy_n(rect, 4, picture.Rect);
  return picture;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkOpenGLFramebufferObject> vtkWaterRankSamples::MakeFramebuffer(
  vtkOpenGLRenderWindow* window, int width, int height, int type, int samples)
{
  const auto w = static_cast<unsigned int>(width);
  const auto h = static_cast<unsigned int>(height);
  vtkNew<vtkTextureObject> color;
  vtkNew<vtkTextureObject> depth;
  for (vtkTextureObject* texture : { color.Get(), depth.Get() })
  {
    texture->SetContext(window);
    texture->SetSamples(samples);
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    texture->SetWrapS(vtkTextureObject::ClampToEdge);
    texture->SetWrapT(vtkTextureObject::ClampToEdge);
  }
  if (!color->Allocate2D(w, h, 4, type) || !depth->AllocateDepth(w, h, vtkTextureObject::Float32))
  {
    return nullptr;
  }
  auto made = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  made->SetContext(window);
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  made->Bind();
  made->AddColorAttachment(0, color);
  made->AddDepthAttachment(depth);
  made->ActivateDrawBuffer(0);
  const bool isComplete = vtkWaterFramebuffers::IsComplete();
  state->PopFramebufferBindings();
  return isComplete ? made : nullptr;
}

//------------------------------------------------------------------------------
bool vtkWaterRankSamples::Ensure(vtkOpenGLRenderWindow* window, int width, int height, int type)
{
  if (this->One && this->One->GetContext() == window && this->Width == width &&
    this->Height == height && this->Type == type)
  {
    return true;
  }
  this->ReleaseGraphicsResources(window);
  this->One = MakeFramebuffer(window, width, height, type, 0);
  if (!this->One)
  {
    return false;
  }
  this->Width = width;
  this->Height = height;
  this->Type = type;
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterRankSamples::Read(vtkOpenGLRenderWindow* window, const Picture& picture,
  unsigned int type, vtkWaterRankPixels& pixels)
{
  const int* rect = picture.Rect;
  const int whole[4] = { 0, 0, rect[2], rect[3] };
  if (picture.Samples < 1 || picture.Samples > WATER_RANK_SAMPLES_MAX)
  {
    return false;
  }
  pixels.AllocateSamples(type, whole, picture.Samples);
  if (!this->Ensure(
        window, rect[2], rect[3], type == GL_UNSIGNED_BYTE ? VTK_UNSIGNED_CHAR : VTK_FLOAT))
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->One->Bind();
  this->One->ActivateDrawBuffer(0);
  vtkShaderProgram* program = this->Taking.Ready(window, vtkWaterTakeSampleFS);
  for (int i = 0; program && i < picture.Samples; ++i)
  {
    {
      const vtkWaterScopedOverwrite overwrite(state, whole);
      const vtkWaterScopedSamples samples(state, picture.Color, picture.Depth);
      vtkWaterUniforms::Set(program, "waterSampleColor", 0);
      vtkWaterUniforms::Set(program, "waterSampleDepth", 1);
      vtkWaterUniforms::Set(program, "waterSample", i);
      double numbers[4];
      std::copy_n(rect, 4, numbers);
      vtkWaterUniforms::Set4(program, "waterSampleRect", numbers);
      this->Taking.Draw();
    }
    pixels.ReadSample(this->One, i);
  }
  state->PopFramebufferBindings();
  return program != nullptr;
}

//------------------------------------------------------------------------------
bool vtkWaterRankSamples::Write(vtkOpenGLRenderWindow* window, const vtkWaterRankPixels& pixels,
  int samples, const int rect[4], vtkOpenGLFramebufferObject* framebuffer)
{
  if (!this->Ensure(window, rect[2], rect[3], this->Type)) // of what was read before
  {
    return false;
  }
  vtkTextureObject* color = this->One->GetColorAttachmentAsTextureObject(0);
  vtkTextureObject* depth = this->One->GetDepthAttachmentAsTextureObject();
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  framebuffer->Bind();
  framebuffer->ActivateDrawBuffer(0);
  vtkShaderProgram* program = this->Putting.Ready(window, vtkWaterPutSampleFS);
  if (program)
  {
    const vtkWaterScopedOverwrite overwrite(state, rect);
    const vtkWaterScopedSampleMask mask(state);
    for (int i = 0; i < samples; ++i)
    {
      pixels.UploadSample(color, depth, i);
      color->Activate();
      depth->Activate();
      vtkWaterUniforms::Set(program, "waterTakenColor", color);
      vtkWaterUniforms::Set(program, "waterTakenDepth", depth);
      glSampleMaski(0, 1u << i);
      this->Putting.Draw();
      depth->Deactivate();
      color->Deactivate();
    }
  }
  state->PopFramebufferBindings();
  return program != nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterRankSamples::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Taking.ReleaseGraphicsResources();
  this->Putting.ReleaseGraphicsResources();
  if (this->One && window)
  {
    this->One->ReleaseGraphicsResources(window);
  }
  this->One = nullptr;
  this->Width = this->Height = 0;
}
