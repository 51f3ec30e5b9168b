// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSurfaceShader.h"

#include "vtkActor.h"
#include "vtkLogger.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkTexture.h"
#include "vtkTextureObject.h"
#include "vtkWaterGL.h"
#include "vtkWaterGLSL.h" // all files of the list
#include "vtkWaterSea.h"
#include "water_flatness.h"
#include "water_plan.h"
#include "water_waves.h"

#include <algorithm>
#include <new>

namespace
{
// A file of water_features.h.
struct ShaderFile
{
  water_feature_set AnyOf;
  water_feature_set NoneOf;
  const char* Source;
};
#define WATER_SHADER_FILE(slot, file, any_of, none_of, what) { any_of, none_of, file },
const ShaderFile surfaceFiles[] = { WATER_SURFACE_FILE_LIST(WATER_SHADER_FILE) };

template <size_t Count>
std::string Join(const ShaderFile (&files)[Count], water_feature_set features)
{
  std::string source;
  for (const ShaderFile& file : files)
  {
    if (water_features_want(features, file.AnyOf, file.NoneOf))
    {
      source += file.Source;
      source += "\n";
    }
  }
  return source;
}
}

//------------------------------------------------------------------------------
std::string vtkWaterSurfaceShader::GetShader(water_feature_set features)
{
  static const ShaderFile buffer[] = { WATER_BUFFER_FILE_LIST(WATER_SHADER_FILE) };
  return features & WATER_FEATURE_BUFFERED ? Join(buffer, features) : Join(surfaceFiles, features);
}

//------------------------------------------------------------------------------
bool vtkWaterSurfaceShader::ShadeBuffer(vtkAbstractMapper* mapper)
{
  const std::string shader =
    vtkWaterBufferHead + Join(surfaceFiles, this->Features) + vtkWaterBufferShadeFS;
  return this->Buffer.Shade(shader,
    [this, mapper](vtkShaderProgram* program) { this->SetParameters(program, mapper, nullptr); });
}

//------------------------------------------------------------------------------
std::string vtkWaterSurfaceShader::GetVertexShader(water_feature_set features)
{
  static const ShaderFile files[] = { WATER_VERTEX_FILE_LIST(WATER_SHADER_FILE) };
  return Join(files, features);
}

//------------------------------------------------------------------------------
std::string vtkWaterSurfaceShader::GetPhotonShader(water_feature_set features)
{
  static const ShaderFile files[] = { WATER_PHOTON_FILE_LIST(WATER_SHADER_FILE) };
  return Join(files, features);
}

//------------------------------------------------------------------------------
bool vtkWaterSurfaceShader::UpdateFeatures(water_feature_set features)
{
  const bool isOther = features != this->Features;
  this->Features = features;
  this->IsRefused = this->IsRefused && !isOther;
  return isOther;
}

