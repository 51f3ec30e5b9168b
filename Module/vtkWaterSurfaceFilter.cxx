// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSurfaceFilter.h"

#include "vtkCellData.h"
#include "vtkCellTypes.h"
#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWaterColumns.h"
#include "vtkWaterCompat.h"
#include "vtkWaterGridPolygons.h"
#include "vtkWaterPolygons.h"
#include "vtkWaterWetPart.h"
#include "water_heights.h"
#include "water_placement.h"
#include "water_shore.h"

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkWaterSurfaceFilter);

namespace
{
constexpr const char* kLevel = vtkWaterColumns::LevelName;
constexpr const char* kDepth = vtkWaterColumns::DepthName;
constexpr vtkIdType kSample = 4096; // places whose heights are compared

// Names of all numeric arrays, for an error.
std::string NamesOf(vtkDataSet* data)
{
  std::string names;
  for (vtkDataSetAttributes* arrays :
    std::array<vtkDataSetAttributes*, 2>{ data->GetPointData(), data->GetCellData() })
  {
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      const char* name = arrays->GetArrayName(i);
      if (!arrays->GetArray(i)) // texts
      {
        continue;
      }
      names += (names.empty() ? "" : ", ") + std::string(name ? name : "(no name)") +
        (arrays == data->GetCellData() ? " (cells)" : " (points)");
    }
  }
  return names.empty() ? "none" : names;
}

// Of points, or else of cells.
//
// Returns what is wrong with it; empty: nothing, also if the name is.
std::string Find(vtkDataSet* data, const std::string& name, vtkDataArray*& array, bool& isOfCells)
{
  if (name.empty())
  {
    return std::string();
  }
  array = data->GetPointData()->GetArray(name.c_str());
  isOfCells = !array;
  array = array ? array : data->GetCellData()->GetArray(name.c_str());
  if (!array)
  {
    return "there is no numeric array '" + name + "'; the numeric arrays are: " + NamesOf(data);
  }
  const int components = array->GetNumberOfComponents();
  const vtkIdType wanted = isOfCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  std::string wrong;
  if (components != 1)
  {
    wrong = std::to_string(components) + " components; it must have 1";
  }
  else if (array->GetNumberOfTuples() != wanted)
  {
    wrong = std::to_string(array->GetNumberOfTuples()) + " values; the mesh has " +
      std::to_string(wanted) + (isOfCells ? " cells" : " points");
  }
  return wrong.empty() ? wrong : "the array '" + name + "' has " + wrong;
}

// Returns what is wrong with the arrays together; empty: nothing.
std::string FindAll(vtkDataSet* data, const std::string& level, const std::string& depth,
  const std::string& bed, vtkWaterColumns::Given& given)
{
  bool isLevelOfCells = false;
  bool isDepthOfCells = false;
  std::string wrong = Find(data, level, given.Level, isLevelOfCells);
  wrong = wrong.empty() ? Find(data, depth, given.Depth, isDepthOfCells) : wrong;
  wrong = wrong.empty() ? Find(data, bed, given.Bed, given.IsBedOfCells) : wrong;
  given.AreOfCells = isLevelOfCells || isDepthOfCells;
  if (wrong.empty() && !given.Level && !given.Depth)
  {
    return "neither LevelArrayName nor DepthArrayName is set; the numeric arrays are: " +
      NamesOf(data);
  }
  if (wrong.empty() && given.Level && given.Depth && isLevelOfCells != isDepthOfCells)
  {
    return "the arrays '" + level + "' and '" + depth +
      "' must both be of points, or both of cells";
  }
  return wrong;
}

// The most dimensions that a cell has.
int DimensionOf(vtkDataSet* data)
{
  if (auto* mesh = vtkPolyData::SafeDownCast(data)) // asking that by cells would make it build them
  {
    return mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0 ? 2 : 1;
  }
  vtkNew<vtkCellTypes> types;
  vtkNew<vtkGenericCell> cell;
  data->GetCellTypes(types);
  int most = 0;
  for (vtkIdType i = 0; i < types->GetNumberOfTypes(); ++i)
  {
    cell->SetCellType(types->GetCellType(i));
    most = std::max(most, cell->GetCellDimension());
  }
  return most;
}

