// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterSurfaceFilter
 * @brief   extracts the water surface from a solver's mesh: the wet part, up to the shore
 *
 * The input is a two-dimensional mesh of a flood, a tide or a river. Arrays of points or cells give
 * the water's level, its depth and the bed. The output is the mesh of the water's surface: only the
 * wet part, at the level, with all arrays. Two of the three arrays are enough; with only the depth,
 * the z of the mesh's points is the bed. With only the level, the whole mesh is wet.
 *
 *     filter.SetLevelArrayName("zeta")
 *     filter.SetBedArrayName("zb")
 *     mapper.SetInputConnection(filter.GetOutputPort())
 *     water.SetMapper(mapper)
 *     filter.Update()
 *     water.SetLevel(filter.GetMeanLevel())
 *
 * The shore lies where the bed reaches the level, between the points of the mesh: the level of wet
 * places is extended into adjacent dry places. Lakes at different levels on both sides of a ridge
 * end at their own levels, also if the ridge is only one row of points or cells wide. A place that
 * the solver marks as dry stays dry, even if its bed is below that level, as behind a dyke. Places
 * with values that are not finite or beyond 1e9, as the fill values of files are, or with depths
 * below 0, are dry.
 *
 * In a dry cell, many solvers write the height of its bed as the level. If the bed is known at the
 * points only, such a level lies over the lowest corners of the cell, and the filter cannot tell it
 * from a puddle: give the depth of the cells, with either the level or the bed as the second array;
 * or give the bed of the cells. A warning reports this, once, if most of the cells that the shore
 * cuts have such a level.
 *
 * Output points have the arrays "WaterLevel" and "WaterDepth" (0 at the shore; absent with only the
 * level), in the unit of the mesh. Lines and vertices are left out. In a composite dataset each
 * block is a separate mesh; GetMeanLevel then returns the level of the last one. Heights are along
 * z; for other directions, transform the mesh first.
 *
 * Do not change the output's cells in place. Where everything is wet, they are the input's own
 * cells or, for a structured or rectilinear grid or an image, the cells that the filter keeps for
 * the next steps. Change a deep copy.
 *
 * Hidden cells of grids and images (vtkDataSetAttributes::HIDDENCELL) are not water. Hidden cells
 * of vtkPolyData are, because its mappers draw them.
 *
 * Level, depth and bed must have the same unit. If one array seems to have another unit, a warning
 * names it, once, with the ranges of all arrays. The checks convert an array between millimetres,
 * centimetres, feet and metres. With all three arrays, there is a warning if level = bed + depth
 * holds only after a conversion, and otherwise if it is wrong by more than a hundredth of the
 * largest depth in a wet place. With depth and bed alone, there is one if the surface, their sum,
 * is level only after a conversion of the depth. With level and bed alone, there is one if the
 * levels lie far below the lowest bed, or far above the whole bed but among its heights after a
 * conversion. Other mistakes of units look like real water and are not detected.
 *
 * @sa vtkWaterActor
 */
#ifndef vtkWaterSurfaceFilter_h
#define vtkWaterSurfaceFilter_h

#include "vtkNew.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkRenderingWaterModule.h" // for the export macro

#include <array>
#include <memory>
#include <string>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkDataArray;
class vtkDataSet;
class vtkPolyData;
class vtkWaterColumns;
class vtkWaterGridPolygons;
class vtkWaterLakes;

class VTKRENDERINGWATER_EXPORT vtkWaterSurfaceFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkWaterSurfaceFilter* New();
  vtkTypeMacro(vtkWaterSurfaceFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the array with the water's level: its height above z = 0, one number per point or cell.
   * Values that are not finite are dry. Empty, the default, means that there is no such array;
   * DepthArrayName is then required.
   */
  void SetLevelArrayName(const std::string& name);
  std::string GetLevelArrayName() const { return this->LevelArrayName; }
  ///@}

  ///@{
  /**
   * Name of the array with the water's depth above the bed, one number per point or cell. Values
   * that are not finite, and values not above DryDepth, are dry. If no value is above 0, and one
   * is below -DryDepth, a warning says so, once. Empty, the default, means that there is
   * no such array; the level is then required.
   */
  void SetDepthArrayName(const std::string& name);
  std::string GetDepthArrayName() const { return this->DepthArrayName; }
  ///@}

  ///@{
  /**
   * Name of the array with the bed's height above z = 0, one finite number per point or cell.
   * Empty, the default: the bed is the level minus the depth or, with only the depth, the z of the
   * mesh's points.
   */
  void SetBedArrayName(const std::string& name);
  std::string GetBedArrayName() const { return this->BedArrayName; }
  ///@}

  ///@{
  /**
   * Depth up to which a place is dry, in the unit of the mesh: finite and not negative. Solvers
   * leave thin films of water on dry land. Default is 0.001.
   */
  void SetDryDepth(double depth);
  vtkGetMacro(DryDepth, double);
  ///@}

  ///@{
  /**
   * Vertical exaggeration: factor of the heights of the output's points; the arrays keep their
   * values. Finite and greater than 0. Default is 1.
   */
  void SetVerticalScale(double scale);
  vtkGetMacro(VerticalScale, double);
  ///@}

  /**
   * Mean height of the output's points, weighted by area, including VerticalScale. Use it as the
   * water's level. 0 before the first update, and for a surface that is dry everywhere.
   */
  double GetMeanLevel();

  /**
   * Number of cells that the last update cut at the shore (NumberOfCutCells). A vtkWaterLakes that
   * cuts the shore while drawing does not update this filter; it is updated when its output is
   * requested.
   */
  vtkGetMacro(NumberOfCutCells, vtkIdType);

protected:
  vtkWaterSurfaceFilter();
  ~vtkWaterSurfaceFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkWaterSurfaceFilter(const vtkWaterSurfaceFilter&) = delete;
  void operator=(const vtkWaterSurfaceFilter&) = delete;

  friend class vtkWaterLakes; // which reads steps without cutting them

  void SetName(std::string& member, const std::string& name);
  // The polygons of a data set, with level and depth at each point. Says what is wrong; false: then
  // there is no surface.
  bool ReadStep(vtkDataSet* input, vtkPolyData* mesh, vtkWaterColumns& columns);
  void CheckUnits(vtkDataArray* level, vtkDataArray* depth, vtkDataArray* bed);
  void CheckSum(const std::vector<double>& levels, const std::vector<double>& depths,
    const std::vector<double>& beds);
  bool CheckDepths(vtkDataArray* depth);
  double GetMeanOfUpdate(); // the last one; updates nothing

  std::string LevelArrayName;
  std::string DepthArrayName;
  std::string BedArrayName;
  double DryDepth = 0.001;
  double VerticalScale = 1.0;
  double MeanLevel = 0.0;
  vtkIdType NumberOfCutCells = 0;
  bool IsMeanKnown = true;
  bool IsCutMissing = false; // the last step was read for a drawing alone
  bool AreUnitsTold = false;
  bool IsSignTold = false;
  bool IsLandTold = false;
  std::array<vtkMTimeType, 5> Checked{}; // the cells whose points have been checked
  vtkNew<vtkPolyData>
    Surface; // the surface from which MeanLevel is still to be computed; empty afterwards
  std::unique_ptr<vtkWaterGridPolygons> Polygons;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif
