// SPDX-License-Identifier: BSD-3-Clause
// Without memory for the parts of large meshes, or for the tile of a wind sea, the program goes on:
// the reflection is the same, or the sea is flat, one error says so, and the next picture is right
// again. Every large allocation fails in its turn, and the first one of calls of the C interface.
#include "WaterFaultyScene.h"

#include "vtkLogger.h"
#include "vtkOutputWindow.h"
#include "vtkSMPTools.h"
#include "vtkWaterC.h"
#include "vtkWaterReflectionPass.h"
#include "vtkWaterRendererClass.h"

#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <new>

namespace
{
constexpr int kNone = -1;
constexpr int kAll = -2;
std::atomic<size_t> leastBytes(SIZE_MAX); // of an allocation that counts
std::atomic<int> failing(kNone);          // number of the one that fails
std::atomic<int> counted(0);
std::atomic<int> failed(0);

// Neither VTK nor the driver, which would end the program.
bool IsOurs(const void* caller)
{
  Dl_info info;
  return dladdr(caller, &info) && info.dli_fname && std::strstr(info.dli_fname, "RenderingWater");
}
}

// Of the whole program; all else than what is counted is as ever.
[[gnu::noinline]] void* operator new(size_t bytes)
{
  if (bytes >= leastBytes && IsOurs(__builtin_return_address(0)))
  {
    const int number = counted++;
    if (failing == kAll || failing == number)
    {
      ++failed;
      throw std::bad_alloc();
    }
  }
  if (void* memory = std::malloc(bytes > 0 ? bytes : 1))
  {
    return memory;
  }
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept
{
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, size_t) noexcept
{
  std::free(memory);
}

namespace
{
using Bytes = std::vector<unsigned char>;

// One of the allocations from a size on fails while an object of this class lives.
struct Without
{
  Without(int number, size_t bytes)
  {
    counted = 0;
    failed = 0;
    failing = number;
    leastBytes = bytes;
  }
  ~Without() { leastBytes = SIZE_MAX; }
};

Bytes PictureWithout(FaultyScene& scene, int number, size_t bytes)
{
  {
    const Without without(number, bytes);
    scene.Window->Render();
  }
  return scene.Read();
}

bool Says(const FaultyScene& scene, const std::string& name, const std::string& words)
{
  bool ok = WaterCheck<size_t>(name + ": errors", scene.Errors.size(), 1);
  const bool isSaid = !scene.Errors.empty() && scene.Errors[0].find(words) != std::string::npos;
  return WaterCheck(name + ": says \"" + words + "\"", isSaid, true) && ok;
}

// Two large meshes, one before the other, in a picture of its own reflection's size and a coarser
// one.
struct LargeScene : public FaultyScene
{
  explicit LargeScene(vtkRenderWindow* window = WaterTestWindow())
    : FaultyScene(window)
  {
    for (int i = 0; i < 2; ++i)
    {
      vtkNew<vtkSphereSource> ball;
      ball->SetCenter(-1.0 + i, 2.0 + 3.0 * i, 1.0);
      ball->SetRadius(3.0);
      ball->SetThetaResolution(140);
      ball->SetPhiResolution(140);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(ball->GetOutputPort());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->GetProperty()->SetColor(0.9, 0.7, 0.3 + 0.4 * i);
      this->Renderer->AddActor(actor);
    }
    this->Water->GetReflectionPass()->SetTextureScale(2.0);
  }
  // With everything drawn: shaders and buffers are there afterwards, and nothing of ours.
  Bytes Whole()
  {
    this->Water->GetReflectionPass()->SetSkips(vtkWaterReflectionPass::SKIP_NONE);
    return this->Picture();
  }
  void BeginSkipping()
  {
    using Pass = vtkWaterReflectionPass;
    this->Water->GetReflectionPass()->SetSkips(
      Pass::SKIP_ALL & ~static_cast<unsigned>(Pass::UNCHANGED_VIEWS));
  }
};

// All scenes of a check have one window, so that their shaders are compiled once.
bool CheckPieces()
{
  const auto window = WaterTestWindow();
  constexpr size_t kLarge = 20000; // bytes: all else that is allocated in these frames is smaller
  bool ok = true;
  int number = 0;
  for (bool isDone = false; !isDone && number < 100; ++number)
  {
    LargeScene scene(window);
    const Bytes right = scene.Whole();
    scene.BeginSkipping();
    const Bytes poor = PictureWithout(scene, number, kLarge);
    isDone = failed == 0;
    const std::string name = "pieces, without allocation " + std::to_string(number);
    ok &= WaterCheck(name + ": the picture is the same", WaterSame(poor, right), true);
    ok &= isDone || Says(scene, name, "no memory for");
    const Bytes after = PictureWithout(scene, kNone, kLarge);
    ok &= WaterCheck(name + ": and afterwards", WaterSame(after, right), true);
    ok &= isDone || WaterCheck(name + ": which tries again", counted > 0, true);
  }
  ok &= WaterCheck("several allocations have failed", number > 2, true);

  LargeScene scene(window);
  const Bytes right = scene.Whole();
  scene.BeginSkipping();
  for (int i = 0; i < 3; ++i)
  {
    const Bytes poor = PictureWithout(scene, kAll, kLarge);
    ok &= WaterCheck("pieces, without any: the picture is the same", WaterSame(poor, right), true);
  }
  return Says(scene, "pieces, without any, three times", "large mesh") && ok;
}

// A ball before the camera hides most of the water: what of it is hidden is asked of the picture,
// which has just become larger.
bool CheckHidden()
{
  const auto window = WaterTestWindow();
  constexpr size_t kLarge = 20000;
  bool ok = true;
  bool hasAskedPicture = false;
  int number = 0;
  for (bool isDone = false; !isDone && number < 100; ++number)
  {
    Bytes pictures[2];
    const std::string name = "hidden, without allocation " + std::to_string(number);
    for (int i = 0; i < 2; ++i)
    {
      LargeScene scene(window);
      vtkNew<vtkSphereSource> ball;
      ball->SetCenter(2.0, -10.0, 3.0);
      ball->SetRadius(2.0);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(ball->GetOutputPort());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      scene.Renderer->AddActor(actor);
      scene.Whole();
      scene.BeginSkipping();
      scene.Picture();
      scene.Picture();
      scene.Window->SetSize(400, 300);
      pictures[i] = i == 0 ? PictureWithout(scene, number, kLarge) : scene.Whole();
      isDone = i == 0 ? failed == 0 : isDone;
      ok &= isDone || i > 0 || Says(scene, name, "no memory for");
      hasAskedPicture = hasAskedPicture ||
        (!scene.Errors.empty() && scene.Errors[0].find("of hidden water") != std::string::npos);
    }
    ok &= WaterCheck(name + ": the picture is the same", WaterSame(pictures[0], pictures[1]), true);
  }
  return WaterCheck("what is hidden was asked for", hasAskedPicture, true) && ok;
}

struct SeaScene : public FaultyScene
{
  explicit SeaScene(int size, vtkRenderWindow* window = WaterTestWindow())
    : FaultyScene(window)
  {
    auto* look = this->Water->GetWaterProperty();
    look->SeaOn();
    look->SetSeaTileSize(size);
    this->Water->SetTime(1.0);
  }
};

bool CheckSea()
{
  constexpr int kSize = 128;
  constexpr size_t kLarge = 2500; // bytes: the tables of a tile of this size
  const auto window = WaterTestWindow();
  const Bytes right = SeaScene(kSize, window).Picture();
  bool ok = true;
  int number = 0;
  for (bool isDone = false; !isDone && number < 100; ++number)
  {
    SeaScene scene(64, window); // builds the shader
    scene.Picture();
    scene.Water->GetWaterProperty()->SetSeaTileSize(kSize);
    const Bytes poor = PictureWithout(scene, number, kLarge);
    isDone = failed == 0;
    const std::string name = "sea, without allocation " + std::to_string(number);
    ok &= isDone || Says(scene, name, "tiles of 128 x 128 points");
    ok &= isDone || WaterCheck(name + ": there are no waves", poor == right, false);
    ok &= WaterCheck(name + ": right afterwards", WaterSame(scene.Picture(), right), true);
  }
  ok &= WaterCheck("many allocations have failed", number > 50, true);

  SeaScene scene(64, window);
  scene.Picture(); // builds the shader
  scene.Water->GetWaterProperty()->SetSeaTileSize(kSize);
  Bytes flat;
  for (int i = 0; i < 2; ++i)
  {
    scene.Water->SetTime(2.0 + i);
    const Bytes poor = PictureWithout(scene, kAll, kLarge);
    flat = i == 0 ? poor : flat;
    ok &= WaterCheck("sea, without any: no waves", poor == right, false);
    ok &= WaterCheck("sea, without any: nothing moves", WaterSame(poor, flat), true);
  }
  return Says(scene, "sea, without any, twice", "tiles of 128 x 128 points") && ok;
}

bool CheckHeights()
{
  SeaScene scene(128);
  const double right = scene.Water->GetWaveHeight(0.3, -1.6);
  double normal[3];
  scene.Water->GetWaveNormal(0.3, -1.6, normal);
  bool ok = true;
  for (int i = 0; i < 2; ++i)
  {
    SeaScene poor(128);
    {
      const Without without(kAll, 2500);
      double found[3];
      poor.Water->GetWaveNormal(0.3, -1.6, found);
      const double height = poor.Water->GetWaveHeight(0.3, -1.6);
      ok &= WaterCheck("height: not a number", std::isnan(height) && std::isnan(found[2]), true);
    }
    ok &= Says(poor, "height", "tiles of 128 x 128 points");
    ok &= WaterCheck("height afterwards", poor.Water->GetWaveHeight(0.3, -1.6), right);
    double again[3];
    poor.Water->GetWaveNormal(0.3, -1.6, again);
    ok &= WaterCheck("normal afterwards", again[0], normal[0]);
  }
  return ok;
}

// Without memory for what they need first, calls of the C interface return a status with its text;
// afterwards the same calls succeed.
bool CheckC()
{
  const double points[9] = { 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0 };
  const int64_t triangle[3] = { 0, 1, 2 };
  vtk_water_actor* water = nullptr;
  bool ok = true;
  const auto check = [&ok](const std::string& name, auto call) {
    vtk_water_status status = VTK_WATER_OK;
    {
      const Without without(kAll, 1);
      status = call();
    }
    const std::string text = vtk_water_last_error();
    ok &= WaterCheck<int>(name + ": status", status, VTK_WATER_NO_MEMORY);
    ok &= WaterCheck<std::string>(name + ": text", text, "out of memory");
    ok &= WaterCheck<int>(name + ", afterwards: status", call(), VTK_WATER_OK);
    ok &= WaterCheck<std::string>(name + ", afterwards: text", vtk_water_last_error(), "");
  };
  check("new water", [&] { return vtk_water_actor_new(&water); });
  check("surface", [&] { return vtk_water_actor_set_surface(water, points, 3, triangle, 1); });
  check("flow", [&] { return vtk_water_actor_set_flow(water, points, 3); });
  vtk_water_actor_delete(water);
  return ok;
}
}

int TestWaterNoMemory(int, char*[])
{
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkSMPTools::SetBackend("STDThread"); // what throws in a thread ends the program
  vtkSMPTools::Initialize(2);
  bool ok = CheckPieces();
  LargeScene scene;
  scene.Picture();                                             // there is a driver to ask
  ok &= !vtkWaterRendererClass::IsSoftware() || CheckHidden(); // on a GPU it is not asked for
  setenv("VTK_WATER_SOFTWARE", "1", 1);                        // a GPU computes the sea itself
  ok &= CheckSea();
  ok &= CheckHeights();
  ok &= CheckC();
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
