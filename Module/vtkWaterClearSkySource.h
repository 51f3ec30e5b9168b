// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterClearSkySource
 * @brief   a picture of a clear daytime sky, for a skybox, and the matching sunlight
 *
 * The sky is computed from the sun's position and the air's turbidity (Preetham, Shirley and Smits
 * 1999, "A Practical Analytic Model for Daylight"). Water reflects it automatically when a skybox
 * shows it:
 *
 *     sky = vtkWaterClearSkySource()
 *     sky.SetElevation(20)
 *     skybox = vtkSkybox()
 *     sky.ConfigureSkybox(skybox, renderer)  # its texture, projection and axes
 *     renderer.AddActor(skybox)
 *     light = vtkLight()
 *     light.SetPosition(sky.GetSunDirection())
 *     light.SetColor(sky.GetSunColor())
 *     renderer.AddLight(light)
 *
 * The picture does not contain the sun's disc; waves show the glitter of the light instead. Up is
 * z, and north is y.
 */
#ifndef vtkWaterClearSkySource_h
#define vtkWaterClearSkySource_h

#include "vtkObject.h"
#include "vtkRenderingWaterModule.h" // for the export macro
#include "vtkSmartPointer.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkImageData;
class vtkRenderer;
class vtkSkybox;
class vtkTexture;

class VTKRENDERINGWATER_EXPORT vtkWaterClearSkySource : public vtkObject
{
public:
  static vtkWaterClearSkySource* New();
  vtkTypeMacro(vtkWaterClearSkySource, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Azimuth of the sun, in degrees from north (y) towards east (x), in [-360, 360]. Other values
   * are rejected with an error. Default is 150.
   */
  void SetAzimuth(double degrees);
  vtkGetMacro(Azimuth, double);
  ///@}

  ///@{
  /**
   * Elevation of the sun above the horizon, in degrees in [0, 90]: the model is for daylight.
   * Other values are rejected with an error. Default is 35.
   */
  void SetElevation(double degrees);
  vtkGetMacro(Elevation, double);
  ///@}

  ///@{
  /**
   * Turbidity of the air, in [2, 10]: the ratio of all scattered light to that scattered by air
   * molecules alone. 2 is very clear, 3 clear, 6 warm and moist, 10 hazy. Other values are rejected
   * with an error. Default is 2.
   */
  void SetTurbidity(double turbidity);
  vtkGetMacro(Turbidity, double);
  ///@}

  ///@{
  /**
   * Factor from luminances (kcd/m^2) to colours, finite and not negative. 0, the default, shows the
   * sky's mean as 0.3 of white, like a camera's automatic exposure. A clear sky at noon has a mean
   * of about 7 kcd/m^2. Other values are rejected with an error.
   */
  void SetExposure(double exposure);
  vtkGetMacro(Exposure, double);
  ///@}

  ///@{
  /**
   * Width of the picture in pixels, in [16, 8192]; its height is half of that. Other values are
   * rejected with an error. Default is 1024.
   */
  void SetWidth(int pixels);
  vtkGetMacro(Width, int);
  ///@}

  /**
   * The picture in longitude and latitude: red, green and blue as floats, linear, not limited to
   * [0, 1]. Its lowest row is the nadir. Below the horizon there is haze and grey ground.
   */
  vtkImageData* GetOutput();

  /**
   * Configures a skybox to show the sky. It sets a texture of the picture with mip levels, the
   * projection Sphere, gamma correction, and z as the up direction, for VTK 9.1 (its FloorPlane and
   * FloorRight) and for later versions (the renderer's EnvironmentUp and EnvironmentRight). It does
   * not add the skybox to the renderer.
   */
  void ConfigureSkybox(vtkSkybox* skybox, vtkRenderer* renderer);

  ///@{
  /**
   * Unit vector towards the sun.
   */
  void GetSunDirection(double direction[3]);
  double* GetSunDirection() VTK_SIZEHINT(3);
  ///@}

  ///@{
  /**
   * Colour for a light of intensity 1 at the sun's position: the colour that a display shows for a
   * white card facing the sun, at most 1. Red, green, blue.
   */
  void GetSunColor(double color[3]);
  double* GetSunColor() VTK_SIZEHINT(3);
  ///@}

  ///@{
  /**
   * Colour that a display shows for a horizontal white card lit by the sky alone. A background of
   * this colour gives the water the sky's light (DeepColor). Red, green, blue.
   */
  void GetMeanColor(double color[3]);
  double* GetMeanColor() VTK_SIZEHINT(3);
  ///@}

protected:
  vtkWaterClearSkySource();
  ~vtkWaterClearSkySource() override;

private:
  vtkWaterClearSkySource(const vtkWaterClearSkySource&) = delete;
  void operator=(const vtkWaterClearSkySource&) = delete;

  void SetNumber(
    const char* name, const char* unit, double value, double least, double most, double& member);

  double Azimuth = 150.0;
  double Elevation = 35.0;
  double Turbidity = 2.0;
  double Exposure = 0.0;
  int Width = 1024;
  double Result[3][3] = {}; // of the getters that return an address
  vtkSmartPointer<vtkImageData> Output;
  vtkMTimeType OutputTime = 0;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
