// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterIsotropicTexture.h"

#include "vtkOpenGLTexture.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

namespace
{
vtkTextureObject* FindObject(vtkTexture* texture)
{
  auto* openGL = vtkOpenGLTexture::SafeDownCast(texture);
  return openGL ? openGL->GetTextureObject() : nullptr;
}

void SetAnisotropy(vtkTextureObject* object, float most)
{
  object->SetMaximumAnisotropicFiltering(most);
  object->Activate(); // sends it
}
}

//------------------------------------------------------------------------------
vtkWaterIsotropicTexture::vtkWaterIsotropicTexture(vtkRenderer* renderer, vtkTexture* texture)
  : Renderer(renderer)
  , Texture(texture)
{
  if (!texture)
  {
    return;
  }
  texture->Render(renderer);
  if (vtkTextureObject* object = FindObject(texture))
  {
    // not what the texture says: VTK uses that with mip levels only
    this->Anisotropy = object->GetMaximumAnisotropicFiltering();
    SetAnisotropy(object, 1.0f);
  }
}

//------------------------------------------------------------------------------
vtkWaterIsotropicTexture::~vtkWaterIsotropicTexture()
{
  if (this->Texture)
  {
    if (vtkTextureObject* object = FindObject(this->Texture))
    {
      SetAnisotropy(object, this->Anisotropy);
    }
    this->Texture->PostRender(this->Renderer);
  }
}
