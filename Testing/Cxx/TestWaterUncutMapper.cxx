// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a mesh that is cut while drawn are listed once, whatever is land in a step;
// other polygons, other points of the solver's and values of cells make a list anew.
#include "WaterTestScene.h"

#include "vtkWaterUncutMapper.h"
#include "vtkWaterUncutMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <cstdlib>

namespace
{
constexpr int kSide = 8; // quads

vtkIdType PointAt(int x, int y)
{
  return y * (kSide + 1) + x;
}

vtkSmartPointer<vtkPolyData> SolvedMesh()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (int y = 0; y <= kSide; ++y)
  {
    for (int x = 0; x <= kSide; ++x)
    {
      points->InsertNextPoint(x - 0.5 * kSide, y - 0.5 * kSide, -5.0);
    }
  }
  for (int y = 0; y < kSide; ++y)
  {
    for (int x = 0; x < kSide; ++x)
    {
      const vtkIdType quad[4] = { PointAt(x, y), PointAt(x + 1, y), PointAt(x + 1, y + 1),
        PointAt(x, y + 1) };
      cells->InsertNextCell(4, quad);
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

// A step in which the first columns of points are wet, and the others lie in one place.
vtkSmartPointer<vtkWaterUncutMesh> Step(vtkPolyData* solved, int wet)
{
  auto mesh = vtkSmartPointer<vtkWaterUncutMesh>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < solved->GetNumberOfPoints(); ++i)
  {
    double point[3];
    solved->GetPoint(i % (kSide + 1) < wet ? i : 0, point);
    points->InsertNextPoint(point[0], point[1], 0.0);
  }
  mesh->SetPoints(points);
  mesh->SetPolys(solved->GetPolys());
  mesh->SetSolvedMesh(solved);
  return mesh;
}

struct Scene : public WaterTestScene
{
  vtkNew<vtkActor> Actor;
  vtkNew<vtkWaterUncutMapper> Mapper;

  Scene()
  {
    this->Renderer->GradientBackgroundOff();
    this->Renderer->SetBackground(0, 0, 0);
    this->Renderer->GetActiveCamera()->SetPosition(0, 0.1, 20);
    this->Renderer->GetActiveCamera()->SetFocalPoint(0, 0, 0);
    this->Actor->SetMapper(this->Mapper);
    this->Actor->GetProperty()->LightingOff();
    this->Renderer->AddActor(this->Actor);
  }

  // Pixels that the mesh covers.
  int Draw(vtkPolyData* mesh)
  {
    this->Mapper->SetInputDataObject(0, mesh);
    this->Window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    const int* size = this->Window->GetSize();
    this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
    int covered = 0;
    for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
    {
      covered += pixels->GetValue(3 * i) > 0 ? 1 : 0;
    }
    return covered;
  }
};

// Pixels that VTK's own mapper covers.
int Expected(vtkPolyData* mesh)
{
  Scene scene;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  scene.Actor->SetMapper(mapper);
  return scene.Draw(mesh);
}
}

int TestWaterUncutMapper(int, char*[])
{
  Scene scene;
  const vtkSmartPointer<vtkPolyData> solved = SolvedMesh();
  bool ok = true;
  for (int wet : { 3, 9, 5, 2 })
  {
    const vtkSmartPointer<vtkWaterUncutMesh> step = Step(solved, wet);
    ok &= WaterCheck("columns " + std::to_string(wet), scene.Draw(step), Expected(step));
    ok &= WaterCheck("lists", scene.Mapper->GetNumberOfLists(), vtkIdType(1));
  }
  ok &= WaterCheck("something is drawn", Expected(Step(solved, 9)) > 10000, true);

  solved->GetPoints()->SetPoint(0, -6.0, -6.0, -5.0);
  solved->GetPoints()->Modified();
  const vtkSmartPointer<vtkWaterUncutMesh> moved = Step(solved, 9);
  ok &= WaterCheck("moved", scene.Draw(moved), Expected(moved));
  ok &= WaterCheck("lists", scene.Mapper->GetNumberOfLists(), vtkIdType(2));

  vtkNew<vtkCellArray> half;
  half->DeepCopy(solved->GetPolys());
  half->Initialize();
  const vtkIdType one[4] = { PointAt(0, 0), PointAt(8, 0), PointAt(8, 3), PointAt(0, 3) };
  half->InsertNextCell(4, one);
  solved->SetPolys(half);
  const vtkSmartPointer<vtkWaterUncutMesh> other = Step(solved, 9);
  ok &= WaterCheck("other polygons", scene.Draw(other), Expected(other));
  ok &= WaterCheck("lists", scene.Mapper->GetNumberOfLists(), vtkIdType(3));

  vtkNew<vtkDoubleArray> values;
  values->InsertNextValue(1.0);
  other->GetCellData()->SetScalars(values);
  other->Modified();
  ok &= WaterCheck("values of cells", scene.Draw(other), Expected(other));
  ok &= WaterCheck("lists", scene.Mapper->GetNumberOfLists(), vtkIdType(3));
  other->GetCellData()->SetScalars(nullptr);
  other->Modified();
  ok &= WaterCheck("none again", scene.Draw(other), Expected(other));
  ok &= WaterCheck("lists", scene.Mapper->GetNumberOfLists(), vtkIdType(4));

  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  ok &= WaterCheck("after a release", scene.Draw(other), Expected(other));
  ok &= WaterCheck(
    "its class", std::string(scene.Mapper->GetClassName()), std::string("vtkOpenGLPolyDataMapper"));
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
