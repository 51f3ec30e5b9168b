// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSea.h"

#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSMPTools.h"
#include "vtkTextureObject.h"
#include "vtkWaterRendererClass.h"
#include "water_tile_time.h"

namespace
{

bool AreEqual(const water_tile& a, const water_tile& b)
{
  return a.size == b.size && a.length == b.length && a.period == b.period && a.seed == b.seed;
}

bool AreEqual(const water_sea& a, const water_sea& b)
{
  return a.model == b.model && a.spreading == b.spreading && a.wind_speed == b.wind_speed &&
    a.wind_dir_rad == b.wind_dir_rad && a.fetch == b.fetch && a.depth == b.depth &&
    a.peak_enhancement == b.peak_enhancement && a.spreading_power == b.spreading_power;
}
}

//------------------------------------------------------------------------------
void vtkWaterSea::Update(const water_tile& tile, const water_sea& sea, double time)
{
  const bool isOther =
    this->Amplitudes.empty() || !AreEqual(tile, this->Tile) || !AreEqual(sea, this->Sea);
  if (!isOther && time == this->Time)
  {
    return;
  }
  this->Time = time;
  this->HasPhasors = false;
  this->HasHeights = false;
  this->HasSlopes = false;
  this->IsUploaded = false;
  if (isOther)
  {
    this->Tile = tile;
    this->Sea = sea;
    double held[2];
    water_tile_slopes(&tile, &sea, held, this->LeftOut);
    this->Passes.Forget();
    this->Amplitudes.clear(); // and last: there are none unless there is memory for all
    this->Frequencies.resize(tile.size / 2 * (tile.size / 2));
    water_tile_frequencies(&tile, &sea, this->Frequencies.data());
    this->Amplitudes.resize(2 * tile.size * tile.size);
    water_tile_amplitudes(&tile, &sea, this->Amplitudes.data());
  }
}

//------------------------------------------------------------------------------
void vtkWaterSea::UpdatePhasors()
{
  if (this->HasPhasors)
  {
    return;
  }
  this->Phasors.resize(2 * this->Frequencies.size());
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(this->Tile.size / 2), [this](vtkIdType first, vtkIdType end) {
      water_tile_phasors(&this->Tile, this->Frequencies.data(), this->Time,
        static_cast<size_t>(first), static_cast<size_t>(end), this->Phasors.data());
    });
  this->HasPhasors = true;
}

//------------------------------------------------------------------------------
void vtkWaterSea::UpdateHeights()
{
  if (this->HasHeights)
  {
    return;
  }
  this->UpdatePhasors();
  this->Heights.resize(this->Tile.size * this->Tile.size);
  this->Transform.Run(
    this->Tile.size,
    [this](size_t row, double* own, double* mirror) {
      water_tile_height_row(
        &this->Tile, this->Amplitudes.data(), this->Phasors.data(), row, own, mirror);
    },
    this->Heights.data(), nullptr);
  this->HasHeights = true;
}

//------------------------------------------------------------------------------
void vtkWaterSea::UpdateSlopes()
{
  if (this->HasSlopes)
  {
    return;
  }
  this->UpdatePhasors();
  this->SlopesX.resize(this->Tile.size * this->Tile.size);
  this->SlopesY.resize(this->Tile.size * this->Tile.size);
  this->Transform.Run(
    this->Tile.size,
    [this](size_t row, double* own, double* mirror) {
      water_tile_slope_row(
        &this->Tile, this->Amplitudes.data(), this->Phasors.data(), row, own, mirror);
    },
    this->SlopesX.data(), this->SlopesY.data());
  this->HasSlopes = true;
}

//------------------------------------------------------------------------------
double vtkWaterSea::Sample(const std::vector<double>& field, double x, double y) const
{
  double value = vtkMath::Nan();
  water_tile_sample(&this->Tile, field.data(), x, y, &value);
  return value;
}

//------------------------------------------------------------------------------
double vtkWaterSea::GetHeight(double x, double y)
{
  this->UpdateHeights();
  return this->Sample(this->Heights, x, y);
}

//------------------------------------------------------------------------------
void vtkWaterSea::GetSlope(double x, double y, double slope[2])
{
  this->UpdateSlopes();
  slope[0] = this->Sample(this->SlopesX, x, y);
  slope[1] = this->Sample(this->SlopesY, x, y);
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
vtkTextureObject* vtkWaterSea::Upload(vtkOpenGLRenderWindow* window)
{
  if (this->IsUploaded && this->Texture.Get(window))
  {
    return this->Texture.Get(window);
  }
  this->Detour = nullptr;
  if (!this->IsSoftware(window))
  {
    this->Detour = this->Passes.Draw(
      window, { this->Tile, this->Amplitudes, this->Frequencies, this->Time }, this->Texture);
    if (!this->Detour)
    {
      this->IsUploaded = true;
      return this->Texture.Get(window);
    }
  }
  this->UpdateSlopes();
  this->Texels.resize(4 * this->SlopesX.size());
  water_tile_texels(&this->Tile, this->SlopesX.data(), this->SlopesY.data(), this->Texels.data());
  const auto size = static_cast<unsigned int>(this->Tile.size);
  this->Texture.Upload(window, size, size, this->Texels);
  this->IsUploaded = true;
  return this->Texture.Get(window);
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterSea::UploadFlat(vtkOpenGLRenderWindow* window)
{
  std::vector<float> texel(4, 0.0f);
  this->Texture.ReleaseGraphicsResources(window); // the passes' framebuffers have it at its size
  this->Texture.Upload(window, 1, 1, texel);
  this->IsUploaded = false;
  return this->Texture.Get(window);
}

//------------------------------------------------------------------------------
void vtkWaterSea::ReleaseGraphicsResources(vtkWindow* window)
{
  this->AskedWindow = nullptr;
  this->Passes.ReleaseGraphicsResources(window);
  this->Texture.ReleaseGraphicsResources(window);
}
