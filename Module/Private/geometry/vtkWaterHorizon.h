// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHorizon: the own sheet without an end: what an eye sees of the plane, for each eye.
#ifndef vtkWaterHorizon_h
#define vtkWaterHorizon_h

#include "water_types.h"

#include <memory>
#include <vector>

class vtkPolyDataMapper;
class vtkRenderer;
class vtkWindow;

class vtkWaterHorizon
{
public:
  // What the sheet of an eye depends on.
  struct Place
  {
    water_camera Eye = water_camera();
    water_plane Plane = water_plane(); // of any scale
    double Kept[4] = {};               // as in water_horizon_make
    bool HasKept = false;
    double ToLocal[16] = {}; // world -> coordinates of the mapper's points, row-major
  };

  vtkWaterHorizon();
  ~vtkWaterHorizon();

  // The sheet for the active camera of a renderer, laid unless it lies there already; nullptr: the
  // eye sees nothing of the plane.
  vtkPolyDataMapper* Lay(vtkRenderer* renderer, const Place& place);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkWaterHorizon(const vtkWaterHorizon&) = delete;
  void operator=(const vtkWaterHorizon&) = delete;

  struct Sheet;

  Sheet& Find(vtkRenderer* renderer);

  // an eye each: what is laid for one is not laid anew for another in the same frame
  std::vector<std::unique_ptr<Sheet>> Sheets;
};

#endif