//------------------------------------------------------------------------------
vtkOpenGLRenderWindow* vtkWaterSurfaceShader::GetWindow() const
{
  return static_cast<vtkOpenGLRenderWindow*>(this->Drawn.Renderer->GetRenderWindow());
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::ReleaseShader()
{
  this->GetWindow()->GetShaderCache()->ReleaseCurrentShader();
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::UploadWaves(const double origin[2])
{
  const std::vector<water_wave_term>& terms = this->Water->Waves;
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
  vtkOpenGLRenderWindow* window = this->GetWindow();
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
void vtkWaterSurfaceShader::UploadHulls()
{
  vtkOpenGLRenderWindow* window = this->GetWindow();
  const vtkWaterHullTablePointer& table = this->Water->Hulls;
  if (!this->Hulls || this->Hulls->GetContext() != window)
  {
    this->Hulls = vtkSmartPointer<vtkTextureObject>::New();
    this->Hulls->SetContext(window);
    this->Hulls->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Hulls->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->HullTable = nullptr;
  }
  if (this->HullTable != table)
  {
    this->Hulls->Create2DFromRaw(static_cast<unsigned int>(table->Rows.longest),
      static_cast<unsigned int>(table->Rows.count), 4, VTK_FLOAT,
      const_cast<float*>(table->Texels.data())); // it is only read
    this->HullTable = table;
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::UploadNormalMap(size_t number)
{
  // with one reflection texture the second is the same, with strength 0
  const auto& layers = this->Water->Look.NormalMaps;
  const vtkWaterNormalMaps::Layer& layer = layers[std::min(number, layers.size() - 1)];
  vtkOpenGLRenderWindow* window = this->GetWindow();
  const std::string wrong = vtkWaterNormalMaps::Check(layer);
  if (!wrong.empty())
  {
    const std::pair<vtkTexture*, vtkMTimeType> broken{ layer.Texture, 0 };
    if (this->NormalMapTimes[number] != broken)
    {
      std::vector<float> level(4, 0.0f);
      this->NormalMaps[number].Upload(window, 1, 1, 1, level);
      this->NormalMapTimes[number] = broken;
      if (number < layers.size()) // said once
      {
        vtkErrorWithObjectMacro(this->Water->Look.Property,
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
      window, static_cast<unsigned int>(size[0]), static_cast<unsigned int>(size[1]), 1, texels);
    this->NormalMapTimes[number] = now;
    this->NormalMapTexels[number] = 1.0 / std::max(size[0], size[1]);
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::BeginWaves()
{
  vtkOpenGLRenderWindow* window = this->GetWindow();
  if (this->Drawn.Plan && this->Has(WATER_FEATURE_NORMAL_MAPS))
  {
    this->UploadNormalMap(0);
    this->UploadNormalMap(1);
    this->Use("waterNormalMap0", this->NormalMaps[0].Get(window));
    this->Use("waterNormalMap1", this->NormalMaps[1].Get(window));
  }
  const bool isMoved = this->Drawn.View && this->Has(WATER_FEATURE_SEA_MOVES);
  if (((this->Drawn.Plan || this->Drawn.IsWarmUp) && this->Has(WATER_FEATURE_SEA)) || isMoved)
  {
    this->BeginSea();
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::BeginSea()
{
  vtkOpenGLRenderWindow* window = this->GetWindow();
  vtkWaterSea* sea = this->Water->Sea;
  vtkTextureObject* texture = nullptr;
  const int fields = this->Water->GetSeaFields();
  try
  {
    sea->Update(this->Water->Look.Cascades, this->Water->Look.Sea, this->Water->Time);
    texture = sea->Upload(window, fields);
  }
  catch (const std::bad_alloc&)
  {
    if (!this->IsSeaFlat) // said once
    {
      vtkErrorWithObjectMacro(this->Water->Actor,
        "There is no memory for the wind sea's tiles of "
          << this->Water->Look.Cascades.tiles[0].size << " x "
          << this->Water->Look.Cascades.tiles[0].size
          << " points (SetSeaTileSize). The sea has no waves; the next frame"
             " tries again.");
    }
  }
  this->IsSeaFlat = !texture;
  this->Use("waterSea", texture ? texture : sea->UploadFlat(window, fields));
  if (this->Has(WATER_FEATURE_WHITECAPS))
  {
    this->BeginOldFoam();
  }
  this->HasSea = true;
  if (sea->GetDetour() && sea->GetDetour() != this->SeaDetour) // said once
  {
    vtkVLog(vtkLogger::VERBOSITY_TRACE,
      << "The CPU computes the fields of the wind sea: " << sea->GetDetour() << ".");
  }
  this->SeaDetour = sea->GetDetour();
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::BeginOldFoam()
{
  vtkOpenGLRenderWindow* window = this->GetWindow();
  const vtkWaterLook& look = this->Water->Look;
  vtkTextureObject* texture = nullptr;
  try
  {
    texture = this->Water->Sea->UploadOldFoam(window, look.OldFoam, look.Sea, this->Water->Time);
  }
  catch (const std::bad_alloc&)
  {
    if (!this->IsFoamFresh) // said once
    {
      vtkErrorWithObjectMacro(this->Water->Actor,
        "There is no memory for the foam that whitecaps leave (SetWhitecapLifeTime). They vanish "
        "with the crest; the next frame tries again.");
    }
  }
  this->IsFoamFresh = !texture;
  this->Use("waterOldFoam",
    texture ? texture : this->Water->Sea->UploadOldFoam(window, water_old_foam(), look.Sea, 0.0));
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::BeginReflection(const int viewport_px[4])
{
  const Inputs& drawn = this->Drawn;
  // where pixel meets texel, one texel is the same as four
  const bool isAligned = this->IsFlat && !this->Backdrop.GetSpread() &&
    !this->Has(WATER_FEATURE_WAVES | WATER_FEATURE_RAY_TRACED | WATER_FEATURE_OFFSET) &&
    std::equal(viewport_px + 2, viewport_px + 4, this->Plan.texture_px);
  const int blurred = this->Has(WATER_FEATURE_ROUGH) ? vtkTextureObject::LinearMipmapLinear
                                                     : vtkTextureObject::Linear;
  drawn.Reflection->SetMagnificationFilter(
    isAligned ? vtkTextureObject::Nearest : vtkTextureObject::Linear);
  drawn.Reflection->SetMinificationFilter(isAligned ? vtkTextureObject::Nearest : blurred);
  for (vtkTextureObject* texture : { drawn.Translucent.Opaque, drawn.Translucent.Color })
  {
    if (texture)
    {
      texture->SetMinificationFilter(blurred);
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::UseReflection()
{
  const Inputs& drawn = this->Drawn;
  this->Use("waterReflectionDepth", drawn.ReflectionDepth);
  if (drawn.Translucent.Color)
  {
    this->Use("waterOpaque", drawn.Translucent.Opaque);
    this->Use("waterLayer", drawn.Translucent.Color);
    this->Use("waterLayerDepth", drawn.Translucent.Depth);
  }
  if (this->Has(WATER_FEATURE_PEELED))
  {
    this->Use("waterPeelColor", drawn.PeelColor);
    this->Use("waterPeelBehindDepth", drawn.PeelDepth);
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::Activate()
{
  for (const auto& [name, texture] : this->Active)
  {
    if (texture)
    {
      texture->Activate();
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::Begin(const vtkWaterSnapshotPointer& water, const Inputs& inputs)
{
  this->Water = water;
  this->Drawn = inputs;
  if (inputs.Plan)
  {
    this->Plan = *inputs.Plan;
    this->Drawn.Plan = &this->Plan;
  }
  this->HasBackdrop = false;
  this->HasLight = false;
  this->HasShafts = false;
  this->Backdrop.Forget();
  this->HasSea = false;
  this->Active.clear();
  int viewport_px[4];
  this->GetWindow()->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport_px);
  this->IsFlat = inputs.Plan && inputs.IsAtRest &&
    water_flatness_is_unseen(&this->Plan, water->Mesh.HeightMax, viewport_px + 2);
  this->Use("waterReflection", inputs.Reflection);
  if (inputs.Plan && this->Has(WATER_FEATURE_MEDIUM))
  {
    this->BeginMedium(viewport_px);
  }
  if ((inputs.Plan || inputs.View) && this->Has(WATER_FEATURE_WAVES))
  {
    // both count from the point under the eye
    this->UploadWaves(inputs.View ? inputs.View->origin_xy : inputs.Plan->origin_xy);
    this->Use("waterWaves", this->Waves);
  }
  if (inputs.Plan && this->Has(WATER_FEATURE_RAY_TRACED))
  {
    this->UseReflection();
  }
  if (inputs.Plan && this->Has(WATER_FEATURE_SHADOWS) && inputs.SunView.Depth)
  {
    this->Use("waterSunView", inputs.SunView.Depth);
  }
  if (inputs.Plan && this->Has(WATER_FEATURE_SKY_VIEW))
  {
    this->Use("waterSkyView", inputs.SkyView.Color);
    this->Use("waterSkyViewDepth", inputs.SkyView.Depth);
  }
  if (inputs.Plan && this->Has(WATER_FEATURE_HULLS))
  {
    this->UploadHulls();
    this->Use("waterHulls", this->Hulls);
  }
  this->BeginWaves();
  if (inputs.Plan && water_plan_has_reflection(inputs.Plan))
  {
    this->BeginReflection(viewport_px);
  }
  this->Activate();
  this->BeginLight(viewport_px);
  this->BeginSky();
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::End()
{
  this->SkyTextures.clear(); // as they were
  for (const auto& [name, texture] : this->Active)
  {
    if (texture)
    {
      texture->Deactivate();
    }
  }
  this->Active.clear();
  this->Water = nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Waves && window)
  {
    this->Waves->ReleaseGraphicsResources(window);
  }
  this->Waves = nullptr;
  if (this->Hulls && window)
  {
    this->Hulls->ReleaseGraphicsResources(window);
  }
  this->Hulls = nullptr;
  for (vtkWaterSlopeTexture& texture : this->NormalMaps)
  {
    texture.ReleaseGraphicsResources(window);
  }
  this->Flow.ReleaseGraphicsResources();
  this->Matter.ReleaseGraphicsResources();
  this->Foam.ReleaseGraphicsResources();
  this->Shore.ReleaseGraphicsResources();
  this->Backdrop.ReleaseGraphicsResources(window);
  this->Buffer.ReleaseGraphicsResources(window);
  this->Caustics.ReleaseGraphicsResources(window);
  this->ShaftLight.ReleaseGraphicsResources(window);
  this->IsRefused = false;
}
