// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSlopeTexture: layers of four numbers on the GPU, as slopes and their squares, repeating,
// with mip levels that average: what a pixel does not resolve of slopes is left as a variance.
#ifndef vtkWaterSlopeTexture_h
#define vtkWaterSlopeTexture_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWaterLayers;
class vtkWindow;

class vtkWaterSlopeTexture
{
public:
  vtkWaterSlopeTexture();
  ~vtkWaterSlopeTexture();

  // texels  4 * width * height numbers for each layer
  void Upload(vtkOpenGLRenderWindow* window, unsigned int width, unsigned int height,
    unsigned int layers, const std::vector<float>& texels);

  // For what writes the layers by itself: the texture without them.
  //
  // isHalf  numbers of 16 bits, not 32, which GPUs filter at least twice as fast. A slope of 0.06
  // is off
  //         by 3e-5 at most then. The ray that it reflects turns by a fifth of a minute of arc.
  //         Places would be too coarse.
  void Allocate(vtkOpenGLRenderWindow* window, unsigned int width, unsigned int height,
    unsigned int layers, bool isHalf);
  // One of them, from a framebuffer that is bound for reading, from that row on.
  void CopyLayer(unsigned int layer, unsigned int row);
  // Of all of them, when each is there.
  void MakeMipLevels();

  // nullptr: nothing was uploaded for this window.
  vtkTextureObject* Get(vtkOpenGLRenderWindow* window);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkSmartPointer<vtkWaterLayers> Texture;
};

#endif
