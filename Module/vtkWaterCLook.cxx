// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterCLook.cxx: the part of the C interface, vtkWaterC.h, that says how a water looks. Copies
// and calls.
#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkWaterCInternals.h"

#include <cstring>
#include <functional>

using namespace vtkWaterC;

namespace
{
// A copy of a picture, top row first.
vtkSmartPointer<vtkTexture> MakeTexture(const unsigned char* pixels, int width, int height)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const size_t row_bytes = 3 * static_cast<size_t>(width);
  for (int row = 0; row < height; ++row)
  {
    std::memcpy(image->GetScalarPointer(0, height - 1 - row, 0),
      pixels + row_bytes * static_cast<size_t>(row), row_bytes);
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->MipmapOn();
  return texture;
}

// A setting that is 0 or 1.
template <typename Set>
vtk_water_status Switch(vtk_water_actor* actor, const char* name, int value, const Set& set)
{
  if (value != 0 && value != 1)
  {
    return Guarded([=] {
      return Fail(VTK_WATER_BAD_VALUE,
        std::string(name) + " is " + std::to_string(value) + "; it must be 0 or 1");
    });
  }
  return Change(
    actor, [=](vtkWaterActor*, vtkWaterProperty* look) { std::invoke(set, look, value == 1); });
}
}

//------------------------------------------------------------------------------
std::string vtkWaterC::DescribeBadSize(int width, int height)
{
  return width >= 1 && width <= 16384 && height >= 1 && height <= 16384
    ? std::string()
    : "size is " + std::to_string(width) + " x " + std::to_string(height) +
      " pixels; both must lie in [1, 16384]";
}

//------------------------------------------------------------------------------
vtk_water_status vtk_water_actor_set_preset(vtk_water_actor* actor, const char* name)
{
  return Change(actor, [=](vtkWaterActor*, vtkWaterProperty* look) { look->SetPreset(name); });
}

vtk_water_status vtk_water_actor_add_wave(vtk_water_actor* actor, double amplitude,
  double wavelength, double direction_deg, double phase_deg, double steepness)
{
  return Change(actor, [=](vtkWaterActor*, vtkWaterProperty* look) {
    look->AddWave(amplitude, wavelength, direction_deg, phase_deg, steepness);
  });
}

vtk_water_status vtk_water_actor_remove_all_waves(vtk_water_actor* actor)
{
  return Change(actor, [](vtkWaterActor*, vtkWaterProperty* look) { look->RemoveAllWaves(); });
}

vtk_water_status vtk_water_actor_set_wind(vtk_water_actor* actor, double speed)
{
  return Change(actor, [=](vtkWaterActor*, vtkWaterProperty* look) {
    if (speed != 0.0)
    {
      look->SetWindSpeed(speed);
    }
    if (lastError.empty())
    {
      look->SetSea(speed != 0.0);
    }
  });
}

vtk_water_status vtk_water_actor_set_wind_direction(vtk_water_actor* actor, double direction_deg)
{
  return Change(
    actor, [=](vtkWaterActor*, vtkWaterProperty* look) { look->SetWindDirection(direction_deg); });
}

vtk_water_status vtk_water_actor_set_whitecaps(vtk_water_actor* actor, int whitecaps)
{
  return Switch(actor, "whitecaps", whitecaps, &vtkWaterProperty::SetWhitecaps);
}

vtk_water_status vtk_water_actor_set_whitecap_life_time(vtk_water_actor* actor, double seconds)
{
  return Change(
    actor, [=](vtkWaterActor*, vtkWaterProperty* look) { look->SetWhitecapLifeTime(seconds); });
}

vtk_water_status vtk_water_actor_set_color(vtk_water_actor* actor, const double color[3])
{
  if (!color)
  {
    return Guarded([] { return Fail(VTK_WATER_NULL_ARGUMENT, "color is NULL"); });
  }
  return Change(actor, [=](vtkWaterActor*, vtkWaterProperty* look) { look->SetDeepColor(color); });
}

vtk_water_status vtk_water_actor_set_opacity(vtk_water_actor* actor, double opacity)
{
  return Change(actor, [=](vtkWaterActor*, vtkWaterProperty* look) { look->SetOpacity(opacity); });
}

vtk_water_status vtk_water_actor_set_refraction(vtk_water_actor* actor, int refraction)
{
  return Switch(actor, "refraction", refraction, &vtkWaterProperty::SetRefraction);
}

vtk_water_status vtk_water_actor_set_own_view(vtk_water_actor* actor, int own_view)
{
  return Switch(actor, "own_view", own_view, [](vtkWaterProperty* look, bool isOn) {
    look->SetRefractionSource(isOn ? vtkWaterProperty::OWN_VIEW : vtkWaterProperty::PICTURE);
  });
}

vtk_water_status vtk_water_actor_set_water_type(vtk_water_actor* actor, const char* name)
{
  return Change(actor, [=](vtkWaterActor*, vtkWaterProperty* look) { look->SetWaterType(name); });
}

vtk_water_status vtk_water_actor_set_foam(vtk_water_actor* actor, double depth)
{
  return Change(actor, [=](vtkWaterActor*, vtkWaterProperty* look) { look->SetFoamDepth(depth); });
}

vtk_water_status vtk_water_actor_set_caustics(vtk_water_actor* actor, double strength)
{
  return Change(
    actor, [=](vtkWaterActor*, vtkWaterProperty* look) { look->SetCaustics(strength); });
}

vtk_water_status vtk_water_actor_set_light_shafts(vtk_water_actor* actor, double share)
{
  return Change(
    actor, [=](vtkWaterActor*, vtkWaterProperty* look) { look->SetLightShafts(share); });
}

vtk_water_status vtk_water_actor_set_shadows(vtk_water_actor* actor, int shadows)
{
  return Switch(actor, "shadows", shadows, &vtkWaterProperty::SetShadows);
}

vtk_water_status vtk_water_actor_set_dome_port(vtk_water_actor* actor, double radius)
{
  return Change(
    actor, [=](vtkWaterActor*, vtkWaterProperty* look) { look->SetDomePortRadius(radius); });
}

vtk_water_status vtk_water_actor_set_units(vtk_water_actor* actor, const char* name)
{
  return Change(actor, [=](vtkWaterActor*, vtkWaterProperty* look) { look->SetUnits(name); });
}

vtk_water_status vtk_water_actor_set_vertical_exaggeration(vtk_water_actor* actor, double factor)
{
  return Change(
    actor, [=](vtkWaterActor*, vtkWaterProperty* look) { look->SetVerticalExaggeration(factor); });
}

vtk_water_status vtk_water_actor_set_quality(vtk_water_actor* actor, const char* name)
{
  return Change(
    actor, [=](vtkWaterActor*, vtkWaterProperty* look) { look->SetRayTraceQuality(name); });
}

vtk_water_status vtk_water_actor_set_environment(
  vtk_water_actor* actor, const unsigned char* pixels, int width, int height)
{
  const vtk_water_status status = Guarded([&] {
    const std::string wrong = pixels ? DescribeBadSize(width, height) : std::string();
    return wrong.empty() ? VTK_WATER_OK : Fail(VTK_WATER_BAD_VALUE, wrong);
  });
  if (status != VTK_WATER_OK)
  {
    return status;
  }
  return Change(actor, [=](vtkWaterActor*, vtkWaterProperty* look) {
    look->SetEnvironmentTexture(pixels ? MakeTexture(pixels, width, height).Get() : nullptr);
    look->SetReflectionSource(pixels ? vtkWaterProperty::ENVIRONMENT : vtkWaterProperty::SCENE);
  });
}
