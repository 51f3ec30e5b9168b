// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterProperty.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkTexture.h"
#include "vtkWaterCompat.h"
#include "vtkWaterPropertyInternals.h"
#include "water_daylight.h"
#include "water_medium.h"
#include "water_preset.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkWaterProperty);

//------------------------------------------------------------------------------
vtkWaterProperty::vtkWaterProperty()
  : Internal(std::make_unique<Internals>())
  , Depth(std::numeric_limits<double>::infinity())
{
  water_medium medium;
  water_preset_default(&medium, this->Internal->Natural);
  this->UseMedium(medium);
}

//------------------------------------------------------------------------------
vtkWaterProperty::~vtkWaterProperty() = default;

//------------------------------------------------------------------------------
void vtkWaterProperty::SetReflectanceMode(int mode)
{
  vtkWaterSetInRange(ReflectanceMode, mode, FRESNEL, CONSTANT);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetReflectance(double reflectance)
{
  vtkWaterSetInRange(Reflectance, reflectance, 0.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetIndexOfRefraction(double index)
{
  vtkWaterSetInRange(IndexOfRefraction, index, 1.0, 10.0);
}

//------------------------------------------------------------------------------
bool vtkWaterProperty::SetColor(
  const char* name, double (&member)[3], double red, double green, double blue)
{
  const double rgb[3] = { red, green, blue };
  for (double channel : rgb)
  {
    if (!(channel >= 0.0 && channel <= 1.0))
    {
      vtkErrorMacro(<< name << " is (" << red << ", " << green << ", " << blue
                    << "); every channel must lie in [0, 1]. It stays (" << member[0] << ", "
                    << member[1] << ", " << member[2] << ").");
      return false;
    }
  }
  if (!std::equal(rgb, rgb + 3, member))
  {
    std::copy(rgb, rgb + 3, member);
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetDeepColor(double red, double green, double blue)
{
  if (this->SetColor("DeepColor", this->DeepColor, red, green, blue))
  {
    this->SetDeepColorMode(GIVEN);
  }
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetDeepColorMode(int mode)
{
  vtkWaterSetInRange(DeepColorMode, mode, MEDIUM, GIVEN);
  this->UpdateDeepColor();
}

//------------------------------------------------------------------------------
void vtkWaterProperty::UpdateDeepColor()
{
  if (this->DeepColorMode == MEDIUM)
  {
    const double white[3] = { 1.0, 1.0, 1.0 };
    water_medium medium;
    std::copy_n(this->Absorption, 3, medium.absorption);
    std::copy_n(this->Scattering, 3, medium.scattering);
    water_daylight_deep_color(&medium, white, this->DeepColor);
  }
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetFoamColor(double red, double green, double blue)
{
  this->SetColor("FoamColor", this->FoamColor, red, green, blue);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetFoamDepth(double depth)
{
  vtkWaterSetInRange(FoamDepth, depth, 0.0, std::numeric_limits<double>::max());
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetFoamStretch(double stretch)
{
  vtkWaterSetInRange(FoamStretch, stretch, 0.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetShoreSoftness(double depth)
{
  vtkWaterSetInRange(ShoreSoftness, depth, 0.0, std::numeric_limits<double>::max());
  if (this->ShoreSoftness == depth && !this->HasShoreSoftness)
  {
    this->HasShoreSoftness = true;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetDomePortRadius(double radius)
{
  vtkWaterSetInRange(DomePortRadius, radius, 0.0, std::numeric_limits<double>::max());
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetReflectionSource(int source)
{
  vtkWaterSetInRange(ReflectionSource, source, SCENE, ENVIRONMENT);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetEnvironmentTexture(vtkTexture* texture)
{
  if (texture && texture->GetCubeMap())
  {
    vtkErrorMacro("EnvironmentTexture is a cube map; it must be one picture in latitude and "
                  "longitude. It stays as it was.");
  }
  else if (this->Internal->Environment != texture)
  {
    this->Internal->Environment = texture;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTexture* vtkWaterProperty::GetEnvironmentTexture() const
{
  return this->Internal->Environment;
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetGlitter(bool glitter)
{
  vtkWaterSetInRange(Glitter, glitter, false, true);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetHighlightRollOff(bool rolls)
{
  vtkWaterSetInRange(HighlightRollOff, rolls, false, true);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetShadows(bool shadows)
{
  vtkWaterSetInRange(Shadows, shadows, false, true);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetLightShafts(double share)
{
  vtkWaterSetInRange(LightShafts, share, 0.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetCaustics(double strength)
{
  vtkWaterSetInRange(Caustics, strength, 0.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetRefraction(bool refraction)
{
  vtkWaterSetInRange(Refraction, refraction, false, true);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetRefractionSource(int source)
{
  vtkWaterSetInRange(RefractionSource, source, PICTURE, AUTOMATIC);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetMedium(
  const char* name, double (vtkWaterProperty::*member)[3], const double value[3])
{
  water_medium medium;
  const double(&last)[3] = this->*member;
  std::copy(this->Absorption, this->Absorption + 3, medium.absorption);
  std::copy(this->Scattering, this->Scattering + 3, medium.scattering);
  std::copy(value, value + 3,
    member == &vtkWaterProperty::Absorption ? medium.absorption : medium.scattering);
  const water_status status = water_medium_check(&medium);
  if (status != WATER_OK)
  {
    vtkErrorMacro(<< name << " is (" << value[0] << ", " << value[1] << ", " << value[2]
                  << "): " << water_status_text(status) << ". It stays (" << last[0] << ", "
                  << last[1] << ", " << last[2] << ").");
  }
  else if (!std::equal(value, value + 3, last))
  {
    this->UseMedium(medium);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterProperty::UseMedium(const water_medium& medium)
{
  std::copy(medium.absorption, medium.absorption + 3, this->Absorption);
  std::copy(medium.scattering, medium.scattering + 3, this->Scattering);
  water_medium_extinction(&medium, this->Internal->Extinction);
  this->UpdateDeepColor();
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetAbsorption(double red, double green, double blue)
{
  const double perMetre[3] = { red, green, blue };
  this->SetMedium("Absorption", &vtkWaterProperty::Absorption, perMetre);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetScattering(double red, double green, double blue)
{
  const double perMetre[3] = { red, green, blue };
  this->SetMedium("Scattering", &vtkWaterProperty::Scattering, perMetre);
}

//------------------------------------------------------------------------------
bool vtkWaterProperty::SetWaterType(const char* name)
{
  for (int type = 0; name && type < WATER_TYPE_COUNT; ++type)
  {
    water_medium medium;
    if (std::strcmp(name, water_type_text(static_cast<water_type>(type))) == 0 &&
      water_type_medium(static_cast<water_type>(type), &medium) == WATER_OK)
    {
      this->DeepColorMode = MEDIUM;
      this->UseMedium(medium);
      this->Modified();
      return true;
    }
  }
  vtkErrorMacro("WaterType is '" << (name ? name : "(null)") << "'; it must be one of I, IA, IB, "
                                 << "II, III, 1C, 3C, 5C, 7C, 9C. The water stays as it was.");
  return false;
}

//------------------------------------------------------------------------------
bool vtkWaterProperty::SetPreset(const char* name)
{
  water_preset preset;
  if (water_preset_find(name, &preset) != WATER_OK)
  {
    std::string known;
    for (int i = 0; i < GetNumberOfPresets(); ++i)
    {
      known += std::string(i ? ", " : "") + GetPresetName(i);
    }
    vtkErrorMacro("Preset is '" << (name ? name : "(null)") << "'; it must be one of " << known
                                << ". The water stays as it was.");
    return false;
  }
  this->ReflectanceMode = preset.look.constant_reflectance ? CONSTANT : FRESNEL;
  this->Reflectance = preset.look.constant_reflectance ? preset.look.reflectance : 1.0;
  this->IndexOfRefraction = preset.look.index_of_refraction;
  this->Refraction = !preset.look.constant_reflectance;
  this->DeepColorMode = MEDIUM;
  this->UseMedium(preset.medium);
  std::copy_n(preset.natural_m, 3, this->Internal->Natural);
  this->Internal->Waves.assign(preset.waves, preset.waves + preset.wave_count);
  this->Depth = preset.has_sea ? preset.sea.depth : std::numeric_limits<double>::infinity();
  this->Sea = preset.has_sea;
  if (preset.has_sea)
  {
    this->SeaModel = preset.sea.model == WATER_SEA_PHILLIPS ? PHILLIPS : JONSWAP;
    this->WindSpeed = preset.sea.wind_speed;
    this->WindDirection = vtkMath::DegreesFromRadians(preset.sea.wind_dir_rad);
    this->Fetch = preset.sea.fetch;
    this->PeakEnhancement = preset.sea.peak_enhancement;
    this->SeaTileLength = 0.0;
  }
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
int vtkWaterProperty::GetNumberOfPresets()
{
  return static_cast<int>(water_preset_count());
}

//------------------------------------------------------------------------------
const char* vtkWaterProperty::GetPresetName(int number)
{
  return number < 0 ? nullptr : water_preset_name(static_cast<size_t>(number));
}

//------------------------------------------------------------------------------
const char* vtkWaterProperty::GetPresetSource(const char* name)
{
  water_preset preset;
  return water_preset_find(name, &preset) == WATER_OK ? preset.source : nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetDataOpacity(double opacity)
{
  vtkWaterSetInRange(DataOpacity, opacity, 0.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetOpacity(double opacity)
{
  vtkWaterSetInRange(Opacity, opacity, 0.0, 1.0);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkWaterProperty::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkTexture* texture :
    { this->GetEnvironmentTexture(), this->GetNormalMapTexture(0), this->GetNormalMapTexture(1) })
  {
    time = texture ? std::max(time, texture->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetOutput(int output)
{
  vtkWaterSetInRange(Output, output, COLOR, REFLECTANCE);
}

//------------------------------------------------------------------------------
// Long because every setting has a line.
void vtkWaterProperty::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReflectanceMode: " << this->GetReflectanceModeAsString() << "\n";
  os << indent << "Reflectance: " << this->Reflectance << "\n";
  os << indent << "IndexOfRefraction: " << this->IndexOfRefraction << "\n";
  os << indent << "DeepColorMode: " << this->GetDeepColorModeAsString() << "\n";
  os << indent << "DeepColor: (" << this->DeepColor[0] << ", " << this->DeepColor[1] << ", "
     << this->DeepColor[2] << ")\n";
  os << indent << "Refraction: " << (this->Refraction ? "on" : "off") << "\n";
  os << indent << "RefractionSource: " << this->GetRefractionSourceAsString() << "\n";
  os << indent << "Absorption: (" << this->Absorption[0] << ", " << this->Absorption[1] << ", "
     << this->Absorption[2] << ")\n";
  os << indent << "Scattering: (" << this->Scattering[0] << ", " << this->Scattering[1] << ", "
     << this->Scattering[2] << ")\n";
  os << indent << "MetresPerUnit: " << this->MetresPerUnit
     << (this->MetresPerUnit == 0.0 ? " (automatic)" : "") << "\n";
  os << indent << "VerticalExaggeration: " << this->VerticalExaggeration << "\n";
  os << indent << "ShoreSoftness: " << this->ShoreSoftness << "\n";
  os << indent << "DomePortRadius: " << this->DomePortRadius << "\n";
  os << indent << "ReflectionSource: " << this->GetReflectionSourceAsString() << "\n";
  os << indent << "EnvironmentTexture: " << this->GetEnvironmentTexture() << "\n";
  os << indent << "Glitter: " << (this->Glitter ? "on" : "off") << "\n";
  os << indent << "HighlightRollOff: " << (this->HighlightRollOff ? "on" : "off") << "\n";
  os << indent << "SlopeVariance: " << this->SlopeVariance[0] << " along, "
     << this->SlopeVariance[1] << " across " << this->SlopeVariance[2] << " degrees\n";
  os << indent << "FoamDepth: " << this->FoamDepth << (this->FoamFitsScene ? " fits\n" : "\n");
  os << indent << "FoamStretch: " << this->FoamStretch << "\n";
  os << indent << "FoamColor: (" << this->FoamColor[0] << ", " << this->FoamColor[1] << ", "
     << this->FoamColor[2] << ")\n";
  os << indent << "Shadows: " << (this->Shadows ? "on" : "off") << "\n";
  os << indent << "Caustics: " << this->Caustics << "\n";
  os << indent << "LightShafts: " << this->LightShafts << "\n";
  os << indent << "DataOpacity: " << this->DataOpacity << "\n";
  os << indent << "Opacity: " << this->Opacity << "\n";
  os << indent << "Depth: " << this->Depth << "\n";
  os << indent << "Waves: " << this->GetNumberOfWaves() << "\n";
  for (int i = 0; i < this->GetNumberOfWaves(); ++i)
  {
    double wave[5];
    this->GetWave(i, wave);
    os << indent.GetNextIndent() << "amplitude " << wave[0] << ", wavelength " << wave[1]
       << ", direction " << wave[2] << ", phase " << wave[3] << ", steepness " << wave[4] << "\n";
  }
  this->PrintSea(os, indent);
  os << indent << "NormalMaps: " << this->GetNumberOfNormalMaps() << "\n";
  for (int i = 0; i < this->GetNumberOfNormalMaps(); ++i)
  {
    double map[4];
    this->GetNormalMap(i, map);
    os << indent.GetNextIndent() << "size " << map[0] << ", speed " << map[1] << ", direction "
       << map[2] << ", strength " << map[3] << "\n";
  }
  os << indent << "WaveGeometry: " << (this->WaveGeometry ? "on" : "off") << "\n";
  os << indent << "WaveGridSize: " << this->WaveGridSize << "\n";
  os << indent << "Lookup: " << this->GetLookupAsString() << "\n";
  os << indent << "OffsetScale: " << this->OffsetScale << "\n";
  os << indent << "RayTraceSteps: " << this->RayTraceSteps << "\n";
  os << indent << "RayTraceProbes: " << this->RayTraceProbes << "\n";
  os << indent << "RayTraceRays: " << this->RayTraceRays << "\n";
  os << indent << "RayTraceLayers: " << this->RayTraceLayers << "\n";
  os << indent << "RayTraceFootprint: " << this->RayTraceFootprint << "\n";
  os << indent << "Output: " << this->GetOutputAsString() << "\n";
}
VTK_ABI_NAMESPACE_END
