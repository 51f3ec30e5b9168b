// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterUncutSurface.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkWaterCellChunks.h"
#include "vtkWaterColumns.h"
#include "vtkWaterPolygons.h"
#include "vtkWaterVertexNormals.h"
#include "water_shore.h"

#include <algorithm>
#include <array>

namespace
{
// Of a point's values: those that are no numbers.
size_t CountUnknown(vtkDataArray* array, vtkIdType point)
{
  size_t count = 0;
  for (int i = 0; i < array->GetNumberOfComponents(); ++i)
  {
    count += vtkMath::IsFinite(array->GetComponent(point, i)) ? 0 : 1;
  }
  return count;
}

// The first wet corner of a cell.
vtkIdType WetCornerOf(vtkCellArray* polygons, vtkIdType cell, const double* depths)
{
  vtkIdType found = 0;
  vtkWaterForCells(
    polygons, cell, cell + 1, [&](vtkIdType, const vtkIdType* points, vtkIdType count) {
      found = *std::find_if(
        points, points + count - 1, [depths](vtkIdType point) { return depths[point] > 0.0; });
    });
  return found;
}

void FillDistances(const double* depths, vtkFloatArray* made)
{
  float* distances = made->GetPointer(0);
  vtkSMPTools::For(
    0, made->GetNumberOfValues(), [depths, distances](vtkIdType begin, vtkIdType end) {
      water_shore_distances(depths + begin, static_cast<size_t>(end - begin), distances + begin);
    });
}

// Tells VTK the ranges of an array's columns, which it asks before it sends points to a graphics
// card, and which it would find by another walk. A change of the array makes it forget them.
void TellRanges(vtkDataArray* array, const double bounds[6])
{
  vtkNew<vtkInformationVector> columns;
  columns->SetNumberOfInformationObjects(3);
  for (int i = 0; i < 3; ++i)
  {
    columns->GetInformationObject(i)->Set(vtkDataArray::COMPONENT_RANGE(), bounds + 2 * i, 2);
  }
  array->GetInformation()->Set(vtkAbstractArray::PER_COMPONENT(), columns);
}

// Points whose bounds are known: VTK need not look for them.
class BoundedPoints : public vtkPoints
{
public:
  static BoundedPoints* New() { VTK_STANDARD_NEW_BODY(BoundedPoints); }

  void SetPlaces(vtkDoubleArray* places, const double bounds[6])
  {
    this->SetData(places);
    TellRanges(places, bounds);
    std::copy_n(bounds, 6, this->Bounds);
    this->ComputeTime.Modified();
  }
};
}

//------------------------------------------------------------------------------
void vtkWaterUncutSurface::Classify(const Given& given, vtkWaterColumns& columns)
{
  const double* depths = columns.GetDepths();
  vtkCellArray* polygons = given.Mesh->GetPolys();
  this->Facts = water_shore_facts();
  this->Facts.has_depths = columns.HasDepths();
  this->Facts.shared = columns.GetDivides().GetCount();
  columns.ShareCells(polygons, this->Cells);
  for (vtkIdType dyke : columns.GetDykes())
  {
    this->Facts.dykes +=
      this->Cells.Kinds[static_cast<size_t>(dyke)] != vtkWaterShoreCells::Dry ? 1 : 0;
  }
  std::vector<double> own;
  for (vtkIdType cell : this->Cells.CutCells)
  {
    vtkWaterForCells(
      polygons, cell, cell + 1, [&](vtkIdType, const vtkIdType* points, vtkIdType count) {
        own.clear();
        for (vtkIdType i = 0; i < count; ++i)
        {
          own.push_back(depths[points[i]]);
          for (vtkDataArray* array : given.Shown)
          {
            const bool isShown = array && own.back() <= 0.0;
            this->Facts.unknown += isShown ? CountUnknown(array, points[i]) : 0;
          }
        }
        const bool isSplit = count > 4 && water_shore_is_split(own.data(), own.size());
        this->Facts.crossed += isSplit ? 1 : 0;
      });
  }
}

