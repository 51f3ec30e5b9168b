// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterColumns.h"

#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkWaterPolygons.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <unordered_map>

namespace
{
// The values of an array; NaN if there is no array.
class Values
{
public:
  explicit Values(vtkDataArray* array)
    : Array(array)
  {
    auto* doubles = vtkArrayDownCast<vtkDoubleArray>(array);
    this->Doubles = doubles ? doubles->GetPointer(0) : nullptr;
  }

  double operator[](vtkIdType i) const
  {
    if (this->Doubles) // without a virtual call
    {
      return this->Doubles[i];
    }
    return this->Array ? this->Array->GetComponent(i, 0) : vtkMath::Nan();
  }

  // Are they doubles, or not there?
  bool AreRows() const { return this->Doubles || !this->Array; }
  const double* GetRows(vtkIdType begin) const
  {
    return this->Doubles ? this->Doubles + begin : nullptr;
  }

private:
  vtkDataArray* Array;
  const double* Doubles;
};

// The mean of finite numbers.
class Mean
{
public:
  void Add(double value)
  {
    const bool counts = vtkMath::IsFinite(value);
    this->Sum += counts ? value : 0.0;
    this->Count += counts ? 1 : 0;
  }
  double Get() const { return this->Count > 0 ? this->Sum / this->Count : vtkMath::Nan(); }

private:
  double Sum = 0.0;
  int Count = 0;
};

// The range of numbers.
class Range
{
public:
  Range() = default;
  explicit Range(double value)
    : Lowest(value)
    , Highest(value)
  {
  }
  void Add(const Range& other)
  {
    this->Lowest = std::min(this->Lowest, other.Lowest);
    this->Highest = std::max(this->Highest, other.Highest);
  }
  bool IsApart(double dryDepth) const
  {
    return water_shore_are_apart(this->Lowest, this->Highest, dryDepth);
  }
  bool IsOfLakes(double dryDepth) const
  {
    return water_shore_are_of_lakes(this->Lowest, this->Highest, dryDepth);
  }

private:
  double Lowest = std::numeric_limits<double>::infinity(); // of none
  double Highest = -std::numeric_limits<double>::infinity();
};

// One for each point of a mesh.
std::vector<Mean> MeansOf(vtkPolyData* mesh)
{
  return std::vector<Mean>(static_cast<size_t>(mesh->GetNumberOfPoints()));
}

// Calls function(point) for every point, in several threads.
template <typename Function>
void ForEachPoint(vtkPolyData* mesh, Function function)
{
  vtkSMPTools::For(0, mesh->GetNumberOfPoints(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType point = begin; point < end; ++point)
    {
      function(point);
    }
  });
}
}

//------------------------------------------------------------------------------
void vtkWaterColumns::Make(vtkPolyData* mesh, const Given& given)
{
  const auto count = static_cast<size_t>(mesh->GetNumberOfPoints());
  this->LevelArray = nullptr; // its memory may be free then
  this->DepthArray = nullptr;
  this->LevelArray = this->KeptLevels.Take(LevelName, 1, mesh->GetNumberOfPoints());
  this->DepthArray = this->KeptDepths.Take(DepthName, 1, mesh->GetNumberOfPoints());
  this->Levels = this->LevelArray->GetPointer(0);
  this->Depths = this->DepthArray->GetPointer(0);
  this->Chunks.Update(mesh);
  this->AreDepthsKnown = given.Depth || given.Bed;
  this->Beds.resize(count);
  this->IsWet.resize(count);
  this->IsCellWet.clear();
  this->Dykes.clear();
  this->Divides.Clear();
  this->DryDepth = given.DryDepth;
  this->AreCellsKnown = false;
  this->Faces = {};
  if (given.AreOfCells || (given.Bed && given.IsBedOfCells))
  {
    this->ReadBeds(mesh, given);
  }
  if (!given.AreOfCells)
  {
    this->MakeOfPoints(mesh, given);
    return;
  }
  std::fill_n(this->Levels, count, vtkMath::Nan());
  std::fill(this->IsWet.begin(), this->IsWet.end(), 0);
  this->ReadCells(mesh, given);
  this->Spread(mesh);
  this->FindDykes(mesh);
  ForEachPoint(mesh, [this](vtkIdType point) { this->Finish(point); });
}

//------------------------------------------------------------------------------
void vtkWaterColumns::Finish(vtkIdType point)
{
  const auto i = static_cast<size_t>(point);
  this->Depths[i] = water_shore_depth(this->IsWet[i] != 0, this->Levels[i], this->Beds[i]);
  this->Levels[i] = water_shore_level(this->Levels[i], this->Beds[i]);
}

