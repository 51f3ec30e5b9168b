// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSlopeTexture.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"
#include "vtkWaterGL.h"

namespace
{
constexpr int kAllLevels = 1000;
}

// A texture of layers, which VTK's class has no method for.
class vtkWaterLayers : public vtkTextureObject
{
public:
  static vtkWaterLayers* New();
  vtkTypeMacro(vtkWaterLayers, vtkTextureObject);

  // numbers  nullptr: they come later
  void Fill(
    unsigned int width, unsigned int height, unsigned int layers, bool isHalf, const float* numbers)
  {
    const GLint format = isHalf ? GL_RGBA16F : GL_RGBA32F;
    this->Target = GL_TEXTURE_2D_ARRAY;
    this->NumberOfDimensions = 2;
    this->Components = 4;
    this->Format = GL_RGBA;
    this->Type = GL_FLOAT;
    this->InternalFormat = static_cast<unsigned int>(format);
    this->Context->ActivateTexture(this);
    this->CreateTexture();
    this->Bind();
    this->SendParameters();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, format, static_cast<GLsizei>(width),
      static_cast<GLsizei>(height), static_cast<GLsizei>(layers), 0, GL_RGBA, GL_FLOAT, numbers);
    this->Width = width;
    this->Height = height;
    this->Depth = layers;
    this->IsHalf = isHalf;
    this->Deactivate();
  }

  bool HasSize(unsigned int width, unsigned int height, unsigned int layers, bool isHalf) const
  {
    return this->Handle != 0 && this->Width == width && this->Height == height &&
      this->Depth == layers && this->IsHalf == isHalf;
  }

protected:
  // VTK's own way to send parameters does not know arrays of layers: it asserts that there are none
  vtkWaterLayers() { this->AutoParametersOff(); }
  ~vtkWaterLayers() override = default;

private:
  vtkWaterLayers(const vtkWaterLayers&) = delete;
  void operator=(const vtkWaterLayers&) = delete;

  void SendParameters()
  {
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, kAllLevels);
  }

  bool IsHalf = false;
};
vtkStandardNewMacro(vtkWaterLayers);

//------------------------------------------------------------------------------
vtkWaterSlopeTexture::vtkWaterSlopeTexture() = default;

//------------------------------------------------------------------------------
vtkWaterSlopeTexture::~vtkWaterSlopeTexture() = default;

//------------------------------------------------------------------------------
void vtkWaterSlopeTexture::Upload(vtkOpenGLRenderWindow* window, unsigned int width,
  unsigned int height, unsigned int layers, const std::vector<float>& texels)
{
  this->Allocate(window, 0, 0, 0, false);
  this->Texture->Fill(width, height, layers, false, texels.data());
  this->MakeMipLevels();
}

//------------------------------------------------------------------------------
void vtkWaterSlopeTexture::Allocate(vtkOpenGLRenderWindow* window, unsigned int width,
  unsigned int height, unsigned int layers, bool isHalf)
{
  if (!this->Get(window))
  {
    this->Texture = vtkSmartPointer<vtkWaterLayers>::New();
    this->Texture->SetContext(window);
  }
  if (layers > 0 && !this->Texture->HasSize(width, height, layers, isHalf))
  {
    this->Texture->Fill(width, height, layers, isHalf, nullptr);
  }
}

//------------------------------------------------------------------------------
void vtkWaterSlopeTexture::CopyLayer(unsigned int layer, unsigned int row)
{
  this->Texture->Activate();
  glCopyTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, static_cast<GLint>(layer), 0,
    static_cast<GLint>(row), static_cast<GLsizei>(this->Texture->GetWidth()),
    static_cast<GLsizei>(this->Texture->GetHeight()));
  this->Texture->Deactivate();
}

//------------------------------------------------------------------------------
void vtkWaterSlopeTexture::MakeMipLevels()
{
  this->Texture->Activate();
  glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
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
