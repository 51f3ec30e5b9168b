// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSheet: the water's own sheet: a rectangle in the plane, over the bounds of the scene.
#ifndef vtkWaterSheet_h
#define vtkWaterSheet_h

#include "vtkNew.h"
#include "water_plane.h"

#include <vector>

class vtkPoints;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;

class vtkWaterSheet
{
public:
  vtkWaterSheet();
  ~vtkWaterSheet();

  vtkPolyDataMapper* GetMapper();

  // xmin, xmax, ymin, ymax in the plane's axes, as last fitted.
  const double* GetRectangle() const { return this->Bounds; }

  // Fits the sheet; when it cannot, the last good one stays.
  //
  // plane     of any scale; its origin is the origin of the sheet's axes
  // bounds    xmin, xmax, ymin, ymax in the plane's axes; nullptr: over the scene
  // scene     bounds of what is to be covered, when bounds is nullptr
  // wet       corners of the parts of it that there are, four of x, y, z each; empty: all of it
  water_status Fit(const water_plane& plane, const double origin[3], const double bounds[4],
    const double scene[6], const std::vector<double>& wet);

  // Bounds of what renderers show, waters left out; min > max: nothing.
  static void FindSceneBounds(const std::vector<vtkRenderer*>& scene, double bounds[6]);
  // Leaves the sheet without a point, for one that has no end. WATER_BAD_PLANE: as Fit.
  water_status Clear(const water_plane& plane);

private:
  vtkWaterSheet(const vtkWaterSheet&) = delete;
  void operator=(const vtkWaterSheet&) = delete;

  // corners  of rectangles, four of x, y, z each
  void SetParts(const std::vector<double>& corners, const double normal[3]);

  vtkNew<vtkPoints> Points; // in double precision: scenes may lie far from the origin
  vtkNew<vtkPolyData> Rectangle;
  vtkNew<vtkPolyDataMapper> Mapper;
  double Bounds[4] = {};
  std::vector<double> Corners;
  double Normal[3] = {};
};

#endif
