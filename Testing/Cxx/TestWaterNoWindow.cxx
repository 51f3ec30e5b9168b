// SPDX-License-Identifier: BSD-3-Clause
// A renderer that gets its first window releases what its props hold in no window at all. VTK's
// passes must not hear of that: they assert that there is one, and end the program in builds that
// check it.
#include "WaterTestScene.h"

#include "vtkObjectFactory.h"
#include "vtkRenderStepsPass.h"
#include "vtkWaterReflectionPass.h"

namespace
{
class CountingPass : public vtkRenderStepsPass
{
public:
  static CountingPass* New();
  vtkTypeMacro(CountingPass, vtkRenderStepsPass);

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    ++(window ? this->WithWindow : this->WithoutWindow);
    if (window)
    {
      this->Superclass::ReleaseGraphicsResources(window);
    }
  }

  int WithWindow = 0;
  int WithoutWindow = 0;
};
vtkStandardNewMacro(CountingPass);
}

int TestWaterNoWindow(int, char*[])
{
  bool ok = true;
  WaterTestScene scene;
  scene.AddThings<vtkPolyDataMapper>();
  scene.AddWater();
  vtkNew<CountingPass> pass;
  scene.Water->GetReflectionPass()->SetDelegatePass(pass);
  scene.Window->RemoveRenderer(scene.Renderer);
  pass->WithWindow = 0;

  scene.Window->AddRenderer(scene.Renderer); // releases what is in the window before it: none
  ok &= WaterCheck("first window: releases without a window", pass->WithoutWindow, 0);
  ok &= WaterCheck("first window: releases with one", pass->WithWindow, 0);
  scene.Window->Render();
  ok &= WaterCheck("decision", std::string(scene.Water->GetReflectionPass()->GetDecisionAsString()),
    std::string("rendered"));
  scene.Window->RemoveRenderer(scene.Renderer);
  ok &= WaterCheck("removed: releases without a window", pass->WithoutWindow, 0);
  ok &= WaterCheck("removed: releases in the window", pass->WithWindow > 0, true);

  scene.Renderer->ReleaseGraphicsResources(nullptr); // as programs do that clean up by themselves
  ok &= WaterCheck("by hand: releases without a window", pass->WithoutWindow, 0);
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
