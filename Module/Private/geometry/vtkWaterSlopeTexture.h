// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSlopeTexture: slopes and their squares on the GPU, repeating, with mip levels that
// average both: what a pixel does not resolve is left as a variance.
#ifndef vtkWaterSlopeTexture_h
#define vtkWaterSlopeTexture_h

#include "vtkSmartPointer.h"
#include "vtkTextureObject.h" // for members

#include <vector>

class vtkOpenGLRenderWindow;
class vtkWindow;

class vtkWaterSlopeTexture
{
public:
  // texels  4 * width * height: slope x, slope y and their squares
  void Upload(vtkOpenGLRenderWindow* window, unsigned int width, unsigned int height,
    std::vector<float>& texels);

  // For what draws the texels itself: the texture without them; nullptr when there is no memory.
  vtkTextureObject* Allocate(
    vtkOpenGLRenderWindow* window, unsigned int width, unsigned int height);
  // After that, from its texels.
  void MakeMipLevels();

  // nullptr: nothing was uploaded for this window.
  vtkTextureObject* Get(vtkOpenGLRenderWindow* window);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Ensure(vtkOpenGLRenderWindow* window);

  vtkSmartPointer<vtkTextureObject> Texture;
};

#endif
