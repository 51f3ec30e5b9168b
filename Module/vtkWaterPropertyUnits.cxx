// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPropertyUnits.cxx: the part of vtkWaterProperty that knows what a metre is in a scene.
#include "vtkWaterCompat.h"
#include "vtkWaterPropertyInternals.h"
#include "vtkWaterSnapshot.h"
#include "water_units.h"

#include <algorithm>
#include <cstring>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr double kSmallestUnit = 1e-9; // m
constexpr double kLargestUnit = 1e9;
constexpr double kLeastExaggeration = 1e-6;
constexpr double kMostExaggeration = 1e6;
constexpr const char* kAutomatic = "automatic";
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetMetresPerUnit(double metres)
{
  if (metres != 0.0 && !(metres >= kSmallestUnit && metres <= kLargestUnit))
  {
    vtkErrorMacro("MetresPerUnit is " << metres << "; it must be 0 (automatic) or lie in ["
                                      << kSmallestUnit << ", " << kLargestUnit << "]. It stays "
                                      << this->MetresPerUnit << ".");
  }
  else if (this->MetresPerUnit != metres)
  {
    this->MetresPerUnit = metres;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetVerticalExaggeration(double factor)
{
  vtkWaterSetInRange(VerticalExaggeration, factor, kLeastExaggeration, kMostExaggeration);
}

//------------------------------------------------------------------------------
bool vtkWaterProperty::SetUnits(const char* name)
{
  double metres = 0.0;
  if ((name && std::strcmp(name, kAutomatic) == 0) || water_units_find(name, &metres) == WATER_OK)
  {
    this->SetMetresPerUnit(metres);
    return true;
  }
  std::string known;
  for (size_t i = 0; water_units_name(i); ++i)
  {
    known += std::string(water_units_name(i)) + ", ";
  }
  vtkErrorMacro("Units are '" << (name ? name : "(null)") << "'; they must be one of " << known
                              << kAutomatic << ". The water stays as it was.");
  return false;
}

//------------------------------------------------------------------------------
void vtkWaterProperty::DescribeUnits(double diagonal, vtkWaterLook& look) const
{
  const bool isAutomatic = this->MetresPerUnit == 0.0;
  look.MetresPerUnit =
    isAutomatic ? water_units_fit(diagonal, this->Internal->Natural) : this->MetresPerUnit;
  look.NaturalDepth = isAutomatic ? this->Internal->Natural[2] / look.MetresPerUnit : 0.0;
  look.SceneDiagonal = diagonal;
  double longest = 0.0;
  for (const water_wave& wave : this->Internal->Waves)
  {
    longest = std::max(longest, wave.wavelength);
  }
  if (this->Sea)
  {
    water_sea sea;
    water_cascades cascades;
    this->ReadSea(&sea, &cascades);
    longest = std::max(longest, water_tile_peak_wavelength(&sea));
  }
  look.HidesWaves =
    isAutomatic && longest > 0.0 && !water_units_show_waves(longest, diagonal * look.MetresPerUnit);
}
VTK_ABI_NAMESPACE_END
