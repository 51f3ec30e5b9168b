// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterBackdrop.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkWaterBoundPicture.h"
#include "vtkWaterGL.h"
#include "vtkWaterRankPixels.h"
#include "vtkWaterRanks.h"
#include "water_samples.h"

#include <algorithm>
#include <new>
#include <vector>

namespace
{
using Source = vtkWaterBoundPicture;

// Are there several samples a pixel, in textures? Then these are in the picture.
bool FindSamples(const Source& source, vtkWaterSampleSpread::Picture& picture)
{
  if (source.Samples == 0 || !source.HasTextures())
  {
    return false;
  }
  picture.Samples = source.Samples;
  picture.Color = source.GetColorTexture();
  picture.Depth = source.GetDepthTexture();
  return true;
}

bool SetPart(const int rect[4], const int part[4], vtkWaterSampleSpread::Picture& picture)
{
  std::copy_n(rect, 4, picture.Rect);
  std::copy_n(part, 4, picture.Part);
  return part[2] > 0 && part[3] > 0;
}

// Did the GPU have the memory? VTK's textures do not say.
bool HasSize(vtkTextureObject* texture, int width)
{
  GLint given = 0;
  texture->Activate();
  glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &given);
  texture->Deactivate();
  return given == width;
}

void CopyTo(vtkTextureObject* texture, const int rect[4], const int part[4])
{
  texture->Activate();
  glCopyTexSubImage2D(
    GL_TEXTURE_2D, 0, part[0], part[1], rect[0] + part[0], rect[1] + part[1], part[2], part[3]);
  texture->Deactivate();
}
}

//------------------------------------------------------------------------------
bool vtkWaterBackdrop::Ensure(vtkOpenGLRenderWindow* window, int width, int height)
{
  const Source source;
  const int colorType = source.GetColorType();
  const int depthFormat = source.GetDepthFormat();
  if (this->Color && this->Color->GetContext() == window && this->Width == width &&
    this->Height == height && this->ColorType == colorType && this->DepthFormat == depthFormat)
  {
    return true;
  }
  this->ReleaseCopies(nullptr);
  this->Color = vtkSmartPointer<vtkTextureObject>::New();
  this->Depth = vtkSmartPointer<vtkTextureObject>::New();
  for (vtkTextureObject* texture : { this->Color.Get(), this->Depth.Get() })
  {
    const int filter =
      texture == this->Color ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
    texture->SetContext(window);
    texture->SetMinificationFilter(filter);
    texture->SetMagnificationFilter(filter);
    texture->SetWrapS(vtkTextureObject::ClampToEdge);
    texture->SetWrapT(vtkTextureObject::ClampToEdge);
  }
  if (!this->Color->Allocate2D(
        static_cast<unsigned int>(width), static_cast<unsigned int>(height), 4, colorType) ||
    !this->Depth->AllocateDepth(
      static_cast<unsigned int>(width), static_cast<unsigned int>(height), depthFormat) ||
    !HasSize(this->Color, width) || !HasSize(this->Depth, width))
  {
    this->ReleaseCopies(nullptr);
    this->HasFailed = true;
    return false;
  }
  this->HasFailed = false;
  this->Width = width;
  this->Height = height;
  this->ColorType = colorType;
  this->DepthFormat = depthFormat;
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterBackdrop::Spread(
  vtkOpenGLRenderWindow* window, const int rect[4], const int part[4], const double* heightClip)
{
  const Source source;
  vtkWaterSampleSpread::Picture picture;
  this->IsSpread = heightClip && FindSamples(source, picture) && SetPart(rect, part, picture);
  if (this->IsSpread)
  {
    this->Side = water_samples_side(
      picture.Samples, rect + 2, vtkTextureObject::GetMaximumTextureSize(window));
    this->IsSpread = this->Ensure(window, this->Side * rect[2], this->Side * rect[3]) &&
      this->Samples.Draw(window, picture, heightClip, this->Side, this->Color, this->Depth);
  }
  this->IsMixed = source.Samples > 0 && !this->IsSpread;
  return this->IsSpread;
}

//------------------------------------------------------------------------------
bool vtkWaterBackdrop::Copy(
  vtkOpenGLRenderWindow* window, const int rect[4], const int part[4], const double* heightClip)
{
  if (this->Spread(window, rect, part, heightClip))
  {
    return true;
  }
  const Source source;
  if (!source.HasDepth() || !this->Ensure(window, rect[2], rect[3]))
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<unsigned int>(source.Framebuffer));
  GLint readBuffer = 0;
  glGetIntegerv(GL_READ_BUFFER, &readBuffer);
  glReadBuffer(static_cast<GLenum>(source.Buffer));
  if (source.Samples > 0)
  {
    if (!this->Framebuffer)
    {
      this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
      this->Framebuffer->SetContext(window);
    }
    vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
    state->vtkglDisable(GL_SCISSOR_TEST); // it cuts a blit
    this->Framebuffer->Bind(vtkOpenGLFramebufferObject::GetDrawMode());
    this->Framebuffer->AddColorAttachment(0, this->Color);
    this->Framebuffer->AddDepthAttachment(this->Depth);
    this->Framebuffer->ActivateDrawBuffer(0);
    const int end[2] = { part[0] + part[2], part[1] + part[3] };
    state->vtkglBlitFramebuffer(rect[0] + part[0], rect[1] + part[1], rect[0] + end[0],
      rect[1] + end[1], part[0], part[1], end[0], end[1], GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT,
      GL_NEAREST);
  }
  else
  {
    CopyTo(this->Color, rect, part);
    CopyTo(this->Depth, rect, part);
  }
  glReadBuffer(static_cast<GLenum>(readBuffer));
  state->PopFramebufferBindings();
  return true;
}

