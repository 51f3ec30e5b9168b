// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterActorHulls.cxx: the part of vtkWaterActor that knows what floats in the water.
#include "vtkWaterActorInternals.h"
#include "vtkWaterCompat.h"
#include "water_plane.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
void vtkWaterActor::AddHull(vtkActor* hull)
{
  if (!hull)
  {
    vtkErrorMacro("A hull is nullptr; it must be a vtkActor with a mapper. It is left out.");
  }
  else if (vtkWaterActor::SafeDownCast(hull))
  {
    vtkErrorMacro(
      "A hull is a vtkWaterActor; it must be the actor of a floating body. It is left out.");
  }
  else if (this->Internal->Hulls.Add(hull))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::RemoveHull(vtkActor* hull)
{
  if (this->Internal->Hulls.Remove(hull))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::RemoveAllHulls()
{
  if (!this->Internal->Hulls.IsEmpty())
  {
    this->Internal->Hulls.Clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkWaterActor::GetNumberOfHulls()
{
  return static_cast<int>(this->Internal->Hulls.List().size());
}

//------------------------------------------------------------------------------
vtkActor* vtkWaterActor::GetHull(int number)
{
  const auto hulls = this->Internal->Hulls.List();
  const bool isOne = number >= 0 && number < static_cast<int>(hulls.size());
  return isOne ? hulls[static_cast<size_t>(number)].Get() : nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::CutHulls(vtkWaterSnapshot& water)
{
  vtkWaterHulls::Surface surface;
  if (this->Hulls.IsEmpty())
  {
    this->HullError.clear();
    return;
  }
  if (water_plane_normalise(&water.Plane, &surface.Unit) != WATER_OK)
  {
    return;
  }
  std::copy_n(water.Origin, 3, surface.Origin);
  surface.HeightMax = this->IsDisplaced() ? water.Look.WaveHeightMax : 0.0;
  surface.Lower = [this](
                    double* places, size_t count) { return this->LowerByWaves(places, count); };
  const std::pair<vtkMTimeType, double> time(
    std::max(this->Self->GetMTime(), this->Hulls.GetMeshTime()), water.Look.MetresPerUnit);
  if (time != this->HullTime)
  {
    this->HullTime = time;
    std::string wrong;
    this->HullTable = this->Hulls.Cut(surface, wrong);
    const bool isKnown = !this->HullError.empty(); // until it is mended
    this->HullError = wrong;                       // observers of the event may ask for it
    if (!wrong.empty() && !isKnown)
    {
      vtkErrorWithObjectMacro(this->Self, << wrong);
    }
  }
  water.Hulls = this->HullTable;
  if (water.Hulls)
  {
    water.Features = water_features_with_hulls(water.Features);
  }
}

VTK_ABI_NAMESPACE_END
