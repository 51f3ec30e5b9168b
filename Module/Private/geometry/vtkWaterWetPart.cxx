// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterWetPart.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkSMPTools.h"
#include "vtkWaterPolygons.h"

#include <algorithm>
#include <numeric>

namespace
{
size_t Index(vtkIdType number)
{
  return static_cast<size_t>(number);
}

vtkIdType CountOf(const std::vector<vtkIdType>& all)
{
  return static_cast<vtkIdType>(all.size());
}

// The triangles of a polygon, three points each; of a quad those that VTK draws it as, and of a
// polygon that VTK cannot triangulate a fan, as vtkWaterForWetParts has it.
void TriangulateInto(
  const vtkIdType* corners, vtkIdType count, vtkPoints* points, vtkIdList* triangles)
{
  vtkNew<vtkPolygon> polygon; // perhaps concave
  vtkNew<vtkPoints> places;
  bool isFan = count == 4;
  if (!isFan)
  {
    polygon->Initialize(static_cast<int>(count), corners, points);
    isFan = polygon->Triangulate(0, triangles, places) == 0; // then it leaves numbers of corners
  }
  if (isFan)
  {
    triangles->Reset();
    for (size_t number = 0; number + 2 < static_cast<size_t>(count); ++number)
    {
      size_t three[3];
      water_shore_triangle(number, three);
      std::for_each(
        three, three + 3, [&](size_t corner) { triangles->InsertNextId(corners[corner]); });
    }
  }
}
}

//------------------------------------------------------------------------------
vtkWaterWetPart::vtkWaterWetPart(vtkPolyData* mesh, const double* levels, const double* depths,
  const std::vector<vtkIdType>& dykes, const vtkWaterDivides& divides, double scale)
  : Mesh(mesh)
  , Levels(levels)
  , Depths(depths)
  , Dykes(dykes)
  , Divides(divides)
  , Scale(scale)
{
}

//------------------------------------------------------------------------------
void vtkWaterWetPart::Make(const char* levelName, const char* depthName, vtkPolyData* output)
{
  this->ClassifyCells();
  vtkNew<vtkDoubleArray> levels;
  vtkNew<vtkDoubleArray> depths;
  levels->SetName(levelName);
  depths->SetName(depthName);
  if (this->IsAll)
  {
    output->ShallowCopy(this->Mesh);
  }
  else
  {
    this->NumberPoints();
    this->CutCells();
    this->AddPolygons(output);
    this->AddArrays(output);
  }
  // those of the mesh, which may be its bed's, are not the surface's
  output->GetPointData()->SetNormals(nullptr);
  output->GetPointData()->SetTangents(nullptr);
  output->GetCellData()->SetNormals(nullptr);
  this->AddPoints(levels, depths, output);
  output->GetPointData()->AddArray(levels);
  output->GetPointData()->AddArray(depths);
}

//------------------------------------------------------------------------------
void vtkWaterWetPart::ClassifyCells()
{
  const double* depths = this->Depths;
  const vtkIdType points = this->Mesh->GetNumberOfPoints();
  this->Cells.assign(Index(this->Mesh->GetNumberOfPolys()), Cell::Wet);
  for (vtkIdType dyke : this->Dykes)
  {
    this->Cells[Index(dyke)] = Cell::Dry;
  }
  vtkCellArray* cells = this->Mesh->GetPolys();
  vtkWaterForBlocks(cells->GetNumberOfCells(), [&](vtkIdType, vtkIdType begin, vtkIdType end) {
    vtkWaterForCells(
      cells, begin, end, [&](vtkIdType cell, const vtkIdType* corners, vtkIdType count) {
        Cell& kind = this->Cells[Index(cell)];
        const auto wet = std::count_if(corners, corners + count,
          [depths](vtkIdType point) { return depths[Index(point)] > 0.0; });
        const bool isDry = kind == Cell::Dry || wet == 0 || count < 3;
        kind = isDry ? Cell::Dry : (wet == count ? Cell::Wet : Cell::Cut);
      });
  });
  this->PointMap.assign(Index(points), -1);
  vtkWaterForEachCell(cells, [this](vtkIdType cell, const vtkIdType* corners, vtkIdType count) {
    if (this->Cells[Index(cell)] == Cell::Wet)
    {
      ++this->WetCells;
      this->WetCorners += count;
      std::for_each(
        corners, corners + count, [this](vtkIdType point) { this->PointMap[Index(point)] = 0; });
    }
  });
  this->IsAll = this->WetCells == static_cast<vtkIdType>(this->Cells.size()) &&
    std::find(this->PointMap.begin(), this->PointMap.end(), -1) == this->PointMap.end();
}

