// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSlopeTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkWaterGL.h"

namespace
{
constexpr int kAllLevels = 1000;
}

//------------------------------------------------------------------------------
void vtkWaterSlopeTexture::Upload(vtkOpenGLRenderWindow* window, unsigned int width,
  unsigned int height, std::vector<float>& texels)
{
  if (!this->Get(window))
  {
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
    this->Texture->SetContext(window);
    this->Texture->SetWrapS(vtkTextureObject::Repeat);
    this->Texture->SetWrapT(vtkTextureObject::Repeat);
    this->Texture->SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
    this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
    this->Texture->SetMaxLevel(kAllLevels);
  }
  this->Texture->Create2DFromRaw(width, height, 4, VTK_FLOAT, texels.data());
  this->Texture->Activate();
  glGenerateMipmap(GL_TEXTURE_2D);
  this->Texture->Deactivate();
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterSlopeTexture::Get(vtkOpenGLRenderWindow* window)
{
  return this->Texture && this->Texture->GetContext() == window ? this->Texture.Get() : nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterSlopeTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Texture && window)
  {
    this->Texture->ReleaseGraphicsResources(window);
  }
  this->Texture = nullptr;
}
