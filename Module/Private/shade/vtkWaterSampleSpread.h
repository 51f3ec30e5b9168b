// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSampleSpread: the samples of a multisampled picture, spread over a finer one
// (water_samples.h, vtkWaterSpreadFS.glsl), for what is seen through a water's surface.
#ifndef vtkWaterSampleSpread_h
#define vtkWaterSampleSpread_h

#include "vtkOpenGLFramebufferObject.h" // for members
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h" // for members
#include "vtkWaterQuad.h"

#include <string>

class vtkShaderProgram;
class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkWindow;

class vtkWaterSampleSpread
{
public:
  // A multisampled framebuffer's textures.
  struct Picture
  {
    unsigned int Color; // handles
    unsigned int Depth;
    int Samples;
    int Rect[4]; // of the picture in them: x, y, width, height in pixels
    int Part[4]; // of that, from its corner, that is spread
  };

  // Spreads the samples.
  //
  // heightClip    point in clip space of the eye -> height over the water's plane, times w; of four
  // side          water_samples_side
  // color, depth  so many times as large as the picture
  //
  // Returns false when the GPU refuses.
  bool Draw(vtkOpenGLRenderWindow* window, const Picture& picture, const double* heightClip,
    int side, vtkTextureObject* color, vtkTextureObject* depth);

  // The middle of those samples that lie beyond the surface, where others do not; as large as the
  // picture.
  vtkTextureObject* GetSeen() { return this->Seen; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Ensure(vtkOpenGLRenderWindow* window, const Picture& picture);
  void MakePrograms(int samples, int side); // for so many, when they are next ready
  bool DrawSeen(vtkOpenGLRenderWindow* window, const Picture& picture, const float places[][2],
    const double* heightClip);
  bool DrawSpread(vtkOpenGLRenderWindow* window, const Picture& picture, const float places[][2],
    int side, vtkTextureObject* color, vtkTextureObject* depth);

  vtkSmartPointer<vtkTextureObject> MakeTexture(
    vtkOpenGLRenderWindow* window, const Picture& picture);

  vtkSmartPointer<vtkTextureObject> Seen;
  vtkSmartPointer<vtkTextureObject> Plane; // of the depth in each pixel
  vtkSmartPointer<vtkOpenGLFramebufferObject> SeenFramebuffer;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  vtkWaterQuad SeenQuad;
  vtkWaterQuad Quad;
  std::string SeenSource; // of their shaders
  std::string Source;
  int Samples = 0; // they are for so many
  int Side = 0;
};

#endif