//------------------------------------------------------------------------------
void vtkWaterWetPart::NumberPoints()
{
  for (size_t point = 0; point < this->PointMap.size(); ++point)
  {
    if (this->PointMap[point] == 0)
    {
      this->PointMap[point] = CountOf(this->Kept);
      this->Kept.push_back(static_cast<vtkIdType>(point));
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterWetPart::CutCells()
{
  const double* depths = this->Depths;
  std::vector<double> own;
  vtkNew<vtkIdList> triangles;
  vtkWaterForEachCell(
    this->Mesh->GetPolys(), [&](vtkIdType cell, const vtkIdType* corners, vtkIdType count) {
      if (this->Cells[Index(cell)] != Cell::Cut)
      {
        return;
      }
      ++this->CutCount;
      own.clear();
      std::transform(corners, corners + count, std::back_inserter(own),
        [depths](vtkIdType point) { return depths[Index(point)]; });
      if (count <= 4 && !water_shore_is_split(own.data(), own.size()))
      {
        this->CutPolygon(cell, corners, Index(count));
        return;
      }
      if (this->Divides.Cells.count(cell) && water_shore_is_split(own.data(), own.size()))
      {
        this->CutWaters(cell, corners, count);
        return;
      }
      TriangulateInto(corners, count, this->Mesh->GetPoints(), triangles);
      for (vtkIdType i = 0; i + 2 < triangles->GetNumberOfIds(); i += 3)
      {
        this->CutPolygon(cell, triangles->GetPointer(i), 3);
      }
    });
  this->CutStarts.push_back(CountOf(this->CutCorners));
}

//------------------------------------------------------------------------------
void vtkWaterWetPart::CutWaters(vtkIdType cell, const vtkIdType* points, vtkIdType count)
{
  const auto isDry = [this](vtkIdType point) { return !(this->Depths[Index(point)] > 0.0); };
  std::vector<vtkIdType> turned(points, points + count); // from a dry one on, which is the end, too
  std::rotate(turned.begin(), std::find_if(turned.begin(), turned.end(), isDry), turned.end());
  turned.push_back(turned.front());
  for (auto dry = turned.begin(); dry + 1 != turned.end();)
  {
    const auto next = std::find_if(dry + 1, turned.end(), isDry);
    this->CutPolygon(cell, &*dry, Index(next - dry) + 1); // nothing, if it is the neighbour
    dry = next;
  }
}

//------------------------------------------------------------------------------
void vtkWaterWetPart::CutPolygon(vtkIdType cell, const vtkIdType* points, size_t count)
{
  std::vector<water_shore_corner>& corners = this->OwnCorners;
  this->OwnDepths.resize(count);
  corners.resize(2 * count);
  std::transform(points, points + count, this->OwnDepths.begin(),
    [this](vtkIdType point) { return this->Depths[Index(point)]; });
  const size_t made = water_shore_cut(this->OwnDepths.data(), count, corners.data());
  // triangles: VTK 9.1 finds places outside of a quad that is no parallelogram in it
  for (size_t number = 0; number + 2 < made; ++number)
  {
    size_t three[3];
    water_shore_triangle(number, three);
    this->CutStarts.push_back(CountOf(this->CutCorners));
    this->CutFrom.push_back(cell);
    for (size_t corner : three)
    {
      this->CutCorners.push_back(this->Map(points, corners[corner]));
    }
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterWetPart::Map(vtkIdType point)
{
  vtkIdType& number = this->PointMap[Index(point)];
  if (number < 0)
  {
    number = CountOf(this->Kept);
    this->Kept.push_back(point);
  }
  return number;
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterWetPart::Map(const vtkIdType* points, const water_shore_corner& corner)
{
  const vtkIdType from = points[corner.from];
  const vtkIdType to = points[corner.to];
  if (from == to)
  {
    return this->Map(from);
  }
  std::vector<vtkIdType>& edges = this->EdgesOf[from];
  for (vtkIdType edge : edges)
  {
    if (this->Edges[Index(edge)].To == to)
    {
      return -1 - edge;
    }
  }
  edges.push_back(static_cast<vtkIdType>(this->Edges.size()));
  const auto divide = this->Divides.Beds.find(to);
  const bool isDivide = divide != this->Divides.Beds.end();
  this->Edges.push_back({ from, to,
    isDivide ? water_shore_before_divide(
                 this->Depths[Index(from)], this->Levels[Index(from)], divide->second)
             : corner.share });
  return -1 - edges.back();
}

//------------------------------------------------------------------------------
void vtkWaterWetPart::AddPoints(
  vtkDoubleArray* levels, vtkDoubleArray* depths, vtkPolyData* output) const
{
  const vtkIdType kept = this->IsAll ? this->Mesh->GetNumberOfPoints() : CountOf(this->Kept);
  const vtkIdType count = kept + static_cast<vtkIdType>(this->Edges.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  levels->SetNumberOfValues(count);
  depths->SetNumberOfValues(count);
  double* place = static_cast<double*>(points->GetVoidPointer(0));
  double* level = levels->GetPointer(0);
  double* depth = depths->GetPointer(0);
  vtkDataArray* places = this->Mesh->GetPoints()->GetData(); // thread-safe, unlike its GetPoint
  vtkSMPTools::For(0, kept, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const vtkIdType point = this->IsAll ? i : this->Kept[Index(i)];
      level[i] = this->Levels[Index(point)];
      depth[i] = std::max(this->Depths[Index(point)], 0.0);
      places->GetTuple(point, place + 3 * i);
      place[3 * i + 2] = this->Scale * level[i];
    }
  });
  for (size_t i = 0; i < this->Edges.size(); ++i)
  {
    const Edge& edge = this->Edges[i];
    const vtkIdType at = kept + static_cast<vtkIdType>(i);
    double from[3];
    double to[3];
    places->GetTuple(edge.From, from);
    places->GetTuple(edge.To, to);
    from[2] = this->Levels[Index(edge.From)];
    to[2] = this->Divides.Beds.count(edge.To) ? from[2] : this->Levels[Index(edge.To)];
    water_shore_point(from, to, edge.Share, place + 3 * at);
    level[at] = place[3 * at + 2];
    depth[at] = 0.0;
    place[3 * at + 2] *= this->Scale;
  }
  output->SetPoints(points);
}

//------------------------------------------------------------------------------
void vtkWaterWetPart::AddPolygons(vtkPolyData* output) const
{
  const vtkIdType cut = CountOf(this->CutFrom);
  vtkNew<vtkIdTypeArray> starts;
  vtkNew<vtkIdTypeArray> corners;
  starts->SetNumberOfValues(this->WetCells + cut + 1);
  corners->SetNumberOfValues(this->WetCorners + CountOf(this->CutCorners));
  vtkIdType* start = starts->GetPointer(0);
  vtkIdType* corner = corners->GetPointer(0);
  vtkWaterForEachCell(
    this->Mesh->GetPolys(), [&](vtkIdType cell, const vtkIdType* points, vtkIdType count) {
      if (this->Cells[Index(cell)] == Cell::Wet)
      {
        *start++ = corner - corners->GetPointer(0);
        corner = std::transform(points, points + count, corner,
          [this](vtkIdType point) { return this->PointMap[Index(point)]; });
      }
    });
  std::transform(this->CutStarts.begin(), this->CutStarts.end(), start,
    [this](vtkIdType from) { return this->WetCorners + from; });
  const vtkIdType kept = CountOf(this->Kept);
  std::transform(this->CutCorners.begin(), this->CutCorners.end(), corner,
    [kept](vtkIdType place) { return place < 0 ? kept - 1 - place : place; });
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(starts, corners);
  output->SetPolys(polygons);
}

//------------------------------------------------------------------------------
void vtkWaterWetPart::KeepKnownValues(vtkPointData* from, vtkPointData* to) const
{
  for (int number = 0; number < to->GetNumberOfArrays(); ++number)
  {
    vtkDataArray* made = to->GetArray(number);
    vtkDataArray* given = made && made->GetName() ? from->GetArray(made->GetName()) : nullptr;
    const int type = made ? made->GetDataType() : VTK_VOID;
    if (!given || (type != VTK_FLOAT && type != VTK_DOUBLE))
    {
      continue; // of whole numbers all are known
    }
    for (size_t i = 0; i < this->Edges.size(); ++i)
    {
      const vtkIdType at = CountOf(this->Kept) + static_cast<vtkIdType>(i);
      for (int j = 0; j < made->GetNumberOfComponents(); ++j)
      {
        const double first = given->GetComponent(this->Edges[i].From, j);
        const double second = given->GetComponent(this->Edges[i].To, j);
        if (vtkMath::IsFinite(first) != vtkMath::IsFinite(second))
        {
          made->SetComponent(at, j, vtkMath::IsFinite(first) ? first : second);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterWetPart::KeepMarks(vtkPointData* from, vtkPointData* to) const
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  vtkDataArray* made = to->GetArray(name);
  vtkDataArray* given = from->GetArray(name);
  for (size_t i = 0; made && given && i < this->Edges.size(); ++i)
  {
    made->SetTuple(CountOf(this->Kept) + static_cast<vtkIdType>(i), this->Edges[i].From, given);
  }
}

//------------------------------------------------------------------------------
void vtkWaterWetPart::AddArrays(vtkPolyData* output) const
{
  const vtkIdType kept = CountOf(this->Kept);
  vtkPointData* from = this->Mesh->GetPointData();
  vtkPointData* to = output->GetPointData();
  vtkNew<vtkIdList> ids;
  vtkNew<vtkIdList> places;
  const auto list = [&ids, &places](const std::vector<vtkIdType>& all) {
    ids->SetNumberOfIds(CountOf(all));
    places->SetNumberOfIds(CountOf(all));
    std::copy(all.begin(), all.end(), ids->begin());
    std::iota(places->begin(), places->end(), 0);
  };
  list(this->Kept);
  to->InterpolateAllocate(from, kept + static_cast<vtkIdType>(this->Edges.size()));
  to->CopyData(from, ids, places);
  for (size_t i = 0; i < this->Edges.size(); ++i)
  {
    const Edge& edge = this->Edges[i];
    to->InterpolateEdge(from, kept + static_cast<vtkIdType>(i), edge.From, edge.To, edge.Share);
  }
  this->KeepKnownValues(from, to);
  this->KeepMarks(from, to);
  if (this->Mesh->GetCellData()->GetNumberOfArrays() == 0)
  {
    return;
  }
  std::vector<vtkIdType> cells;
  for (size_t cell = 0; cell < this->Cells.size(); ++cell)
  {
    if (this->Cells[cell] == Cell::Wet)
    {
      cells.push_back(static_cast<vtkIdType>(cell));
    }
  }
  cells.insert(cells.end(), this->CutFrom.begin(), this->CutFrom.end());
  list(cells);
  output->GetCellData()->CopyAllocate(this->Mesh->GetCellData(), CountOf(cells));
  output->GetCellData()->CopyData(this->Mesh->GetCellData(), ids, places);
}
