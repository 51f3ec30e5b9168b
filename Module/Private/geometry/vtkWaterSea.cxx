// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSea.h"

#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"
#include "vtkWaterGL.h"
#include "vtkWaterQueryResult.h"
#include "vtkWaterRendererClass.h"

#include <algorithm>
#include <new>
#include <utility>

//------------------------------------------------------------------------------
void vtkWaterSea::Update(const water_cascades& cascades, const water_sea& sea, double time)
{
  bool isOther = cascades.count != this->Cascades.count;
  this->Cascades.count = 0; // until there is memory for all
  for (size_t i = 0; i < cascades.count; ++i)
  {
    if (this->Tiles[i].Update(cascades.tiles[i], sea, time))
    {
      this->Passes.Forget();
      isOther = true;
    }
  }
  this->Cascades = cascades;
  if (isOther || time != this->Time)
  {
    this->Time = time;
    this->UploadedFields = 0;
  }
}

//------------------------------------------------------------------------------
double vtkWaterSea::GetHeight(double x, double y)
{
  double sum = 0.0;
  for (size_t i = 0; i < this->Cascades.count; ++i)
  {
    double value = vtkMath::Nan();
    const double place[2] = { x, y };
    double onTile[2];
    double turn[2][2];
    water_cascades_place(&this->Cascades, i, place, onTile, turn);
    water_tile_sample(
      &this->Cascades.tiles[i], this->Tiles[i].GetHeight(), onTile[0], onTile[1], &value);
    sum += value;
  }
  return sum;
}

//------------------------------------------------------------------------------
void vtkWaterSea::GetSlope(double x, double y, double slope[2])
{
  std::fill_n(slope, 2, 0.0);
  for (size_t i = 0; i < this->Cascades.count; ++i)
  {
    double value[2] = { vtkMath::Nan(), vtkMath::Nan() };
    const water_tile* tile = &this->Cascades.tiles[i];
    const double place[2] = { x, y };
    double onTile[2];
    double turn[2][2];
    water_cascades_place(&this->Cascades, i, place, onTile, turn);
    water_tile_sample(
      tile, this->Tiles[i].GetFirst(WATER_PAIR_SLOPES), onTile[0], onTile[1], &value[0]);
    water_tile_sample(
      tile, this->Tiles[i].GetSecond(WATER_PAIR_SLOPES), onTile[0], onTile[1], &value[1]);
    water_cascades_turned(turn, value);
    slope[0] += value[0];
    slope[1] += value[1];
  }
}

//------------------------------------------------------------------------------
water_cascade_surface vtkWaterSea::GetSurface(double choppiness, double unitsPerMetre)
{
  for (size_t i = 0; i < this->Cascades.count; ++i)
  {
    vtkWaterSeaTile& tile = this->Tiles[i];
    water_cascade_fields& fields = this->Fields[i];
    fields.height = tile.GetFirst(WATER_PAIR_HEIGHT_SHEAR);
    fields.bend[2] = tile.GetSecond(WATER_PAIR_HEIGHT_SHEAR);
    fields.slope[0] = tile.GetFirst(WATER_PAIR_SLOPES);
    fields.slope[1] = tile.GetSecond(WATER_PAIR_SLOPES);
    fields.chop[0] = tile.GetFirst(WATER_PAIR_CHOP);
    fields.chop[1] = tile.GetSecond(WATER_PAIR_CHOP);
    fields.bend[0] = tile.GetFirst(WATER_PAIR_STRETCH);
    fields.bend[1] = tile.GetSecond(WATER_PAIR_STRETCH);
  }
  return { &this->Cascades, this->Fields, choppiness, unitsPerMetre };
}

//------------------------------------------------------------------------------
bool vtkWaterSea::IsSoftware(vtkOpenGLRenderWindow* window)
{
  if (window != this->AskedWindow)
  {
    this->AskedWindow = window;
    this->IsSoftwareWindow = vtkWaterRendererClass::IsSoftware();
  }
  return this->IsSoftwareWindow;
}

