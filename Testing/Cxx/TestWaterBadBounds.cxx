// SPDX-License-Identifier: BSD-3-Clause
// A prop with NaN bounds is named in one error, however many frames; the water shows its plain
// colour, and is right again in the first frame without the prop.
#include "WaterTestScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCullerCollection.h"
#include "vtkObjectFactory.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWaterReflectionPass.h"

#include <limits>

namespace
{
class BoundlessProp : public vtkProp
{
public:
  static BoundlessProp* New();
  vtkTypeMacro(BoundlessProp, vtkProp);

  double* GetBounds() override { return this->Bounds; }

private:
  double Bounds[6] = { 0.0, 1.0, 0.0, std::numeric_limits<double>::quiet_NaN(), 0.0, 1.0 };
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
}

int TestWaterBadBounds(int, char*[])
{
  WaterTestScene scene;
  scene.AddThings<vtkPolyDataMapper>();
  scene.AddWater();
  const std::string good = Picture(scene.Window);

  int errors = 0;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&errors);
  observer->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  scene.Water->AddObserver(vtkCommand::ErrorEvent, observer);
  scene.Water->GetWaterProperty()->SetReflectanceModeToConstant();
  scene.Water->GetWaterProperty()->SetReflectance(0.0);
  const std::string plain = Picture(scene.Window);
  scene.Water->GetWaterProperty()->SetReflectanceModeToFresnel();

  vtkNew<BoundlessProp> bad;
  scene.Renderer->GetCullers()->RemoveAllItems(); // VTK's own cannot take NaN either
  scene.Renderer->AddViewProp(bad);
  std::string picture;
  for (int frame = 0; frame < 3; ++frame)
  {
    picture = Picture(scene.Window);
  }
  bool ok = WaterCheck("errors in three frames", errors, 1);
  const std::string text = scene.Water->GetLastError();
  for (const char* word : { "BoundlessProp", "nan", "finite" })
  {
    ok &= WaterCheck(
      std::string("the error names ") + word, text.find(word) != std::string::npos, true);
  }
  ok &= WaterCheck("picture is that of plain water", picture == plain, true);
  ok &= WaterCheck("plain water differs from reflecting water", plain == good, false);

  scene.Renderer->RemoveViewProp(bad);
  ok &= WaterCheck("next picture is right again", Picture(scene.Window) == good, true);
  ok &= WaterCheck("errors after that", errors, 1);
  ok &= WaterCheck("no error left", std::string(scene.Water->GetLastError()), std::string());
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
