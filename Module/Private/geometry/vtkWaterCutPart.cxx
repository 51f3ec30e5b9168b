// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterCutPart.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkWaterColumns.h"
#include "vtkWaterUncutMesh.h"
#include "vtkWaterVertexNormals.h"
#include "vtkWaterWetPart.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
vtkStandardNewMacro(vtkWaterCutPart);

//------------------------------------------------------------------------------
vtkWaterCutPart::vtkWaterCutPart() = default;

//------------------------------------------------------------------------------
vtkWaterCutPart::~vtkWaterCutPart() = default;

//------------------------------------------------------------------------------
int vtkWaterCutPart::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* whole = vtkWaterUncutMesh::SafeDownCast(vtkPolyData::GetData(inputVector[0]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!whole)
  {
    return 1;
  }
  const auto arrayOf = [whole](const char* name) {
    return vtkArrayDownCast<vtkDoubleArray>(whole->GetPointData()->GetArray(name));
  };
  const bool hasNormals = whole->GetPointData()->GetNormals() != nullptr;
  vtkWaterWetPart(whole, arrayOf(vtkWaterColumns::LevelName)->GetPointer(0),
    arrayOf(vtkWaterColumns::DepthName)->GetPointer(0), {}, {}, whole->GetHeightScale())
    .Make(vtkWaterColumns::LevelName, vtkWaterColumns::DepthName, output);
  if (hasNormals)
  {
    output->GetPointData()->SetNormals(vtkWaterVertexNormals(output).Get());
  }
  output->GetFieldData()->PassData(whole->GetFieldData());
  return 1;
}
#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_END
#endif
