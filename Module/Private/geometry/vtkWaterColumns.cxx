// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterColumns.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace
{
double ValueOf(vtkDataArray* array, vtkIdType i)
{
  return array ? array->GetComponent(i, 0) : vtkMath::Nan();
}

// Means of what cells, or points beside them, add to points.
class Means
{
public:
  explicit Means(vtkIdType count)
    : Sums(static_cast<size_t>(count), 0.0)
    , Counts(static_cast<size_t>(count), 0)
  {
  }
  void Add(vtkIdType i, double value)
  {
    if (vtkMath::IsFinite(value))
    {
      this->Sums[static_cast<size_t>(i)] += value;
      ++this->Counts[static_cast<size_t>(i)];
    }
  }
  double Get(vtkIdType i) const
  {
    const int count = this->Counts[static_cast<size_t>(i)];
    return count > 0 ? this->Sums[static_cast<size_t>(i)] / count : vtkMath::Nan();
  }

private:
  std::vector<double> Sums;
  std::vector<int> Counts;
};

template <typename Function>
void ForEachCell(vtkPolyData* mesh, Function function)
{
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const vtkIdType* points = nullptr;
    vtkIdType count = 0;
    mesh->GetCellPoints(cell, count, points);
    function(cell, points, count);
  }
}
}

//------------------------------------------------------------------------------
void vtkWaterColumns::Make(vtkPolyData* mesh, const Given& given)
{
  const auto count = static_cast<size_t>(mesh->GetNumberOfPoints());
  this->Levels.assign(count, vtkMath::Nan());
  this->Beds.assign(count, vtkMath::Nan());
  this->Depths.assign(count, 0.0);
  this->IsWet.assign(count, 0);
  this->IsCellWet.clear();
  this->Dykes.clear();
  this->ReadBeds(mesh, given);
  given.AreOfCells ? this->ReadCells(mesh, given) : this->ReadPoints(mesh, given);
  this->Spread(mesh);
  this->FindDykes(mesh);
  for (size_t i = 0; i < count; ++i)
  {
    this->Depths[i] = water_shore_depth(this->IsWet[i] != 0, this->Levels[i], this->Beds[i]);
  }
  for (size_t i = 0; i < count; ++i)
  {
    const bool isKnown = vtkMath::IsFinite(this->Levels[i]);
    const bool hasBed = vtkMath::IsFinite(this->Beds[i]);
    this->Levels[i] = isKnown ? this->Levels[i] : (hasBed ? this->Beds[i] : 0.0);
  }
}

//------------------------------------------------------------------------------
void vtkWaterColumns::ReadBeds(vtkPolyData* mesh, const Given& given)
{
  Means means(mesh->GetNumberOfPoints());
  if (given.Bed && given.IsBedOfCells)
  {
    ForEachCell(mesh, [&](vtkIdType cell, const vtkIdType* points, vtkIdType count) {
      std::for_each(points, points + count,
        [&](vtkIdType point) { means.Add(point, ValueOf(given.Bed, cell)); });
    });
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double& bed = this->Beds[static_cast<size_t>(i)];
    if (given.Bed)
    {
      bed = given.IsBedOfCells ? means.Get(i) : ValueOf(given.Bed, i);
    }
    else if (!given.Level)
    {
      bed = mesh->GetPoint(i)[2];
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterColumns::ReadPoints(vtkPolyData* mesh, const Given& given)
{
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const auto at = static_cast<size_t>(i);
    const water_column column = water_shore_column(
      ValueOf(given.Level, i), this->Beds[at], ValueOf(given.Depth, i), given.DryDepth);
    this->IsWet[at] = column.is_wet;
    this->Beds[at] = column.bed;
    this->Levels[at] = column.is_wet ? column.level : vtkMath::Nan();
  }
}

//------------------------------------------------------------------------------
void vtkWaterColumns::ReadCells(vtkPolyData* mesh, const Given& given)
{
  Means levels(mesh->GetNumberOfPoints());
  Means beds(mesh->GetNumberOfPoints());
  this->IsCellWet.assign(static_cast<size_t>(mesh->GetNumberOfCells()), 0);
  ForEachCell(mesh, [&](vtkIdType cell, const vtkIdType* points, vtkIdType count) {
    Means own(1);
    std::for_each(points, points + count,
      [&](vtkIdType point) { own.Add(0, this->Beds[static_cast<size_t>(point)]); });
    const double bed = given.IsBedOfCells ? ValueOf(given.Bed, cell) : own.Get(0);
    const water_column column = water_shore_column(
      ValueOf(given.Level, cell), bed, ValueOf(given.Depth, cell), given.DryDepth);
    this->IsCellWet[static_cast<size_t>(cell)] = column.is_wet;
    for (vtkIdType i = 0; i < count; ++i)
    {
      beds.Add(points[i], column.bed);
      if (column.is_wet)
      {
        this->IsWet[static_cast<size_t>(points[i])] = 1;
        levels.Add(points[i], column.level);
      }
    }
  });
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const auto at = static_cast<size_t>(i);
    this->Levels[at] = levels.Get(i);
    this->Beds[at] = vtkMath::IsFinite(this->Beds[at]) ? this->Beds[at] : beds.Get(i);
  }
}

//------------------------------------------------------------------------------
void vtkWaterColumns::Spread(vtkPolyData* mesh)
{
  Means means(mesh->GetNumberOfPoints());
  ForEachCell(mesh, [&](vtkIdType, const vtkIdType* points, vtkIdType count) {
    Means own(1);
    std::for_each(points, points + count,
      [&](vtkIdType point) { own.Add(0, this->Levels[static_cast<size_t>(point)]); });
    std::for_each(points, points + count, [&](vtkIdType point) { means.Add(point, own.Get(0)); });
  });
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double& level = this->Levels[static_cast<size_t>(i)];
    level = vtkMath::IsFinite(level) ? level : means.Get(i);
  }
}

//------------------------------------------------------------------------------
void vtkWaterColumns::FindDykes(vtkPolyData* mesh)
{
  if (this->IsCellWet.empty())
  {
    return;
  }
  ForEachCell(mesh, [&](vtkIdType cell, const vtkIdType* points, vtkIdType count) {
    Means levels(1);
    Means beds(1);
    for (vtkIdType i = 0; i < count; ++i)
    {
      levels.Add(0, this->Levels[static_cast<size_t>(points[i])]);
      beds.Add(0, this->Beds[static_cast<size_t>(points[i])]);
    }
    if (!this->IsCellWet[static_cast<size_t>(cell)] && !(beds.Get(0) >= levels.Get(0)))
    {
      this->Dykes.push_back(cell);
      return;
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      const auto at = static_cast<size_t>(points[i]);
      this->IsWet[at] =
        vtkMath::IsFinite(this->Levels[at]); // up to where its bed reaches the level
    }
  });
}
