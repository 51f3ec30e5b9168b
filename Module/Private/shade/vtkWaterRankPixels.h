// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterRankPixels: the pixels of a rectangle of two textures, colour and depth, which ranks make
// one picture of: the nearest of all, or layers in their order. First each rank reads its own; then
// it may tell the others that it has no memory for them; then they are exchanged.
#ifndef vtkWaterRankPixels_h
#define vtkWaterRankPixels_h

#include "water_rank_pixels.h"

#include <cstdint>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkTextureObject;
class vtkWaterRanks;

class vtkWaterRankPixels
{
public:
  // Reads a framebuffer. Throws std::bad_alloc.
  //
  // type  of a colour's channels: GL_UNSIGNED_BYTE, GL_HALF_FLOAT, GL_FLOAT
  // rect  x, y, width, height in pixels: the same on all ranks
  void Read(vtkOpenGLFramebufferObject* framebuffer, unsigned int type, const int rect[4]);

  // The same of samples, one of each pixel after the other: as many as there are, of a framebuffer
  // that has them alone.
  void AllocateSamples(unsigned int type, const int rect[4], int samples);
  void ReadSample(vtkOpenGLFramebufferObject* framebuffer, int sample);

  // Likewise of a layer, which has colours only; nullptr: nothing is in it.
  void ReadLayer(vtkOpenGLFramebufferObject* framebuffer, unsigned int type, const int rect[4]);

  // Likewise of depths alone, where they are nearer than those of another picture of the rectangle;
  // nullptr: nowhere.
  void ReadDepths(vtkOpenGLFramebufferObject* framebuffer, const vtkWaterRankPixels& behind);

  // Likewise of all depths of a framebuffer.
  void ReadDepths(vtkOpenGLFramebufferObject* framebuffer, const int rect[4]);

  // Ranks' pixels become those of all. All ranks call it, or none. false: they cannot be reached.
  bool KeepNearest(vtkWaterRanks& ranks);
  bool BlendInOrder(vtkWaterRanks& ranks, const std::vector<size_t>& order);

  // Puts a layer over these colours.
  void Blend(const vtkWaterRankPixels& layer);

  // Writes them back; depth may be nullptr.
  void Upload(vtkTextureObject* color, vtkTextureObject* depth) const;
  void UploadDepths(vtkTextureObject* depth) const;
  void UploadDepths(vtkTextureObject* depth, const vtkWaterRankPixels& behind);
  void UploadSample(vtkTextureObject* color, vtkTextureObject* depth, int sample) const;

private:
  void Allocate(unsigned int type, const int rect[4], int samples);
  void ReadColors(vtkOpenGLFramebufferObject* framebuffer);
  water_rank_picture GetPicture(bool hasDepths);

  std::vector<std::uint32_t> Colors;
  std::vector<std::uint32_t> Depths; // as the texture has them: floats would round
  std::vector<std::uint32_t> Spare;
  std::vector<float> Floats;        // depths of one sample
  std::vector<unsigned char> Bytes; // that are sent
  unsigned int Type = 0;
  size_t Samples = 1; // of a pixel
  size_t Words = 1;
  int Rect[4] = {};
};

#endif
