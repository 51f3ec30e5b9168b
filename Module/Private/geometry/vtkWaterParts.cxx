// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterParts.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkWaterPolygons.h"
#include "water_regions.h"

#include <algorithm>
#include <numeric>

namespace
{
constexpr int64_t kNone = -1;
constexpr size_t kBlockFits = 1 << 14; // more than fit into a processor's cache are not worth it

size_t Index(int64_t number)
{
  return static_cast<size_t>(number);
}
}

//------------------------------------------------------------------------------
void vtkWaterParts::Join(vtkPolyData* mesh)
{
  this->Parents.resize(Index(mesh->GetNumberOfPoints()));
  water_regions_begin(this->Parents.data(), this->Parents.size());
  vtkWaterForEachCell(
    mesh->GetPolys(), [this](vtkIdType, const vtkIdType* points, vtkIdType count) {
      static_assert(sizeof(vtkIdType) == sizeof(int64_t), "VTK's numbers are those of the core");
      water_regions_join(
        this->Parents.data(), reinterpret_cast<const int64_t*>(points), Index(count));
    });
}

//------------------------------------------------------------------------------
void vtkWaterParts::Number(vtkPolyData* mesh)
{
  std::vector<int64_t> partOfPoint(this->Parents.size(), kNone); // of those that stand for a region
  this->PartOfCell.assign(Index(mesh->GetNumberOfPolys()), kNone);
  this->PartCount = 0;
  vtkWaterForEachCell(
    mesh->GetPolys(), [&](vtkIdType cell, const vtkIdType* points, vtkIdType count) {
      if (count < 3)
      {
        return;
      }
      int64_t& part = partOfPoint[Index(water_regions_find(this->Parents.data(), points[0]))];
      part = part == kNone ? static_cast<int64_t>(this->PartCount++) : part;
      this->PartOfCell[Index(cell)] = part;
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
      int64_t& part = this->PartOfCell[Index(cell)];
      if (part == kNone)
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
    const int64_t part = this->PartOfCell[Index(cell)];
    vtkIdType next = cell + 1;
    while (next < end && this->PartOfCell[Index(next)] == part)
    {
      ++next;
    }
    while (part != kNone && cell < next)
    {
      cell += static_cast<vtkIdType>(water_fit_add_polygons(
        points, lists.Starts + cell, lists.Corners, Index(next - cell), &fits[Index(part)]));
      if (cell < next)
      {
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
void vtkWaterParts::Share(vtkPolyData* mesh, size_t most)
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
  double all[6];
  mesh->GetBounds(all);
  this->IsTight = std::equal(bounds, bounds + 6, all);
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
  this->PlaneOfPart.assign(this->Fits.size(), kNone);
  const double rounding = water_fit_tolerance(0.0, coordinate, isSingle);
  for (size_t i = 0; i < parts.size(); ++i)
  {
    Plane& plane = this->Planes[planes[i]];
    this->PlaneOfPart[sorted[i]] = static_cast<int64_t>(planes[i]);
    plane.Fit = parts[first[planes[i]]];
    plane.Area += parts[i].area;
    plane.IsFlat = plane.IsFlat && parts[i].rms <= rounding;
  }
}

//------------------------------------------------------------------------------
void vtkWaterParts::Find(vtkPolyData* mesh, const double up[3], size_t most)
{
  this->Join(mesh);
  this->Number(mesh);
  this->Fit(mesh, up);
  this->Share(mesh, most);
  this->Cells.assign(this->Planes.size(), {});
  this->HasOne = this->Planes.size() == 1 && this->IsTight &&
    std::find(this->PartOfCell.begin(), this->PartOfCell.end(), kNone) == this->PartOfCell.end() &&
    std::find(this->PlaneOfPart.begin(), this->PlaneOfPart.end(), kNone) == this->PlaneOfPart.end();
  if (this->HasOne) // nothing will be extracted
  {
    return;
  }
  for (size_t cell = 0; cell < this->PartOfCell.size(); ++cell)
  {
    const int64_t part = this->PartOfCell[cell];
    if (part != kNone && this->PlaneOfPart[Index(part)] != kNone)
    {
      this->Cells[Index(this->PlaneOfPart[Index(part)])].push_back(static_cast<vtkIdType>(cell));
    }
  }
  this->Extracted.assign(this->Parents.size(), kNone);
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
