// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSea.h"

#include "vtkFFT.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"
#include "vtkWaterGL.h"

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

// Transforms lines of a square in place: rows with stride 1, columns with stride size.
void TransformLines(std::vector<double>& square, size_t size, size_t stride, size_t next)
{
  std::vector<vtkFFT::ComplexNumber> line(size);
  for (size_t i = 0; i < size; ++i)
  {
    double* start = square.data() + 2 * i * next;
    for (size_t j = 0; j < size; ++j)
    {
      line[j].r = start[2 * j * stride];
      line[j].i = start[2 * j * stride + 1];
    }
    const std::vector<vtkFFT::ComplexNumber> out = vtkFFT::Fft(line);
    for (size_t j = 0; j < size; ++j)
    {
      start[2 * j * stride] = out[j].r;
      start[2 * j * stride + 1] = out[j].i;
    }
  }
}

// One or two fields from their spectra; second may be null.
void Transform(const water_tile& tile, std::vector<double>& first,
  const std::vector<double>* second, std::vector<double>& firstField,
  std::vector<double>* secondField)
{
  water_tile_pack(&tile, first.data(), second ? second->data() : nullptr, first.data());
  TransformLines(first, tile.size, 1, tile.size);
  TransformLines(first, tile.size, tile.size, 1);
  for (size_t i = 0; i < firstField.size(); ++i)
  {
    firstField[i] = first[2 * i];
    if (secondField)
    {
      (*secondField)[i] = first[2 * i + 1];
    }
  }
}
}

//------------------------------------------------------------------------------
void vtkWaterSea::Update(const water_tile& tile, const water_sea& sea, double time)
{
  const size_t count = tile.size * tile.size;
  const bool isOther =
    this->Amplitudes.empty() || !AreEqual(tile, this->Tile) || !AreEqual(sea, this->Sea);
  if (!isOther && time == this->Time)
  {
    return;
  }
  if (isOther)
  {
    this->Tile = tile;
    this->Sea = sea;
    this->Amplitudes.resize(2 * count);
    water_tile_amplitudes(&tile, &sea, this->Amplitudes.data());
    double held[2];
    water_tile_slopes(&tile, &sea, held, this->LeftOut);
    this->Heights.resize(count);
    this->SlopesX.resize(count);
    this->SlopesY.resize(count);
  }
  this->Time = time;
  std::vector<double> height(2 * count);
  std::vector<double> slopeX(2 * count);
  std::vector<double> slopeY(2 * count);
  water_tile_at(&tile, &sea, this->Amplitudes.data(), time, height.data());
  water_tile_derive(&tile, height.data(), WATER_TILE_SLOPE_X, slopeX.data());
  water_tile_derive(&tile, height.data(), WATER_TILE_SLOPE_Y, slopeY.data());
  Transform(tile, slopeX, &slopeY, this->SlopesX, &this->SlopesY);
  Transform(tile, height, nullptr, this->Heights, nullptr);
  this->IsUploaded = false;
}

//------------------------------------------------------------------------------
double vtkWaterSea::Sample(const std::vector<double>& field, double x, double y) const
{
  double value = vtkMath::Nan();
  water_tile_sample(&this->Tile, field.data(), x, y, &value);
  return value;
}

//------------------------------------------------------------------------------
double vtkWaterSea::GetHeight(double x, double y) const
{
  return this->Sample(this->Heights, x, y);
}

//------------------------------------------------------------------------------
void vtkWaterSea::GetSlope(double x, double y, double slope[2]) const
{
  slope[0] = this->Sample(this->SlopesX, x, y);
  slope[1] = this->Sample(this->SlopesY, x, y);
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterSea::Upload(vtkOpenGLRenderWindow* window)
{
  if (!this->IsUploaded || !this->Texture.Get(window))
  {
    std::vector<float> texels(4 * this->Heights.size());
    water_tile_texels(&this->Tile, this->SlopesX.data(), this->SlopesY.data(), texels.data());
    const auto size = static_cast<unsigned int>(this->Tile.size);
    this->Texture.Upload(window, size, size, texels);
    this->IsUploaded = true;
  }
  return this->Texture.Get(window);
}

//------------------------------------------------------------------------------
void vtkWaterSea::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture.ReleaseGraphicsResources(window);
}