//------------------------------------------------------------------------------
void vtkWaterColumns::MakeOfPoints(vtkPolyData* mesh, const Given& given)
{
  const Values levels(given.Level);
  const Values depths(given.Depth);
  const bool isBedHere = given.IsBedOfCells && given.Bed; // of cells, it has been read
  const Values beds(isBedHere ? nullptr : given.Bed);
  vtkDataArray* places = mesh->GetPoints()->GetData(); // thread-safe, unlike its GetPoint
  const bool isBedOfPlaces = !given.Bed && !given.Level;
  const bool areRows = levels.AreRows() && depths.AreRows() && beds.AreRows() && !isBedOfPlaces;
  std::atomic<bool> isOdd{ false }; // a wet point has no water by level and bed
  const auto make = [&](const double* level, const double* bed, const double* depth, vtkIdType i,
                      vtkIdType count) {
    const auto at = static_cast<size_t>(i);
    const water_shore_rows rows = { level, bed, depth, this->Levels + i, this->Depths + i,
      &this->Beds[at], &this->IsWet[at] };
    return water_shore_columns(&rows, static_cast<size_t>(count), given.DryDepth);
  };
  vtkSMPTools::For(0, mesh->GetNumberOfPoints(), [&](vtkIdType begin, vtkIdType end) {
    bool isOddHere = false;
    const double* bedRows = isBedHere ? this->Beds.data() + begin : beds.GetRows(begin);
    if (areRows)
    {
      isOddHere = make(levels.GetRows(begin), bedRows, depths.GetRows(begin), begin, end - begin);
    }
    for (vtkIdType i = begin; i < end && !areRows; ++i)
    {
      const double level = levels[i];
      const double depth = depths[i];
      const double bed = isBedHere ? this->Beds[static_cast<size_t>(i)]
        : isBedOfPlaces            ? places->GetComponent(i, 2)
                                   : beds[i];
      isOddHere = make(given.Level ? &level : nullptr, given.Bed || isBedOfPlaces ? &bed : nullptr,
                    given.Depth ? &depth : nullptr, i, 1) ||
        isOddHere;
    }
    if (isOddHere)
    {
      isOdd = true;
    }
  });
  if (isOdd)
  {
    this->Spread(mesh);
  }
  else // the cells with wet and dry points are those that the shore cuts: one walk finds both
  {
    this->Cells.Classify(mesh->GetPolys(), this->Depths, &this->Chunks);
    this->AreCellsKnown = true;
    this->SpreadOver(mesh, { this->Cells.CutCells });
  }
}

//------------------------------------------------------------------------------
void vtkWaterColumns::ShareCells(vtkCellArray* polygons, vtkWaterShoreCells& cells)
{
  if (this->AreCellsKnown)
  {
    cells = this->Cells;
  }
  else
  {
    cells.Classify(polygons, this->Depths, &this->Chunks);
  }
}

//------------------------------------------------------------------------------
void vtkWaterColumns::ReadBeds(vtkPolyData* mesh, const Given& given)
{
  if (given.Bed && given.IsBedOfCells)
  {
    std::vector<Mean> means = MeansOf(mesh);
    const Values bedsOfCells(given.Bed);
    vtkWaterForEachCell(
      mesh->GetPolys(), [&](vtkIdType cell, const vtkIdType* points, vtkIdType count) {
        std::for_each(points, points + count, [&](vtkIdType point) {
          means[static_cast<size_t>(point)].Add(water_shore_known(bedsOfCells[cell]));
        });
      });
    std::transform(
      means.begin(), means.end(), this->Beds.begin(), [](const Mean& mean) { return mean.Get(); });
    return;
  }
  const Values beds(given.Bed);
  vtkDataArray* places = mesh->GetPoints()->GetData(); // thread-safe, unlike its GetPoint
  ForEachPoint(mesh, [&](vtkIdType i) {
    double& bed = this->Beds[static_cast<size_t>(i)];
    bed = given.Bed ? beds[i] : given.Level ? vtkMath::Nan() : places->GetComponent(i, 2);
  });
}

