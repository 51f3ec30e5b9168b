// SPDX-License-Identifier: BSD-3-Clause
// Creating, rendering, resizing, releasing and creating again leaves nothing behind: neither GL
// objects, nor descriptors, nor memory. GL's objects are counted by asking it for all names.
//
//   vtkRenderingWaterCxxTests TestWaterLeaks --rounds 1000
#include "WaterTestScene.h"

#include "../../Module/Private/host/vtkWaterGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkWaterReflectionPass.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <dirent.h>
#include <fstream>
#include <unistd.h>
#include <vector>

namespace
{
constexpr GLuint kNames = 20000; // at least these are asked for
constexpr int kWarmUp = 48;      // rounds, until caches are full
constexpr int kPeriod = 12;      // rounds after which a water's dress comes again
constexpr int kQueries = 20;     // VTK's mappers time themselves now and then: two for each thing

struct Count
{
  int Objects = 0; // without queries
  int Queries = 0;
  int Descriptors = 0;
  double Megabytes = 0.0;
};

int CountDescriptors()
{
  int count = 0;
  DIR* folder = opendir("/proc/self/fd");
  while (folder && readdir(folder))
  {
    ++count;
  }
  if (folder)
  {
    closedir(folder);
  }
  return count;
}

double ReadMegabytes()
{
  std::ifstream file("/proc/self/statm");
  double pages = 0.0;
  file >> pages >> pages; // the second: resident
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

// Drivers hand out small names again, or count on: then none is above the next one of its kind.
GLuint FindLastName()
{
  GLuint next[7] = {};
  glGenTextures(1, &next[0]);
  glGenBuffers(1, &next[1]);
  glGenFramebuffers(1, &next[2]);
  glGenRenderbuffers(1, &next[3]);
  glGenVertexArrays(1, &next[4]);
  glGenQueries(1, &next[5]);
  next[6] = glCreateProgram();
  glDeleteTextures(1, &next[0]);
  glDeleteBuffers(1, &next[1]);
  glDeleteFramebuffers(1, &next[2]);
  glDeleteRenderbuffers(1, &next[3]);
  glDeleteVertexArrays(1, &next[4]);
  glDeleteQueries(1, &next[5]);
  glDeleteProgram(next[6]);
  return std::max(kNames, *std::max_element(next, next + 7));
}

void CountObjects(Count& count)
{
  const GLuint last = FindLastName();
  for (GLuint name = 1; name <= last; ++name)
  {
    count.Queries += glIsQuery(name);
    count.Objects += glIsTexture(name) + glIsBuffer(name) + glIsFramebuffer(name) +
      glIsRenderbuffer(name) + glIsVertexArray(name) + glIsProgram(name) + glIsShader(name);
  }
}

// All that a water has on the GPU: waves, backdrop, sea, instruments, samples, pieces.
void Dress(vtkWaterActor* water, int round)
{
  auto* look = water->GetWaterProperty();
  look->SetRefraction(round % 2 != 0);
  look->SetSea(round % 3 == 1);
  look->SetSeaTileSize(32);
  look->AddWave(0.02, 2.0, 30.0);
  look->SetWaveGeometry(round % 3 == 2);
  look->SetWaveGridSize(16);
  water->GetReflectionPass()->SetMultiSamples(round % 4 == 3 ? 4 : 0);
  water->GetReflectionPass()->SetInstrumentation(true);
}

// A water comes, is rendered at two sizes and goes; the window and its other props stay.
void LiveOneLife(WaterTestScene& scene, int round)
{
  vtkNew<vtkWaterActor> water;
  water->SetSheetBounds(-9, 9, -8, 14);
  Dress(water, round);
  scene.Renderer->AddActor(water);
  scene.Window->SetSize(60, 45);
  scene.Window->Render();
  scene.Window->SetSize(50 + round % 12, 40);
  scene.Window->Render();
  if (round % 2)
  {
    water->ReleaseGraphicsResources(scene.Window);
    scene.Window->Render();
  }
  scene.Renderer->RemoveActor(water);
  scene.Window->Render();
}

// A window of its own.
void LiveWithWindow(int round)
{
  WaterTestScene scene;
  scene.AddThings<vtkPolyDataMapper>();
  scene.AddWater();
  Dress(scene.Water, round);
  scene.Window->SetSize(60, 45);
  scene.Window->Render();
}

Count Take(WaterTestScene& scene)
{
  vtkOpenGLRenderWindow::SafeDownCast(scene.Window)->MakeCurrent();
  Count count;
  CountObjects(count);
  count.Descriptors = CountDescriptors();
  count.Megabytes = ReadMegabytes();
  std::cout << count.Objects << " GL objects, " << count.Queries << " queries, "
            << count.Descriptors << " descriptors, " << count.Megabytes << " MB" << std::endl;
  return count;
}
}

int TestWaterLeaks(int argc, char* argv[])
{
  int rounds = 2 * kPeriod;
  for (int i = 1; i + 1 < argc; ++i)
  {
    rounds = std::strcmp(argv[i], "--rounds") == 0 ? std::atoi(argv[i + 1]) : rounds;
  }
  WaterTestScene scene;
  scene.AddThings<vtkPolyDataMapper>();
  for (int round = 0; round < kWarmUp; ++round)
  {
    LiveOneLife(scene, round);
  }
  for (int round = 0; round < kPeriod; ++round)
  {
    LiveWithWindow(round);
  }
  const Count before = Take(scene);
  for (int round = 0; round < rounds; ++round)
  {
    LiveOneLife(scene, round);
  }
  const Count between = Take(scene);
  for (int round = 0; round < rounds; ++round)
  {
    LiveWithWindow(round);
  }
  const Count after = Take(scene);
  bool ok = WaterCheck("GL objects after lives of waters", between.Objects, before.Objects);
  ok &= WaterCheck("GL objects after lives of windows", after.Objects, before.Objects);
  const bool hasFewQueries = between.Queries <= kQueries && after.Queries <= kQueries;
  ok &= WaterCheck("no more queries than VTK's own", hasFewQueries, true);
  ok &= WaterCheck("descriptors", after.Descriptors, before.Descriptors);
  const double grown[2] = { between.Megabytes - before.Megabytes,
    after.Megabytes - between.Megabytes };
  std::cout << "memory grown by " << grown[0] << " and " << grown[1] << " MB" << std::endl;
#if defined(__SANITIZE_ADDRESS__)
  std::cout << "not judged: the address sanitizer keeps what is freed" << std::endl;
#else
  ok &= WaterCheck("each by less than 24 MB", grown[0] < 24.0 && grown[1] < 24.0, true);
#endif
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
