// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSurfaceShader.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkTexture.h"
#include "vtkTextureObject.h"
#include "vtkWaterActor.h"
#include "vtkWaterBlurFS.h"
#include "vtkWaterCausticsFS.h"
#include "vtkWaterCell.h"
#include "vtkWaterDisplacementFS.h"
#include "vtkWaterDisplacementVS.h"
#include "vtkWaterEnvironmentFS.h"
#include "vtkWaterFacetsFS.h"
#include "vtkWaterFoamFS.h"
#include "vtkWaterGL.h"
#include "vtkWaterGlitterFS.h"
#include "vtkWaterMediumFS.h"
#include "vtkWaterMirrorFS.h"
#include "vtkWaterNoBlurFS.h"
#include "vtkWaterNoCausticsFS.h"
#include "vtkWaterNoDisplacementFS.h"
#include "vtkWaterNoFacetsFS.h"
#include "vtkWaterNoFoamFS.h"
#include "vtkWaterNoGlitterFS.h"
#include "vtkWaterNoMediumFS.h"
#include "vtkWaterNoNormalMapsFS.h"
#include "vtkWaterNoOutputFS.h"
#include "vtkWaterNoSeaFS.h"
#include "vtkWaterNoShadowsFS.h"
#include "vtkWaterNoSunFS.h"
#include "vtkWaterNoTranslucentLayerFS.h"
#include "vtkWaterNoWavesFS.h"
#include "vtkWaterNormalMapsFS.h"
#include "vtkWaterOffsetFS.h"
#include "vtkWaterOptics.h"
#include "vtkWaterOutputFS.h"
#include "vtkWaterPointFS.h"
#include "vtkWaterProperty.h"
#include "vtkWaterRayTracedFS.h"
#include "vtkWaterRippleFS.h"
#include "vtkWaterSea.h"
#include "vtkWaterSeaFS.h"
#include "vtkWaterShadowsFS.h"
#include "vtkWaterSunFS.h"
#include "vtkWaterSurfaceFS.h"
#include "vtkWaterTileFS.h"
#include "vtkWaterTranslucentLayer.h"
#include "vtkWaterTranslucentLayerFS.h"
#include "vtkWaterWavesFS.h"
#include "water_plan.h"
#include "water_waves.h"

#include <algorithm>
#include <vector>

//------------------------------------------------------------------------------
int vtkWaterSurfaceShader::GetStages(vtkWaterActor* water)
{
  vtkWaterProperty* property = water->GetWaterProperty();
  int stages = 0;
  const bool hasWaves = property->HasWaves();
  if (hasWaves)
  {
    stages |= WAVES;
    stages |= property->GetSea() ? SEA : 0;
    stages |= property->GetNumberOfNormalMaps() > 0 ? NORMAL_MAPS : 0;
  }
  stages |= property->IsRough() ? ROUGH : 0;
  if (property->GetReflectionSource() == vtkWaterProperty::ENVIRONMENT)
  {
    stages |= ENVIRONMENT;
  }
  else if (property->NeedsRays())
  {
    stages |= property->GetLookup() == vtkWaterProperty::RAY_TRACED ? RAY_TRACED : OFFSET;
  }
  if (property->GetWaveGeometry() && property->GetNumberOfWaves() > 0)
  {
    stages |= DISPLACED;
  }
  if (property->GetRefraction() && water->HasOpaqueGeometry())
  {
    stages |= BODY;
    stages |= hasWaves && property->GetCaustics() > 0.0 ? CAUSTICS : 0;
  }
  stages |= property->HasGlitter() ? GLITTER : 0;
  stages |= property->GetFoamDepth() > 0.0 || property->GetFoamStretch() > 0.0 ? FOAM : 0;
  if (stages & (GLITTER | FOAM))
  {
    stages |= property->GetShadows() ? SHADOWS : 0;
  }
  stages |= property->GetOutput() != vtkWaterProperty::COLOR ? OUTPUT : 0;
  return stages;
}