//------------------------------------------------------------------------------
void vtkWaterColumns::ReadCells(vtkPolyData* mesh, const Given& given)
{
  const Values givenLevels(given.Level);
  const Values givenDepths(given.Depth);
  const Values givenBeds(given.Bed);
  std::vector<Mean> levels = MeansOf(mesh);
  std::vector<Mean> beds = MeansOf(mesh);
  const bool areLevelsInDoubt = given.Level && given.Bed && !given.Depth && !given.IsBedOfCells;
  std::vector<double> corners;
  this->IsCellWet.assign(static_cast<size_t>(mesh->GetNumberOfCells()), 0);
  this->CellBeds.resize(this->IsCellWet.size());
  vtkWaterForEachCell(
    mesh->GetPolys(), [&](vtkIdType cell, const vtkIdType* points, vtkIdType count) {
      Mean own;
      std::for_each(points, points + count, [&](vtkIdType point) {
        own.Add(water_shore_known(this->Beds[static_cast<size_t>(point)]));
      });
      const double bed = given.IsBedOfCells ? givenBeds[cell] : own.Get();
      const bool hasBed = given.Bed || !given.Level;
      const water_column column =
        water_shore_column(given.Level ? water_shore_given(givenLevels[cell]) : vtkMath::Nan(),
          hasBed ? water_shore_given(bed) : vtkMath::Nan(),
          given.Depth ? water_shore_given(givenDepths[cell]) : vtkMath::Nan(), given.DryDepth);
      this->IsCellWet[static_cast<size_t>(cell)] = column.is_wet;
      this->CellBeds[static_cast<size_t>(cell)] = water_shore_known(column.bed);
      if (areLevelsInDoubt)
      {
        corners.clear();
        std::for_each(points, points + count,
          [&](vtkIdType point) { corners.push_back(this->Beds[static_cast<size_t>(point)]); });
        water_heights_add_face(
          givenLevels[cell], corners.data(), corners.size(), given.DryDepth, &this->Faces);
      }
      for (vtkIdType i = 0; i < count; ++i)
      {
        beds[static_cast<size_t>(points[i])].Add(water_shore_known(column.bed));
        if (column.is_wet)
        {
          this->IsWet[static_cast<size_t>(points[i])] = 1;
          levels[static_cast<size_t>(points[i])].Add(column.level);
        }
      }
    });
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const auto at = static_cast<size_t>(i);
    this->Levels[at] = levels[at].Get();
    this->Beds[at] = vtkMath::IsFinite(this->Beds[at]) ? this->Beds[at] : beds[at].Get();
  }
}

//------------------------------------------------------------------------------
void vtkWaterColumns::Spread(vtkPolyData* mesh)
{
  vtkCellArray* cells = mesh->GetPolys();
  std::vector<std::vector<vtkIdType>> shores( // cells with wet and dry points, of each block
    static_cast<size_t>(vtkWaterBlockCount(cells->GetNumberOfCells())));
  vtkWaterForBlocks(
    cells->GetNumberOfCells(), [&](vtkIdType block, vtkIdType begin, vtkIdType end) {
      std::vector<vtkIdType>& found = shores[static_cast<size_t>(block)];
      vtkWaterForCells(
        cells, begin, end, [&](vtkIdType cell, const vtkIdType* points, vtkIdType count) {
          const auto dry = std::count_if(points, points + count,
            [this](vtkIdType point) { return !this->IsWet[static_cast<size_t>(point)]; });
          if (dry > 0 && dry < count)
          {
            found.push_back(cell);
          }
        });
    });
  this->SpreadOver(mesh, shores);
}

//------------------------------------------------------------------------------
void vtkWaterColumns::SpreadOver(
  vtkPolyData* mesh, const std::vector<std::vector<vtkIdType>>& shores)
{
  std::unordered_map<vtkIdType, Mean> means; // of the points beside the water: few
  size_t even = 0;                           // sides of cells with two wet points at one level
  size_t uneven = 0;                         // those at different levels
  const auto add = [&](vtkIdType, const vtkIdType* points, vtkIdType count) {
    Mean own;
    const auto isWet = [this](
                         vtkIdType point) { return this->IsWet[static_cast<size_t>(point)] != 0; };
    for (vtkIdType i = 0; i < count; ++i)
    {
      const vtkIdType next = points[(i + 1) % count];
      own.Add(isWet(points[i]) ? this->Levels[points[i]] : vtkMath::Nan());
      if (isWet(points[i]) && isWet(next))
      {
        ++(water_shore_are_apart(this->Levels[points[i]], this->Levels[next], this->DryDepth)
            ? uneven
            : even);
      }
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (!isWet(points[i]))
      {
        means[points[i]].Add(own.Get());
      }
    }
  };
  for (const std::vector<vtkIdType>& ofBlock : shores)
  {
    for (vtkIdType cell : ofBlock)
    {
      vtkWaterForCells(mesh->GetPolys(), cell, cell + 1, add);
    }
  }
  for (const auto& [point, mean] : means)
  {
    this->Levels[point] = mean.Get();
    this->Finish(point);
  }
  if (this->IsCellWet.empty() && water_shore_are_lakes(even, uneven))
  {
    this->FindDivides(mesh, shores);
  }
}

