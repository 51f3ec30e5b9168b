// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSampleSort.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkWaterGL.h"
#include "vtkWaterScopedSamples.h"
#include "vtkWaterSortFS.h"
#include "vtkWaterUniforms.h"

#include <algorithm>
#include <string>

namespace
{
constexpr int kMostSamples = 32;                         // as in vtkWaterSortFS.glsl
constexpr const char* kCount = "WATER_SORT_SAMPLES = 4"; // there

vtkSmartPointer<vtkTextureObject> MakeTexture(
  vtkOpenGLRenderWindow* window, unsigned int width, unsigned int height, int type)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  return texture->Allocate2D(width, height, 4, type) ? texture : nullptr;
}
}

//------------------------------------------------------------------------------
bool vtkWaterSampleSort::Ensure(vtkOpenGLRenderWindow* window, vtkTextureObject* color)
{
  if (this->Other && this->Other->GetContext() == window &&
    this->Other->GetWidth() == color->GetWidth() &&
    this->Other->GetHeight() == color->GetHeight() &&
    this->Other->GetVTKDataType() == color->GetVTKDataType())
  {
    return true;
  }
  this->ReleaseGraphicsResources(nullptr);
  this->Other = MakeTexture(window, color->GetWidth(), color->GetHeight(), color->GetVTKDataType());
  this->OtherPlace = MakeTexture(window, color->GetWidth(), color->GetHeight(), VTK_FLOAT);
  this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Framebuffer->SetContext(window);
  return this->Other && this->OtherPlace;
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkWaterSampleSort::Ready(vtkOpenGLRenderWindow* window, int samples)
{
  if (samples != this->Samples)
  {
    this->Quad.ReleaseGraphicsResources();
    this->Samples = samples;
    this->Source = vtkWaterSortFS;
    vtkShaderProgram::Substitute(
      this->Source, kCount, "WATER_SORT_SAMPLES = " + std::to_string(samples));
  }
  return this->Quad.Ready(window, this->Source.c_str());
}

//------------------------------------------------------------------------------
bool vtkWaterSampleSort::Draw(vtkOpenGLRenderWindow* window, const Picture& picture,
  const double* heightClip, vtkTextureObject* color, vtkTextureObject* depth)
{
  if (picture.Samples > kMostSamples || !this->Ensure(window, color))
  {
    this->ReleaseGraphicsResources(nullptr);
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  float places[kMostSamples][2] = {};
  for (int i = 0; i < picture.Samples; ++i)
  {
    glGetMultisamplefv(
      GL_SAMPLE_POSITION, static_cast<GLuint>(i), places[i]); // of the bound framebuffer
    std::for_each(places[i], places[i] + 2, [](float& place) { place -= 0.5f; });
  }
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, color);
  this->Framebuffer->AddColorAttachment(1, this->Other);
  this->Framebuffer->AddColorAttachment(2, this->OtherPlace);
  this->Framebuffer->AddDepthAttachment(depth);
  this->Framebuffer->ActivateDrawBuffers(3);
  const char* reason = nullptr;
  vtkShaderProgram* program = vtkOpenGLFramebufferObject::GetFrameBufferStatus(
                                vtkOpenGLFramebufferObject::GetBothMode(), reason)
    ? this->Ready(window, picture.Samples)
    : nullptr;
  if (program)
  {
    const vtkWaterScopedOverwrite overwrite(state, picture.Part);
    const vtkWaterScopedSamples samples(state, picture.Color, picture.Depth);
    vtkWaterUniforms::Set(program, "waterSampleColor", 0);
    vtkWaterUniforms::Set(program, "waterSampleDepth", 1);
    program->SetUniform2fv("waterSamplePlaces", picture.Samples, places);
    double rect[4];
    double part[4];
    std::copy_n(picture.Rect, 4, rect);
    std::copy_n(picture.Part, 4, part);
    vtkWaterUniforms::Set4(program, "waterSampleRect", rect);
    vtkWaterUniforms::Set4(program, "waterSamplePart", part);
    vtkWaterUniforms::Set4(program, "waterHeightClip", heightClip);
    this->Quad.Draw();
  }
  state->PopFramebufferBindings();
  return program != nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterSampleSort::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad.ReleaseGraphicsResources();
  if (this->Framebuffer && window)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
  }
  for (vtkTextureObject* texture : { this->Other.Get(), this->OtherPlace.Get() })
  {
    if (texture && window)
    {
      texture->ReleaseGraphicsResources(window);
    }
  }
  // without a window the destructors free what is left, through VTK's resource callbacks
  this->Framebuffer = nullptr;
  this->Other = nullptr;
  this->OtherPlace = nullptr;
}