//------------------------------------------------------------------------------
int vtkWaterSurfaceShader::GetLayeredStages(vtkWaterActor* water)
{
  const int stages = GetStages(water);
  return stages & RAY_TRACED ? stages | LAYER : stages;
}

//------------------------------------------------------------------------------
int vtkWaterSurfaceShader::GetSecondaryStages(vtkWaterActor* water)
{
  return water->GetWaterProperty()->IsRough() ? ENVIRONMENT | ROUGH : ENVIRONMENT;
}

//------------------------------------------------------------------------------
bool vtkWaterSurfaceShader::IsClear(vtkProp* prop)
{
  auto* water = vtkWaterActor::SafeDownCast(prop);
  return water && (GetStages(water) & BODY);
}

//------------------------------------------------------------------------------
std::string vtkWaterSurfaceShader::GetShader(int stages, bool canDisplace)
{
  const char* reflection = stages & ENVIRONMENT ? vtkWaterEnvironmentFS
    : stages & RAY_TRACED                       ? vtkWaterRayTracedFS
    : stages & OFFSET                           ? vtkWaterOffsetFS
                                                : vtkWaterMirrorFS;
  const bool isDisplaced = canDisplace && (stages & DISPLACED);
  std::vector<const char*> files{ vtkWaterOptics };
  if (isDisplaced)
  {
    files.push_back(vtkWaterCell);
  }
  files.push_back(isDisplaced ? vtkWaterDisplacementFS : vtkWaterNoDisplacementFS);
  files.push_back(vtkWaterPointFS);
  if (stages & WAVES)
  {
    files.insert(files.end(),
      { vtkWaterTileFS, vtkWaterWavesFS, stages & SEA ? vtkWaterSeaFS : vtkWaterNoSeaFS,
        stages & NORMAL_MAPS ? vtkWaterNormalMapsFS : vtkWaterNoNormalMapsFS, vtkWaterRippleFS });
  }
  else
  {
    files.push_back(vtkWaterNoWavesFS);
  }
  files.insert(
    files.end(), { stages & OUTPUT ? vtkWaterOutputFS : vtkWaterNoOutputFS, reflection });
  if (stages & LAYER)
  {
    files.push_back(vtkWaterTranslucentLayerFS);
  }
  else if (reflection != vtkWaterMirrorFS)
  {
    files.insert(files.end(),
      { vtkWaterNoTranslucentLayerFS,
        stages & (RAY_TRACED | OFFSET) ? vtkWaterBlurFS : vtkWaterNoBlurFS });
  }
  files.insert(files.end(),
    { stages & CAUSTICS ? vtkWaterCausticsFS : vtkWaterNoCausticsFS,
      stages & BODY ? vtkWaterMediumFS : vtkWaterNoMediumFS,
      stages & ROUGH ? vtkWaterFacetsFS : vtkWaterNoFacetsFS,
      stages & SHADOWS ? vtkWaterShadowsFS : vtkWaterNoShadowsFS,
      stages & GLITTER ? vtkWaterGlitterFS : vtkWaterNoGlitterFS,
      stages & FOAM ? vtkWaterFoamFS : vtkWaterNoFoamFS,
      stages & (GLITTER | FOAM) ? vtkWaterSunFS : vtkWaterNoSunFS, vtkWaterSurfaceFS });
  std::string source;
  for (const char* file : files)
  {
    source += file;
    source += "\n";
  }
  return source;
}

//------------------------------------------------------------------------------
std::string vtkWaterSurfaceShader::GetVertexShader()
{
  return std::string(vtkWaterCell) + "\n" + vtkWaterDisplacementVS;
}

//------------------------------------------------------------------------------
bool vtkWaterSurfaceShader::UpdateStages(int stages)
{
  const bool isOther = stages != this->BuiltStages;
  this->BuiltStages = stages;
  this->IsRefused = this->IsRefused && !isOther;
  return isOther;
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::ReleaseShader()
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(this->Drawn.Renderer->GetRenderWindow());
  window->GetShaderCache()->ReleaseCurrentShader();
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::UploadWaves(vtkWaterActor* water, const double origin[2])
{
  const std::vector<water_wave_term> terms = water->GetWaveTerms();
  // a table is never empty
  std::vector<water_wave_row> rows(std::max<size_t>(terms.size(), 1), water_wave_row());
  water_waves_rows(terms.data(), terms.size(), origin[0], origin[1], rows.data());
  std::vector<float> table;
  this->IsSteep = false;
  for (const water_wave_row& row : rows)
  {
    table.insert(table.end(),
      { row.k[0], row.k[1], row.amplitude, row.phase, row.steepness, 0.0f, 0.0f, 0.0f });
    this->IsSteep = this->IsSteep || row.steepness > 0.0f;
  }
  this->WaveCount = static_cast<int>(terms.size());
  auto* window = static_cast<vtkOpenGLRenderWindow*>(this->Drawn.Renderer->GetRenderWindow());
  if (!this->Waves || this->Waves->GetContext() != window)
  {
    this->Waves = vtkSmartPointer<vtkTextureObject>::New();
    this->Waves->SetContext(window);
    this->Waves->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Waves->SetMagnificationFilter(vtkTextureObject::Nearest);
  }
  this->Waves->Create2DFromRaw(
    2, static_cast<unsigned int>(rows.size()), 4, VTK_FLOAT, table.data());
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::UploadNormalMap(size_t number)
{
  // with one reflection texture the second is the same, with strength 0
  const auto& layers = this->Property->GetNormalMaps().Layers;
  const vtkWaterNormalMaps::Layer& layer = layers[std::min(number, layers.size() - 1)];
  auto* window = static_cast<vtkOpenGLRenderWindow*>(this->Drawn.Renderer->GetRenderWindow());
  const std::string wrong = vtkWaterNormalMaps::Check(layer);
  if (!wrong.empty())
  {
    const std::pair<vtkTexture*, vtkMTimeType> broken{ layer.Texture, 0 };
    if (this->NormalMapTimes[number] != broken)
    {
      std::vector<float> level(4, 0.0f);
      this->NormalMaps[number].Upload(window, 1, 1, level);
      this->NormalMapTimes[number] = broken;
      if (number < layers.size()) // said once
      {
        vtkErrorWithObjectMacro(this->Property,
          "The texture of a normal map has changed: " << wrong << ". The map is left out.");
      }
    }
    return;
  }
  const std::pair<vtkTexture*, vtkMTimeType> now{ layer.Texture,
    vtkWaterNormalMaps::GetTime(layer) };
  if (this->NormalMapTimes[number] != now || !this->NormalMaps[number].Get(window))
  {
    int size[2];
    std::vector<float> texels = vtkWaterNormalMaps::GetTexels(layer, size);
    this->NormalMaps[number].Upload(
      window, static_cast<unsigned int>(size[0]), static_cast<unsigned int>(size[1]), texels);
    this->NormalMapTimes[number] = now;
    this->NormalMapTexels[number] = 1.0 / std::max(size[0], size[1]);
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::Begin(vtkWaterActor* water, const Frame& frame)
{
  this->Drawn = frame;
  if (frame.Plan)
  {
    this->Plan = *frame.Plan;
    this->Drawn.Plan = &this->Plan;
  }
  this->Property = water->GetWaterProperty();
  this->HasBackdrop = false;
  this->Active.clear();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(frame.Renderer->GetRenderWindow());
  int drawn[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, drawn);
  this->Active.emplace_back("waterReflection", frame.Reflection);
  if (frame.Plan && (this->BuiltStages & BODY))
  {
    const bool hadFailed = this->Backdrop.GetHasFailed();
    this->HasBackdrop = this->Backdrop.Copy(window, drawn);
    if (this->Backdrop.GetHasFailed() && !hadFailed) // said once
    {
      vtkErrorWithObjectMacro(water,
        "the GPU gave no textures for what is seen through the water. The water shows its plain "
        "colour.");
    }
    this->Active.emplace_back("waterSceneColor", this->Backdrop.GetColor());
    this->Active.emplace_back("waterSceneDepth", this->Backdrop.GetDepth());
    if (this->HasBackdrop && frame.AddsFog)
    {
      frame.Screen->DrawFog(frame.Renderer, *frame.Plan, this->Backdrop,
        this->Property->GetDeepColor(), this->Property->GetExtinction());
    }
  }
  if ((frame.Plan || frame.View) && (this->BuiltStages & WAVES))
  {
    // both count from the point under the eye
    this->UploadWaves(water, frame.View ? frame.View->origin_xy : frame.Plan->origin_xy);
    this->Active.emplace_back("waterWaves", this->Waves);
  }
  if (frame.Plan && (this->BuiltStages & RAY_TRACED))
  {
    this->Active.emplace_back("waterReflectionDepth", frame.ReflectionDepth);
    if (frame.Layer)
    {
      this->Active.emplace_back("waterOpaque", frame.Layer->GetOpaque());
      this->Active.emplace_back("waterLayer", frame.Layer->GetColor());
      this->Active.emplace_back("waterLayerDepth", frame.Layer->GetDepth());
    }
  }
  this->Time = water->GetTime();
  if (frame.Plan && (this->BuiltStages & NORMAL_MAPS))
  {
    this->UploadNormalMap(0);
    this->UploadNormalMap(1);
    this->Active.emplace_back("waterNormalMap0", this->NormalMaps[0].Get(window));
    this->Active.emplace_back("waterNormalMap1", this->NormalMaps[1].Get(window));
  }
  this->Sea = nullptr;
  if (frame.Plan && (this->BuiltStages & SEA))
  {
    vtkWaterSea* sea = water->GetSeaAtTime();
    this->Active.emplace_back("waterSea", sea->Upload(window));
    this->Sea = sea;
  }
  if (frame.Plan && water_plan_has_reflection(frame.Plan))
  {
    // where pixel meets texel, one texel is the same as four
    const bool isAligned = !(this->BuiltStages & (WAVES | RAY_TRACED | OFFSET)) && frame.IsFlat &&
      std::equal(drawn + 2, drawn + 4, frame.Plan->texture_px);
    frame.Reflection->SetMagnificationFilter(
      isAligned ? vtkTextureObject::Nearest : vtkTextureObject::Linear);
    frame.Reflection->SetMinificationFilter(isAligned ? vtkTextureObject::Nearest
        : this->BuiltStages & ROUGH                   ? vtkTextureObject::LinearMipmapLinear
                                                      : vtkTextureObject::Linear);
    if (frame.Layer)
    {
      frame.Layer->SetHasLevels((this->BuiltStages & ROUGH) != 0);
    }
  }
  for (const auto& [name, texture] : this->Active)
  {
    if (texture)
    {
      texture->Activate();
    }
  }
  this->Environment =
    this->BuiltStages & ENVIRONMENT ? this->Property->GetEnvironmentTexture() : nullptr;
  if (this->Environment &&
    (this->Environment->GetCubeMap() || this->Environment->GetNumberOfInputConnections(0) == 0))
  {
    this->Environment = nullptr; // it has changed since it was set; the background is at hand
  }
  if (this->Environment)
  {
    this->Environment->Render(frame.Renderer);
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::End()
{
  if (this->Environment)
  {
    this->Environment->PostRender(this->Drawn.Renderer);
  }
  for (const auto& [name, texture] : this->Active)
  {
    if (texture)
    {
      texture->Deactivate();
    }
  }
  this->Active.clear();
  this->Environment = nullptr;
  this->Property = nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Waves && window)
  {
    this->Waves->ReleaseGraphicsResources(window);
  }
  this->Waves = nullptr;
  for (vtkWaterSlopeTexture& texture : this->NormalMaps)
  {
    texture.ReleaseGraphicsResources(window);
  }
  this->Backdrop.ReleaseGraphicsResources(window);
  this->IsRefused = false;
}
