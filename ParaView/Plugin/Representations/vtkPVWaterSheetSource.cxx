// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVWaterSheetSource.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkWaterActor.h"

#include <algorithm>

namespace
{
constexpr const char* kArray = "WaterSheet";
constexpr int kCount = 11; // origin, normal, extent, bounds
}

vtkStandardNewMacro(vtkPVWaterSheetSource);

//------------------------------------------------------------------------------
void vtkPVWaterSheetSource::SetExtent(int extent)
{
  if (extent < AUTOMATIC || extent > BOUNDS)
  {
    vtkErrorMacro("Extent is " << extent << "; it must lie in [0, 3].");
    return;
  }
  if (this->Extent != extent)
  {
    this->Extent = extent;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkPVWaterSheetSource::Place(vtkPolyData* sheet, vtkWaterActor* water)
{
  vtkFieldData* fields = sheet ? sheet->GetFieldData() : nullptr;
  auto* values = fields ? vtkDoubleArray::SafeDownCast(fields->GetArray(kArray)) : nullptr;
  if (!values || values->GetNumberOfValues() != kCount)
  {
    return false;
  }
  const double* value = values->GetPointer(0);
  // what has not changed is not set again: the water would render its mirrored view again
  vtkPlane* now = water->GetPlane();
  if (!std::equal(value, value + 3, now->GetOrigin()) ||
    !std::equal(value + 3, value + 6, now->GetNormal()))
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(value[0], value[1], value[2]);
    plane->SetNormal(value[3], value[4], value[5]);
    water->SetPlane(plane);
  }
  const int extent = static_cast<int>(value[6]);
  if (extent == BOUNDS)
  {
    if (!water->GetUseSheetBounds() || !std::equal(value + 7, value + 11, water->GetSheetBounds()))
    {
      water->SetSheetBounds(value + 7);
    }
  }
  else if (extent == AUTOMATIC)
  {
    if (!water->GetSheetIsAutomatic())
    {
      water->SetSheetToAutomatic();
    }
  }
  else if (extent == HORIZON)
  {
    if (!water->GetSheetToHorizon() || water->GetSheetIsAutomatic())
    {
      water->SetSheetToHorizon();
    }
  }
  else if (water->GetUseSheetBounds() || water->GetSheetToHorizon() || water->GetSheetIsAutomatic())
  {
    water->ResetSheetBounds();
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkPVWaterSheetSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  // or ranks other than the first would get nothing, and place their waters elsewhere
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVWaterSheetSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (this->UsePlane && vtkMath::Norm(this->Normal) == 0.0)
  {
    vtkErrorMacro("Normal is (0, 0, 0); it must point out of the water.");
    return 0;
  }
  vtkNew<vtkDoubleArray> values;
  values->SetName(kArray);
  const double level[3] = { 0.0, 0.0, this->Level };
  const double up[3] = { 0.0, 0.0, 1.0 };
  const double* origin = this->UsePlane ? this->Origin : level;
  const double* normal = this->UsePlane ? this->Normal : up;
  for (int i = 0; i < 3; ++i)
  {
    values->InsertNextValue(origin[i]);
  }
  for (int i = 0; i < 3; ++i)
  {
    values->InsertNextValue(normal[i]);
  }
  values->InsertNextValue(this->Extent);
  for (const double bound : this->SheetBounds)
  {
    values->InsertNextValue(bound);
  }
  output->GetFieldData()->AddArray(values);
  return 1;
}

//------------------------------------------------------------------------------
void vtkPVWaterSheetSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "UsePlane: " << this->UsePlane << "\n";
  os << indent << "Origin: " << this->Origin[0] << ", " << this->Origin[1] << ", "
     << this->Origin[2] << "\n";
  os << indent << "Normal: " << this->Normal[0] << ", " << this->Normal[1] << ", "
     << this->Normal[2] << "\n";
  os << indent << "Extent: " << this->Extent << "\n";
  os << indent << "SheetBounds: " << this->SheetBounds[0] << ", " << this->SheetBounds[1] << ", "
     << this->SheetBounds[2] << ", " << this->SheetBounds[3] << "\n";
}
