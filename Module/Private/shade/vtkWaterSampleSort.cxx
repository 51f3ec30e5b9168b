// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSampleSort.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkWaterGL.h"
#include "vtkWaterScopedPlainDraws.h"
#include "vtkWaterSortFS.h"
#include "vtkWaterUniforms.h"

#include <algorithm>

namespace
{
constexpr int kMostSamples = 32; // as in vtkWaterSortFS.glsl

// Draws overwrite depth, too, while an object of this class lives, in a part of a framebuffer.
struct ScopedOverwrite
{
  ScopedOverwrite(vtkOpenGLState* state, const int part[4])
    : Plain(state)
    , DepthMask(state)
    , DepthFunc(state)
  {
    state->vtkglEnable(GL_DEPTH_TEST); // without it no depth is written
    state->vtkglDepthFunc(GL_ALWAYS);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglViewport(part[0], part[1], part[2], part[3]);
  }

  vtkWaterScopedPlainDraws Plain;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunc;
};

// Multisampled textures are bound to the first units while an object of this class lives: a target
// of its own there, which VTK's textures do not have.
struct ScopedSamples
{
  ScopedSamples(vtkOpenGLState* state, unsigned int color, unsigned int depth)
    : State(state)
    , Active(state)
  {
    this->Bind(color, depth);
  }
  ~ScopedSamples() { this->Bind(0, 0); }

  void Bind(unsigned int color, unsigned int depth)
  {
    this->State->vtkglActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, depth);
    this->State->vtkglActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, color);
  }

  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglActiveTexture Active;
};

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
    ? this->Quad.Ready(window, vtkWaterSortFS)
    : nullptr;
  if (program)
  {
    const ScopedOverwrite overwrite(state, picture.Part);
    const ScopedSamples samples(state, picture.Color, picture.Depth);
    vtkWaterUniforms::Set(program, "waterSampleColor", 0);
    vtkWaterUniforms::Set(program, "waterSampleDepth", 1);
    vtkWaterUniforms::Set(program, "waterSampleCount", picture.Samples);
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
