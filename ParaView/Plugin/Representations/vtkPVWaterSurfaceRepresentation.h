// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVWaterSurfaceRepresentation
 * @brief   shows a surface of a dataset as water
 *
 * The input is a surface: that of vtkPVWaterSurfaceFilter, a contour of a free surface, or any mesh
 * of polygons. Of other datasets the outer surface is shown; the blocks of composite data are
 * joined. The water's plane is horizontal, at the mean height of the whole surface, over all ranks.
 * A surface that is not flat gets point normals unless it has some. Ghost cells are left out.
 *
 * An array of points or cells may colour the water (SetInputArrayToProcess and SetLookupTable), and
 * an array of velocities may carry its waves (SetFlowArrayName).
 *
 * @sa vtkPVWaterRepresentation vtkPVWaterSurfaceFilter
 */
#ifndef vtkPVWaterSurfaceRepresentation_h
#define vtkPVWaterSurfaceRepresentation_h

#include "vtkPVWaterRepresentation.h"
#include "vtkWaterRepresentationsModule.h" // for the export macro

class vtkPolyDataMapper;
class vtkScalarsToColors;

class VTKWATERREPRESENTATIONS_EXPORT vtkPVWaterSurfaceRepresentation
  : public vtkPVWaterRepresentation
{
public:
  static vtkPVWaterSurfaceRepresentation* New();
  vtkTypeMacro(vtkPVWaterSurfaceRepresentation, vtkPVWaterRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Table that turns the array of SetInputArrayToProcess into colours; nullptr, the default: no
   * colours from data.
   */
  void SetLookupTable(vtkScalarsToColors* table);
  ///@}

  ///@{
  /**
   * Opacity of the colours from data, in [0, 1]: see vtkWaterProperty::SetDataOpacity. Default
   * is 1.
   */
  void SetDataOpacity(double opacity) { this->Set(this->DataOpacity, opacity); }
  ///@}

  ///@{
  /**
   * The current: see vtkWaterActor::SetFlowArrayName and SetFlowPeriod. "None" and "", the default,
   * mean no current. The period is in seconds; its default is 4.
   */
  void SetFlowArrayName(const char* name);
  void SetFlowPeriod(double seconds) { this->Set(this->FlowPeriod, seconds); }
  ///@}

  ///@{
  /**
   * Whether the slopes of the mesh turn its reflections: see vtkWaterActor::SetMeshSlopes. Default
   * is on.
   */
  void SetMeshSlopes(bool isOn) { this->Set(this->MeshSlopes, isOn); }
  ///@}

  /**
   * Height of the water's plane in the last frame that this process has rendered.
   */
  double GetMeanLevel();

protected:
  vtkPVWaterSurfaceRepresentation();
  ~vtkPVWaterSurfaceRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Keep(vtkDataObject* input, vtkPolyData* piece) override;
  void Offer(vtkInformation* inInfo) override;
  void OfferCoarse(vtkInformation* inInfo) override;
  void Take(vtkInformation* inInfo, vtkMultiProcessController* ranks) override;
  bool IsWhole() const override { return false; }
  void ApplyMore(vtkWaterProperty* look) override;

private:
  vtkPVWaterSurfaceRepresentation(const vtkPVWaterSurfaceRepresentation&) = delete;
  void operator=(const vtkPVWaterSurfaceRepresentation&) = delete;

  void ApplyColors();

  vtkNew<vtkPolyDataMapper> Mapper;
  // Of frames of one process, and of frames of several ranks.
  double Levels[2] = { 0.0, 0.0 };
  bool IsLevelNew[2] = { true, true };
  double DataOpacity = 1.0;
  double FlowPeriod = 4.0;
  std::string FlowArrayName;
  bool MeshSlopes = true;
};

#endif
