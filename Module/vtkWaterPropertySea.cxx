// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPropertySea.cxx: the part of vtkWaterProperty that describes a wind sea.
#include "vtkMath.h"
#include "vtkWaterCompat.h"
#include "vtkWaterProperty.h"
#include "water_cascade.h"
#include "water_old_foam.h"
#include "water_whitecap.h"

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr int kSmallestTile = 32;
constexpr int kLargestTile = 1024;
constexpr double kSpreadingPower = 10.0; // of a spreading that is not in use
}

//------------------------------------------------------------------------------
int vtkWaterProperty::ReadSea(water_sea* sea, water_cascades* cascades) const
{
  sea->model = this->SeaModel == PHILLIPS ? WATER_SEA_PHILLIPS : WATER_SEA_JONSWAP;
  sea->spreading = WATER_SPREAD_DONELAN_BANNER;
  sea->wind_speed = this->WindSpeed;
  sea->wind_dir_rad = vtkMath::RadiansFromDegrees(this->WindDirection);
  sea->fetch = this->Fetch;
  sea->depth = this->Depth;
  sea->peak_enhancement = this->PeakEnhancement;
  sea->spreading_power = kSpreadingPower;
  *cascades = water_cascades();
  const bool isSea = water_sea_check(sea) == WATER_OK; // not while a setter tries a bad value
  const auto count = static_cast<size_t>(this->SeaCascades);
  water_tile& first = cascades->tiles[0];
  first.size = static_cast<size_t>(this->SeaTileSize);
  first.length = this->SeaTileLength;
  if (this->SeaTileLength == 0.0)
  {
    first.length = isSea ? water_cascades_natural_length(sea, count) : 1.0;
  }
  first.period = this->SeaPeriod;
  first.seed = static_cast<uint64_t>(this->Seed);
  const water_tile given = first;
  return water_cascades_make(&given, sea, count, cascades);
}

//------------------------------------------------------------------------------
template <typename T>
void vtkWaterProperty::SetOfSea(const char* name, T& member, T value)
{
  const T last = member;
  if (last == value)
  {
    return;
  }
  member = value;
  water_sea sea;
  water_cascades cascades;
  const auto status = static_cast<water_status>(this->ReadSea(&sea, &cascades));
  if (status != WATER_OK)
  {
    member = last;
    vtkErrorMacro(<< name << " is " << value << ": " << water_status_text(status) << ". It stays "
                  << last << ".");
    return;
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetSea(bool sea)
{
  if (this->Sea != sea)
  {
    this->Sea = sea;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetWindSpeed(double speed)
{
  this->SetOfSea("WindSpeed", this->WindSpeed, speed);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetWindDirection(double direction)
{
  this->SetOfSea("WindDirection", this->WindDirection, direction);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetFetch(double fetch)
{
  this->SetOfSea("Fetch", this->Fetch, fetch);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetSeaModel(int model)
{
  vtkWaterSetInRange(SeaModel, model, JONSWAP, PHILLIPS);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetPeakEnhancement(double enhancement)
{
  this->SetOfSea("PeakEnhancement", this->PeakEnhancement, enhancement);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetSeed(int seed)
{
  if (this->Seed != seed)
  {
    this->Seed = seed;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetSeaTileSize(int size)
{
  if (size < kSmallestTile || size > kLargestTile || (size & (size - 1)) != 0)
  {
    vtkErrorMacro("SeaTileSize is " << size << "; it must be a power of two in [" << kSmallestTile
                                    << ", " << kLargestTile << "]. It stays " << this->SeaTileSize
                                    << ".");
  }
  else if (this->SeaTileSize != size)
  {
    this->SeaTileSize = size;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetSeaTileLength(double length)
{
  this->SetOfSea("SeaTileLength", this->SeaTileLength, length);
}

//------------------------------------------------------------------------------
double vtkWaterProperty::GetUsedSeaTileLength() const
{
  water_sea sea;
  water_cascades cascades;
  this->ReadSea(&sea, &cascades);
  return cascades.tiles[0].length;
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetSeaPeriod(double period)
{
  this->SetOfSea("SeaPeriod", this->SeaPeriod, period);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetSeaCascades(int cascades)
{
  vtkWaterSetInRange(SeaCascades, cascades, 1, WATER_CASCADES_MAX);
}

//------------------------------------------------------------------------------
int vtkWaterProperty::GetUsedSeaCascades() const
{
  water_sea sea;
  water_cascades cascades;
  this->ReadSea(&sea, &cascades);
  return static_cast<int>(cascades.count);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetSeaChoppiness(double choppiness)
{
  vtkWaterSetInRange(SeaChoppiness, choppiness, 0.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetWhitecaps(bool whitecaps)
{
  if (this->Whitecaps != whitecaps)
  {
    this->Whitecaps = whitecaps;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetWhitecapLifeTime(double seconds)
{
  vtkWaterSetInRange(WhitecapLifeTime, seconds, 0.0, WATER_FOAM_LIFE_MAX);
}

//------------------------------------------------------------------------------
double vtkWaterProperty::GetWhitecapCover() const
{
  double cover = 0.0;
  (void)water_whitecap_cover(this->WindSpeed, &cover); // checked by its setter
  return this->Sea && this->Whitecaps ? cover : 0.0;
}

//------------------------------------------------------------------------------
void vtkWaterProperty::PrintSea(ostream& os, vtkIndent indent) const
{
  os << indent << "Sea: " << (this->Sea ? "on" : "off") << "\n";
  os << indent << "WindSpeed: " << this->WindSpeed << "\n";
  os << indent << "WindDirection: " << this->WindDirection << "\n";
  os << indent << "Fetch: " << this->Fetch << "\n";
  os << indent << "SeaModel: " << this->GetSeaModelAsString() << "\n";
  os << indent << "PeakEnhancement: " << this->PeakEnhancement << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "SeaTileSize: " << this->SeaTileSize << "\n";
  os << indent << "SeaTileLength: " << this->SeaTileLength << " (" << this->GetUsedSeaTileLength()
     << " in use)\n";
  os << indent << "SeaPeriod: " << this->SeaPeriod << "\n";
  os << indent << "SeaCascades: " << this->SeaCascades << " (" << this->GetUsedSeaCascades()
     << " in use)\n";
  os << indent << "SeaChoppiness: " << this->SeaChoppiness << "\n";
  os << indent << "Whitecaps: " << (this->Whitecaps ? "on" : "off") << "\n";
  os << indent << "WhitecapLifeTime: " << this->WhitecapLifeTime << "\n";
  os << indent << "SlopeRMS: " << this->GetSlopeRMS() << "\n";
}
VTK_ABI_NAMESPACE_END