// What tells whether a data set's cells are those that were looked at before.
std::array<vtkMTimeType, 5> CellsOf(vtkDataSet* data)
{
  auto* mesh = vtkPolyData::SafeDownCast(data);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  vtkCellArray* polygons = grid ? grid->GetCells() : mesh ? mesh->GetPolys() : nullptr;
  if (!polygons || data->GetNumberOfCells() != polygons->GetNumberOfCells())
  {
    return {}; // not known
  }
  return { 1, reinterpret_cast<vtkMTimeType>(polygons), vtkWaterCellsTime(polygons),
    static_cast<vtkMTimeType>(polygons->GetNumberOfConnectivityIds()),
    static_cast<vtkMTimeType>(data->GetNumberOfPoints()) };
}

// Some values of an array, of places all over the mesh, without fill values; empty: there is no
// array.
std::vector<double> SampleOf(vtkDataArray* array)
{
  std::vector<double> values;
  const vtkIdType count = array ? array->GetNumberOfTuples() : 0;
  const vtkIdType step = std::max<vtkIdType>(count / kSample, 1);
  for (vtkIdType i = 0; i < count; i += step)
  {
    values.push_back(water_shore_known(array->GetComponent(i, 0)));
  }
  return values;
}

std::string RangeOf(const std::string& name, vtkDataArray* array)
{
  double range[2];
  array->GetFiniteRange(range);
  std::ostringstream text;
  text << "'" << name << "' is " << range[0] << " to " << range[1];
  return text.str();
}

// Is a number above 0? Mostly one of a few is, so that no array need be read for its range.
bool HasDepth(vtkDataArray* depth)
{
  const auto isWet = [](double value) { return vtkMath::IsFinite(value) && value > 0.0; };
  const std::vector<double> few = SampleOf(depth);
  if (std::any_of(few.begin(), few.end(), isWet))
  {
    return true;
  }
  const vtkIdType count = depth->GetNumberOfTuples();
  vtkIdType i = 0;
  while (i < count && !isWet(depth->GetComponent(i, 0)))
  {
    ++i;
  }
  return i < count;
}

double MeanHeightOf(vtkPolyData* surface)
{
  const water_plane ground = { { 0.0, 0.0, 1.0 }, 0.0 };
  water_placement placement;
  water_placement_begin(&ground, &placement);
  vtkWaterForEachCell(
    surface->GetPolys(), [&](vtkIdType, const vtkIdType* points, vtkIdType count) {
      double corners[3][3];
      for (vtkIdType i = 2; i < count; ++i)
      {
        surface->GetPoint(points[0], corners[0]);
        surface->GetPoint(points[i - 1], corners[1]);
        surface->GetPoint(points[i], corners[2]);
        water_placement_add(corners[0], corners[1], corners[2], &placement);
      }
    });
  return water_placement_judge(&placement).height;
}
}

//------------------------------------------------------------------------------
vtkWaterSurfaceFilter::vtkWaterSurfaceFilter()
  : Polygons(std::make_unique<vtkWaterGridPolygons>())
{
}

//------------------------------------------------------------------------------
vtkWaterSurfaceFilter::~vtkWaterSurfaceFilter() = default;

