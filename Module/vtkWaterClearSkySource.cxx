// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterClearSkySource.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkSkybox.h"
#include "vtkTexture.h"
#include "vtkWaterCompat.h"
#include "water_clear_sky.h"
#include "water_daylight.h"

#include <algorithm>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr int kNarrowest = 16;
constexpr int kWidest = 8192;

water_clear_sky MakeSky(vtkWaterClearSkySource* source)
{
  water_clear_sky sky;
  (void)water_clear_sky_make( // the setters have checked
    source->GetAzimuth(), source->GetElevation(), source->GetTurbidity(), &sky);
  return sky;
}

double FindExposure(vtkWaterClearSkySource* source, const water_clear_sky& sky)
{
  return source->GetExposure() > 0.0 ? source->GetExposure() : water_clear_sky_exposure(&sky);
}

// As a display has it, and of the same hue where it is too bright.
void Show(const double luminance[3], double exposure, double color[3])
{
  const double most = std::max({ luminance[0], luminance[1], luminance[2] });
  const double scale = most * exposure > 1.0 ? 1.0 / most : exposure;
  std::transform(luminance, luminance + 3, color,
    [scale](double value) { return water_display_encode(scale * value); });
}
}

vtkStandardNewMacro(vtkWaterClearSkySource);

//------------------------------------------------------------------------------
vtkWaterClearSkySource::vtkWaterClearSkySource() = default;

//------------------------------------------------------------------------------
vtkWaterClearSkySource::~vtkWaterClearSkySource() = default;

//------------------------------------------------------------------------------
void vtkWaterClearSkySource::SetNumber(
  const char* name, const char* unit, double value, double least, double most, double& member)
{
  if (!(value >= least && value <= most))
  {
    vtkErrorMacro(<< name << " is " << value << "; it must lie in [" << least << ", " << most << "]"
                  << unit << ". It stays " << member << ".");
    return;
  }
  if (member != value)
  {
    member = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterClearSkySource::SetAzimuth(double degrees)
{
  this->SetNumber("Azimuth", " degrees", degrees, -360.0, 360.0, this->Azimuth);
}

//------------------------------------------------------------------------------
void vtkWaterClearSkySource::SetElevation(double degrees)
{
  this->SetNumber("Elevation", " degrees above the horizon", degrees, 0.0, 90.0, this->Elevation);
}

//------------------------------------------------------------------------------
void vtkWaterClearSkySource::SetTurbidity(double turbidity)
{
  this->SetNumber("Turbidity", "", turbidity, water_clear_sky_turbidity_min,
    water_clear_sky_turbidity_max, this->Turbidity);
}

//------------------------------------------------------------------------------
void vtkWaterClearSkySource::SetExposure(double exposure)
{
  const double largest = static_cast<double>(std::numeric_limits<float>::max());
  this->SetNumber("Exposure", "", exposure, 0.0, largest, this->Exposure);
}

//------------------------------------------------------------------------------
void vtkWaterClearSkySource::SetWidth(int pixels)
{
  vtkWaterSetInRange(Width, pixels, kNarrowest, kWidest);
}

//------------------------------------------------------------------------------
vtkImageData* vtkWaterClearSkySource::GetOutput()
{
  if (this->Output && this->OutputTime == this->GetMTime())
  {
    return this->Output;
  }
  const water_clear_sky sky = MakeSky(this);
  const double exposure = FindExposure(this, sky);
  const int height = this->Width / 2;
  vtkNew<vtkFloatArray> texels;
  texels->SetName("ClearSky");
  texels->SetNumberOfComponents(3);
  texels->SetNumberOfTuples(static_cast<vtkIdType>(this->Width) * height);
  float* texel = texels->GetPointer(0);
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < this->Width; ++i)
    {
      double dir[3];
      double color[3];
      water_clear_sky_place((i + 0.5) / this->Width, (j + 0.5) / height, dir);
      water_clear_sky_color(&sky, dir, color);
      texel = std::transform(color, color + 3, texel,
        [exposure](double value) { return static_cast<float>(exposure * value); });
    }
  }
  if (!this->Output)
  {
    this->Output = vtkSmartPointer<vtkImageData>::New();
  }
  this->Output->SetDimensions(this->Width, height, 1);
  this->Output->GetPointData()->SetScalars(texels);
  this->Output->Modified();
  this->OutputTime = this->GetMTime();
  return this->Output;
}

//------------------------------------------------------------------------------
void vtkWaterClearSkySource::ConfigureSkybox(vtkSkybox* skybox, vtkRenderer* renderer)
{
  if (!skybox || !renderer)
  {
    vtkErrorMacro(<< "ConfigureSkybox needs a skybox and a renderer; the "
                  << (skybox ? "renderer" : "skybox") << " is nullptr.");
    return;
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(this->GetOutput());
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->SetMaximumAnisotropicFiltering(1.0f); // costs software renderers much, and shows nothing
  skybox->SetTexture(texture);
  skybox->SetProjectionToSphere();
  skybox->GammaCorrectOn();
  skybox->SetFloorPlane(0.0f, 0.0f, 1.0f, 0.0f);
  skybox->SetFloorRight(0.0f, -1.0f, 0.0f);
  renderer->SetEnvironmentUp(0.0, 0.0, 1.0);
  renderer->SetEnvironmentRight(1.0, 0.0, 0.0);
}

//------------------------------------------------------------------------------
void vtkWaterClearSkySource::GetSunDirection(double direction[3])
{
  const water_clear_sky sky = MakeSky(this);
  std::copy_n(sky.sun_dir, 3, direction);
}

//------------------------------------------------------------------------------
void vtkWaterClearSkySource::GetSunColor(double color[3])
{
  const water_clear_sky sky = MakeSky(this);
  double luminance[3];
  water_clear_sky_sun(&sky, luminance);
  Show(luminance, FindExposure(this, sky), color);
}

//------------------------------------------------------------------------------
void vtkWaterClearSkySource::GetMeanColor(double color[3])
{
  const water_clear_sky sky = MakeSky(this);
  Show(sky.mean, FindExposure(this, sky), color);
}

//------------------------------------------------------------------------------
double* vtkWaterClearSkySource::GetSunDirection()
{
  this->GetSunDirection(this->Result[0]);
  return this->Result[0];
}

//------------------------------------------------------------------------------
double* vtkWaterClearSkySource::GetSunColor()
{
  this->GetSunColor(this->Result[1]);
  return this->Result[1];
}

//------------------------------------------------------------------------------
double* vtkWaterClearSkySource::GetMeanColor()
{
  this->GetMeanColor(this->Result[2]);
  return this->Result[2];
}

//------------------------------------------------------------------------------
void vtkWaterClearSkySource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Azimuth: " << this->Azimuth << "\n";
  os << indent << "Elevation: " << this->Elevation << "\n";
  os << indent << "Turbidity: " << this->Turbidity << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "Width: " << this->Width << "\n";
}
VTK_ABI_NAMESPACE_END
