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
  water_cascades cascades;
  property->ReadSea(&sea, &cascades);
  this->Sea.Update(cascades, sea, this->Self->Time);
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
      const int size = this->Self->WaterProperty->GetSeaTileSize();
      vtkErrorWithObjectMacro(this->Self,
        "There is no memory for the wind sea's tiles of "
          << size << " x " << size
          << " points (SetSeaTileSize). Heights and normals of the waves are NaN.");
    }
    this->IsSeaUnknown = true;
  }
  return !this->IsSeaUnknown;
}

//------------------------------------------------------------------------------
bool vtkWaterActor::Internals::FindSurfaces(
  const double* places, size_t count, water_wave_point* points)
{
  vtkWaterLook look;
  this->Describe(look);
  const std::vector<water_wave_term> terms = this->GetWaveTerms(look);
  const double metres = look.MetresPerUnit;
  const bool isMoved = look.Has.has_wave_geometry;
  bool isKnown = true;
  const auto askAll = [&](vtkWaterSea* sea) {
    const water_cascade_surface surface =
      sea && isMoved ? sea->GetSurface(look.SeaChoppiness, 1.0 / metres) : water_cascade_surface();
    const water_wave_others others = { water_cascades_add, &surface, look.WaveReach };
    for (size_t i = 0; i < count; ++i)
    {
      const double x = places[3 * i];
      const double y = places[3 * i + 1];
      double rest[2];
      const water_status status = sea && isMoved
        ? water_waves_find_all(terms.data(), terms.size(), &others, x, y, rest, points + i)
        : water_waves_find(terms.data(), terms.size(), x, y, rest, points + i);
      isKnown = isKnown && status == WATER_OK;
      if (sea && !isMoved)
      {
        double slope[2];
        sea->GetSlope(x * metres, y * metres, slope);
        water_waves_tilt(slope, points[i].normal);
        points[i].displacement[2] += sea->GetHeight(x * metres, y * metres) / metres;
      }
    }
  };
  if (!look.Has.has_sea)
  {
    askAll(nullptr);
    return isKnown;
  }
  return this->AskSea([&](vtkWaterSea& sea) { askAll(&sea); }) && isKnown;
}

//------------------------------------------------------------------------------
bool vtkWaterActor::Internals::FindSurface(double x, double y, water_wave_point* point)
{
  const double place[3] = { x, y, 0.0 };
  return this->FindSurfaces(place, 1, point);
}

//------------------------------------------------------------------------------
bool vtkWaterActor::Internals::LowerByWaves(double* places, size_t count)
{
  std::vector<water_wave_point> points(count);
  if (!this->FindSurfaces(places, count, points.data()))
  {
    return false;
  }
  for (size_t i = 0; i < count; ++i)
  {
    places[3 * i + 2] -= points[i].displacement[2];
  }
  return true;
}

//------------------------------------------------------------------------------
double vtkWaterActor::GetWaveHeight(double x, double y)
{
  water_wave_point point;
  return this->Internal->FindSurface(x, y, &point) ? point.displacement[2] : vtkMath::Nan();
}

//------------------------------------------------------------------------------
void vtkWaterActor::GetWaveNormal(double x, double y, double normal[3])
{
  water_wave_point point;
  std::fill(normal, normal + 3, vtkMath::Nan());
  if (this->Internal->FindSurface(x, y, &point))
  {
    std::copy(point.normal, point.normal + 3, normal);
  }
}

//------------------------------------------------------------------------------
bool vtkWaterActor::Internals::IsDisplaced() const
{
  vtkWaterProperty* property = this->Self->WaterProperty;
  return property->GetWaveGeometry() && (property->GetNumberOfWaves() > 0 || property->GetSea());
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
