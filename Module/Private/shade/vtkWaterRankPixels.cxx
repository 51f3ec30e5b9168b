// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterRankPixels.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"
#include "vtkWaterGL.h"
#include "vtkWaterRanks.h"

#include <cstdint>
#include <vector>

namespace
{
size_t WordsOf(unsigned int type)
{
  return type == GL_FLOAT ? 4 : type == GL_HALF_FLOAT ? 2 : 1;
}

void Upload(
  vtkTextureObject* texture, const int rect[4], GLenum format, GLenum type, const void* data)
{
  texture->Activate();
  glTexSubImage2D(GL_TEXTURE_2D, 0, rect[0], rect[1], rect[2], rect[3], format, type, data);
  texture->Deactivate();
}
}

//------------------------------------------------------------------------------
bool vtkWaterRankPixels::Join(vtkWaterRanks& ranks, const int rect[4]) const
{
  const size_t count = static_cast<size_t>(rect[2]) * static_cast<size_t>(rect[3]);
  const size_t words = WordsOf(this->Type);
  std::vector<std::uint32_t> colors(words * count);
  std::vector<std::uint32_t> depths(count); // as the texture has them: floats would round
  std::vector<water_rank_pixel> pixels(words * count);
  vtkOpenGLState* state = this->Framebuffer->GetContext()->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind(vtkOpenGLFramebufferObject::GetReadMode());
  this->Framebuffer->ActivateReadBuffer(0);
  // rows are whole words, as GL aligns them by default
  glReadPixels(rect[0], rect[1], rect[2], rect[3], GL_RGBA, this->Type, colors.data());
  glReadPixels(
    rect[0], rect[1], rect[2], rect[3], GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depths.data());
  state->PopFramebufferBindings();
  water_ranks_pack(colors.data(), depths.data(), words, count, pixels.data());
  if (!ranks.KeepNearest(pixels))
  {
    return false;
  }
  water_ranks_unpack(pixels.data(), words, count, colors.data(), depths.data());
  Upload(this->Color, rect, GL_RGBA, this->Type, colors.data());
  Upload(this->Depth, rect, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depths.data());
  return true;
}
