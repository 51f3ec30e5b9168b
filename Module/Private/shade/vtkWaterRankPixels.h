// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterRankPixels: makes of what all ranks have in two textures, colour and depth, the nearest
// of it, place by place.
#ifndef vtkWaterRankPixels_h
#define vtkWaterRankPixels_h

class vtkOpenGLFramebufferObject;
class vtkTextureObject;
class vtkWaterRanks;

struct vtkWaterRankPixels
{
  vtkOpenGLFramebufferObject* Framebuffer = nullptr; // holds the two textures
  vtkTextureObject* Color = nullptr;                 // RGBA
  vtkTextureObject* Depth = nullptr;
  unsigned int Type = 0; // of a colour's channels: GL_UNSIGNED_BYTE, GL_HALF_FLOAT, GL_FLOAT

  // All ranks call it with the same rectangle (x, y, width, height in pixels), or none.
  //
  // Returns false, and changes nothing, when they cannot be reached.
  bool Join(vtkWaterRanks& ranks, const int rect[4]) const;
};

#endif
