// SPDX-License-Identifier: BSD-3-Clause
// No mapper builds its shaders anew from frame to frame, neither for the mirrored nor for the main
// view, with one water and with two of different levels. Counted in the mappers themselves.
#include "WaterTestScene.h"

#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkWaterReflectionPass.h"

namespace
{
int builds = 0;

class CountingMapper : public vtkOpenGLPolyDataMapper
{
public:
  static CountingMapper* New();
  vtkTypeMacro(CountingMapper, vtkOpenGLPolyDataMapper);

protected:
  void BuildShaders(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override
  {
    ++builds;
    this->Superclass::BuildShaders(shaders, renderer, actor);
  }
};
vtkStandardNewMacro(CountingMapper);

int CountFrames(vtkRenderWindow* window, int frames)
{
  builds = 0;
  for (int i = 0; i < frames; ++i)
  {
    window->Render();
  }
  return builds;
}
}

int TestWaterShaderRebuilds(int, char*[])
{
  WaterTestScene scene;
  scene.AddThings<CountingMapper>();
  const int things = scene.Renderer->GetViewProps()->GetNumberOfItems();
  vtkNew<vtkCubeSource> sunk; // what is under water is not reflected
  sunk->SetCenter(0, 0, -5);
  vtkNew<CountingMapper> sunkMapper;
  sunkMapper->SetInputConnection(sunk->GetOutputPort());
  vtkNew<vtkActor> sunkActor;
  sunkActor->SetMapper(sunkMapper);
  scene.Renderer->AddActor(sunkActor);
  scene.Window->Render();
  bool ok = WaterCheck("builds in 5 frames without water", CountFrames(scene.Window, 5), 0);

  scene.AddWater();
  ok &= WaterCheck("builds in the first frame with water, of what it reflects alone",
    CountFrames(scene.Window, 1), things);
  const vtkIdType before = scene.Water->GetReflectionPass()->GetNumberOfReflectionRenders();
  ok &= WaterCheck("builds in 5 frames with water", CountFrames(scene.Window, 5), 0);
  ok &= WaterCheck<vtkIdType>("mirrors in these 5 frames",
    scene.Water->GetReflectionPass()->GetNumberOfReflectionRenders() - before, 5);

  vtkNew<vtkWaterActor> second;
  second->SetLevel(1.5);
  second->SetSheetBounds(4, 8, -6, 6);
  scene.Renderer->AddActor(second);
  scene.Window->Render();
  ok &= WaterCheck("builds in 5 frames with two waters", CountFrames(scene.Window, 5), 0);

  builds = 0;
  for (int i = 0; i < 5; ++i)
  {
    scene.Renderer->GetActiveCamera()->Azimuth(3);
    scene.Water->SetLevel(0.1 * i);
    scene.Window->Render();
  }
  ok &= WaterCheck("builds in 5 frames with moving camera and level", builds, 0);
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