//------------------------------------------------------------------------------
void vtkWaterUncutSurface::Place(
  const Given& given, const vtkWaterColumns& columns, vtkIdType still)
{
  const vtkIdType count = given.Mesh->GetNumberOfPoints();
  double* made = this->Places->GetPointer(0);
  const double* depths = columns.GetDepths();
  const double* levels = columns.GetLevels();
  const vtkWaterPlaces places(given.Mesh->GetPoints());
  double land[3]; // where it lies
  places.Get(still, land);
  land[2] = given.Scale * levels[still];
  const std::array<double, 6> begun = { land[0], land[0], land[1], land[1], land[2], land[2] };
  std::vector<std::array<double, 6>> bounds(static_cast<size_t>(vtkWaterBlockCount(count)), begun);
  vtkWaterForBlocks(count, [&](vtkIdType block, vtkIdType begin, vtkIdType end) {
    double* all = bounds[static_cast<size_t>(block)].data();
    if (places.GetDoubles())
    {
      water_shore_places(places.GetDoubles() + 3 * begin, levels + begin, depths + begin,
        static_cast<size_t>(end - begin), given.Scale, land, made + 3 * begin, all);
      return;
    }
    for (vtkIdType i = begin; i < end; ++i)
    {
      double point[3];
      places.Get(i, point);
      water_shore_places(point, levels + i, depths + i, 1, given.Scale, land, made + 3 * i, all);
    }
  });
  vtkBoundingBox box;
  for (const std::array<double, 6>& ofBlock : bounds)
  {
    box.AddBounds(ofBlock.data());
  }
  std::array<double, 6> all;
  box.GetBounds(all.data());
  static const double wet = 1.0; // the dry corners beside the water are needed, too
  for (vtkIdType cell : this->Cells.CutCells)
  {
    vtkWaterForCells(given.Mesh->GetPolys(), cell, cell + 1,
      [&](vtkIdType, const vtkIdType* corners, vtkIdType size) {
        std::for_each(corners, corners + size, [&](vtkIdType i) {
          double point[3];
          places.Get(i, point);
          water_shore_places(
            point, levels + i, &wet, 1, given.Scale, land, made + 3 * i, all.data());
        });
      });
  }
  this->Places->Modified();
  vtkNew<BoundedPoints> points;
  points->SetPlaces(this->Places, all.data());
  this->Whole->SetPoints(points);
}

