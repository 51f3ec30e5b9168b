// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterColumns: level of the water, and depth to the bed, at each point of a solver's mesh, also
// at the dry ones beside the shore; by water_shore.h.
#ifndef vtkWaterColumns_h
#define vtkWaterColumns_h

#include "vtkDoubleArray.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWaterCellChunks.h"
#include "vtkWaterDivides.h"
#include "vtkWaterKept.h"
#include "vtkWaterShoreCells.h"
#include "water_heights.h"
#include "water_shore.h"

#include <vector>

class vtkDataArray;
class vtkPolyData;

class vtkWaterColumns
{
public:
  // nullptr: there is none. Level and depth are both of cells, or both of points.
  struct Given
  {
    vtkDataArray* Level = nullptr;
    vtkDataArray* Depth = nullptr;
    vtkDataArray* Bed = nullptr;
    bool AreOfCells = false; // level and depth
    bool IsBedOfCells = false;
    double DryDepth = 0.0;
  };

  // Of a surface's arrays.
  static constexpr const char* LevelName = "WaterLevel";
  static constexpr const char* DepthName = "WaterDepth";

  // mesh  of polygons alone
  void Make(vtkPolyData* mesh, const Given& given);

  // At each point; a point far from all water has its own bed as the level.
  const double* GetLevels() const { return this->Levels; }
  const double* GetDepths() const { return this->Depths; }
  // The same, for a surface to keep: another Make leaves them alone while anybody has them.
  vtkDoubleArray* GetLevelArray() const { return this->LevelArray; }
  vtkDoubleArray* GetDepthArray() const { return this->DepthArray; }

  // Which polygons of the mesh are under water, by the depths.
  void ShareCells(vtkCellArray* polygons, vtkWaterShoreCells& cells);

  // Do the data say where the water ends? Else the depths are of no use but their signs.
  bool HasDepths() const { return this->AreDepthsKnown; }

  // Is the level of most cells that the shore cuts their own bed, as of dry land? Known if the
  // level is of cells, the bed of points, and there is no depth.
  bool AreLevelsBeds() const { return water_heights_are_beds(&this->Faces); }

  // Cells that the solver calls dry though their bed lies below the water beside them, or that no
  // water is beside; and dry cells between two lakes, as one level over them would join the lakes.
  const std::vector<vtkIdType>& GetDykes() const { return this->Dykes; }

  // Of data of points; those of cells have one level at each point.
  const vtkWaterDivides& GetDivides() const { return this->Divides; }

private:
  // Of data of points.
  void MakeOfPoints(vtkPolyData* mesh, const Given& given);
  void ReadCells(vtkPolyData* mesh, const Given& given);
  void ReadBeds(vtkPolyData* mesh, const Given& given);
  // Extends the levels of wet points to those beside them.
  void Spread(vtkPolyData* mesh);
  void SpreadOver(vtkPolyData* mesh, const std::vector<std::vector<vtkIdType>>& shores);
  // Between lakes: the depth of such a point is only a mark of land.
  void FindDivides(vtkPolyData* mesh, const std::vector<std::vector<vtkIdType>>& shores);
  // The depth of a point, once its level is known, and a level where there is none.
  void Finish(vtkIdType point);
  void FindDykes(vtkPolyData* mesh);
  // Of a cell: the points with a level are wet up to where their bed reaches it.
  void Fill(const vtkIdType* points, vtkIdType count);
  // Dry cells with corners at different levels: those between lakes are dykes, those at a river are
  // not.
  //
  // areUneven  points of cells with water that is not level
  void DivideLakes(
    vtkPolyData* mesh, const std::vector<vtkIdType>& between, const std::vector<char>& areUneven);

  vtkWaterKept<vtkDoubleArray> KeptLevels;
  vtkWaterKept<vtkDoubleArray> KeptDepths;
  vtkSmartPointer<vtkDoubleArray> LevelArray;
  vtkSmartPointer<vtkDoubleArray> DepthArray;
  double* Levels = nullptr; // of the arrays; NaN: not known
  double* Depths = nullptr;
  bool AreDepthsKnown = false;
  std::vector<double> Beds;
  std::vector<char> IsWet;      // points: the bed alone says where the water ends
  std::vector<char> IsCellWet;  // of data of cells; else empty
  std::vector<double> CellBeds; // the same
  water_heights_faces Faces = {};
  std::vector<vtkIdType> Dykes;
  vtkWaterDivides Divides;
  double DryDepth = 0.0;
  vtkWaterCellChunks Chunks; // of the mesh
  vtkWaterShoreCells Cells;  // if they are known
  bool AreCellsKnown = false;
};

#endif
