// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSampleSort: a multisampled picture with each pixel's samples sorted into those of one
// thing and those of another (vtkWaterSortFS.glsl), for what is seen through a water's surface.
#ifndef vtkWaterSampleSort_h
#define vtkWaterSampleSort_h

#include "vtkOpenGLFramebufferObject.h" // for members
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h" // for members
#include "vtkWaterQuad.h"

#include <string>

class vtkShaderProgram;
class vtkOpenGLRenderWindow;
class vtkWindow;

class vtkWaterSampleSort
{
public:
  // A multisampled framebuffer's textures.
  struct Picture
  {
    unsigned int Color; // handles
    unsigned int Depth;
    int Samples;
    int Rect[4]; // of the picture in them: x, y, width, height in pixels
    int Part[4]; // of that, from its corner, that is sorted
  };

  // Sorts the samples.
  //
  // heightClip  point in clip space of the eye -> height over the water's plane, times w; of four
  // color       of the thing with more samples; as large as the picture
  // depth       the same
  //
  // Returns false when the GPU refuses.
  bool Draw(vtkOpenGLRenderWindow* window, const Picture& picture, const double* heightClip,
    vtkTextureObject* color, vtkTextureObject* depth);

  // Color of the thing with fewer samples, and their share of those that are seen through the
  // surface.
  vtkTextureObject* GetOther() { return this->Other; }

  // Depth of that thing; the middle of those samples that lie beyond the surface, where others do
  // not.
  vtkTextureObject* GetOtherPlace() { return this->OtherPlace; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Ensure(vtkOpenGLRenderWindow* window, vtkTextureObject* color);

  // The program for so many samples; nullptr: it does not compile.
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, int samples);

  vtkSmartPointer<vtkTextureObject> Other;
  vtkSmartPointer<vtkTextureObject> OtherPlace;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  vtkWaterQuad Quad;
  std::string Source; // of its shader
  int Samples = 0;    // it is for so many
};

#endif
