// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterWetPart: the part of a mesh that is under water, cut at the shore (water_shore.h).
//
// Only polygons that the shore crosses are cut. Of a mesh that is wet everywhere the polygons and
// all arrays are shared, not copied: VTK then keeps what it has on the GPU of them.
#ifndef vtkWaterWetPart_h
#define vtkWaterWetPart_h

#include "vtkType.h"
#include "vtkWaterDivides.h"
#include "water_shore.h"

#include <unordered_map>
#include <vector>

class vtkDoubleArray;
class vtkIdList;
class vtkPointData;
class vtkPolyData;

class vtkWaterWetPart
{
public:
  // mesh    of polygons alone
  // levels  of its points
  // depths  of the same, below 0 on land
  // dykes   cells that are dry whatever the depths
  // divides of lakes at different levels
  // scale   of heights: the z of a point is scale * level
  vtkWaterWetPart(vtkPolyData* mesh, const double* levels, const double* depths,
    const std::vector<vtkIdType>& dykes, const vtkWaterDivides& divides, double scale);

  // Points at the level, the mesh's arrays, and two arrays with the level and the depth of points.
  void Make(const char* levelName, const char* depthName, vtkPolyData* output);

  // Cells that were cut.
  vtkIdType GetCutCount() const { return this->CutCount; }

private:
  enum class Cell : char
  {
    Dry,
    Wet,
    Cut
  };

  struct Edge // from a wet point to a dry one
  {
    vtkIdType From;
    vtkIdType To;
    double Share;
  };

  void ClassifyCells();
  void NumberPoints();
  void CutCells();
  // Of a cell with waters that land separates: each by itself.
  void CutWaters(vtkIdType cell, const vtkIdType* points, vtkIdType count);
  void CutPolygon(vtkIdType cell, const vtkIdType* points, size_t count);
  vtkIdType Map(const vtkIdType* points, const water_shore_corner& corner);
  vtkIdType Map(vtkIdType point);
  void AddPoints(vtkDoubleArray* levels, vtkDoubleArray* depths, vtkPolyData* output) const;
  void AddPolygons(vtkPolyData* output) const;
  void AddArrays(vtkPolyData* output) const;
  // Where one end of a shore edge has no number, as land without data, the shore has the other's.
  void KeepKnownValues(vtkPointData* from, vtkPointData* to) const;
  // Marks of ghosts are bits, which have no mean: the shore has those of the wet end.
  void KeepMarks(vtkPointData* from, vtkPointData* to) const;

  vtkPolyData* Mesh;
  const double* Levels;
  const double* Depths;
  const std::vector<vtkIdType>& Dykes;
  const vtkWaterDivides& Divides;
  double Scale;
  bool IsAll = true;             // everything is wet, and each point is one of a polygon
  std::vector<double> OwnDepths; // of the polygon that is cut
  std::vector<water_shore_corner> OwnCorners;
  std::vector<Cell> Cells;
  vtkIdType WetCells = 0;
  vtkIdType CutCount = 0;
  vtkIdType WetCorners = 0;
  std::vector<vtkIdType> PointMap; // from the mesh's points to the part's; -1: not in it
  std::vector<vtkIdType> Kept;     // points of the mesh, by their number in the part
  std::vector<Edge> Edges; // points on the shore: their numbers follow those of all that are kept
  std::unordered_map<vtkIdType, std::vector<vtkIdType>> EdgesOf; // a wet point's: indices of Edges
  std::vector<vtkIdType> CutStarts;  // of the cut polygons, in CutCorners
  std::vector<vtkIdType> CutCorners; // points of the part; of an edge: -1 - its index
  std::vector<vtkIdType> CutFrom;    // cells of the mesh
};

#endif
