// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterHulls.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCleanPolyData.h"
#include "vtkDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"
#include "vtkWaterPolygons.h"
#include "water_plane.h"

#include <algorithm>
#include <sstream>

namespace
{
// Triangles of a data set's surface; points in the same place are one, so that edges know each
// other.
vtkSmartPointer<vtkPolyData> TrianglesOf(vtkDataSet* data)
{
  vtkNew<vtkDataSetSurfaceFilter> surface;
  vtkNew<vtkTriangleFilter> triangles;
  vtkNew<vtkCleanPolyData> clean;
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    triangles->SetInputData(mesh);
  }
  else
  {
    surface->SetInputData(data);
    triangles->SetInputConnection(surface->GetOutputPort());
  }
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  clean->SetInputConnection(triangles->GetOutputPort());
  clean->SetTolerance(0.0);
  clean->ConvertPolysToLinesOff();
  clean->Update();
  return clean->GetOutput();
}

// place  in the plane's axes
std::string SayOpen(const vtkWaterHulls::Surface& surface, const double place[2])
{
  double axes[2][3];
  water_plane_axes(surface.Unit.normal, axes[0], axes[1]);
  double point[3];
  for (int i = 0; i < 3; ++i)
  {
    point[i] = surface.Origin[i] + place[0] * axes[0][i] + place[1] * axes[1][i];
  }
  std::ostringstream text;
  text << "is not closed where the water cuts it, at (" << point[0] << ", " << point[1] << ", "
       << point[2]
       << "): its sides must be complete there, each edge must belong to two "
          "polygons, and its rim must lie above the highest wave";
  return text.str();
}

std::string SayPlace(const double point[3])
{
  std::ostringstream text;
  text << "has a point at (" << point[0] << ", " << point[1] << ", " << point[2]
       << "); coordinates must be finite, and lie within " << WATER_WATERLINE_REACH
       << " of the water's origin";
  return text.str();
}
}

//------------------------------------------------------------------------------
bool vtkWaterHulls::Add(vtkActor* hull)
{
  const bool isKnown = std::any_of(this->Hulls.begin(), this->Hulls.end(),
    [hull](const Hull& other) { return other.Actor == hull; });
  if (!isKnown)
  {
    this->Hulls.emplace_back();
    this->Hulls.back().Actor = hull;
  }
  return !isKnown;
}

