// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSurfaceSky.cxx: the part of vtkWaterSurfaceShader that binds the sky's textures.
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLTexture.h"
#include "vtkTextureObject.h"
#include "vtkWaterSurfaceShader.h"

namespace
{
// GL's anisotropic filter, which VTK has on for textures with mip levels, asks how places differ
// from pixel to pixel, although the level is given. Facets' differ by chance: dashes of other
// colours.
void SetAnisotropy(vtkTexture* texture, float most)
{
  auto* openGL = vtkOpenGLTexture::SafeDownCast(texture);
  if (vtkTextureObject* object = openGL ? openGL->GetTextureObject() : nullptr)
  {
    object->SetMaximumAnisotropicFiltering(most);
    object->Activate(); // sends it
  }
}
}

//------------------------------------------------------------------------------
bool vtkWaterSurfaceShader::HasOwnSky(const vtkWaterSnapshot& water)
{
  // it may have changed since it was set; the scene's sky is at hand then
  return vtkWaterSkyReader::HasData(water.Look.Environment, false);
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::BindSky(const char* name, vtkTexture* texture)
{
  if (texture)
  {
    texture->Render(this->Drawn.Renderer);
    this->SkyTextures.emplace_back(name, texture);
    SetAnisotropy(texture, 1.0f);
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::BeginSky()
{
  this->SkyTextures.clear();
  const vtkWaterSkyTextures& sky = this->Drawn.Sky;
  const bool isOwn = HasOwnSky(*this->Water);
  if (this->Has(WATER_FEATURE_SKY_MAP))
  {
    this->BindSky("waterSkyMap", isOwn ? this->Water->Look.Environment : sky.Map);
  }
  if (this->Has(WATER_FEATURE_SKY_CUBE))
  {
    this->BindSky("waterSkyCube", sky.Map);
  }
  if (this->Has(WATER_FEATURE_SKY_SCREEN))
  {
    this->BindSky("waterScreenPicture", sky.Screen);
  }
  if (this->Has(WATER_FEATURE_SKY_FLOOR))
  {
    this->BindSky("waterSkyFloor", sky.Floor);
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::EndSky()
{
  for (const auto& [name, texture] : this->SkyTextures)
  {
    SetAnisotropy(texture, texture->GetMaximumAnisotropicFiltering());
    texture->PostRender(this->Drawn.Renderer);
  }
  this->SkyTextures.clear();
}
