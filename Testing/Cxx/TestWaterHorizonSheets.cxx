// SPDX-License-Identifier: BSD-3-Clause
// Each eye has its own sheet to the horizon, which is laid anew when that eye has moved, and by
// nothing else: a still camera uploads nothing, however many other eyes there are. The middle of a
// sheet's points is under its eye, from where floats count.
#include "WaterTestScene.h"

#include "vtkWaterHorizon.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{
vtkWaterHorizon::Place PlaceOf(vtkCamera* camera)
{
  vtkWaterHorizon::Place place;
  const double* view = &camera->GetModelViewTransformMatrix()->Element[0][0];
  const double* projection = &camera->GetProjectionTransformMatrix(1.0, -1, 1)->Element[0][0];
  std::copy(view, view + 16, place.Eye.world_to_view);
  std::copy(projection, projection + 16, place.Eye.view_to_clip);
  place.Plane.normal[2] = 1.0;
  vtkMatrix4x4::Identity(place.ToLocal);
  return place;
}

vtkSmartPointer<vtkCamera> MakeCamera(double x)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(x, -5.0, 2.0);
  camera->SetFocalPoint(x, 0.0, 1.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  return camera;
}

vtkPolyDataMapper* Lay(vtkWaterHorizon& horizon, vtkRenderer* renderer, vtkCamera* camera)
{
  renderer->SetActiveCamera(camera);
  return horizon.Lay(renderer, PlaceOf(camera));
}
}

int TestWaterHorizonSheets(int, char*[])
{
  vtkWaterHorizon horizon;
  vtkNew<vtkRenderer> renderer;
  const vtkSmartPointer<vtkCamera> first = MakeCamera(0.0);
  vtkSmartPointer<vtkCamera> second = MakeCamera(1e6);
  vtkPolyDataMapper* mapper = Lay(horizon, renderer, first);
  vtkPolyDataMapper* other = Lay(horizon, renderer, second);
  bool ok = WaterCheck("sheets for two eyes", mapper && other && mapper != other, true);
  const vtkMTimeType time = mapper->GetInput()->GetMTime();
  const vtkMTimeType pointsTime = mapper->GetInput()->GetPoints()->GetMTime();
  for (int i = 0; i < 3; ++i)
  {
    Lay(horizon, renderer, second);
    ok &= WaterCheck("the same sheet again", Lay(horizon, renderer, first) == mapper, true);
  }
  ok &= WaterCheck("laid anew for a still eye", mapper->GetInput()->GetMTime() != time, false);
  ok &= WaterCheck(
    "points of a still eye anew", mapper->GetInput()->GetPoints()->GetMTime() != pointsTime, false);

  double bounds[6];
  other->GetInput()->GetPoints()->ComputeBounds();
  other->GetInput()->GetPoints()->GetBounds(bounds);
  const double middle[2] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]) };
  ok &= WaterCheck("middle under the eye",
    std::fabs(middle[0] - 1e6) < 1e-6 && std::fabs(middle[1] + 5.0) < 1e-6, true);

  first->SetPosition(0.0, -5.0, 3.0);
  ok &= WaterCheck("sheet of an eye that has moved", Lay(horizon, renderer, first) == mapper, true);
  ok &= WaterCheck("laid anew for it", mapper->GetInput()->GetMTime() != time, true);

  second = nullptr; // and its sheet is free
  const vtkSmartPointer<vtkCamera> third = MakeCamera(7.0);
  ok &= WaterCheck("sheet of an eye that is no more", Lay(horizon, renderer, third) == other, true);

  third->SetFocalPoint(7.0, 0.0, 90.0);
  ok &= WaterCheck("nothing for an eye that looks away", !Lay(horizon, renderer, third), true);
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
