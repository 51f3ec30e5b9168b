// SPDX-License-Identifier: BSD-3-Clause
// A prop with bounds that are not finite is named in one error, however many frames; the water
// reflects everything all the same, that prop included.
#include "WaterTestScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCullerCollection.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWaterReflectionPass.h"

#include <algorithm>
#include <limits>

namespace
{
class BoundlessProp : public vtkOpenGLActor
{
public:
  static BoundlessProp* New();
  vtkTypeMacro(BoundlessProp, vtkOpenGLActor);

  double* GetBounds() override { return this->OwnBounds; }

  double OwnBounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
};
vtkStandardNewMacro(BoundlessProp);

std::string Picture(vtkRenderWindow* window)
{
  window->Render();
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  return std::string(reinterpret_cast<char*>(pixels->GetPointer(0)),
    static_cast<size_t>(pixels->GetNumberOfValues()));
}

void Place(vtkActor* actor, vtkMapper* mapper)
{
  actor->SetMapper(mapper);
  actor->SetPosition(0, -4, 1);
  actor->GetProperty()->SetColor(0.9, 0.1, 0.8);
}
}

int TestWaterBadBounds(int, char*[])
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const double bad[3][6] = { { 0, 1, 0, nan, 0, 1 }, { nan, nan, nan, nan, nan, nan },
    { -infinity, infinity, -infinity, infinity, -infinity, infinity } };
  const std::string words[3] = { "nan", "nan", "inf" };
  bool ok = true;

  WaterTestScene scene;
  scene.AddThings<vtkPolyDataMapper>();
  scene.AddWater();
  vtkNew<vtkSphereSource> source;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> ordinary;
  Place(ordinary, mapper);
  const std::string without = Picture(scene.Window);
  scene.Renderer->AddActor(ordinary);
  const std::string with = Picture(scene.Window);
  scene.Renderer->RemoveActor(ordinary);
  ok &= WaterCheck("the prop is seen", with == without, false);

  int errors = 0;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&errors);
  observer->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  scene.Water->AddObserver(vtkCommand::ErrorEvent, observer);
  scene.Renderer->GetCullers()->RemoveAllItems(); // VTK's own cannot take NaN either
  for (int i = 0; i < 3; ++i)
  {
    const std::string name = "bounds " + std::to_string(i) + ": ";
    errors = 0;
    vtkNew<BoundlessProp> boundless;
    Place(boundless, mapper);
    std::copy(bad[i], bad[i] + 6, boundless->OwnBounds);
    scene.Renderer->AddActor(boundless);
    for (int frame = 0; frame < 3; ++frame)
    {
      ok &= WaterCheck(name + "picture is as with ordinary bounds, frame " + std::to_string(frame),
        Picture(scene.Window) == with, true);
    }
    ok &= WaterCheck(name + "errors in three frames", errors, 1);
    const std::string text = scene.Water->GetLastError();
    for (const std::string& word :
      { std::string("BoundlessProp"), words[i], std::string("finite") })
    {
      ok &=
        WaterCheck(name + "the error names " + word, text.find(word) != std::string::npos, true);
    }
    ok &= WaterCheck(name + "decision",
      std::string(scene.Water->GetReflectionPass()->GetDecisionAsString()),
      std::string("rendered"));

    scene.Renderer->RemoveActor(boundless);
    ok &= WaterCheck(name + "next picture is right again", Picture(scene.Window) == without, true);
    ok &= WaterCheck(name + "errors after that", errors, 1);
    ok &=
      WaterCheck(name + "no error left", std::string(scene.Water->GetLastError()), std::string());
  }
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
