// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSurfaceSky.cxx: the part of vtkWaterSurfaceShader that binds the sky's textures.
#include "vtkOpenGLRenderer.h"
#include "vtkTexture.h"
#include "vtkWaterSurfaceShader.h"

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
    // how places differ from pixel to pixel means nothing here: facets' differ by chance
    this->SkyTextures.emplace_back(
      name, std::make_unique<vtkWaterIsotropicTexture>(this->Drawn.Renderer, texture));
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
