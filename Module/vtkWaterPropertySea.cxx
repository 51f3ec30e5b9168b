// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPropertySea.cxx: the part of vtkWaterProperty that describes a wind sea.
#include "vtkMath.h"
#include "vtkWaterCompat.h"
#include "vtkWaterProperty.h"
#include "water_tile.h"

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr int kSmallestTile = 32;
constexpr int kLargestTile = 1024;
constexpr double kSpreadingPower = 10.0; // of a spreading that is not in use
}

//------------------------------------------------------------------------------
void vtkWaterProperty::ReadSea(water_sea* sea, water_tile* tile) const
{
  sea->model = this->SeaModel == PHILLIPS ? WATER_SEA_PHILLIPS : WATER_SEA_JONSWAP;
  sea->spreading = WATER_SPREAD_DONELAN_BANNER;
  sea->wind_speed = this->WindSpeed;
  sea->wind_dir_rad = vtkMath::RadiansFromDegrees(this->WindDirection);
  sea->fetch = this->Fetch;
  sea->depth = this->Depth;
  sea->peak_enhancement = this->PeakEnhancement;
  sea->spreading_power = kSpreadingPower;
  tile->size = static_cast<size_t>(this->SeaTileSize);
  tile->length = this->SeaTileLength;
  tile->period = this->SeaPeriod;
  tile->seed = static_cast<uint64_t>(this->Seed);
  if (this->SeaTileLength == 0.0)
  {
    tile->length = water_sea_check(sea) == WATER_OK ? water_tile_natural_length(sea) : 1.0;
  }
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
  water_tile tile;
  this->ReadSea(&sea, &tile);
  const water_status status = water_tile_check(&tile, &sea);
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
  water_tile tile;
  this->ReadSea(&sea, &tile);
  return tile.length;
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetSeaPeriod(double period)
{
  this->SetOfSea("SeaPeriod", this->SeaPeriod, period);
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
  os << indent << "SlopeRMS: " << this->GetSlopeRMS() << "\n";
}
VTK_ABI_NAMESPACE_END
