// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterSurfaceFilter
 * @brief   the surface of a solver's water: its mesh at the height of the water, up to the shore
 *
 * Takes a two-dimensional mesh of a flood, a tide or a river, with the level of the water, its
 * depth and the bed as arrays of points or cells, and makes the mesh of the water's surface: the
 * wet part alone, at the level, with all arrays. Two of the three arrays are enough; without a bed
 * the z of the mesh's points is the bed. With the level alone all of the mesh is wet.
 *
 *     filter.SetLevelArrayName("zeta")
 *     filter.SetBedArrayName("zb")
 *     mapper.SetInputConnection(filter.GetOutputPort())
 *     water.SetMapper(mapper)
 *     filter.Update()
 *     water.SetLevel(filter.GetMeanLevel())
 *
 * The shore lies where the bed reaches the level, between the points of the mesh: the level of the
 * wet places goes on into the dry places beside them. A place that the solver calls dry stays dry,
 * even where its bed is below that level, as behind a dyke. Values that are not finite, and depths
 * below 0, are dry.
 *
 * Output points have the arrays "WaterLevel" and "WaterDepth" (0 at the shore; not with the level
 * alone), in the unit of the mesh. Lines and vertices are left out. Of a composite dataset each
 * block is a mesh; GetMeanLevel is that of the last one. All is over z; other directions want a
 * transform before it.
 *
 * @sa vtkWaterActor
 */
#ifndef vtkWaterSurfaceFilter_h
#define vtkWaterSurfaceFilter_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRenderingWaterModule.h" // for the export macro

#include <string>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKRENDERINGWATER_EXPORT vtkWaterSurfaceFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkWaterSurfaceFilter* New();
  vtkTypeMacro(vtkWaterSurfaceFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the array of the water's level: its height over z = 0, one number a point or a cell, of
   * any finite value; all others are dry. Empty, the default: there is none, and DepthArrayName is
   * needed.
   */
  void SetLevelArrayName(const std::string& name);
  std::string GetLevelArrayName() const { return this->LevelArrayName; }
  ///@}

  ///@{
  /**
   * Name of the array of the water's depth over the bed, one number a point or a cell as the level,
   * a finite value; others, and those not above DryDepth, are dry. Empty, the default: there is
   * none, and the level must be there.
   */
  void SetDepthArrayName(const std::string& name);
  std::string GetDepthArrayName() const { return this->DepthArrayName; }
  ///@}

  ///@{
  /**
   * Name of the array of the bed's height over z = 0, one finite number a point or a cell.
   * Empty, the default: the bed is the level less the depth, or with the depth alone the z of the
   * mesh's points.
   */
  void SetBedArrayName(const std::string& name);
  std::string GetBedArrayName() const { return this->BedArrayName; }
  ///@}

  ///@{
  /**
   * Depth up to which a place is dry, in the unit of the mesh: finite and not negative. Solvers
   * leave films of water on dry land. Default is 0.001.
   */
  void SetDryDepth(double depth);
  vtkGetMacro(DryDepth, double);
  ///@}

  ///@{
  /**
   * What heights are multiplied with, those of the output's points alone: its arrays keep their
   * values. Finite and greater than 0. Default is 1.
   */
  void SetVerticalScale(double scale);
  vtkGetMacro(VerticalScale, double);
  ///@}

  /**
   * The mean height of the output's points, by area, scale included: a plane for the water. 0
   * before the first update, and of a surface that is dry everywhere.
   */
  double GetMeanLevel() const { return this->MeanLevel; }

protected:
  vtkWaterSurfaceFilter();
  ~vtkWaterSurfaceFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkWaterSurfaceFilter(const vtkWaterSurfaceFilter&) = delete;
  void operator=(const vtkWaterSurfaceFilter&) = delete;

  void SetName(std::string& member, const std::string& name);

  std::string LevelArrayName;
  std::string DepthArrayName;
  std::string BedArrayName;
  double DryDepth = 0.001;
  double VerticalScale = 1.0;
  double MeanLevel = 0.0;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif
