// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterGrid: the own sheet as a grid over the part in view, for waves that displace it.
#ifndef vtkWaterGrid_h
#define vtkWaterGrid_h

#include "vtkNew.h"
#include "water_grid.h"

#include <vector>

class vtkFloatArray;
class vtkPoints;
class vtkPolyData;
class vtkPolyDataMapper;

class vtkWaterGrid
{
public:
  // What a grid depends on.
  struct Place
  {
    water_grid_view View;
    double Sheet[4];
    bool IsEndless; // whatever Sheet is
    double Height;  // as in water_grid_lay
    double Reach;
    int Size;
  };

  vtkWaterGrid();
  ~vtkWaterGrid();

  vtkPolyDataMapper* GetMapper();

  // Lays the grid, unless it lies there already.
  void Lay(const Place& place);

  // In the plane's own axes, from row to row.
  const double* GetRowDir() const { return this->RowDir; }

private:
  vtkWaterGrid(const vtkWaterGrid&) = delete;
  void operator=(const vtkWaterGrid&) = delete;

  void Resize(int size);

  vtkNew<vtkPoints> Points; // in double precision: scenes may lie far from the origin
  vtkNew<vtkFloatArray> Cells;
  vtkNew<vtkPolyData> Grid;
  vtkNew<vtkPolyDataMapper> Mapper;
  Place Laid = Place();
  double RowDir[2] = { 1.0, 0.0 };
};

#endif
