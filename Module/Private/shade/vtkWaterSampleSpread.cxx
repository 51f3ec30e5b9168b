// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSampleSpread.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkWaterFramebuffers.h"
#include "vtkWaterGL.h"
#include "vtkWaterScopedSamples.h"
#include "vtkWaterSeenFS.h"
#include "vtkWaterSpreadFS.h"
#include "vtkWaterUniforms.h"
#include "water_samples.h"

#include <algorithm>
#include <string>

namespace
{
constexpr const char* kCount = "WATER_SEEN_SAMPLES = 4";         // in vtkWaterSeenFS.glsl
constexpr const char* kSpreadCount = "WATER_SPREAD_SAMPLES = 4"; // in vtkWaterSpreadFS.glsl
constexpr const char* kSide = "WATER_SPREAD_SIDE = 2";

// GL's own call: VTK sets no integers of four.
void SetRect(vtkShaderProgram* program, const char* name, const int rect[4])
{
  const GLint location = glGetUniformLocation(static_cast<GLuint>(program->GetHandle()), name);
  glUniform4iv(location, 1, rect);
}
}

//------------------------------------------------------------------------------
bool vtkWaterSampleSpread::Ensure(vtkOpenGLRenderWindow* window, const Picture& picture)
{
  const auto width = static_cast<unsigned int>(picture.Rect[2]);
  const auto height = static_cast<unsigned int>(picture.Rect[3]);
  if (this->Seen && this->Plane && this->Seen->GetContext() == window &&
    this->Seen->GetWidth() == width && this->Seen->GetHeight() == height)
  {
    return true;
  }
  this->ReleaseGraphicsResources(nullptr);
  this->Seen = this->MakeTexture(window, picture);
  this->Plane = this->MakeTexture(window, picture);
  this->SeenFramebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->SeenFramebuffer->SetContext(window);
  this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Framebuffer->SetContext(window);
  return this->Seen && this->Plane;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTextureObject> vtkWaterSampleSpread::MakeTexture(
  vtkOpenGLRenderWindow* window, const Picture& picture)
{
  auto made = vtkSmartPointer<vtkTextureObject>::New();
  made->SetContext(window);
  made->SetMinificationFilter(vtkTextureObject::Nearest);
  made->SetMagnificationFilter(vtkTextureObject::Nearest);
  made->SetWrapS(vtkTextureObject::ClampToEdge);
  made->SetWrapT(vtkTextureObject::ClampToEdge);
  const bool isMade = made->Allocate2D(static_cast<unsigned int>(picture.Rect[2]),
    static_cast<unsigned int>(picture.Rect[3]), 4, VTK_FLOAT);
  return isMade ? made : nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterSampleSpread::MakePrograms(int samples, int side)
{
  if (samples != this->Samples)
  {
    this->SeenQuad.ReleaseGraphicsResources();
    this->SeenSource = vtkWaterSeenFS;
    vtkShaderProgram::Substitute(
      this->SeenSource, kCount, "WATER_SEEN_SAMPLES = " + std::to_string(samples));
  }
  if (samples != this->Samples || side != this->Side)
  {
    this->Quad.ReleaseGraphicsResources();
    this->Source = vtkWaterSpreadFS;
    vtkShaderProgram::Substitute(
      this->Source, kSpreadCount, "WATER_SPREAD_SAMPLES = " + std::to_string(samples));
    vtkShaderProgram::Substitute(
      this->Source, kSide, "WATER_SPREAD_SIDE = " + std::to_string(side));
  }
  this->Samples = samples;
  this->Side = side;
}

//------------------------------------------------------------------------------
bool vtkWaterSampleSpread::DrawSeen(vtkOpenGLRenderWindow* window, const Picture& picture,
  const float places[][2], const double* heightClip)
{
  this->SeenFramebuffer->Bind();
  this->SeenFramebuffer->AddColorAttachment(0, this->Seen);
  this->SeenFramebuffer->AddColorAttachment(1, this->Plane);
  this->SeenFramebuffer->ActivateDrawBuffers(2);
  vtkShaderProgram* program = vtkWaterFramebuffers::IsComplete()
    ? this->SeenQuad.Ready(window, this->SeenSource.c_str())
    : nullptr;
  if (program)
  {
    vtkOpenGLState* state = window->GetState();
    const vtkWaterScopedPlainDraws plain(state);
    state->vtkglViewport(picture.Part[0], picture.Part[1], picture.Part[2], picture.Part[3]);
    vtkWaterUniforms::Set(program, "waterSampleDepth", 1);
    program->SetUniform2fv("waterSamplePlaces", picture.Samples, places);
    SetRect(program, "waterSampleRect", picture.Rect);
    SetRect(program, "waterSamplePart", picture.Part);
    vtkWaterUniforms::Set4(program, "waterHeightClip", heightClip);
    this->SeenQuad.Draw();
  }
  return program != nullptr;
}

//------------------------------------------------------------------------------
bool vtkWaterSampleSpread::DrawSpread(vtkOpenGLRenderWindow* window, const Picture& picture,
  const float places[][2], int side, vtkTextureObject* color, vtkTextureObject* depth)
{
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, color);
  this->Framebuffer->AddDepthAttachment(depth);
  this->Framebuffer->ActivateDrawBuffer(0);
  vtkShaderProgram* program =
    vtkWaterFramebuffers::IsComplete() ? this->Quad.Ready(window, this->Source.c_str()) : nullptr;
  if (program)
  {
    int fine[4]; // of the finer picture
    std::transform(picture.Part, picture.Part + 4, fine, [side](int px) { return side * px; });
    int numbers[WATER_SAMPLES_SIDE_MAX * WATER_SAMPLES_SIDE_MAX] = {};
    water_samples_nearest(places, picture.Samples, side, numbers);
    const vtkWaterScopedOverwrite overwrite(window->GetState(), fine);
    vtkWaterUniforms::Set(program, "waterSampleColor", 0);
    vtkWaterUniforms::Set(program, "waterSampleDepth", 1);
    const vtkOpenGLState::ScopedglActiveTexture active(window->GetState());
    // the first two units have the samples, unknown to VTK
    window->GetState()->vtkglActiveTexture(GL_TEXTURE2);
    this->Seen->Bind();
    vtkWaterUniforms::Set(program, "waterSampleSeen", 2);
    window->GetState()->vtkglActiveTexture(GL_TEXTURE3);
    this->Plane->Bind();
    vtkWaterUniforms::Set(program, "waterSamplePlane", 3);
    SetRect(program, "waterSampleRect", picture.Rect);
    SetRect(program, "waterSamplePart", picture.Part);
    program->SetUniform2fv("waterSamplePlaces", picture.Samples, places);
    program->SetUniform1iv("waterSampleNumbers", side * side, numbers);
    this->Quad.Draw();
    glBindTexture(GL_TEXTURE_2D, 0);
    window->GetState()->vtkglActiveTexture(GL_TEXTURE2);
    glBindTexture(GL_TEXTURE_2D, 0);
  }
  return program != nullptr;
}

//------------------------------------------------------------------------------
bool vtkWaterSampleSpread::Draw(vtkOpenGLRenderWindow* window, const Picture& picture,
  const double* heightClip, int side, vtkTextureObject* color, vtkTextureObject* depth)
{
  if (picture.Samples > WATER_SAMPLES_MAX || !this->Ensure(window, picture))
  {
    this->ReleaseGraphicsResources(nullptr);
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  float places[WATER_SAMPLES_MAX][2] = {};
  for (int i = 0; i < picture.Samples; ++i)
  {
    glGetMultisamplefv(
      GL_SAMPLE_POSITION, static_cast<GLuint>(i), places[i]); // of the bound framebuffer
    std::for_each(places[i], places[i] + 2, [](float& place) { place -= 0.5f; });
  }
  this->MakePrograms(picture.Samples, side);
  state->PushFramebufferBindings();
  bool isDrawn = false;
  {
    const vtkWaterScopedSamples samples(state, picture.Color, picture.Depth);
    isDrawn = this->DrawSeen(window, picture, places, heightClip) &&
      this->DrawSpread(window, picture, places, side, color, depth);
  }
  state->PopFramebufferBindings();
  return isDrawn;
}

//------------------------------------------------------------------------------
void vtkWaterSampleSpread::ReleaseGraphicsResources(vtkWindow* window)
{
  this->SeenQuad.ReleaseGraphicsResources();
  this->Quad.ReleaseGraphicsResources();
  for (vtkOpenGLFramebufferObject* framebuffer :
    { this->SeenFramebuffer.Get(), this->Framebuffer.Get() })
  {
    if (framebuffer && window)
    {
      framebuffer->ReleaseGraphicsResources(window);
    }
  }
  for (vtkTextureObject* texture : { this->Seen.Get(), this->Plane.Get() })
  {
    if (texture && window)
    {
      texture->ReleaseGraphicsResources(window);
    }
  }
  // without a window the destructors free what is left, through VTK's resource callbacks
  this->SeenFramebuffer = nullptr;
  this->Framebuffer = nullptr;
  this->Seen = nullptr;
  this->Plane = nullptr;
}
