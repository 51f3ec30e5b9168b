// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSlopeTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkWaterGL.h"

namespace
{
constexpr int kAllLevels = 1000;
}

//------------------------------------------------------------------------------
void vtkWaterSlopeTexture::Ensure(vtkOpenGLRenderWindow* window)
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
}

//------------------------------------------------------------------------------
void vtkWaterSlopeTexture::Upload(vtkOpenGLRenderWindow* window, unsigned int width,
  unsigned int height, std::vector<float>& texels)
{
  this->Ensure(window);
  this->Texture->Create2DFromRaw(width, height, 4, VTK_FLOAT, texels.data());
  this->MakeMipLevels();
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterSlopeTexture::Allocate(
  vtkOpenGLRenderWindow* window, unsigned int width, unsigned int height)
{
  this->Ensure(window);
  return this->Texture->Allocate2D(width, height, 4, VTK_FLOAT) ? this->Texture.Get() : nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterSlopeTexture::MakeMipLevels()
{
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
