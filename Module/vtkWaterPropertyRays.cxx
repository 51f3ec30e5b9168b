// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPropertyRays.cxx: the part of vtkWaterProperty that says how a wave's reflection is
// found.
#include "vtkWaterCompat.h"
#include "vtkWaterProperty.h"
#include "water_quality.h"

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
void vtkWaterProperty::SetLookup(int lookup)
{
  vtkWaterSetInRange(Lookup, lookup, RAY_TRACED, MOVED_POINT);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetOffsetScale(double scale)
{
  vtkWaterSetInRange(OffsetScale, scale, -1000.0, 1000.0);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetRayTraceSteps(int steps)
{
  vtkWaterSetInRange(RayTraceSteps, steps, 1, 256);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetRayTraceProbes(int probes)
{
  vtkWaterSetInRange(RayTraceProbes, probes, 0, 64);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetRayTraceRays(int rays)
{
  vtkWaterSetInRange(RayTraceRays, rays, 1, 16);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetRayTraceLayers(int layers)
{
  vtkWaterSetInRange(RayTraceLayers, layers, 1, 2);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetRayTraceFootprint(double footprint)
{
  vtkWaterSetInRange(RayTraceFootprint, footprint, 0.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetRayTraceQuality(const char* name)
{
  water_ray_quality quality;
  const water_status status = water_quality_of_name(name ? name : "", &quality);
  if (status != WATER_OK)
  {
    vtkErrorMacro("RayTraceQuality is \"" << (name ? name : "") << "\"; "
                                          << water_status_text(status) << ". It stays as it was.");
    return;
  }
  this->SetRayTraceSteps(quality.steps);
  this->SetRayTraceProbes(quality.probes);
  this->SetRayTraceRays(quality.rays);
  this->SetRayTraceLayers(quality.layers);
  this->SetRayTraceFootprint(quality.footprint_px);
}
VTK_ABI_NAMESPACE_END
