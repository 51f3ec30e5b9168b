// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterRankPixels.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"
#include "vtkWaterGL.h"
#include "vtkWaterRanks.h"

#include <algorithm>

namespace
{
size_t WordsOf(unsigned int type)
{
  return type == GL_FLOAT ? 4 : type == GL_HALF_FLOAT ? 2 : 1;
}

// Puts the words of pixels that are next to each other where they are so many words apart.
void Spread(const std::uint32_t* from, size_t words, size_t count, size_t step, std::uint32_t* to)
{
  for (size_t i = 0; i < count; ++i)
  {
    std::copy_n(from + i * words, words, to + i * step);
  }
}

// The reverse.
std::vector<std::uint32_t> Collect(
  const std::uint32_t* from, size_t words, size_t count, size_t step)
{
  std::vector<std::uint32_t> made(words * count);
  for (size_t i = 0; i < count; ++i)
  {
    std::copy_n(from + i * step, words, made.data() + i * words);
  }
  return made;
}

void Write(
  vtkTextureObject* texture, const int rect[4], GLenum format, GLenum type, const void* data)
{
  texture->Activate();
  glTexSubImage2D(GL_TEXTURE_2D, 0, rect[0], rect[1], rect[2], rect[3], format, type, data);
  texture->Deactivate();
}
}

//------------------------------------------------------------------------------
void vtkWaterRankPixels::Allocate(unsigned int type, const int rect[4], int samples)
{
  std::copy_n(rect, 4, this->Rect);
  this->Type = type;
  this->Words = WordsOf(type);
  this->Samples = static_cast<size_t>(samples);
  const size_t size = static_cast<size_t>(rect[2]) * static_cast<size_t>(rect[3]);
  this->Colors.assign(this->Words * size * this->Samples, 0);
  const water_rank_picture picture = this->GetPicture(false);
  this->Bytes.resize(1 + water_rank_pixels_limit(&picture));
}

//------------------------------------------------------------------------------
water_rank_picture vtkWaterRankPixels::GetPicture(bool hasDepths)
{
  water_rank_picture picture;
  picture.colors = this->Colors.data();
  picture.depths = hasDepths ? this->Depths.data() : nullptr;
  picture.words = this->Words;
  picture.pixel_count = this->Colors.size() / this->Words;
  picture.samples = this->Samples;
  return picture;
}

//------------------------------------------------------------------------------
void vtkWaterRankPixels::ReadColors(vtkOpenGLFramebufferObject* framebuffer)
{
  const int* rect = this->Rect;
  framebuffer->Bind(vtkOpenGLFramebufferObject::GetReadMode());
  framebuffer->ActivateReadBuffer(0);
  // rows are whole words, as GL aligns them by default
  glReadPixels(rect[0], rect[1], rect[2], rect[3], GL_RGBA, this->Type, this->Colors.data());
}