//------------------------------------------------------------------------------
// Long because a surface is made in many steps, whose order matters.
bool vtkWaterUncutSurface::Make(const Given& given, vtkWaterColumns& columns)
{
  this->Blocks.clear();
  this->Classify(given, columns);
  if (!water_shore_draw_is_exact(&this->Facts))
  {
    return false;
  }
  const auto& kinds = this->Cells.Kinds;
  const auto first = std::find_if(kinds.begin(), kinds.end(),
    [](vtkWaterShoreCells::Kind kind) { return kind != vtkWaterShoreCells::Dry; });
  if (first == kinds.end())
  {
    return true; // all is land
  }
  const double* depths = columns.GetDepths();
  this->Whole = vtkSmartPointer<vtkWaterUncutMesh>::New();
  this->Whole->ShallowCopy(given.Mesh);
  // those of the mesh, which may be its bed's, are not the surface's
  this->Whole->GetPointData()->SetNormals(nullptr);
  this->Whole->GetPointData()->SetTangents(nullptr);
  this->Whole->GetCellData()->SetNormals(nullptr);
  this->Whole->GetPointData()->AddArray(columns.GetLevelArray());
  this->Whole->GetPointData()->AddArray(columns.GetDepthArray());
  vtkNew<vtkPolyData> solved;
  solved->SetPoints(given.Mesh->GetPoints());
  solved->SetPolys(given.Mesh->GetPolys());
  this->Whole->SetSolvedMesh(solved);
  this->Places = this->KeptPlaces.Take("Points", 3, given.Mesh->GetNumberOfPoints());
  this->Place(given, columns,
    WetCornerOf(given.Mesh->GetPolys(), static_cast<vtkIdType>(first - kinds.begin()), depths));
  this->Parts.Find(this->Whole, given.Up, given.MostPlanes, &this->Cells);
  this->Facts.shared = this->Parts.GetSharedCount();
  this->Facts.unplaced = this->Parts.GetUnplacedCount();
  if (!water_shore_draw_is_exact(&this->Facts))
  {
    return false;
  }
  const size_t planes = this->Parts.GetPlanes().size();
  const bool hasOne = planes > 0 && this->Parts.HasAll(0);
  const auto land = std::count(kinds.begin(), kinds.end(), vtkWaterShoreCells::Dry);
  const bool isWholeDrawn = hasOne ||
    (planes > 0 &&
      water_shore_draw_is_whole(
        this->Parts.GetCells(0).size(), kinds.size() - static_cast<size_t>(land)));
  for (size_t i = 0; i < planes; ++i)
  {
    this->Blocks.push_back(this->Whole);
    if (i > 0 || !isWholeDrawn)
    {
      this->Blocks[i] = vtkSmartPointer<vtkWaterUncutMesh>::New();
      this->Parts.Extract(this->Whole, i, this->Blocks[i]);
    }
  }
  if (isWholeDrawn && !hasOne)
  {
    this->Leave(given, columns, 0); // the others have copies
  }
  for (size_t i = 0; i < planes; ++i)
  {
    this->Finish(i, this->Blocks[i], this->Blocks[i] == this->Whole);
    this->Blocks[i]->SetHeightScale(given.Scale);
  }
  this->Whole = nullptr;
  this->Places = nullptr;
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterUncutSurface::Forget()
{
  this->Blocks.clear();
  this->Whole = nullptr;
  this->Places = nullptr;
  this->KeptPlaces.Forget();
  this->KeptDistances.Forget();
  this->KeptNormals.Forget();
}

//------------------------------------------------------------------------------
void vtkWaterUncutSurface::Leave(const Given& given, const vtkWaterColumns& columns, size_t plane)
{
  double* depths = columns.GetDepthArray()->GetPointer(0);
  vtkCellArray* polygons = given.Mesh->GetPolys();
  std::vector<vtkIdType> kept; // of the cut cells
  for (size_t cell = 0; cell < this->Cells.Kinds.size(); ++cell)
  {
    const auto number = static_cast<vtkIdType>(cell);
    if (this->Cells.Kinds[cell] == vtkWaterShoreCells::Dry)
    {
      continue;
    }
    if (this->Parts.PlaneOf(number) != static_cast<int64_t>(plane))
    {
      this->Cells.Kinds[cell] = vtkWaterShoreCells::Dry;
      vtkWaterForCells(
        polygons, number, number + 1, [&](vtkIdType, const vtkIdType* points, vtkIdType count) {
          std::for_each(points, points + count,
            [depths](vtkIdType point) { depths[point] = std::min(depths[point], -depths[point]); });
        });
    }
    else if (this->Cells.Kinds[cell] == vtkWaterShoreCells::Cut)
    {
      kept.push_back(number);
    }
  }
  this->Cells.CutCells = kept;
  this->Place(given, columns, WetCornerOf(polygons, this->Parts.GetCells(plane).front(), depths));
}

//------------------------------------------------------------------------------
void vtkWaterUncutSurface::Finish(size_t plane, vtkWaterUncutMesh* block, bool isWhole)
{
  auto* depths =
    vtkArrayDownCast<vtkDoubleArray>(block->GetPointData()->GetArray(vtkWaterColumns::DepthName));
  const vtkIdType count = depths->GetNumberOfTuples();
  vtkWaterKept<vtkFloatArray> own; // the parts of a mesh are of another size in each step
  auto distances = (isWhole ? &this->KeptDistances : &own)->Take("distances", 1, count);
  FillDistances(depths->GetPointer(0), distances);
  block->SetDistances(distances);
  if (!this->Parts.GetPlanes()[plane].IsFlat)
  {
    block->GetPointData()->SetNormals(vtkWaterVertexNormals(block, isWhole ? &this->Cells : nullptr,
      isWhole ? &this->KeptNormals : nullptr, isWhole ? this->Cells.Chunks->GetBlocks() : nullptr)
                                        .Get());
  }
  this->Parts.Describe(plane, block);
  block->SetWetBounds(this->Parts.GetPlanes()[plane].Bounds);
}
