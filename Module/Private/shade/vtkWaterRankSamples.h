// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterRankSamples: the samples of multisampled pixels, out of a framebuffer and into one, for
// ranks that make one picture of them: of each sample the nearest. Pixels whose samples are
// averaged first would show, along each rank's edges, a mixture with what another rank hides.
#ifndef vtkWaterRankSamples_h
#define vtkWaterRankSamples_h

#include "vtkOpenGLFramebufferObject.h" // for members
#include "vtkSmartPointer.h"
#include "vtkWaterQuad.h"

class vtkOpenGLRenderWindow;
class vtkWaterRankPixels;
class vtkWindow;

class vtkWaterRankSamples
{
public:
  // A multisampled framebuffer's textures.
  struct Picture
  {
    unsigned int Color = 0; // handles
    unsigned int Depth = 0;
    int Samples = 0;  // 1 to WATER_RANK_SAMPLES_MAX
    int Rect[4] = {}; // in them: x, y, width, height in pixels
  };

  // The textures of a framebuffer.
  static Picture PictureOf(vtkOpenGLFramebufferObject* framebuffer, const int rect[4]);

  // A framebuffer with textures of its own; nullptr: the GPU refuses. Depths are floats: fixed
  // numbers would be rounded whenever a shader reads or writes them.
  //
  // type     VTK's, of a colour's channels
  // samples  a pixel; 0: none
  static vtkSmartPointer<vtkOpenGLFramebufferObject> MakeFramebuffer(
    vtkOpenGLRenderWindow* window, int width, int height, int type, int samples);

  // Reads samples. Throws std::bad_alloc.
  //
  // type  of a colour's channels in pixels: GL_UNSIGNED_BYTE, GL_HALF_FLOAT, GL_FLOAT
  //
  // Returns false when the GPU refuses.
  bool Read(vtkOpenGLRenderWindow* window, const Picture& picture, unsigned int type,
    vtkWaterRankPixels& pixels);

  // Writes them into a rectangle (x, y; as large as they are) of a framebuffer of as many samples,
  // which may be another one.
  //
  // Returns false when the GPU refuses.
  bool Write(vtkOpenGLRenderWindow* window, const vtkWaterRankPixels& pixels, int samples,
    const int rect[4], vtkOpenGLFramebufferObject* framebuffer);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Ensure(vtkOpenGLRenderWindow* window, int width, int height, int type);

  vtkSmartPointer<vtkOpenGLFramebufferObject> One; // holds one sample of each pixel
  int Width = 0;
  int Height = 0;
  int Type = 0; // VTK's
  vtkWaterQuad Taking;
  vtkWaterQuad Putting;
};

#endif
