// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterClearSkySource
 * @brief   a picture of a clear sky by day, for a skybox, and the sun's light to go with it
 *
 * The sky is computed from the sun's place and the air's turbidity (Preetham, Shirley and Smits
 * 1999, "A Practical Analytic Model for Daylight"). Water finds it by itself when a skybox shows
 * it:
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
 * The sun's disc is not in the picture: what waves reflect of it is the glitter of the light. Up is
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
   * Where the sun is: degrees from north (y) over east (x), in [-360, 360]. Default is 150. Another
   * value is an error and changes nothing.
   */
  void SetAzimuth(double degrees);
  vtkGetMacro(Azimuth, double);
  ///@}

  ///@{
  /**
   * The sun's height over the horizon, degrees in [0, 90]: the model is for daylight. Default
   * is 35. Another value is an error and changes nothing.
   */
  void SetElevation(double degrees);
  vtkGetMacro(Elevation, double);
  ///@}

  ///@{
  /**
   * How much more light the air scatters than its molecules alone, in [2, 10]: 2 is very clear, 3
   * clear, 6 warm and moist, 10 hazy. Default is 3. Another value is an error and changes nothing.
   */
  void SetTurbidity(double turbidity);
  vtkGetMacro(Turbidity, double);
  ///@}

  ///@{
  /**
   * What luminances, kcd/m^2, are multiplied by to be colours, finite and not negative. 0: what
   * shows the sky's mean as 0.3 of white, as a camera would be set. Default is 0. A clear sky at
   * noon has a mean of about 7 kcd/m^2. Another value is an error and changes nothing.
   */
  void SetExposure(double exposure);
  vtkGetMacro(Exposure, double);
  ///@}

  ///@{
  /**
   * Width of the picture in pixels, in [16, 8192]; it is half as high. Default is 1024. Another
   * value is an error and changes nothing.
   */
  void SetWidth(int pixels);
  vtkGetMacro(Width, int);
  ///@}

  /**
   * The picture, in longitude and latitude: red, green and blue as floats, linear, not limited to
   * [0, 1]. Its lowest row is the nadir; under the horizon there is haze, and grey ground.
   */
  vtkImageData* GetOutput();

  /**
   * A skybox that shows it: gives it a texture of the picture with mip levels, the projection
   * Sphere, gamma correction, and z for up, in the way of VTK 9.1 (its FloorPlane and FloorRight)
   * and in that of later ones (EnvironmentUp and EnvironmentRight of the renderer). The skybox is
   * not added.
   */
  void ConfigureSkybox(vtkSkybox* skybox, vtkRenderer* renderer);

  ///@{
  /**
   * Towards the sun, of unit length.
   */
  void GetSunDirection(double direction[3]);
  double* GetSunDirection() VTK_SIZEHINT(3);
  ///@}

  ///@{
  /**
   * Colour for a light of intensity 1 in its place: what a white card that faces the sun shows, as
   * a display has it, and at most 1. Red, green, blue.
   */
  void GetSunColor(double color[3]);
  double* GetSunColor() VTK_SIZEHINT(3);
  ///@}

  ///@{
  /**
   * What a level white card shows under the sky alone, as a display has it: a background of this
   * colour brings water the sky's light (DeepColor). Red, green, blue.
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
  double Turbidity = 3.0;
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