//------------------------------------------------------------------------------
void vtkWaterColumns::FindDivides(
  vtkPolyData* mesh, const std::vector<std::vector<vtkIdType>>& shores)
{
  std::unordered_map<vtkIdType, Range> beside; // the levels beside a dry point
  const auto isWet = [this](
                       vtkIdType point) { return this->IsWet[static_cast<size_t>(point)] != 0; };
  const auto add = [&](vtkIdType cell, const vtkIdType* points, vtkIdType count) {
    Range own;
    for (vtkIdType i = 0; i < count; ++i)
    {
      own.Add(isWet(points[i]) ? Range(this->Levels[points[i]]) : Range());
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (!isWet(points[i]))
      {
        beside[points[i]].Add(own);
      }
    }
    if (own.IsOfLakes(this->DryDepth))
    {
      this->Divides.Cells.insert(cell);
    }
  };
  for (const std::vector<vtkIdType>& ofBlock : shores)
  {
    for (vtkIdType cell : ofBlock)
    {
      vtkWaterForCells(mesh->GetPolys(), cell, cell + 1, add);
    }
  }
  for (const auto& [point, levels] : beside)
  {
    if (levels.IsOfLakes(this->DryDepth))
    {
      const double bed = this->Beds[static_cast<size_t>(point)];
      this->Divides.Beds[point] = bed;
      this->Depths[point] = water_shore_depth(false, vtkMath::Nan(), bed);
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterColumns::FindDykes(vtkPolyData* mesh)
{
  if (this->IsCellWet.empty())
  {
    return;
  }
  std::vector<double> levels;
  std::vector<double> beds;
  std::vector<vtkIdType> between;                  // dry cells with corners at different levels
  std::vector<char> areUneven(this->IsWet.size()); // points of cells with water that is not level
  vtkWaterForEachCell(
    mesh->GetPolys(), [&](vtkIdType cell, const vtkIdType* points, vtkIdType count) {
      const bool isWet = this->IsCellWet[static_cast<size_t>(cell)] != 0;
      levels.clear();
      beds.clear();
      Range own;
      for (vtkIdType i = 0; i < count; ++i)
      {
        const double level = this->Levels[static_cast<size_t>(points[i])];
        levels.push_back(level);
        beds.push_back(this->Beds[static_cast<size_t>(points[i])]);
        own.Add(vtkMath::IsFinite(level) ? Range(level) : Range());
      }
      if (isWet && own.IsApart(this->DryDepth))
      {
        std::for_each(points, points + count,
          [&areUneven](vtkIdType point) { areUneven[static_cast<size_t>(point)] = 1; });
      }
      if (!isWet &&
        water_shore_is_dyke(this->CellBeds[static_cast<size_t>(cell)], levels.data(), beds.data(),
          levels.size(), this->DryDepth))
      {
        this->Dykes.push_back(cell);
      }
      else if (!isWet && own.IsOfLakes(this->DryDepth))
      {
        between.push_back(cell);
      }
      else
      {
        this->Fill(points, count);
      }
    });
  this->DivideLakes(mesh, between, areUneven);
}

//------------------------------------------------------------------------------
void vtkWaterColumns::Fill(const vtkIdType* points, vtkIdType count)
{
  std::for_each(points, points + count, [this](vtkIdType point) {
    const auto at = static_cast<size_t>(point);
    this->IsWet[at] = vtkMath::IsFinite(this->Levels[at]);
  });
}

//------------------------------------------------------------------------------
void vtkWaterColumns::DivideLakes(
  vtkPolyData* mesh, const std::vector<vtkIdType>& between, const std::vector<char>& areUneven)
{
  const auto divide = [&](vtkIdType cell, const vtkIdType* points, vtkIdType count) {
    const bool isAtRiver = std::any_of(points, points + count,
      [&areUneven](vtkIdType point) { return areUneven[static_cast<size_t>(point)] != 0; });
    if (isAtRiver)
    {
      this->Fill(points, count);
    }
    else
    {
      this->Dykes.push_back(cell);
    }
  };
  for (vtkIdType cell : between)
  {
    vtkWaterForCells(mesh->GetPolys(), cell, cell + 1, divide);
  }
}
