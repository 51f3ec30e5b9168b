// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterPlanesFilter
 * @brief   splits a water surface into its unconnected parts, grouped by their planes
 *
 * A mesh may contain many waters: lakes, locks, terraces, pools. Each part whose cells are
 * connected by points gets the plane that fits it best. Parts in one plane form one block of the
 * output and share one mirrored view. vtkWaterLakes turns the blocks into water.
 *
 * The plane minimises the mean square of the heights, weighted by the area projected along
 * UpDirection. It is used if it is tilted by 1e-4 to 0.52 rad (30 degrees) and the tilt explains at
 * least half of the heights' mean square; otherwise a horizontal plane is used. So waves leave the
 * plane horizontal, and the slope of a river does not. Parts share a plane if their distance from
 * the plane of the larger one is at most a millionth of the surface's diagonal plus the rounding of
 * its coordinates. There are at most MaximumNumberOfPlanes, those of the largest parts. If there
 * are other parts, they form one more block, the last one (the rest). No mirrored view is correct
 * for all of them.
 *
 * The blocks are vtkPolyData, the block of the largest part first, with all arrays and five arrays
 * of field data: "WaterPlaneOrigin" and "WaterPlaneNormal" (3 numbers each; the origin of a
 * horizontal plane is on the line along UpDirection through the world's origin; the rest has
 * those of the horizontal plane through its lowest part), "WaterArea" (projected along
 * UpDirection), "WaterPartBounds" (6 numbers for each part) and "WaterIsRest" (1 for the rest, 0
 * for others). Blocks that are not flat get point normals, unless the input has some. Lines,
 * vertices, parts without an area along UpDirection, and cells with coordinates that are not finite
 * or over 1e100 are left out. A mesh with a cell that names a missing point is rejected with an
 * error.
 *
 * Coincident points are not merged: apply vtkCleanPolyData to a mesh of separate triangles first.
 *
 * @sa vtkWaterLakes vtkWaterSurfaceFilter
 */
#ifndef vtkWaterPlanesFilter_h
#define vtkWaterPlanesFilter_h

#include "vtkMultiBlockDataSetAlgorithm.h"
#include "vtkRenderingWaterModule.h" // for the export macro

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkPolyData;

class VTKRENDERINGWATER_EXPORT vtkWaterPlanesFilter : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkWaterPlanesFilter* New();
  vtkTypeMacro(vtkWaterPlanesFilter, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Direction out of the water (UpDirection): finite and not zero, of any length; others are
   * rejected with an error. Default is (0, 0, 1).
   */
  void SetUpDirection(double x, double y, double z);
  void SetUpDirection(const double direction[3])
  {
    this->SetUpDirection(direction[0], direction[1], direction[2]);
  }
  vtkGetVector3Macro(UpDirection, double);
  ///@}

  ///@{
  /**
   * Maximum number of planes, in [1, 4096]. The output has a block for each, and one for the rest.
   * Default is 256.
   */
  void SetMaximumNumberOfPlanes(int planes);
  vtkGetMacro(MaximumNumberOfPlanes, int);
  ///@}

  /**
   * Number of planes that the last update found, without the rest (NumberOfPlanes); 0 before the
   * first.
   */
  vtkGetMacro(NumberOfPlanes, int);

protected:
  vtkWaterPlanesFilter();
  ~vtkWaterPlanesFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkWaterPlanesFilter(const vtkWaterPlanesFilter&) = delete;
  void operator=(const vtkWaterPlanesFilter&) = delete;

  double UpDirection[3] = { 0.0, 0.0, 1.0 };
  int MaximumNumberOfPlanes = 256;
  int NumberOfPlanes = 0;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif
