// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterActorWaves.cxx: the part of vtkWaterActor that has a time: its waves and its sea then,
// their heights and normals, and the grid that they displace.
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyDataMapper.h"
#include "vtkWaterActorInternals.h"
#include "vtkWaterCompat.h"
#include "vtkWaterProperty.h"
#include "water_waves.h"

#include <algorithm>
#include <new>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr double kLargestTime = 1e15; // s; beyond, a double has no phases left
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetTime(double seconds)
{
  if (!(seconds >= -kLargestTime && seconds <= kLargestTime))
  {
    vtkErrorMacro("Time is " << seconds << "; it must be finite and lie in [" << -kLargestTime
                             << ", " << kLargestTime << "]. It stays " << this->Time << ".");
  }
  else if (this->Time != seconds)
  {
    this->Time = seconds;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::vector<water_wave_term> vtkWaterActor::Internals::GetWaveTerms(const vtkWaterLook& look) const
{
  const vtkWaterProperty* property = this->Self->WaterProperty;
  const auto count =
    look.Has.has_sines ? static_cast<size_t>(property->GetNumberOfWaves()) : size_t(0);
  std::vector<water_wave_term> terms(count);
  size_t bad_index = 0;
  // all are checked by their setters
  water_waves_at(property->GetWaves(), count, this->Self->WaterProperty->GetDepth(),
    this->Self->Time, terms.data(), &bad_index);
  water_waves_scale(1.0 / look.MetresPerUnit, terms.data(), count);
  return terms;
}

//------------------------------------------------------------------------------
vtkWaterSea* vtkWaterActor::Internals::GetSeaAtTime()
{
  vtkWaterProperty* property = this->Self->WaterProperty;
  if (!property->GetSea())
  {
    return nullptr;
  }
  water_sea sea;
  water_tile tile;
  property->ReadSea(&sea, &tile);
  this->Sea.Update(tile, sea, this->Self->Time);
  return &this->Sea;
}

//------------------------------------------------------------------------------
bool vtkWaterActor::Internals::AskSea(const std::function<void(vtkWaterSea&)>& ask)
{
  try
  {
    if (vtkWaterSea* sea = this->GetSeaAtTime())
    {
      ask(*sea);
    }
    this->IsSeaUnknown = false;
  }
  catch (const std::bad_alloc&)
  {
    if (!this->IsSeaUnknown)
    {
      const size_t size = this->Sea.GetTile().size;
      vtkErrorWithObjectMacro(this->Self,
        "There is no memory for the wind sea's tile of "
          << size << " x " << size
          << " points (SetSeaTileSize). Heights and normals of the waves are NaN.");
    }
    this->IsSeaUnknown = true;
  }
  return !this->IsSeaUnknown;
}

//------------------------------------------------------------------------------
double vtkWaterActor::GetWaveHeight(double x, double y)
{
  vtkWaterLook look;
  this->Internal->Describe(look);
  const std::vector<water_wave_term> terms = this->Internal->GetWaveTerms(look);
  double rest[2];
  water_wave_point point;
  if (water_waves_find(terms.data(), terms.size(), x, y, rest, &point) != WATER_OK)
  {
    return vtkMath::Nan();
  }
  double height = 0.0; // of the sea
  const double metres = look.MetresPerUnit;
  const auto ask = [&](
                     vtkWaterSea& sea) { height = sea.GetHeight(x * metres, y * metres) / metres; };
  return !look.Has.has_sea || this->Internal->AskSea(ask) ? point.displacement[2] + height
                                                          : vtkMath::Nan();
}

//------------------------------------------------------------------------------
void vtkWaterActor::GetWaveNormal(double x, double y, double normal[3])
{
  vtkWaterLook look;
  this->Internal->Describe(look);
  const std::vector<water_wave_term> terms = this->Internal->GetWaveTerms(look);
  double rest[2];
  water_wave_point point;
  std::fill(normal, normal + 3, vtkMath::Nan());
  if (water_waves_find(terms.data(), terms.size(), x, y, rest, &point) == WATER_OK &&
    (!look.Has.has_sea || this->Internal->AskSea([&](vtkWaterSea& sea) {
      double slope[2];
      sea.GetSlope(x * look.MetresPerUnit, y * look.MetresPerUnit, slope);
      water_waves_tilt(slope, point.normal);
    })))
  {
    std::copy(point.normal, point.normal + 3, normal);
  }
}

//------------------------------------------------------------------------------
bool vtkWaterActor::Internals::IsDisplaced() const
{
  vtkWaterProperty* property = this->Self->WaterProperty;
  return property->GetWaveGeometry() && property->GetNumberOfWaves() > 0;
}

//------------------------------------------------------------------------------
vtkMapper* vtkWaterActor::Internals::LayGrid(
  const vtkWaterSnapshot& water, const water_grid_view& view, vtkMapper* mapper)
{
  if (mapper != this->Sheet.GetMapper())
  {
    return mapper;
  }
  vtkWaterGrid::Place place;
  place.View = view;
  std::copy_n(this->Sheet.GetRectangle(), 4, place.Sheet);
  place.IsEndless = water.IsEndless;
  place.Height = water.Look.WaveHeightMax;
  place.Reach = water.Look.WaveReach;
  place.Size = water.Look.WaveGridSize;
  this->Grid.Lay(place);
  return this->Grid.GetMapper();
}

//------------------------------------------------------------------------------
vtkMapper* vtkWaterActor::Internals::LayHorizon(const vtkWaterSnapshot& water,
  vtkRenderer* renderer, const water_camera& eye, const double* kept, vtkMapper* mapper)
{
  if (!water.IsEndless)
  {
    return mapper;
  }
  vtkWaterHorizon::Place place;
  place.Eye = eye;
  place.Plane = water.Plane;
  place.HasKept = kept != nullptr;
  if (kept)
  {
    std::copy_n(kept, 4, place.Kept);
  }
  vtkMatrix4x4::Invert(&this->Self->GetMatrix()->Element[0][0], place.ToLocal);
  return this->Horizon.Lay(renderer, place);
}

VTK_ABI_NAMESPACE_END