//------------------------------------------------------------------------------
bool vtkWaterSea::DrawTexture(vtkOpenGLRenderWindow* window, int fields)
{
  const vtkOpenGLState::ScopedglActiveTexture activeTexture(window->GetState());
  const auto count = static_cast<unsigned int>(this->Cascades.count);
  const auto size = static_cast<unsigned int>(this->Cascades.tiles[0].size);
  const bool areSlopesAlone = fields <= vtkWaterSlopePasses::BENDS; // without bends and moves
  this->Texture.Allocate(
    window, size, size, static_cast<unsigned int>(fields) * count, areSlopesAlone);
  vtkWaterSlopePasses::Inputs inputs = { {}, this->Time };
  for (unsigned int i = 0; i < count; ++i)
  {
    const vtkWaterSeaTile& tile = this->Tiles[i];
    inputs.Tiles.push_back({ &tile.GetTile(), &tile.GetAmplitudes(), &tile.GetFrequencies() });
  }
  this->Detour = this->Passes.Draw(window, inputs, fields, this->Texture);
  if (this->Detour)
  {
    return false;
  }
  this->Texture.MakeMipLevels();
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterSea::FillTexels(int fields)
{
  const size_t count = this->Cascades.count;
  const size_t places = this->Cascades.tiles[0].size * this->Cascades.tiles[0].size;
  this->Texels.resize(static_cast<size_t>(fields) * count * 4 * places);
  for (size_t i = 0; i < count; ++i)
  {
    vtkWaterSeaTile& tile = this->Tiles[i];
    water_tile_texels(&this->Cascades.tiles[i], tile.GetFirst(WATER_PAIR_SLOPES),
      tile.GetSecond(WATER_PAIR_SLOPES), this->Texels.data() + i * 4 * places);
    const double* others[2][3] = {};
    if (fields > vtkWaterSlopePasses::BENDS)
    {
      others[0][2] = tile.GetSecond(WATER_PAIR_HEIGHT_SHEAR);
      others[0][0] = tile.GetFirst(WATER_PAIR_STRETCH);
      others[0][1] = tile.GetSecond(WATER_PAIR_STRETCH);
    }
    if (fields > vtkWaterSlopePasses::MOVES)
    {
      others[1][0] = tile.GetFirst(WATER_PAIR_CHOP);
      others[1][1] = tile.GetSecond(WATER_PAIR_CHOP);
      others[1][2] = tile.GetFirst(WATER_PAIR_HEIGHT_SHEAR);
    }
    for (size_t field = 1; field < static_cast<size_t>(fields); ++field)
    {
      float* texels = this->Texels.data() + (field * count + i) * 4 * places;
      for (size_t place = 0; place < places; ++place)
      {
        for (size_t part = 0; part < 3; ++part)
        {
          texels[4 * place + part] = static_cast<float>(others[field - 1][part][place]);
        }
        texels[4 * place + 3] = 0.0f;
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterSea::Begin(vtkOpenGLRenderWindow* window, const water_cascades& cascades,
  const water_sea& sea, double time, int fields)
{
  const bool wasInUse = std::exchange(this->IsInUse, false);
  if (!wasInUse || this->IsSoftware(window) || vtkWaterQueryResult::IsAnyAwaited())
  {
    return;
  }
  try
  {
    this->Update(cascades, sea, time);
    if (this->UploadedFields < fields || !this->Texture.Get(window))
    {
      this->UploadedFields = this->DrawTexture(window, fields) ? fields : 0;
      glFlush(); // drivers gather commands before they send them, and the GPU would wait for more
    }
  }
  catch (const std::bad_alloc&)
  {
    this->UploadedFields = 0; // the draw tries again, and reports it
  }
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterSea::Upload(vtkOpenGLRenderWindow* window, int fields)
{
  this->IsInUse = true;
  if (this->UploadedFields >= fields && this->Texture.Get(window))
  {
    return this->Texture.Get(window);
  }
  this->Detour = nullptr;
  this->UploadedFields = 0;
  if (this->IsSoftware(window) || !this->DrawTexture(window, fields))
  {
    this->FillTexels(fields);
    const auto size = static_cast<unsigned int>(this->Cascades.tiles[0].size);
    this->Texture.Upload(window, size, size,
      static_cast<unsigned int>(this->Cascades.count) * static_cast<unsigned int>(fields),
      this->Texels);
  }
  this->UploadedFields = fields;
  return this->Texture.Get(window);
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterSea::UploadFlat(vtkOpenGLRenderWindow* window, int fields)
{
  const auto layers = static_cast<unsigned int>(fields * WATER_CASCADES_MAX);
  const std::vector<float> texels(4 * static_cast<size_t>(layers), 0.0f);
  this->Texture.ReleaseGraphicsResources(window);
  this->Texture.Upload(window, 1, 1, layers, texels);
  this->UploadedFields = 0;
  return this->Texture.Get(window);
}

//------------------------------------------------------------------------------
void vtkWaterSea::ReleaseGraphicsResources(vtkWindow* window)
{
  this->AskedWindow = nullptr;
  this->Passes.ReleaseGraphicsResources(window);
  this->OldFoam.ReleaseGraphicsResources(window);
  this->Texture.ReleaseGraphicsResources(window);
}
