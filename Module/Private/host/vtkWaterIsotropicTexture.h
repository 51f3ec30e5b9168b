// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterIsotropicTexture: a texture, bound, that GL reads without its anisotropic filter, which
// VTK has on for textures with mip levels.
//
// The filter asks how places differ from pixel to pixel. Where that means nothing it shows dashes
// of other colours, and where places differ without limit, as on a floor at its horizon, Mesa reads
// thousands of texels for a pixel.
#ifndef vtkWaterIsotropicTexture_h
#define vtkWaterIsotropicTexture_h

#include "vtkSmartPointer.h"
#include "vtkTexture.h"

class vtkRenderer;

// While an object of this class lives.
class vtkWaterIsotropicTexture
{
public:
  // texture  nullptr: does nothing
  vtkWaterIsotropicTexture(vtkRenderer* renderer, vtkTexture* texture);
  ~vtkWaterIsotropicTexture();

  // -1: there is no texture
  int GetTextureUnit() const { return this->Texture ? this->Texture->GetTextureUnit() : -1; }

private:
  vtkWaterIsotropicTexture(const vtkWaterIsotropicTexture&) = delete;
  void operator=(const vtkWaterIsotropicTexture&) = delete;

  vtkRenderer* Renderer;
  vtkSmartPointer<vtkTexture> Texture; // an observer may drop it
  float Anisotropy = 1.0f;             // that VTK has given it
};

#endif
