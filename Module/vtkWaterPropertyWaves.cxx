// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPropertyWaves.cxx: the part of vtkWaterProperty that describes waves one by one, normal
// reflection textures and slopes; the wind sea is in vtkWaterPropertySea.cxx.
#include "vtkMath.h"
#include "vtkWaterCompat.h"
#include "vtkWaterPropertyInternals.h"
#include "water_glitter.h"
#include "water_secondary.h"
#include "water_tile.h"
#include "water_waves.h"
#include "water_whitecap.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr double kLargestVariance = 1e6; // shaders have floats

// A wave from its directions in degrees.
water_wave MakeWave(
  double amplitude, double wavelength, double direction, double phase, double steepness)
{
  return water_wave{ amplitude, wavelength, vtkMath::RadiansFromDegrees(direction),
    vtkMath::RadiansFromDegrees(phase), steepness };
}
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetSlopeVariance(double along, double across, double direction)
{
  const double variance[3] = { along, across, direction };
  if (!(along >= 0.0 && across >= 0.0 && along <= kLargestVariance && across <= kLargestVariance &&
        std::isfinite(direction)))
  {
    vtkErrorMacro("SlopeVariance is " << along << " along and " << across << " across " << direction
                                      << " degrees; the variances must lie in [0, "
                                      << kLargestVariance << "], and the direction must be "
                                      << "finite. They stay as they were.");
  }
  else if (!std::equal(variance, variance + 3, this->SlopeVariance))
  {
    std::copy(variance, variance + 3, this->SlopeVariance);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetSlopeVarianceToWind(double speed, double direction)
{
  double variance[2];
  const water_status status = water_glitter_variance(speed, variance);
  if (status != WATER_OK)
  {
    vtkErrorMacro("Wind of " << speed << " m/s: " << water_status_text(status)
                             << ". SlopeVariance stays as it was.");
    return;
  }
  this->SetSlopeVariance(variance[0], variance[1], direction);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::GetSlopeVariance(double variance[3]) const
{
  std::copy(this->SlopeVariance, this->SlopeVariance + 3, variance);
}

//------------------------------------------------------------------------------
bool vtkWaterProperty::UseWaves(std::vector<water_wave>& waves, int number, const char* otherwise)
{
  size_t bad_index = 0;
  const water_status status = water_waves_check(waves.data(), waves.size(), &bad_index);
  if (status != WATER_OK)
  {
    const water_wave& wave = waves[static_cast<size_t>(number)];
    vtkErrorMacro("Wave of Amplitude "
      << wave.amplitude << ", Wavelength " << wave.wavelength << ", Direction "
      << vtkMath::DegreesFromRadians(wave.direction_rad) << ", Phase "
      << vtkMath::DegreesFromRadians(wave.phase_rad) << ", Steepness " << wave.steepness << ": "
      << water_status_text(status) << ". " << otherwise);
    return false;
  }
  this->Internal->Waves.swap(waves);
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
int vtkWaterProperty::AddWave(
  double amplitude, double wavelength, double direction, double phase, double steepness)
{
  std::vector<water_wave> waves = this->Internal->Waves;
  const int number = this->GetNumberOfWaves();
  waves.push_back(MakeWave(amplitude, wavelength, direction, phase, steepness));
  return this->UseWaves(waves, number, "It is not added.") ? number : -1;
}

//------------------------------------------------------------------------------
bool vtkWaterProperty::HasWave(const char* what, int number)
{
  const int count = this->GetNumberOfWaves();
  if (number >= 0 && number < count)
  {
    return true;
  }
  if (count == 0)
  {
    vtkErrorMacro("Wave " << number << " cannot be " << what << "; there are no waves.");
  }
  else
  {
    vtkErrorMacro("Wave " << number << " cannot be " << what << "; the number must lie in [0, "
                          << count - 1 << "]. The waves stay as they were.");
  }
  return false;
}

//------------------------------------------------------------------------------
bool vtkWaterProperty::SetWave(
  int number, double amplitude, double wavelength, double direction, double phase, double steepness)
{
  if (!this->HasWave("set", number))
  {
    return false;
  }
  std::vector<water_wave> waves = this->Internal->Waves;
  waves[static_cast<size_t>(number)] = MakeWave(amplitude, wavelength, direction, phase, steepness);
  return this->UseWaves(waves, number, "The wave stays as it was.");
}

//------------------------------------------------------------------------------
bool vtkWaterProperty::RemoveWave(int number)
{
  if (!this->HasWave("removed", number))
  {
    return false;
  }
  this->Internal->Waves.erase(this->Internal->Waves.begin() + number);
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterProperty::RemoveAllWaves()
{
  if (!this->Internal->Waves.empty())
  {
    this->Internal->Waves.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkWaterProperty::GetNumberOfWaves() const
{
  return static_cast<int>(this->Internal->Waves.size());
}

//------------------------------------------------------------------------------
bool vtkWaterProperty::GetWave(int number, double wave[5]) const
{
  if (number < 0 || number >= this->GetNumberOfWaves())
  {
    return false;
  }
  const water_wave& found = this->Internal->Waves[static_cast<size_t>(number)];
  wave[0] = found.amplitude;
  wave[1] = found.wavelength;
  wave[2] = vtkMath::DegreesFromRadians(found.direction_rad);
  wave[3] = vtkMath::DegreesFromRadians(found.phase_rad);
  wave[4] = found.steepness;
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterProperty::UpdateSeaSlopes() const
{
  vtkWaterPropertySeaSlopes& known = this->Internal->SeaSlopes;
  water_sea sea;
  water_cascades cascades;
  this->ReadSea(&sea, &cascades);
  bool isKnown = cascades.count == known.Cascades.count && water_sea_is_same(&sea, &known.Sea);
  for (size_t i = 0; i < cascades.count && isKnown; ++i)
  {
    isKnown = water_tile_is_same(&cascades.tiles[i], &known.Cascades.tiles[i]);
  }
  if (!isKnown || known.LifeTime != this->WhitecapLifeTime)
  {
    double cover = 0.0;
    (void)water_whitecap_cover(this->WindSpeed, &cover); // checked by its setter, as the life time
    (void)water_old_foam_make(
      &sea, &cascades.tiles[0], cover, this->WhitecapLifeTime, &known.OldFoam);
    known.LifeTime = this->WhitecapLifeTime;
  }
  if (!isKnown)
  {
    water_cascades_slopes(&cascades, &sea, known.Beyond);
    known.Height = water_cascades_height(&sea);
    known.Sea = sea;
    known.Cascades = cascades;
  }
}

//------------------------------------------------------------------------------
void vtkWaterProperty::GetSeaSlopes(double held[2], double leftOut[2]) const
{
  this->UpdateSeaSlopes();
  const vtkWaterPropertySeaSlopes& known = this->Internal->SeaSlopes;
  double all[3];
  double shorter[3];
  water_cascades_turn(&known.Sea, known.Beyond[0], all);
  water_cascades_turn(&known.Sea, known.Beyond[known.Cascades.count], shorter);
  for (int i = 0; i < 2; ++i)
  {
    held[i] = all[i] - shorter[i];
    leftOut[i] = shorter[i];
  }
}

//------------------------------------------------------------------------------
double vtkWaterProperty::GetSlopeRMS() const
{
  double height = 0.0;
  double slope = 0.0;
  water_waves_rms(this->Internal->Waves.data(), this->Internal->Waves.size(), &height, &slope);
  if (!this->Sea)
  {
    return slope;
  }
  double held[2];
  double leftOut[2];
  this->GetSeaSlopes(held, leftOut);
  return water_tile_slope_rms(held, slope);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::GetMeanSlopes(bool hidesWaves, double covariance[3]) const
{
  static const double none[2] = { 0.0, 0.0 };
  const bool hasSea = this->Sea && !hidesWaves;
  if (hasSea)
  {
    this->UpdateSeaSlopes();
  }
  const vtkWaterPropertySeaSlopes& known = this->Internal->SeaSlopes;
  water_secondary_slopes(this->Internal->Waves.data(),
    hidesWaves ? 0 : this->Internal->Waves.size(), hasSea ? known.Beyond[0] : none,
    hasSea ? known.Sea.wind_dir_rad : 0.0, this->SlopeVariance,
    vtkMath::RadiansFromDegrees(this->SlopeVariance[2]), covariance);
}

//------------------------------------------------------------------------------
double vtkWaterProperty::GetWaveHeightMax() const
{
  double height = 0.0;
  double across = 0.0;
  water_waves_reach(this->Internal->Waves.data(), this->Internal->Waves.size(), &height, &across);
  double ofSea = 0.0;
  if (this->Sea && this->WaveGeometry)
  {
    this->UpdateSeaSlopes();
    water_cascades_reach(this->Internal->SeaSlopes.Height, this->SeaChoppiness, &ofSea, &across);
  }
  return height + ofSea;
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetWaveGeometry(bool geometry)
{
  if (this->WaveGeometry != geometry)
  {
    this->WaveGeometry = geometry;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetWaveGridSize(int size)
{
  vtkWaterSetInRange(WaveGridSize, size, 16, 2048);
}

//------------------------------------------------------------------------------
const water_wave* vtkWaterProperty::GetWaves() const
{
  return this->Internal->Waves.data();
}

//------------------------------------------------------------------------------
int vtkWaterProperty::AddNormalMap(
  vtkTexture* texture, double size, double speed, double direction, double strength)
{
  const std::string wrong = this->Internal->NormalMaps.Add(
    texture, water_normal_map{ size, speed, vtkMath::RadiansFromDegrees(direction), strength });
  if (!wrong.empty())
  {
    vtkErrorMacro("Normal map of Size " << size << ", Speed " << speed << ", Direction "
                                        << direction << ", Strength " << strength << ": " << wrong
                                        << ". It is not added.");
    return -1;
  }
  this->Modified();
  return this->GetNumberOfNormalMaps() - 1;
}

//------------------------------------------------------------------------------
void vtkWaterProperty::RemoveAllNormalMaps()
{
  if (!this->Internal->NormalMaps.Layers.empty())
  {
    this->Internal->NormalMaps.Layers.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkWaterProperty::GetNumberOfNormalMaps() const
{
  return static_cast<int>(this->Internal->NormalMaps.Layers.size());
}

//------------------------------------------------------------------------------
bool vtkWaterProperty::GetNormalMap(int number, double map[4]) const
{
  if (number < 0 || number >= this->GetNumberOfNormalMaps())
  {
    return false;
  }
  const water_normal_map& found =
    this->Internal->NormalMaps.Layers[static_cast<size_t>(number)].Map;
  map[0] = found.size;
  map[1] = found.speed;
  map[2] = vtkMath::DegreesFromRadians(found.direction_rad);
  map[3] = found.strength;
  return true;
}

//------------------------------------------------------------------------------
vtkTexture* vtkWaterProperty::GetNormalMapTexture(int number) const
{
  return number < 0 || number >= this->GetNumberOfNormalMaps()
    ? nullptr
    : this->Internal->NormalMaps.Layers[static_cast<size_t>(number)].Texture;
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetDepth(double depth)
{
  if (!(depth > 0.0))
  {
    vtkErrorMacro("Depth is " << depth << "; it must be greater than 0 (infinity is deep water). "
                              << "It stays " << this->Depth << ".");
  }
  else if (this->Depth != depth)
  {
    this->Depth = depth;
    this->Modified();
  }
}
VTK_ABI_NAMESPACE_END