//------------------------------------------------------------------------------
int vtkWaterBackdrop::CountSamples()
{
  vtkWaterSampleSpread::Picture picture;
  const bool areSent = FindSamples(Source(), picture) && picture.Samples <= WATER_RANK_SAMPLES_MAX;
  return areSent ? picture.Samples : 0;
}

//------------------------------------------------------------------------------
bool vtkWaterBackdrop::EnsureSamples(
  vtkOpenGLRenderWindow* window, int width, int height, int samples)
{
  const int size[4] = { width, height, samples, Source().GetColorType() };
  if (this->Joined && this->Joined->GetContext() == window &&
    std::equal(size, size + 4, this->JoinedSize))
  {
    return true;
  }
  this->Joined = vtkWaterRankSamples::MakeFramebuffer(window, width, height, size[3], samples);
  std::copy_n(size, 4, this->JoinedSize);
  return this->Joined != nullptr;
}

//------------------------------------------------------------------------------
bool vtkWaterBackdrop::CopyOfAll(vtkWaterRanks& ranks, vtkOpenGLRenderWindow* window,
  const int rect[4], const int part[4], int samples, const double* heightClip)
{
  if (samples == 0)
  {
    return this->Join(ranks, window, part, this->Copy(window, rect, part, nullptr));
  }
  const bool isEmpty = part[2] <= 0 || part[3] <= 0; // on all ranks
  vtkWaterSampleSpread::Picture found;
  vtkWaterRankPixels pixels;
  bool isRead = false;
  try
  {
    const Source source;
    const unsigned int type = source.GetColorType() == VTK_FLOAT ? GL_FLOAT : GL_UNSIGNED_BYTE;
    isRead = isEmpty ||
      (FindSamples(source, found) && this->EnsureSamples(window, rect[2], rect[3], samples) &&
        this->RankSamples.Read(window,
          { found.Color, found.Depth, samples,
            { rect[0] + part[0], rect[1] + part[1], part[2], part[3] } },
          type, pixels));
  }
  catch (const std::bad_alloc&)
  {
    isRead = false;
  }
  std::vector<int> claims = { isRead ? 1 : 0 };
  ranks.HoldOnAll(claims);
  if (!claims[0] || isEmpty)
  {
    return claims[0] != 0;
  }
  if (!pixels.KeepNearest(ranks) ||
    !this->RankSamples.Write(window, pixels, samples, part, this->Joined))
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Joined->Bind();
  this->Joined->ActivateDrawBuffer(0);
  const int whole[4] = { 0, 0, rect[2], rect[3] };
  const bool isCopied = this->Copy(window, whole, part, heightClip);
  state->PopFramebufferBindings();
  return isCopied;
}

//------------------------------------------------------------------------------
bool vtkWaterBackdrop::Join(
  vtkWaterRanks& ranks, vtkOpenGLRenderWindow* window, const int part[4], bool isCopied)
{
  const bool isEmpty = part[2] <= 0 || part[3] <= 0; // on all ranks
  vtkWaterRankPixels pixels;
  bool isRead = isCopied;
  try
  {
    if (isCopied && !isEmpty)
    {
      this->Read(window, part, pixels);
    }
  }
  catch (const std::bad_alloc&)
  {
    isRead = false;
  }
  std::vector<int> claims = { isRead ? 1 : 0 };
  ranks.HoldOnAll(claims);
  if (!claims[0] || isEmpty)
  {
    return claims[0] != 0;
  }
  if (!pixels.KeepNearest(ranks))
  {
    return false;
  }
  pixels.Upload(this->Color, this->Depth);
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterBackdrop::Read(
  vtkOpenGLRenderWindow* window, const int part[4], vtkWaterRankPixels& pixels)
{
  if (!this->Framebuffer)
  {
    this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->Framebuffer->SetContext(window);
  }
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Color);
  this->Framebuffer->AddDepthAttachment(this->Depth);
  state->PopFramebufferBindings();
  const unsigned int type = this->ColorType == VTK_FLOAT ? GL_FLOAT : GL_UNSIGNED_BYTE;
  pixels.Read(this->Framebuffer, type, part);
}

//------------------------------------------------------------------------------
void vtkWaterBackdrop::ReleaseGraphicsResources(vtkWindow* window)
{
  this->ReleaseCopies(window);
  this->RankSamples.ReleaseGraphicsResources(window);
  if (this->Joined && window)
  {
    this->Joined->ReleaseGraphicsResources(window);
  }
  this->Joined = nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterBackdrop::ReleaseCopies(vtkWindow* window)
{
  this->Samples.ReleaseGraphicsResources(window);
  if (this->Framebuffer && window)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
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
  this->Color = nullptr;
  this->Depth = nullptr;
  this->Width = this->Height = 0;
}