//------------------------------------------------------------------------------
void vtkWaterRankPixels::Read(
  vtkOpenGLFramebufferObject* framebuffer, unsigned int type, const int rect[4])
{
  this->Allocate(type, rect, 1);
  this->Depths.resize(this->Colors.size() / this->Words);
  vtkOpenGLState* state = framebuffer->GetContext()->GetState();
  state->PushFramebufferBindings();
  this->ReadColors(framebuffer);
  glReadPixels(
    rect[0], rect[1], rect[2], rect[3], GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, this->Depths.data());
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void vtkWaterRankPixels::AllocateSamples(unsigned int type, const int rect[4], int samples)
{
  this->Allocate(type, rect, samples);
  this->Depths.resize(this->Colors.size() / this->Words);
  this->Spare.resize(this->Colors.size() / this->Samples);
  this->Floats.resize(this->Depths.size() / this->Samples);
}

//------------------------------------------------------------------------------
void vtkWaterRankPixels::ReadSample(vtkOpenGLFramebufferObject* framebuffer, int sample)
{
  const int* rect = this->Rect;
  const auto place = static_cast<size_t>(sample);
  vtkOpenGLState* state = framebuffer->GetContext()->GetState();
  state->PushFramebufferBindings();
  framebuffer->Bind(vtkOpenGLFramebufferObject::GetReadMode());
  framebuffer->ActivateReadBuffer(0);
  glReadPixels(rect[0], rect[1], rect[2], rect[3], GL_RGBA, this->Type, this->Spare.data());
  const size_t count = this->Floats.size();
  Spread(this->Spare.data(), this->Words, count, this->Samples * this->Words,
    this->Colors.data() + place * this->Words);
  glReadPixels(
    rect[0], rect[1], rect[2], rect[3], GL_DEPTH_COMPONENT, GL_FLOAT, this->Floats.data());
  water_rank_pixels_from_depths(this->Floats.data(), count, this->Spare.data());
  Spread(this->Spare.data(), 1, count, this->Samples, this->Depths.data() + place);
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void vtkWaterRankPixels::ReadLayer(
  vtkOpenGLFramebufferObject* framebuffer, unsigned int type, const int rect[4])
{
  this->Allocate(type, rect, 1);
  this->Spare.resize(this->Colors.size());
  if (framebuffer)
  {
    vtkOpenGLState* state = framebuffer->GetContext()->GetState();
    state->PushFramebufferBindings();
    this->ReadColors(framebuffer);
    state->PopFramebufferBindings();
  }
}

//------------------------------------------------------------------------------
void vtkWaterRankPixels::ReadDepths(vtkOpenGLFramebufferObject* framebuffer, const int rect[4])
{
  this->Allocate(GL_UNSIGNED_BYTE, rect, 1);
  this->Depths.resize(this->Colors.size());
  vtkOpenGLState* state = framebuffer->GetContext()->GetState();
  state->PushFramebufferBindings();
  framebuffer->Bind(vtkOpenGLFramebufferObject::GetReadMode());
  glReadPixels(
    rect[0], rect[1], rect[2], rect[3], GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, this->Depths.data());
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void vtkWaterRankPixels::ReadDepths(
  vtkOpenGLFramebufferObject* framebuffer, const vtkWaterRankPixels& behind)
{
  if (!framebuffer)
  {
    this->Allocate(GL_UNSIGNED_BYTE, behind.Rect, 1);
    this->Depths.assign(behind.Depths.size(), WATER_RANK_NOTHING);
    return;
  }
  this->ReadDepths(framebuffer, behind.Rect);
  std::transform(this->Depths.begin(), this->Depths.end(), behind.Depths.begin(),
    this->Depths.begin(), [](std::uint32_t own, std::uint32_t other) {
      return own < other ? own : WATER_RANK_NOTHING; // which is not sent
    });
}

//------------------------------------------------------------------------------
void vtkWaterRankPixels::UploadDepths(vtkTextureObject* depth) const
{
  Write(depth, this->Rect, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, this->Depths.data());
}

//------------------------------------------------------------------------------
void vtkWaterRankPixels::UploadDepths(vtkTextureObject* depth, const vtkWaterRankPixels& behind)
{
  std::transform(this->Depths.begin(), this->Depths.end(), behind.Depths.begin(),
    this->Depths.begin(),
    [](std::uint32_t own, std::uint32_t other) { return std::min(own, other); });
  this->UploadDepths(depth);
}

//------------------------------------------------------------------------------
bool vtkWaterRankPixels::KeepNearest(vtkWaterRanks& ranks)
{
  water_rank_picture picture = this->GetPicture(true);
  return ranks.KeepNearest(picture, this->Bytes);
}

//------------------------------------------------------------------------------
bool vtkWaterRankPixels::BlendInOrder(vtkWaterRanks& ranks, const std::vector<size_t>& order)
{
  water_rank_picture layer = this->GetPicture(false);
  water_rank_picture spare = layer;
  spare.colors = this->Spare.data();
  const bool isReached = ranks.BlendInOrder(order, layer, spare, this->Bytes);
  if (layer.colors == this->Spare.data()) // the two have changed places
  {
    this->Colors.swap(this->Spare);
  }
  return isReached;
}

//------------------------------------------------------------------------------
void vtkWaterRankPixels::Blend(const vtkWaterRankPixels& layer)
{
  water_rank_pixels_over(
    layer.Colors.data(), this->Words, this->Colors.size() / this->Words, this->Colors.data());
}

//------------------------------------------------------------------------------
void vtkWaterRankPixels::Upload(vtkTextureObject* color, vtkTextureObject* depth) const
{
  Write(color, this->Rect, GL_RGBA, this->Type, this->Colors.data());
  if (depth)
  {
    Write(depth, this->Rect, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, this->Depths.data());
  }
}

//------------------------------------------------------------------------------
void vtkWaterRankPixels::UploadSample(
  vtkTextureObject* color, vtkTextureObject* depth, int sample) const
{
  const auto place = static_cast<size_t>(sample);
  const size_t count = this->Depths.size() / this->Samples;
  Write(color, this->Rect, GL_RGBA, this->Type,
    Collect(
      this->Colors.data() + place * this->Words, this->Words, count, this->Samples * this->Words)
      .data());
  std::vector<float> floats(count);
  water_rank_pixels_to_depths(
    Collect(this->Depths.data() + place, 1, count, this->Samples).data(), count, floats.data());
  Write(depth, this->Rect, GL_DEPTH_COMPONENT, GL_FLOAT, floats.data());
}
