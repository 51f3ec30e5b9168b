// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterPlanesFilter
 * @brief   the parts of a water's surface that do not hang together, by the planes that they lie in
 *
 * A mesh may have many waters: lakes, locks, terraces, pools. Each part that hangs together by its
 * points gets the plane that lies best in it; parts in one plane are one block of the output, so
 * that they share one mirrored view. vtkWaterLakes makes water of the blocks.
 *
 * The plane is that of the least mean square of heights, by the area that is seen along
 * UpDirection. It is level unless it is tilted by 1e-4 to 0.52 rad (30 degrees) and the tilt takes
 * at least half of the heights' mean square: waves leave it level, a river's fall does not. Parts
 * count as in one plane when that is no farther from the plane of the larger one than a millionth
 * of the surface's diagonal and what its coordinates are rounded by. There are at most
 * MaximumNumberOfPlanes, those of the largest parts; other parts join the nearest.
 *
 * The blocks are vtkPolyData, that of the largest part first, with all arrays, and with three of
 * the field data: "WaterPlaneOrigin" and "WaterPlaneNormal" (3 each; the origin of a level plane is
 * on the line along UpDirection through the world's origin) and "WaterArea" (seen along
 * UpDirection). Blocks that are not flat get point normals, unless the input has some. Lines and
 * vertices are left out, and so are parts that have no area along UpDirection.
 *
 * Points that lie in one place are not one: a mesh of loose triangles wants vtkCleanPolyData first.
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
   * Where up is, out of the water: finite and not zero, of any length; others are refused with an
   * error. Default is (0, 0, 1).
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
   * The most planes that there are, and blocks of the output: in [1, 4096]. Default is 256.
   */
  void SetMaximumNumberOfPlanes(int planes);
  vtkGetMacro(MaximumNumberOfPlanes, int);
  ///@}

  /**
   * The number of planes, and blocks, that the last update has found; 0 before the first.
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
