// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVWaterSheetSource
 * @brief   where a sheet of water lies: ParaView's source "Water"
 *
 * The output is an empty vtkPolyData, or the sheet's rectangle if the sheet has bounds. Its field
 * data has the array "WaterSheet", from which vtkPVWaterRepresentation reads plane and extent.
 *
 * @sa vtkPVWaterRepresentation vtkWaterActor
 */
#ifndef vtkPVWaterSheetSource_h
#define vtkPVWaterSheetSource_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkWaterRepresentationsModule.h" // for the export macro

class vtkWaterActor;

class VTKWATERREPRESENTATIONS_EXPORT vtkPVWaterSheetSource : public vtkPolyDataAlgorithm
{
public:
  static vtkPVWaterSheetSource* New();
  vtkTypeMacro(vtkPVWaterSheetSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Extents
  {
    AUTOMATIC = 0, ///< vtkWaterActor::SetSheetToAutomatic
    SCENE = 1,     ///< the bounds of the scene
    HORIZON = 2,   ///< vtkWaterActor::SetSheetToHorizon
    BOUNDS = 3     ///< SheetBounds
  };

  ///@{
  /**
   * Height of the water along z, in the scene's unit: any finite value. Not used if UsePlane is on.
   * Default is 0.
   */
  vtkSetMacro(Level, double);
  vtkGetMacro(Level, double);
  ///@}

  ///@{
  /**
   * Whether Origin and Normal give the plane, instead of Level. Default is off.
   */
  vtkSetMacro(UsePlane, bool);
  vtkGetMacro(UsePlane, bool);
  ///@}

  ///@{
  /**
   * The plane of the water: a point of it, and a vector out of the water that is not zero. Defaults
   * are (0, 0, 0) and (0, 0, 1).
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  vtkSetVector3Macro(Normal, double);
  vtkGetVector3Macro(Normal, double);
  ///@}

  ///@{
  /**
   * Extent of the sheet (Extents). Other values are rejected with an error. Default is AUTOMATIC.
   */
  void SetExtent(int extent);
  vtkGetMacro(Extent, int);
  ///@}

  ///@{
  /**
   * Bounds of the sheet if Extent is BOUNDS: see vtkWaterActor::SetSheetBounds. Default is
   * -1, 1, -1, 1.
   */
  vtkSetVector4Macro(SheetBounds, double);
  vtkGetVector4Macro(SheetBounds, double);
  ///@}

  /**
   * Puts a water where the data of such a source say. Returns false, and changes nothing, for other
   * data.
   */
  static bool Place(vtkPolyData* sheet, vtkWaterActor* water);

protected:
  vtkPVWaterSheetSource() { this->SetNumberOfInputPorts(0); }
  ~vtkPVWaterSheetSource() override = default;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPVWaterSheetSource(const vtkPVWaterSheetSource&) = delete;
  void operator=(const vtkPVWaterSheetSource&) = delete;

  double Level = 0.0;
  bool UsePlane = false;
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 1.0 };
  int Extent = AUTOMATIC;
  double SheetBounds[4] = { -1.0, 1.0, -1.0, 1.0 };
};

#endif
