// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPropertyLook.cxx: the part of vtkWaterProperty that hands the look out as plain data.
#include "vtkWaterCompat.h"
#include "vtkWaterPropertyInternals.h"
#include "vtkWaterSnapshot.h"
#include "water_quality.h"
#include "water_units.h"
#include "water_whitecap.h"

#include <algorithm>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Lengths in metres to the scene's unit; slopes have none.
//
// exaggeration  factor by which the scene's depths are drawn deeper
void ToUnits(vtkWaterLook& look, double exaggeration)
{
  const double metres = look.MetresPerUnit;
  const double metresDown = metres / exaggeration;
  for (int i = 0; i < 3; ++i)
  {
    look.Medium.absorption[i] *= metresDown;
    look.Medium.scattering[i] *= metresDown;
    look.Extinction[i] *= metresDown;
  }
  look.ShoreSoftness /= metresDown;
  look.DomePortRadius /= metres;
  look.FoamDepth /= metresDown;
  look.WaveNumber *= metres;
  look.WaveHeightMax /= metres;
  look.WaveReach /= metres;
  for (vtkWaterNormalMaps::Layer& layer : look.NormalMaps)
  {
    layer.Map.size /= metres;
    layer.Map.speed /= metres;
  }
}
}

//------------------------------------------------------------------------------
void vtkWaterProperty::Describe(double diagonal, vtkWaterLook& look)
{
  look.Optics.index_of_refraction = this->IndexOfRefraction;
  look.Optics.reflectance = this->Reflectance;
  look.Optics.constant_reflectance = this->ReflectanceMode == CONSTANT;
  look.Has.has_environment = this->ReflectionSource == ENVIRONMENT;
  look.Has.lookup = this->Lookup == RAY_TRACED ? WATER_LOOKUP_RAY_TRACED : WATER_LOOKUP_OFFSET;
  look.Has.has_refraction = this->Refraction;
  look.Has.has_caustics = this->Caustics > 0.0 || this->LightShafts > 0.0;
  look.Has.has_glitter = this->Glitter;
  look.Has.has_foam = this->FoamDepth > 0.0 || this->FoamStretch > 0.0 || look.HasFoamData;
  look.Has.has_shadows = this->Shadows;
  look.Has.has_output = this->Output != COLOR;
  look.RollsOff = this->HighlightRollOff;
  look.DataOpacity = this->DataOpacity;
  look.Opacity = this->Opacity;
  std::copy_n(this->DeepColor, 3, look.DeepColor);
  look.HasDeepColor = this->DeepColorMode == GIVEN;
  std::copy_n(this->Absorption, 3, look.Medium.absorption);
  std::copy_n(this->Scattering, 3, look.Medium.scattering);
  std::copy_n(this->Internal->Extinction, 3, look.Extinction);
  look.RefractionSource = static_cast<water_refraction_source>(this->RefractionSource);
  look.ShoreSoftness = this->ShoreSoftness;
  look.HasShoreSoftness = this->HasShoreSoftness;
  look.DomePortRadius = this->DomePortRadius;
  look.Caustics = this->Caustics;
  look.LightShafts = this->LightShafts;
  look.FoamDepth = this->FoamDepth;
  look.FoamJacobian = this->FoamStretch;
  std::copy_n(this->FoamColor, 3, look.FoamColor);
  look.Lookup = this->Lookup;
  look.OffsetScale = this->OffsetScale;
  look.RayTraceSteps = this->RayTraceSteps;
  look.RayTraceProbes = this->RayTraceProbes;
  look.RayTraceRays = this->RayTraceRays;
  look.RayTraceLayers = this->RayTraceLayers;
  look.RayTraceFootprint = this->RayTraceFootprint;
  look.Output = this->Output;
  look.Environment = this->Internal->Environment;
  look.Property = this;
  this->DescribeUnits(diagonal, look);
  this->DescribeWaves(look);
  ToUnits(look, this->MetresPerUnit == 0.0 ? 1.0 : this->VerticalExaggeration);
  if (this->FoamFitsScene && this->FoamDepth > 0.0 && this->MetresPerUnit == 0.0)
  {
    look.FoamDepth = water_units_show_foam(look.FoamDepth, diagonal);
  }
}

//------------------------------------------------------------------------------
void vtkWaterProperty::DescribeWaves(vtkWaterLook& look)
{
  static const std::vector<water_wave> none;
  const std::vector<water_wave>& waves = look.HidesWaves ? none : this->Internal->Waves;
  look.Has.has_sines = !waves.empty();
  look.Has.has_sea = this->Sea && !look.HidesWaves;
  look.Has.has_normal_maps = this->GetNumberOfNormalMaps() > 0;
  look.Has.has_slope_variance = this->SlopeVariance[0] + this->SlopeVariance[1] > 0.0;
  look.Has.has_wave_geometry = this->WaveGeometry;
  look.Has.has_whitecaps = this->Whitecaps;
  look.Has.has_all_slopes = water_rays_take_all_slopes(this->RayTraceRays);
  std::copy_n(this->SlopeVariance, 3, look.SlopeVariance);
  this->GetMeanSlopes(look.HidesWaves, look.MeanSlopes);
  look.SlopeRMS = look.HidesWaves ? 0.0 : this->GetSlopeRMS();
  look.WaveNumber = look.Has.has_sea ? 0.0 : water_waves_number(waves.data(), waves.size());
  water_waves_reach(waves.data(), waves.size(), &look.WaveHeightMax, &look.WaveReach);
  look.WaveGridSize = this->WaveGridSize;
  const double steepest = water_features_is_of_sines(&look.Has)
    ? water_waves_looked_up(waves.data(), waves.size())
    : std::numeric_limits<double>::infinity();
  look.SlopeLookedUp = water_features_needs_rays(&look.Has) ? steepest : 0.0;
  this->ReadSea(&look.Sea, &look.Cascades);
  this->DescribeSea(look);
  look.NormalMaps = this->Internal->NormalMaps.Layers;
}

//------------------------------------------------------------------------------
void vtkWaterProperty::DescribeSea(vtkWaterLook& look)
{
  look.SeaChoppiness = this->SeaChoppiness;
  if (!look.Has.has_sea)
  {
    return;
  }
  this->UpdateSeaSlopes();
  const vtkWaterPropertySeaSlopes& known = this->Internal->SeaSlopes;
  for (size_t i = 0; i <= look.Cascades.count; ++i)
  {
    water_cascades_turn(&look.Sea, known.Beyond[i], look.SeaBeyond[i]);
  }
  look.OldFoam = known.OldFoam;
  look.WhitecapJacobian = water_whitecap_jacobian(known.OldFoam.fresh, known.Beyond[0]);
  if (look.Has.has_wave_geometry)
  {
    double height = 0.0;
    double across = 0.0;
    water_cascades_reach(known.Height, this->SeaChoppiness, &height, &across);
    look.WaveHeightMax += height;
    look.WaveReach += across;
  }
}
VTK_ABI_NAMESPACE_END
