// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterProperty
 * @brief   how a water surface looks
 *
 * The colour of a water pixel is the reflection, weighted by the reflectance, over the water's own
 * colour. Setters refuse a value outside the stated range: an error names the value and the range,
 * and the last good value stays.
 *
 * @sa vtkWaterActor
 */
#ifndef vtkWaterProperty_h
#define vtkWaterProperty_h

#include "vtkObject.h"
#include "vtkRenderingWaterModule.h" // for the export macro

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKRENDERINGWATER_EXPORT vtkWaterProperty : public vtkObject
{
public:
  static vtkWaterProperty* New();
  vtkTypeMacro(vtkWaterProperty, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ReflectanceModes
  {
    FRESNEL = 0,
    CONSTANT = 1
  };

  ///@{
  /**
   * Where the reflectance comes from: FRESNEL (exact, unpolarised, by IndexOfRefraction and the
   * angle of view; from under water with total internal reflection) or CONSTANT (Reflectance).
   * Default is FRESNEL.
   *
   * Source of the formula: Born & Wolf, "Principles of Optics", section 1.5.2.
   */
  void SetReflectanceMode(int mode);
  vtkGetMacro(ReflectanceMode, int);
  void SetReflectanceModeToFresnel() { this->SetReflectanceMode(FRESNEL); }
  void SetReflectanceModeToConstant() { this->SetReflectanceMode(CONSTANT); }
  const char* GetReflectanceModeAsString() const;
  ///@}

  ///@{
  /**
   * Share of the reflection in the pixel when ReflectanceMode is CONSTANT, in [0, 1]. 1 is a
   * perfect mirror: the pixel is the reflection and nothing else. At 0 no reflection is rendered.
   * Default is 1.
   */
  void SetReflectance(double reflectance);
  vtkGetMacro(Reflectance, double);
  ///@}

  ///@{
  /**
   * Index of refraction of the water against what lies above it, in [1, 10]. Default is 1.333.
   */
  void SetIndexOfRefraction(double index);
  vtkGetMacro(IndexOfRefraction, double);
  ///@}

  ///@{
  /**
   * Colour of the water itself, seen where it does not reflect: red, green, blue, each in [0, 1].
   * It is not lit. Default is (0.02, 0.09, 0.13), a deep lake.
   */
  void SetDeepColor(double red, double green, double blue);
  void SetDeepColor(const double rgb[3]) { this->SetDeepColor(rgb[0], rgb[1], rgb[2]); }
  vtkGetVector3Macro(DeepColor, double);
  ///@}

  ///@{
  /**
   * Opacity of the surface for plain alpha blending with what lies behind it, in [0, 1]. Below 1
   * the water is drawn with the translucent geometry. Default is 1.
   */
  void SetOpacity(double opacity);
  vtkGetMacro(Opacity, double);
  ///@}

protected:
  vtkWaterProperty() = default;
  ~vtkWaterProperty() override = default;

private:
  vtkWaterProperty(const vtkWaterProperty&) = delete;
  void operator=(const vtkWaterProperty&) = delete;

  int ReflectanceMode = FRESNEL;
  double Reflectance = 1.0;
  double IndexOfRefraction = 1.333;
  double DeepColor[3] = { 0.02, 0.09, 0.13 };
  double Opacity = 1.0;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif
