// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterParts.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkWaterCellChunks.h"
#include "vtkWaterPolygons.h"
#include "vtkWaterWetPolygons.h"
#include "water_regions.h"

#include <algorithm>
#include <numeric>

namespace
{
constexpr int32_t kNone = -1;
void AddField(
  vtkPolyData* polygons, const char* name, const double* values, int count, size_t rows = 1)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(count);
  array->SetNumberOfTuples(static_cast<vtkIdType>(rows));
  std::copy_n(values, static_cast<size_t>(count) * rows, array->GetPointer(0));
  polygons->GetFieldData()->AddArray(array);
}

// rounding  of the coordinates
void AddPart(
  const water_fit_plane& fit, const double bounds[6], double rounding, vtkWaterParts::Plane* plane)
{
  plane->Area += fit.area;
  plane->IsFlat = plane->IsFlat && fit.rms <= rounding;
  vtkBoundingBox all(plane->Bounds);
  all.AddBounds(bounds);
  all.GetBounds(plane->Bounds);
  plane->PartBounds.emplace_back();
  std::copy_n(bounds, 6, plane->PartBounds.back().begin());
}

constexpr size_t kBlockFits = 1 << 14; // more than fit into a processor's cache are not worth it

size_t Index(int64_t number)
{
  return static_cast<size_t>(number);
}
}

//------------------------------------------------------------------------------
size_t vtkWaterParts::CountChunks() const
{
  return this->Shore ? this->Shore->Chunks->GetCount() : 0;
}

//------------------------------------------------------------------------------
void vtkWaterParts::Join(vtkPolyData* mesh)
{
  const size_t points = Index(mesh->GetNumberOfPoints());
  const size_t chunks = this->CountChunks();
  this->Parents.resize(points + chunks);
  water_regions_begin(this->Parents.data(), this->Parents.size());
  if (chunks == 0)
  {
    this->JoinCells(mesh, 0, mesh->GetNumberOfPolys());
    return;
  }
  static_assert(vtkWaterShoreCells::Dry == 0 && vtkWaterShoreCells::Wet == 1, "as the core has it");
  this->Shore->Chunks->Judge(reinterpret_cast<const char*>(this->Shore->Kinds.data()));
  for (size_t chunk = 0; chunk < chunks; ++chunk)
  {
    const water_chunk_kind kind = this->Shore->Chunks->KindOf(chunk);
    if (kind == WATER_CHUNK_PART || kind == WATER_CHUNK_RIM)
    {
      this->JoinCells(
        mesh, this->Shore->Chunks->BeginOf(chunk), this->Shore->Chunks->BeginOf(chunk + 1));
    }
    if (kind == WATER_CHUNK_RIM) // it is one region, with that of any of its points
    {
      const int64_t same[2] = { static_cast<int64_t>(points + chunk),
        this->Shore->Chunks->FirstPointOf(chunk) };
      water_regions_join(this->Parents.data(), same, 2);
    }
  }
  this->Shore->Chunks->Join(this->Parents.data(), points);
}

//------------------------------------------------------------------------------
void vtkWaterParts::JoinCells(vtkPolyData* mesh, vtkIdType begin, vtkIdType end)
{
  vtkWaterForCells(
    mesh->GetPolys(), begin, end, [this](vtkIdType cell, const vtkIdType* points, vtkIdType count) {
      static_assert(sizeof(vtkIdType) == sizeof(int64_t), "VTK's numbers are those of the core");
      if (this->IsWhole(cell))
      {
        water_regions_join(
          this->Parents.data(), reinterpret_cast<const int64_t*>(points), Index(count));
      }
      else if (this->Shore->Kinds[Index(cell)] == vtkWaterShoreCells::Cut)
      {
        this->JoinCut(points, count);
      }
    });
}

//------------------------------------------------------------------------------
void vtkWaterParts::JoinCut(const vtkIdType* points, vtkIdType count)
{
  vtkWaterForWetParts(this->Shore->Depths, points, count,
    [this](const water_shore_corner* corners, const vtkIdType* own, size_t made) {
      std::vector<int64_t>& joined = this->Joined;
      joined.clear();
      for (size_t i = 0; i < made; ++i)
      {
        joined.push_back(own[corners[i].from]); // of an edge that is its wet end
      }
      water_regions_join(this->Parents.data(), joined.data(), joined.size());
    });
}

//------------------------------------------------------------------------------
int64_t vtkWaterParts::RegionOf(vtkIdType cell, const vtkIdType* points, vtkIdType count)
{
  if (this->IsWhole(cell))
  {
    return water_regions_find(this->Parents.data(), points[0]);
  }
  int64_t region = kNone;
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (this->Shore->Depths[points[i]] > 0.0)
    {
      const int64_t other = water_regions_find(this->Parents.data(), points[i]);
      this->SharedCount += region != kNone && other != region ? 1 : 0;
      region = other;
    }
  }
  return region;
}

//------------------------------------------------------------------------------
void vtkWaterParts::Number(vtkPolyData* mesh)
{
  this->PartOfPoint.assign(this->Parents.size(), kNone);
  this->PartOfCell.resize(Index(mesh->GetNumberOfPolys()));
  this->PartCount = 0;
  this->SharedCount = 0;
  this->UnplacedCount = 0;
  const size_t chunks = this->CountChunks();
  if (chunks == 0)
  {
    this->NumberCells(mesh, 0, mesh->GetNumberOfPolys());
    return;
  }
  const size_t points = Index(mesh->GetNumberOfPoints());
  for (size_t chunk = 0; chunk < chunks; ++chunk) // in the order of cells, as without chunks
  {
    const vtkIdType begin = this->Shore->Chunks->BeginOf(chunk);
    const vtkIdType end = this->Shore->Chunks->BeginOf(chunk + 1);
    if (this->Shore->Chunks->KindOf(chunk) == WATER_CHUNK_PART)
    {
      this->NumberCells(mesh, begin, end);
      continue;
    }
    const int32_t part = this->Shore->Chunks->KindOf(chunk) == WATER_CHUNK_LAND
      ? kNone
      : this->NumberOf(
          water_regions_find(this->Parents.data(), static_cast<int64_t>(points + chunk)));
    std::fill(this->PartOfCell.begin() + begin, this->PartOfCell.begin() + end, part);
  }
}

//------------------------------------------------------------------------------
int32_t vtkWaterParts::NumberOf(int64_t region)
{
  int32_t& part = this->PartOfPoint[Index(region)];
  part = part == kNone ? static_cast<int32_t>(this->PartCount++) : part;
  return part;
}

//------------------------------------------------------------------------------
void vtkWaterParts::NumberCells(vtkPolyData* mesh, vtkIdType begin, vtkIdType end)
{
  vtkWaterForCells(
    mesh->GetPolys(), begin, end, [&](vtkIdType cell, const vtkIdType* points, vtkIdType count) {
      const bool isLand =
        count < 3 || (this->Shore && this->Shore->Kinds[Index(cell)] == vtkWaterShoreCells::Dry);
      this->PartOfCell[Index(cell)] =
        isLand ? kNone : this->NumberOf(this->RegionOf(cell, points, count));
    });
}

//------------------------------------------------------------------------------
void vtkWaterParts::Fit(
  vtkPolyData* mesh, vtkIdType begin, vtkIdType end, std::vector<water_fit>& fits)
{
  const vtkWaterPlaces places(mesh->GetPoints());
  const vtkWaterCellLists lists(mesh->GetPolys());
  if (places.GetDoubles() && lists.Starts)
  {
    this->FitRuns(places.GetDoubles(), lists, begin, end, fits);
    return;
  }
  std::vector<double> corners;
  vtkWaterForCells(
    mesh->GetPolys(), begin, end, [&](vtkIdType cell, const vtkIdType* points, vtkIdType count) {
      int32_t& part = this->PartOfCell[Index(cell)];
      if (part == kNone || !this->IsWhole(cell))
      {
        return;
      }
      corners.resize(3 * Index(count));
      for (vtkIdType i = 0; i < count; ++i)
      {
        places.Get(points[i], &corners[3 * Index(i)]);
      }
      if (!water_fit_add_polygon(corners.data(), Index(count), &fits[Index(part)]))
      {
        ++this->UnplacedCount;
        part = kNone;
      }
    });
}

//------------------------------------------------------------------------------
void vtkWaterParts::FitRuns(const double* points, const vtkWaterCellLists& lists, vtkIdType begin,
  vtkIdType end, std::vector<water_fit>& fits)
{
  for (vtkIdType cell = begin; cell < end;)
  {
    const int32_t part = this->IsWhole(cell) ? this->PartOfCell[Index(cell)] : kNone;
    vtkIdType next = cell + 1;
    while (
      part != kNone && next < end && this->PartOfCell[Index(next)] == part && this->IsWhole(next))
    {
      ++next;
    }
    while (part != kNone && cell < next)
    {
      cell += static_cast<vtkIdType>(water_fit_add_polygons(
        points, lists.Starts + cell, lists.Corners, Index(next - cell), &fits[Index(part)]));
      if (cell < next)
      {
        ++this->UnplacedCount;
        this->PartOfCell[Index(cell++)] = kNone;
      }
    }
    cell = next;
  }
}

//------------------------------------------------------------------------------
void vtkWaterParts::Fit(vtkPolyData* mesh, const double up[3])
{
  water_fit empty;
  water_fit_begin(up, &empty);
  this->Fits.assign(this->PartCount, empty);
  const vtkIdType cells = mesh->GetNumberOfPolys();
  if (Index(vtkWaterBlockCount(cells)) * this->PartCount > kBlockFits)
  {
    this->Fit(mesh, 0, cells, this->Fits);
    return;
  }
  std::vector<std::vector<water_fit>> fits(Index(vtkWaterBlockCount(cells)), this->Fits);
  vtkWaterForBlocks(cells, [&](vtkIdType block, vtkIdType begin, vtkIdType end) {
    this->Fit(mesh, begin, end, fits[Index(block)]);
  });
  for (const std::vector<water_fit>& ofBlock : fits)
  {
    for (size_t part = 0; part < this->PartCount; ++part)
    {
      water_fit_join(&ofBlock[part], &this->Fits[part]);
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterParts::FitCut(vtkPolyData* mesh)
{
  const vtkWaterPlaces places(mesh->GetPoints());
  std::vector<double> corners;
  const auto addPart = [&](int32_t& part, const water_shore_corner* wet, const vtkIdType* own,
                         size_t made) {
    corners.resize(3 * made);
    for (size_t i = 0; i < made; ++i)
    {
      double from[3];
      double to[3];
      places.Get(own[wet[i].from], from);
      places.Get(own[wet[i].to], to);
      water_shore_point(from, to, wet[i].share, &corners[3 * i]);
    }
    if (part != kNone && !water_fit_add_polygon(corners.data(), made, &this->Fits[Index(part)]))
    {
      ++this->UnplacedCount;
      part = kNone;
    }
  };
  for (vtkIdType cell : this->Shore->CutCells)
  {
    vtkWaterForCells(
      mesh->GetPolys(), cell, cell + 1, [&](vtkIdType, const vtkIdType* points, vtkIdType count) {
        int32_t& part = this->PartOfCell[Index(cell)];
        vtkWaterForWetParts(this->Shore->Depths, points, count,
          [&](const water_shore_corner* wet, const vtkIdType* own, size_t made) {
            addPart(part, wet, own, made);
          });
      });
  }
}

//------------------------------------------------------------------------------
int64_t vtkWaterParts::PlaneOf(vtkIdType cell) const
{
  const int32_t part = this->PartOfCell[Index(cell)];
  return part == kNone ? kNone : this->PlaneOfPart[Index(part)];
}

//------------------------------------------------------------------------------
void vtkWaterParts::Describe(size_t plane, vtkPolyData* polygons) const
{
  const Plane& found = this->Planes[plane];
  AddField(polygons, "WaterPlaneOrigin", found.Fit.origin, 3);
  AddField(polygons, "WaterPlaneNormal", found.Fit.normal, 3);
  AddField(polygons, "WaterArea", &found.Area, 1);
  AddField(
    polygons, "WaterPartBounds", found.PartBounds.front().data(), 6, found.PartBounds.size());
  const double isRest = found.IsRest ? 1.0 : 0.0;
  AddField(polygons, "WaterIsRest", &isRest, 1);
}

//------------------------------------------------------------------------------
void vtkWaterParts::Share(vtkPolyData* mesh, const double up[3], size_t most)
{
  std::vector<water_fit_plane> found(this->Fits.size());
  std::vector<size_t> sorted;
  for (size_t i = 0; i < this->Fits.size(); ++i)
  {
    if (water_fit_judge(&this->Fits[i], &found[i]) == WATER_OK)
    {
      sorted.push_back(i);
    }
  }
  std::stable_sort(sorted.begin(), sorted.end(),
    [&found](size_t a, size_t b) { return found[a].area > found[b].area; });
  std::vector<water_fit_plane> parts(sorted.size());
  std::transform(
    sorted.begin(), sorted.end(), parts.begin(), [&found](size_t i) { return found[i]; });
  vtkBoundingBox box; // without points that no polygon has, or that are not finite
  for (size_t i : sorted)
  {
    box.AddBounds(this->Fits[i].bounds);
  }
  double bounds[6] = {};
  if (box.IsValid())
  {
    box.GetBounds(bounds);
  }
  this->IsTight = true; // land does not matter
  if (!this->Shore)
  {
    double all[6];
    mesh->GetBounds(all);
    this->IsTight = std::equal(bounds, bounds + 6, all);
  }
  const double coordinate =
    std::accumulate(bounds, bounds + 6, 0.0, [](double largest, double bound) {
      return std::max({ largest, bound, -bound });
    });
  const bool isSingle = mesh->GetPoints()->GetDataType() != VTK_DOUBLE;
  std::vector<size_t> planes(parts.size());
  std::vector<size_t> first(std::min(parts.size(), most));
  const size_t count = water_fit_share(parts.data(), parts.size(),
    water_fit_tolerance(box.IsValid() ? box.GetDiagonalLength() : 0.0, coordinate, isSingle), most,
    planes.data(), first.data());
  this->Planes.assign(count, Plane());
  water_fit_plane rest;
  if (water_fit_rest(parts.data(), parts.size(), planes.data(), count, up, &rest))
  {
    this->Planes.emplace_back();
    this->Planes.back().Fit = rest;
    this->Planes.back().IsRest = true;
  }
  this->PlaneOfPart.assign(this->Fits.size(), kNone);
  const double rounding = water_fit_tolerance(0.0, coordinate, isSingle);
  for (size_t i = 0; i < parts.size(); ++i)
  {
    Plane& plane = this->Planes[planes[i]];
    this->PlaneOfPart[sorted[i]] = static_cast<int64_t>(planes[i]);
    plane.Fit = plane.IsRest ? rest : parts[first[planes[i]]];
    AddPart(parts[i], this->Fits[sorted[i]].bounds, rounding, &plane);
  }
}

//------------------------------------------------------------------------------
void vtkWaterParts::Find(
  vtkPolyData* mesh, const double up[3], size_t most, const vtkWaterShoreCells* shore)
{
  this->Shore = shore;
  this->Join(mesh);
  this->Number(mesh);
  this->Fit(mesh, up);
  if (shore)
  {
    this->FitCut(mesh);
  }
  this->Share(mesh, up, most);
  this->Cells.assign(this->Planes.size(), {});
  this->HasOne = this->Planes.size() == 1 && this->IsTight && this->UnplacedCount == 0 &&
    std::find(this->PlaneOfPart.begin(), this->PlaneOfPart.end(), kNone) == this->PlaneOfPart.end();
  if (this->HasOne) // nothing will be extracted
  {
    return;
  }
  for (size_t cell = 0; cell < this->PartOfCell.size(); ++cell)
  {
    const int32_t part = this->PartOfCell[cell];
    if (part != kNone && this->PlaneOfPart[Index(part)] != kNone)
    {
      this->Cells[Index(this->PlaneOfPart[Index(part)])].push_back(static_cast<vtkIdType>(cell));
    }
  }
  this->Extracted.assign(Index(mesh->GetNumberOfPoints()), kNone);
}

//------------------------------------------------------------------------------
bool vtkWaterParts::HasAll(size_t plane) const
{
  return this->HasOne || (this->IsTight && this->Cells[plane].size() == this->PartOfCell.size());
}

//------------------------------------------------------------------------------
void vtkWaterParts::Extract(vtkPolyData* mesh, size_t plane, vtkPolyData* extracted)
{
  const std::vector<vtkIdType>& cells = this->Cells[plane];
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkIdList> corners;
  vtkNew<vtkIdList> kept; // points
  points->SetDataType(mesh->GetPoints()->GetDataType());
  extracted->GetCellData()->CopyAllocate(mesh->GetCellData(), static_cast<vtkIdType>(cells.size()));
  vtkIdType number = 0;
  for (vtkIdType cell : cells)
  {
    mesh->GetPolys()->GetCellAtId(cell, corners);
    polygons->InsertNextCell(static_cast<int>(corners->GetNumberOfIds()));
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      const vtkIdType point = corners->GetId(i);
      vtkIdType& place = this->Extracted[Index(point)];
      if (place == kNone)
      {
        place = points->InsertNextPoint(mesh->GetPoint(point));
        kept->InsertNextId(point);
      }
      polygons->InsertCellPoint(place);
    }
    extracted->GetCellData()->CopyData(mesh->GetCellData(), cell, number++);
  }
  extracted->SetPoints(points);
  extracted->SetPolys(polygons);
  extracted->GetPointData()->CopyAllocate(mesh->GetPointData(), kept->GetNumberOfIds());
  for (vtkIdType i = 0; i < kept->GetNumberOfIds(); ++i)
  {
    extracted->GetPointData()->CopyData(mesh->GetPointData(), kept->GetId(i), i);
    this->Extracted[Index(kept->GetId(i))] = kNone;
  }
  extracted->GetFieldData()->PassData(mesh->GetFieldData());
}
