// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterUncutSurface: the waters of a solver's mesh as meshes that are cut at the shore while
// they are drawn: what vtkWaterWetPart and vtkWaterPlanesFilter make together, without cutting a
// cell.
#ifndef vtkWaterUncutSurface_h
#define vtkWaterUncutSurface_h

#include "vtkSmartPointer.h"
#include "vtkWaterKept.h"
#include "vtkWaterParts.h"
#include "vtkWaterUncutMesh.h"
#include "water_shore_draw.h"

#include <vector>

class vtkDataArray;
class vtkPolyData;
class vtkWaterColumns;

class vtkWaterUncutSurface
{
public:
  struct Given
  {
    vtkPolyData* Mesh = nullptr; // of polygons alone
    double Scale = 1.0;          // the z of a point is scale * level
    double Up[3] = { 0.0, 0.0, 1.0 };
    size_t MostPlanes = 1;
    std::vector<vtkDataArray*> Shown; // arrays of points that the picture shows; or nullptr
  };

  // Returns whether the drawn meshes show the same as the cut one; false: there are none.
  bool Make(const Given& given, vtkWaterColumns& columns);

  // There is no water.
  void Forget();

  // Of the waters, one for each plane, that of the largest part first: with the arrays and field
  // data of the blocks of vtkWaterPlanesFilter.
  const std::vector<vtkSmartPointer<vtkWaterUncutMesh>>& GetBlocks() const { return this->Blocks; }

private:
  // Which cells have water; counts what a drawing cannot show.
  void Classify(const Given& given, vtkWaterColumns& columns);
  // Puts all points to their places; those of dry cells to the place of one that has water.
  void Place(const Given& given, const vtkWaterColumns& columns, vtkIdType still);
  // Makes land of the water in all other planes.
  void Leave(const Given& given, const vtkWaterColumns& columns, size_t plane);
  void Finish(size_t plane, vtkWaterUncutMesh* block, bool isWhole);

  vtkWaterShoreCells Cells;
  water_shore_facts Facts = water_shore_facts();
  vtkWaterParts Parts;
  vtkSmartPointer<vtkWaterUncutMesh> Whole;
  vtkSmartPointer<vtkDoubleArray> Places; // its points
  vtkWaterKept<vtkDoubleArray> KeptPlaces;
  vtkWaterKept<vtkFloatArray> KeptDistances;
  vtkWaterKept<vtkFloatArray> KeptNormals;
  std::vector<vtkSmartPointer<vtkWaterUncutMesh>> Blocks;
};

#endif
