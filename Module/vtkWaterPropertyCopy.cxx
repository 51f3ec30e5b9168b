// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPropertyCopy.cxx: the part of vtkWaterProperty that takes over what another one has.
#include "vtkWaterCompat.h"
#include "vtkWaterPropertyInternals.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
void vtkWaterProperty::DeepCopy(vtkWaterProperty* other)
{
  if (!other || other == this)
  {
    return;
  }
  *this->Internal = *other->Internal; // textures are shared, as vtkProperty shares them
  this->ReflectanceMode = other->ReflectanceMode;
  this->Reflectance = other->Reflectance;
  this->IndexOfRefraction = other->IndexOfRefraction;
  this->Refraction = other->Refraction;
  this->RefractionSource = other->RefractionSource;
  std::copy_n(other->Absorption, 3, this->Absorption);
  std::copy_n(other->Scattering, 3, this->Scattering);
  this->DeepColorMode = other->DeepColorMode;
  std::copy_n(other->DeepColor, 3, this->DeepColor);
  this->MetresPerUnit = other->MetresPerUnit;
  this->VerticalExaggeration = other->VerticalExaggeration;
  this->ShoreSoftness = other->ShoreSoftness;
  this->HasShoreSoftness = other->HasShoreSoftness;
  this->DomePortRadius = other->DomePortRadius;
  this->ReflectionSource = other->ReflectionSource;
  this->Glitter = other->Glitter;
  this->HighlightRollOff = other->HighlightRollOff;
  std::copy_n(other->SlopeVariance, 3, this->SlopeVariance);
  this->FoamDepth = other->FoamDepth;
  this->FoamFitsScene = other->FoamFitsScene;
  this->FoamStretch = other->FoamStretch;
  std::copy_n(other->FoamColor, 3, this->FoamColor);
  this->Shadows = other->Shadows;
  this->Caustics = other->Caustics;
  this->LightShafts = other->LightShafts;
  this->DataOpacity = other->DataOpacity;
  this->Opacity = other->Opacity;
  this->Depth = other->Depth;
  this->Sea = other->Sea;
  this->WindSpeed = other->WindSpeed;
  this->WindDirection = other->WindDirection;
  this->Fetch = other->Fetch;
  this->SeaModel = other->SeaModel;
  this->PeakEnhancement = other->PeakEnhancement;
  this->Seed = other->Seed;
  this->SeaTileSize = other->SeaTileSize;
  this->SeaTileLength = other->SeaTileLength;
  this->SeaPeriod = other->SeaPeriod;
  this->SeaCascades = other->SeaCascades;
  this->SeaChoppiness = other->SeaChoppiness;
  this->Whitecaps = other->Whitecaps;
  this->WhitecapLifeTime = other->WhitecapLifeTime;
  this->WaveGeometry = other->WaveGeometry;
  this->WaveGridSize = other->WaveGridSize;
  this->Lookup = other->Lookup;
  this->OffsetScale = other->OffsetScale;
  this->RayTraceSteps = other->RayTraceSteps;
  this->RayTraceProbes = other->RayTraceProbes;
  this->RayTraceRays = other->RayTraceRays;
  this->RayTraceLayers = other->RayTraceLayers;
  this->RayTraceFootprint = other->RayTraceFootprint;
  this->Output = other->Output;
  this->Modified(); // the sea's slopes are those of another time
}
VTK_ABI_NAMESPACE_END