//------------------------------------------------------------------------------
void vtkWaterSurfaceFilter::SetName(std::string& member, const std::string& name)
{
  if (member != name)
  {
    member = name;
    this->AreUnitsTold = false;
    this->IsSignTold = false;
    this->IsLandTold = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceFilter::SetLevelArrayName(const std::string& name)
{
  this->SetName(this->LevelArrayName, name);
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceFilter::SetDepthArrayName(const std::string& name)
{
  this->SetName(this->DepthArrayName, name);
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceFilter::SetBedArrayName(const std::string& name)
{
  this->SetName(this->BedArrayName, name);
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceFilter::SetDryDepth(double depth)
{
  vtkWaterSetInRange(DryDepth, depth, 0.0, std::numeric_limits<double>::max());
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceFilter::SetVerticalScale(double scale)
{
  vtkWaterSetInRange(
    VerticalScale, scale, std::numeric_limits<double>::min(), std::numeric_limits<double>::max());
}

//------------------------------------------------------------------------------
double vtkWaterSurfaceFilter::GetMeanLevel()
{
  if (this->IsCutMissing) // the step was drawn, and cut there
  {
    this->IsCutMissing = false;
    this->Update();
  }
  return this->GetMeanOfUpdate();
}

//------------------------------------------------------------------------------
double vtkWaterSurfaceFilter::GetMeanOfUpdate()
{
  if (!this->IsMeanKnown) // asked by few, and it takes a walk over all polygons
  {
    this->MeanLevel = MeanHeightOf(this->Surface);
    this->Surface->Initialize();
    this->IsMeanKnown = true;
  }
  return this->MeanLevel;
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceFilter::CheckUnits(vtkDataArray* level, vtkDataArray* depth, vtkDataArray* bed)
{
  vtkDataArray* other = level ? level : depth;
  const vtkIdType count = other && bed ? other->GetNumberOfTuples() : 0;
  if (this->AreUnitsTold || count == 0 || bed->GetNumberOfTuples() != count)
  {
    return; // without two of the same places nothing is known
  }
  const std::vector<double> levels = SampleOf(level);
  const std::vector<double> depths = SampleOf(depth);
  const std::vector<double> beds = SampleOf(bed);
  const water_heights_verdict verdict =
    water_heights_judge(levels.empty() ? nullptr : levels.data(),
      depths.empty() ? nullptr : depths.data(), beds.data(), beds.size());
  if (verdict.wrong == WATER_HEIGHT_NONE)
  {
    if (level && depth)
    {
      this->CheckSum(levels, depths, beds);
    }
    return;
  }
  this->AreUnitsTold = true;
  const std::string& name = verdict.wrong == WATER_HEIGHT_LEVEL ? this->LevelArrayName
    : verdict.wrong == WATER_HEIGHT_DEPTH                       ? this->DepthArrayName
                                                                : this->BedArrayName;
  std::ostringstream factor;
  if (verdict.factor > 0.0)
  {
    factor << " (its values are " << verdict.factor << " times as large as the others imply)";
  }
  vtkWarningMacro("the array '" << name << "' seems to differ in unit from the other heights"
                                << factor.str() << ": "
                                << (level ? RangeOf(this->LevelArrayName, level) + ", " : "")
                                << RangeOf(this->BedArrayName, bed)
                                << (depth ? ", " + RangeOf(this->DepthArrayName, depth) : "")
                                << ". Level, depth and bed must have one unit; convert them.");
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceFilter::CheckSum(const std::vector<double>& levels,
  const std::vector<double>& depths, const std::vector<double>& beds)
{
  const water_heights_sum sum =
    water_heights_compare(levels.data(), depths.data(), beds.data(), depths.size(), this->DryDepth);
  if (!sum.is_wrong)
  {
    return;
  }
  this->AreUnitsTold = true;
  vtkWarningMacro("in wet places the depth '"
    << this->DepthArrayName << "' differs by up to " << sum.off << " from the level '"
    << this->LevelArrayName << "' minus the bed '" << this->BedArrayName
    << "'. The depths are at most " << sum.deepest << " there, and the three must agree within "
    << 100.0 * sum.share << " % of that. Name two of them.");
}

//------------------------------------------------------------------------------
bool vtkWaterSurfaceFilter::CheckDepths(vtkDataArray* depth)
{
  if (!depth || HasDepth(depth))
  {
    return true;
  }
  double range[2];
  depth->GetFiniteRange(range);
  if (!water_heights_are_negative(range[0], range[1], this->DryDepth))
  {
    return true;
  }
  if (!this->IsSignTold)
  {
    this->IsSignTold = true;
    vtkWarningMacro("the array '"
      << this->DepthArrayName << "' is " << range[0] << " to " << range[1] + 0.0 // not -0
      << "; depths must be positive where there is water. There is no water. If its values are the "
         "bed's heights, name it as the bed; otherwise change its sign.");
  }
  return false;
}

//------------------------------------------------------------------------------
int vtkWaterSurfaceFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

//------------------------------------------------------------------------------
bool vtkWaterSurfaceFilter::ReadStep(vtkDataSet* input, vtkPolyData* mesh, vtkWaterColumns& columns)
{
  if (!input || input->GetNumberOfCells() == 0 || input->GetNumberOfPoints() == 0)
  {
    return false;
  }
  const int dimension = DimensionOf(input);
  if (dimension < 2)
  {
    vtkErrorMacro("the mesh has no cells of two dimensions. There is no surface.");
    return false;
  }
  if (dimension == 3)
  {
    vtkErrorMacro("the mesh has cells of three dimensions; the water needs cells of two. Contour "
                  "the free surface first, and use the result as the input of the water's mapper.");
    return false;
  }
  const std::array<vtkMTimeType, 5> cells = CellsOf(input);
  const std::string wrongPoint =
    cells[0] != 0 && cells == this->Checked ? std::string() : vtkWaterFindWrongPoint(input);
  if (!wrongPoint.empty())
  {
    vtkErrorMacro(<< wrongPoint << ". There is no surface.");
    return false;
  }
  this->Checked = cells;
  this->Polygons->Make(input, mesh);
  vtkWaterColumns::Given given;
  const std::string wrong =
    FindAll(mesh, this->LevelArrayName, this->DepthArrayName, this->BedArrayName, given);
  if (!wrong.empty())
  {
    vtkErrorMacro(<< wrong << ". There is no surface.");
    return false;
  }
  given.DryDepth = this->DryDepth;
  if (this->CheckDepths(given.Depth) &&
    given.IsBedOfCells == given.AreOfCells) // or they are of other places
  {
    this->CheckUnits(given.Level, given.Depth, given.Bed);
  }
  columns.Make(mesh, given);
  if (columns.AreLevelsBeds() && !this->IsLandTold)
  {
    this->IsLandTold = true;
    vtkWarningMacro(
      "the level '" << this->LevelArrayName
                    << "', an array of cells, seems to be the bed where they are dry, but the bed '"
                    << this->BedArrayName
                    << "' is an array of points: some dry cells are shown as water. Name the "
                       "array of depths, too, or the bed of the cells.");
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkWaterSurfaceFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->MeanLevel = 0.0;
  this->IsMeanKnown = true;
  this->IsCutMissing = false;
  this->NumberOfCutCells = 0;
  this->Surface->Initialize();
  vtkNew<vtkPolyData> mesh;
  vtkWaterColumns columns;
  if (!this->ReadStep(vtkDataSet::GetData(inputVector[0]), mesh, columns))
  {
    return 1; // said once: a failure would be told by the pipeline, too
  }
  vtkWaterWetPart part(mesh, columns.GetLevels(), columns.GetDepths(), columns.GetDykes(),
    columns.GetDivides(), this->VerticalScale);
  part.Make(kLevel, kDepth, output);
  this->NumberOfCutCells = part.GetCutCount();
  if (!columns.HasDepths())
  {
    output->GetPointData()->RemoveArray(kDepth); // nobody knows it
  }
  this->Surface->ShallowCopy(output);
  this->IsMeanKnown = false;
  return 1;
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LevelArrayName: " << this->LevelArrayName << "\n";
  os << indent << "DepthArrayName: " << this->DepthArrayName << "\n";
  os << indent << "BedArrayName: " << this->BedArrayName << "\n";
  os << indent << "DryDepth: " << this->DryDepth << "\n";
  os << indent << "VerticalScale: " << this->VerticalScale << "\n";
  os << indent << "NumberOfCutCells: " << this->NumberOfCutCells << "\n";
  os << indent << "MeanLevel: " << this->GetMeanOfUpdate() << "\n";
}
VTK_ABI_NAMESPACE_END
