// SPDX-License-Identifier: BSD-3-Clause
// RankDevices RANKS DEVICES PROPS RESOLUTION WIDTH HEIGHT FRAMES: what a frame takes on ranks of
// one host of which each has a GPU of its own, with and without water. The ranks are processes that
// talk over sockets: no MPI is needed. Rank i renders on the EGL device i modulo DEVICES. PROPS
// balls of 2 x RESOLUTION x RESOLUTION triangles are split over the ranks.
//
// Prints one line of JSON: the GPU of each rank; for a frame without and with water, of which each
// rank shows its part or VTK's engine composites all, the median milliseconds of the slowest rank;
// bytes and messages of a frame with water; and the share of pixels by which the composited
// pictures differ from those of one process.
#include "WaterPictures.h"
#include "WaterRankScene.h"
#include "WaterSocketRanks.h"
#include "WaterTestScene.h"

#include "vtkCompositedSynchronizedRenderers.h"
#include "vtkWaterReflectionPass.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <string>
#include <vector>

namespace
{
constexpr unsigned int kPatience = 540; // s, until a process that waits for another is ended
constexpr int kIdSize = 16;             // bytes of a GPU's identity

struct Task
{
  int Ranks;
  int Devices;
  int Props;
  int Resolution;
  int Size[2];
  int Frames;
};

// A rank's part; rank -1: all of it.
void Fill(WaterTestScene& scene, const Task& task, int rank)
{
  WaterAddBalls(scene, task.Props, task.Ranks, task.Resolution, rank);
  scene.Window->SetSize(task.Size[0], task.Size[1]);
}

// The GPU of the current context, as its driver names it (GL_EXT_memory_object); zeros: it does
// not.
void FindDevice(unsigned char id[kIdSize])
{
  using Ask = void (*)(unsigned int, unsigned int, unsigned char*);
  using Find = Ask (*)(const char*);
  constexpr unsigned int deviceUuid = 0x9597; // GL_DEVICE_UUID_EXT
  std::memset(id, 0, kIdSize);
  void* egl = dlopen("libEGL.so.1", RTLD_NOW);
  const auto find = egl ? reinterpret_cast<Find>(dlsym(egl, "eglGetProcAddress")) : nullptr;
  const Ask ask = find ? find("glGetUnsignedBytei_vEXT") : nullptr;
  if (ask)
  {
    ask(deviceUuid, 0, id);
  }
}

// A kind of frame: a scene that is composited, or of which each rank shows its part.
struct Kind
{
  const char* Name;
  bool IsWet;
  bool IsComposited;
};
constexpr Kind kKinds[] = { { "dry_part", false, false }, { "wet_part", true, false },
  { "dry", false, true }, { "wet", true, true } };
constexpr int kKindCount = 4;

// One rank's scene without or with water.
struct Part
{
  Part(const Task& task, vtkMultiProcessController* controller, bool isWet)
  {
    Fill(this->Scene, task, controller->GetLocalProcessId());
    if (isWet)
    {
      this->Scene.AddWater();
      this->Scene.Water->GetReflectionPass()->SetController(controller);
    }
    this->Engine->SetRenderer(this->Scene.Renderer);
    this->Engine->SetParallelController(controller);
    this->Engine->SetRootProcessId(0);
  }

