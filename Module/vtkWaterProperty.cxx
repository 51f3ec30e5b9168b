// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterProperty.h"

#include "vtkObjectFactory.h"
#include "vtkWaterCompat.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkWaterProperty);

//------------------------------------------------------------------------------
void vtkWaterProperty::SetReflectanceMode(int mode)
{
  vtkWaterSetInRange(ReflectanceMode, mode, FRESNEL, CONSTANT);
}

//------------------------------------------------------------------------------
const char* vtkWaterProperty::GetReflectanceModeAsString() const
{
  return this->ReflectanceMode == CONSTANT ? "CONSTANT" : "FRESNEL";
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
void vtkWaterProperty::SetDeepColor(double red, double green, double blue)
{
  const double rgb[3] = { red, green, blue };
  for (double channel : rgb)
  {
    if (!(channel >= 0.0 && channel <= 1.0))
    {
      vtkErrorMacro("DeepColor is ("
        << red << ", " << green << ", " << blue << "); every channel must lie in [0, 1]. It stays ("
        << this->DeepColor[0] << ", " << this->DeepColor[1] << ", " << this->DeepColor[2] << ").");
      return;
    }
  }
  if (red != this->DeepColor[0] || green != this->DeepColor[1] || blue != this->DeepColor[2])
  {
    this->DeepColor[0] = red;
    this->DeepColor[1] = green;
    this->DeepColor[2] = blue;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterProperty::SetOpacity(double opacity)
{
  vtkWaterSetInRange(Opacity, opacity, 0.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkWaterProperty::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReflectanceMode: " << this->GetReflectanceModeAsString() << "\n";
  os << indent << "Reflectance: " << this->Reflectance << "\n";
  os << indent << "IndexOfRefraction: " << this->IndexOfRefraction << "\n";
  os << indent << "DeepColor: (" << this->DeepColor[0] << ", " << this->DeepColor[1] << ", "
     << this->DeepColor[2] << ")\n";
  os << indent << "Opacity: " << this->Opacity << "\n";
}
VTK_ABI_NAMESPACE_END
