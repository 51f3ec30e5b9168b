// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPropertyNames.cxx: the part of vtkWaterProperty that says by a name what is set.
#include "vtkMath.h"
#include "vtkWaterCompat.h"
#include "vtkWaterPropertyInternals.h"
#include "water_medium.h"
#include "water_preset.h"

#include <algorithm>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
bool IsSame(const water_wave& a, const water_wave& b)
{
  return a.amplitude == b.amplitude && a.wavelength == b.wavelength &&
    a.direction_rad == b.direction_rad && a.phase_rad == b.phase_rad && a.steepness == b.steepness;
}

bool IsMedium(const water_medium& medium, const double absorption[3], const double scattering[3])
{
  return std::equal(medium.absorption, medium.absorption + 3, absorption) &&
    std::equal(medium.scattering, medium.scattering + 3, scattering);
}
}

//------------------------------------------------------------------------------
bool vtkWaterProperty::IsPreset(const water_preset& preset) const
{
  const double deep = std::numeric_limits<double>::infinity();
  const std::vector<water_wave>& waves = this->Internal->Waves;
  const bool isLook =
    this->ReflectanceMode == (preset.look.constant_reflectance ? CONSTANT : FRESNEL) &&
    this->Reflectance == (preset.look.constant_reflectance ? preset.look.reflectance : 1.0) &&
    this->IndexOfRefraction == preset.look.index_of_refraction &&
    this->Refraction == !preset.look.constant_reflectance &&
    IsMedium(preset.medium, this->Absorption, this->Scattering) && this->DeepColorMode == MEDIUM;
  const bool isWaves = this->Depth == (preset.has_sea ? preset.sea.depth : deep) &&
    this->Sea == preset.has_sea &&
    std::equal(waves.begin(), waves.end(), preset.waves, preset.waves + preset.wave_count, IsSame);
  const bool isSea = !preset.has_sea ||
    (this->SeaModel == (preset.sea.model == WATER_SEA_PHILLIPS ? PHILLIPS : JONSWAP) &&
      this->WindSpeed == preset.sea.wind_speed &&
      this->WindDirection == vtkMath::DegreesFromRadians(preset.sea.wind_dir_rad) &&
      this->Fetch == preset.sea.fetch && this->PeakEnhancement == preset.sea.peak_enhancement &&
      this->SeaTileLength == 0.0);
  return isLook && isWaves && isSea;
}

//------------------------------------------------------------------------------
const char* vtkWaterProperty::GetPreset() const
{
  for (int i = 0; i < GetNumberOfPresets(); ++i)
  {
    water_preset preset;
    if (water_preset_find(GetPresetName(i), &preset) == WATER_OK && this->IsPreset(preset))
    {
      return GetPresetName(i);
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
const char* vtkWaterProperty::GetWaterType() const
{
  for (int i = 0; i < WATER_TYPE_COUNT; ++i)
  {
    const auto type = static_cast<water_type>(i);
    water_medium medium;
    if (water_type_medium(type, &medium) == WATER_OK &&
      IsMedium(medium, this->Absorption, this->Scattering))
    {
      return water_type_text(type);
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
const char* vtkWaterProperty::GetReflectanceModeAsString() const
{
  return this->ReflectanceMode == CONSTANT ? "CONSTANT" : "FRESNEL";
}

//------------------------------------------------------------------------------
const char* vtkWaterProperty::GetDeepColorModeAsString() const
{
  return this->DeepColorMode == GIVEN ? "GIVEN" : "MEDIUM";
}

//------------------------------------------------------------------------------
const char* vtkWaterProperty::GetReflectionSourceAsString() const
{
  return this->ReflectionSource == ENVIRONMENT ? "ENVIRONMENT" : "SCENE";
}

//------------------------------------------------------------------------------
const char* vtkWaterProperty::GetRefractionSourceAsString() const
{
  static const char* const names[] = { "PICTURE", "OWN_VIEW", "AUTOMATIC" };
  return names[this->RefractionSource];
}

//------------------------------------------------------------------------------
const char* vtkWaterProperty::GetSeaModelAsString() const
{
  return this->SeaModel == PHILLIPS ? "PHILLIPS" : "JONSWAP";
}

//------------------------------------------------------------------------------
const char* vtkWaterProperty::GetLookupAsString() const
{
  static const char* const names[] = { "RAY_TRACED", "FIXED_OFFSET", "VIEW_SCALED_OFFSET",
    "MOVED_POINT" };
  return names[this->Lookup];
}

//------------------------------------------------------------------------------
const char* vtkWaterProperty::GetOutputAsString() const
{
  static const char* const names[] = { "COLOR", "CONFIDENCE", "LOOKUP", "REFLECTANCE" };
  return names[this->Output];
}
VTK_ABI_NAMESPACE_END