  WaterTestScene Scene;
  vtkNew<vtkCompositedSynchronizedRenderers> Engine;
};

struct Figures
{
  double Time = 0.0;  // ms, on the slowest rank
  double Bytes = 0.0; // that this rank has sent
  double Messages = 0.0;
};

// Renders a new frame.
Figures Measure(Part& part, vtkMultiProcessController* controller, bool isComposited)
{
  Figures figures;
  const auto* line = static_cast<WaterSocketCommunicator*>(controller->GetCommunicator());
  part.Engine->SetParallelRendering(isComposited && controller->GetNumberOfProcesses() > 1);
  part.Scene.Renderer->GetActiveCamera()->Azimuth(0.5);
  controller->Barrier();
  const double before[2] = { static_cast<double>(line->BytesSent),
    static_cast<double>(line->MessagesSent) };
  const auto begun = std::chrono::steady_clock::now();
  part.Scene.Window->Render();
  part.Scene.Window->WaitForCompletion();
  const double mine =
    std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
  figures.Bytes = static_cast<double>(line->BytesSent) - before[0];
  figures.Messages = static_cast<double>(line->MessagesSent) - before[1];
  controller->AllReduce(&mine, &figures.Time, 1, vtkCommunicator::MAX_OP);
  return figures;
}

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void PrintDevices(vtkMultiProcessController* controller)
{
  unsigned char mine[kIdSize];
  FindDevice(mine);
  std::vector<unsigned char> all(
    static_cast<size_t>(kIdSize) * static_cast<size_t>(controller->GetNumberOfProcesses()));
  controller->Gather(mine, all.data(), kIdSize, 0);
  if (controller->GetLocalProcessId() == 0)
  {
    std::printf("\"gpus\": [");
    for (size_t i = 0; i < all.size(); ++i)
    {
      const bool isFirst = i % kIdSize == 0;
      std::printf("%s%02x%s", isFirst ? (i ? ", \"" : "\"") : "", all[i],
        i % kIdSize == kIdSize - 1 ? "\"" : "");
    }
    std::printf("], ");
  }
}

bool Run(const WaterSocketRank& self, const Task& task)
{
  const int rank = self.Rank;
  const std::string device = std::to_string(task.Devices > 0 ? rank % task.Devices : 0);
  setenv("VTK_DEFAULT_EGL_DEVICE_INDEX", device.c_str(), 1);
  vtkMultiProcessController* controller = self.Controller;
  Part dry(task, controller, false);
  Part wet(task, controller, true);
  bool isGood = true;
  double off[2] = { 0.0, 0.0 };
  for (Part* part : { &dry, &wet }) // shaders are built
  {
    Measure(*part, controller, true);
    const std::vector<unsigned char> picture = WaterRead(part->Scene.Window);
    if (rank == 0)
    {
      WaterTestScene serial;
      Fill(serial, task, -1);
      serial.Renderer->GetActiveCamera()->DeepCopy(part->Scene.Renderer->GetActiveCamera());
      if (part == &wet)
      {
        serial.AddWater();
      }
      serial.Window->Render();
      off[part == &wet] = WaterCompare(picture, WaterRead(serial.Window)).Share;
    }
    controller->Barrier();
  }
  std::vector<double> times[kKindCount];
  double bytes = 0.0;
  double messages = 0.0;
  for (int frame = 0; frame < task.Frames + 2; ++frame)
  {
    for (int kind = 0; kind < kKindCount; ++kind)
    {
      const Figures figures =
        Measure(kKinds[kind].IsWet ? wet : dry, controller, kKinds[kind].IsComposited);
      if (frame < 2)
      {
        continue; // buffers are made
      }
      times[kind].push_back(figures.Time);
      if (kKinds[kind].IsWet && !kKinds[kind].IsComposited)
      {
        bytes += figures.Bytes / task.Frames;
        messages += figures.Messages / task.Frames;
      }
    }
  }
  auto* pass = wet.Scene.Water->GetReflectionPass();
  isGood = std::string(wet.Scene.Water->GetLastError()).empty() &&
    pass->GetDecision() == vtkWaterReflectionPass::RENDERED;
  const double mine[2] = { bytes, messages };
  double sum[2] = { 0.0, 0.0 };
  controller->Reduce(mine, sum, 2, vtkCommunicator::SUM_OP, 0);
  if (rank == 0)
  {
    std::printf("{\"ranks\": %d, \"devices\": %d, \"props\": %d, \"triangles\": %lld, "
                "\"size\": [%d, %d], \"frames\": %d, ",
      task.Ranks, task.Devices, task.Props, 2LL * task.Props * task.Resolution * task.Resolution,
      task.Size[0], task.Size[1], task.Frames);
  }
  PrintDevices(controller);
  if (rank == 0)
  {
    for (int kind = 0; kind < kKindCount; ++kind)
    {
      std::printf("\"%s_ms\": %.3f, ", kKinds[kind].Name, Median(times[kind]));
    }
    std::printf("\"bytes\": %.0f, \"messages\": %.0f, \"pixels\": %lld, \"off_dry\": %.6f, "
                "\"off_wet\": %.6f}\n",
      sum[0], sum[1], static_cast<long long>(pass->GetNumberOfPixelsJoined()), off[0], off[1]);
    std::fflush(stdout);
  }
  return isGood;
}
}

int main(int argc, char* argv[])
{
  if (argc != 8)
  {
    std::fprintf(stderr, "usage: %s RANKS DEVICES PROPS RESOLUTION WIDTH HEIGHT FRAMES\n", argv[0]);
    return EXIT_FAILURE;
  }
  const Task task = { std::atoi(argv[1]), std::atoi(argv[2]), std::atoi(argv[3]),
    std::atoi(argv[4]), { std::atoi(argv[5]), std::atoi(argv[6]) }, std::atoi(argv[7]) };
  if (task.Ranks < 1 || task.Props < task.Ranks || task.Resolution < 3 || task.Size[0] < 1 ||
    task.Size[1] < 1 || task.Frames < 1)
  {
    std::fprintf(stderr,
      "RANKS, WIDTH, HEIGHT and FRAMES must be at least 1, PROPS at least RANKS, "
      "RESOLUTION at least 3\n");
    return EXIT_FAILURE;
  }
  const bool isGood = WaterRunRanks(
    task.Ranks, kPatience, [&](const WaterSocketRank& self) { return Run(self, task); });
  return isGood ? EXIT_SUCCESS : EXIT_FAILURE;
}
