// SPDX-License-Identifier: BSD-3-Clause
// On hardware the shader of a water that is out of view is built at the end of the first frame:
// once, without a trace, and it is the one that the water is drawn with when it comes into view. In
// software it is not built.
#include "WaterFaultyScene.h"

#include "vtkWaterGL.h"

#include "vtkCommand.h"
#include "vtkCullerCollection.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLRenderPass.h"

#include <set>

namespace
{
constexpr GLuint kNames = 1000; // of programs: OpenGL's are small numbers

std::set<GLuint> Programs(vtkRenderWindow* window)
{
  std::set<GLuint> names;
  window->MakeCurrent();
  for (GLuint name = 1; name < kNames; ++name)
  {
    if (glIsProgram(name))
    {
      names.insert(name);
    }
  }
  return names;
}

size_t CountMore(const std::set<GLuint>& now, const std::set<GLuint>& before)
{
  return static_cast<size_t>(std::count_if(
    now.begin(), now.end(), [&before](GLuint name) { return before.count(name) == 0; }));
}

void SetLook(FaultyScene& scene)
{
  scene.Water->GetWaterProperty()->SetPreset("lake");
  scene.Water->SetTime(3.0);
}

bool Check(const std::string& name, bool isSoftware)
{
  setenv("VTK_WATER_SOFTWARE", isSoftware ? "1" : "0", 1);
  FaultyScene expected;
  SetLook(expected);
  const auto inView = expected.Picture();

  FaultyScene scene;
  SetLook(scene);
  scene.Water->VisibilityOff();
  const auto without = scene.Picture();
  scene.Picture();
  const auto before = Programs(scene.Window);
  scene.Water->VisibilityOn();
  scene.Water->SetSheetBounds(-9, 9, -80, -60); // behind the eye
  bool ok = WaterCheck(
    name + ": out of view it leaves no trace", WaterSame(scene.Picture(), without), true);
  const auto outOfView = Programs(scene.Window);
  const size_t built = CountMore(outOfView, before);
  ok &= WaterCheck(name + ": programs are built for it", built > 0, !isSoftware);
  ok &= WaterCheck(name + ": nor later", WaterSame(scene.Picture(), without), true);
  ok &= WaterCheck(name + ": once", Programs(scene.Window) == outOfView, true);
  ok &= WaterCheck(name + ": the renderer is watched no more",
    scene.Renderer->HasObserver(vtkCommand::EndEvent) != 0, false);

  vtkInformation* keys = scene.Water->GetPropertyKeys();
  ok &= WaterCheck(
    name + ": no key is left on it", keys && keys->Has(vtkOpenGLRenderPass::RenderPasses()), false);

  scene.Water->SetSheetBounds(-9, 9, -8, 14);
  ok &= WaterCheck(name + ": in view it is as ever", WaterSame(scene.Picture(), inView), true);
  const auto then = Programs(scene.Window);
  FaultyScene other; // the same without a warm-up: another window builds all of them
  SetLook(other);
  other.Water->VisibilityOff();
  other.Picture();
  const auto cold = Programs(other.Window);
  other.Water->VisibilityOn();
  other.Picture();
  ok &= WaterCheck(name + ": programs that the frame in view is spared",
    CountMore(Programs(other.Window), cold) - CountMore(then, outOfView), built);
  ok &= WaterCheck<size_t>(name + ": errors", scene.Errors.size(), 0);

  FaultyScene small; // in view, and left out all the same
  SetLook(small);
  auto* culler =
    vtkFrustumCoverageCuller::SafeDownCast(small.Renderer->GetCullers()->GetLastItem());
  culler->SetMinimumCoverage(2.0);
  small.Water->VisibilityOff();
  const auto nothing = small.Picture();
  small.Water->VisibilityOn();
  ok &= WaterCheck(name + ": one that is too small leaves no trace",
    WaterSame(small.Picture(), nothing) && WaterSame(small.Picture(), nothing), true);
  return ok;
}
}

int TestWaterWarmUp(int, char*[])
{
  bool ok = Check("hardware", false);
  ok &= Check("software", true);
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
