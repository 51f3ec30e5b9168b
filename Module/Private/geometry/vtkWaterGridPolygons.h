// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterGridPolygons: the polygons of a data set that comes again, step by step. Those of a grid
// are listed once: a list that stays the same is one whose triangles and rows are known.
#ifndef vtkWaterGridPolygons_h
#define vtkWaterGridPolygons_h

#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkCellArray;
class vtkDataSet;
class vtkPoints;
class vtkPolyData;
class vtkUnstructuredGrid;

class vtkWaterGridPolygons
{
public:
  vtkWaterGridPolygons();
  ~vtkWaterGridPolygons();

  // As vtkWaterPolygonsOf. Points and polygons of a grid of flat cells are its own, in its order;
  // hidden cells of grids are left out. vtkPolyData keeps them, as VTK draws them.
  void Make(vtkDataSet* input, vtkPolyData* mesh);

private:
  vtkWaterGridPolygons(const vtkWaterGridPolygons&) = delete;
  void operator=(const vtkWaterGridPolygons&) = delete;

  bool MakeOfCells(vtkUnstructuredGrid* input, vtkPolyData* mesh);
  bool MakeOfRows(vtkDataSet* input, vtkPolyData* mesh);
  void ListQuads(const std::array<int, 2>& sides);
  void PlacePoints(vtkDataSet* input);

  std::array<int, 2> Sides{}; // of the grid whose quads are listed, in points
  vtkSmartPointer<vtkCellArray> Quads;
  std::vector<double> Axes; // what places the points of an image or a rectilinear grid
  vtkSmartPointer<vtkPoints> Points;
};

#endif