//------------------------------------------------------------------------------
bool vtkWaterHulls::Remove(vtkActor* hull)
{
  const auto found = std::find_if(this->Hulls.begin(), this->Hulls.end(),
    [hull](const Hull& other) { return other.Actor == hull; });
  if (found == this->Hulls.end())
  {
    return false;
  }
  this->Hulls.erase(found);
  return true;
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkActor>> vtkWaterHulls::List() const
{
  std::vector<vtkSmartPointer<vtkActor>> list;
  for (const Hull& hull : this->Hulls)
  {
    list.push_back(hull.Actor);
  }
  return list;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkWaterHulls::GetMTime() const
{
  vtkMTimeType time = 0;
  for (const Hull& hull : this->Hulls)
  {
    time = std::max(time, hull.Actor->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkWaterHulls::GetMeshTime() const
{
  vtkMTimeType time = 0;
  for (const Hull& hull : this->Hulls)
  {
    vtkMapper* mapper = hull.Actor->GetMapper();
    vtkDataObject* data = mapper && mapper->GetNumberOfInputConnections(0) > 0
      ? mapper->GetInputDataObject(0, 0)
      : nullptr;
    time = std::max({ time, hull.Actor->GetRedrawMTime(), data ? data->GetMTime() : 0 });
  }
  return time;
}

//------------------------------------------------------------------------------
std::string vtkWaterHulls::Read(Hull& hull)
{
  vtkMapper* mapper = hull.Actor->GetMapper();
  if (mapper && mapper->GetNumberOfInputConnections(0) > 0)
  {
    mapper->GetInputAlgorithm()->Update();
  }
  vtkDataSet* data = mapper && mapper->GetNumberOfInputConnections(0) > 0
    ? vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0))
    : nullptr;
  if (!data || data->GetNumberOfCells() == 0)
  {
    hull.Triangles.clear();
    hull.DataTime = 0;
    return "has no mesh: its mapper must have a data set with polygons or cells";
  }
  if (hull.DataTime == data->GetMTime())
  {
    return "";
  }
  const std::string wrongPoint = vtkWaterFindWrongPoint(data);
  if (!wrongPoint.empty())
  {
    hull.Triangles.clear();
    hull.DataTime = 0;
    return "has a wrong mesh: " + wrongPoint;
  }
  const vtkSmartPointer<vtkPolyData> mesh = TrianglesOf(data);
  hull.DataTime = data->GetMTime();
  hull.Points.resize(3 * static_cast<size_t>(mesh->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    mesh->GetPoint(i, hull.Points.data() + 3 * i);
  }
  hull.Triangles.clear();
  auto polygon = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (polygon->GoToFirstCell(); !polygon->IsDoneWithTraversal(); polygon->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    polygon->GetCurrentCell(count, ids);
    if (count == 3)
    {
      hull.Triangles.push_back(
        { static_cast<size_t>(ids[0]), static_cast<size_t>(ids[1]), static_cast<size_t>(ids[2]) });
    }
  }
  if (hull.Triangles.empty())
  {
    hull.DataTime = 0; // reported again when it is requested again
    return "has no polygons; its mesh must be a closed surface, or a volume";
  }
  return "";
}

//------------------------------------------------------------------------------
std::string vtkWaterHulls::CutOne(Hull& hull, const Surface& surface)
{
  hull.Pieces.clear();
  hull.Actor->ComputeMatrix();
  const size_t count = hull.Points.size() / 3;
  std::vector<double> places(hull.Points.size());
  water_waterline_places(&hull.Actor->GetMatrix()->Element[0][0], &surface.Unit, surface.Origin,
    hull.Points.data(), count, places.data());
  const size_t wrongPlace = water_waterline_find_wrong(places.data(), count);
  if (wrongPlace < count)
  {
    return SayPlace(hull.Points.data() + 3 * wrongPlace);
  }
  if (surface.HeightMax > 0.0)
  {
    std::vector<size_t> near(count);
    near.resize(water_waterline_near(places.data(), count, surface.HeightMax, near.data()));
    std::vector<double> asked;
    for (size_t i : near)
    {
      asked.insert(asked.end(), places.begin() + 3 * i, places.begin() + 3 * i + 3);
    }
    if (!surface.Lower(asked.data(), near.size()))
    {
      return "";
    }
    for (size_t i = 0; i < near.size(); ++i)
    {
      places[3 * near[i] + 2] = asked[3 * i + 2];
    }
  }
  std::vector<water_waterline_piece>& found = hull.Pieces;
  for (const auto& triangle : hull.Triangles)
  {
    water_waterline_piece piece;
    if (water_waterline_cut(triangle.data(), places.data(), &piece))
    {
      found.push_back(piece);
    }
  }
  std::vector<water_waterline_end> ends(2 * found.size());
  size_t open = 0;
  if (!water_waterline_close(found.data(), found.size(), ends.data(), &open))
  {
    const std::string text = SayOpen(surface, found[open].ends[0]);
    found.clear();
    return text;
  }
  return "";
}

//------------------------------------------------------------------------------
std::string vtkWaterHulls::Update(Hull& hull, const Surface& surface)
{
  const std::string wrong = Read(hull);
  if (!wrong.empty())
  {
    hull.Pieces.clear();
    hull.IsCut = false;
    return wrong;
  }
  hull.Actor->ComputeMatrix();
  std::array<double, 16> matrix;
  std::copy_n(&hull.Actor->GetMatrix()->Element[0][0], 16, matrix.begin());
  if (!hull.IsCut || hull.CutDataTime != hull.DataTime || hull.CutMatrix != matrix)
  {
    hull.Wrong = CutOne(hull, surface);
    hull.IsCut = true;
    hull.CutDataTime = hull.DataTime;
    hull.CutMatrix = matrix;
  }
  return hull.Wrong;
}

//------------------------------------------------------------------------------
vtkWaterHullTablePointer vtkWaterHulls::Cut(const Surface& surface, std::string& wrong)
{
  std::vector<water_waterline_piece> pieces;
  wrong.clear();
  const bool isSame = surface.Unit.offset == this->Water.Unit.offset &&
    std::equal(surface.Unit.normal, surface.Unit.normal + 3, this->Water.Unit.normal) &&
    std::equal(surface.Origin, surface.Origin + 3, this->Water.Origin) &&
    surface.HeightMax == 0.0 && this->Water.HeightMax == 0.0;
  this->Water = surface;
  this->Water.Lower = nullptr; // not kept: it belongs to the caller
  for (size_t i = 0; i < this->Hulls.size(); ++i)
  {
    Hull& hull = this->Hulls[i];
    hull.IsCut = hull.IsCut && isSame;
    const std::string text = Update(hull, surface);
    pieces.insert(pieces.end(), hull.Pieces.begin(), hull.Pieces.end());
    if (!text.empty() && wrong.empty())
    {
      wrong = "Hull " + std::to_string(i) + " " + text + ". The water fills it.";
    }
  }
  auto table = std::make_shared<vtkWaterHullTable>();
  if (!water_waterline_lay(pieces.data(), pieces.size(), &table->Rows))
  {
    return nullptr;
  }
  if (table->Rows.longest > WATER_WATERLINE_LONGEST)
  {
    wrong = "One strip of the hulls' table has " + std::to_string(table->Rows.longest) +
      " edges; it must have at most " + std::to_string(WATER_WATERLINE_LONGEST) +
      ". Use coarser meshes, or separate waters for hulls far apart. The water fills the hulls.";
    return nullptr;
  }
  table->Texels.resize(4 * static_cast<size_t>(table->Rows.count) * table->Rows.longest);
  water_waterline_fill(pieces.data(), pieces.size(), &table->Rows, table->Texels.data());
  return table;
}
