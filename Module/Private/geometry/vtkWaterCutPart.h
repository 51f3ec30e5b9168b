// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterCutPart: a mesh that is cut at the shore while it is drawn (vtkWaterUncutMesh), cut for
// whoever asks for its polygons: pickers, exporters, filters. Without them it never executes.
#ifndef vtkWaterCutPart_h
#define vtkWaterCutPart_h

#include "vtkPolyDataAlgorithm.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkWaterCutPart : public vtkPolyDataAlgorithm
{
public:
  static vtkWaterCutPart* New();
  vtkTypeMacro(vtkWaterCutPart, vtkPolyDataAlgorithm);

protected:
  vtkWaterCutPart();
  ~vtkWaterCutPart() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkWaterCutPart(const vtkWaterCutPart&) = delete;
  void operator=(const vtkWaterCutPart&) = delete;
};
#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_END
#endif

#endif
