// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVWaterSurfaceFilter
 * @brief   the water surface of a solver's mesh: ParaView's filter "Water Surface"
 *
 * Forwards to vtkWaterSurfaceFilter, whose class ParaView's server manager does not know. In
 * parallel it asks for one layer of ghost cells, so that the shore is the same at the border
 * between two ranks. Names may be "None", as a panel says it: there is no such array.
 *
 * @sa vtkWaterSurfaceFilter vtkPVWaterSurfaceRepresentation
 */
#ifndef vtkPVWaterSurfaceFilter_h
#define vtkPVWaterSurfaceFilter_h

#include "vtkNew.h" // for members
#include "vtkPolyDataAlgorithm.h"
#include "vtkWaterRepresentationsModule.h" // for the export macro

#include <string> // for names

class vtkWaterSurfaceFilter;

class VTKWATERREPRESENTATIONS_EXPORT vtkPVWaterSurfaceFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkPVWaterSurfaceFilter* New();
  vtkTypeMacro(vtkPVWaterSurfaceFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * See the functions of vtkWaterSurfaceFilter with these names.
   */
  void SetLevelArrayName(const char* name);
  void SetDepthArrayName(const char* name);
  void SetBedArrayName(const char* name);
  void SetDryDepth(double depth);
  void SetVerticalScale(double scale);
  ///@}

protected:
  vtkPVWaterSurfaceFilter();
  ~vtkPVWaterSurfaceFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPVWaterSurfaceFilter(const vtkPVWaterSurfaceFilter&) = delete;
  void operator=(const vtkPVWaterSurfaceFilter&) = delete;

  void Changed(vtkMTimeType before);

  vtkNew<vtkWaterSurfaceFilter> Filter;
};

#endif
