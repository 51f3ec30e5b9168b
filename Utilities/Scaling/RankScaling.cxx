// SPDX-License-Identifier: BSD-3-Clause
// RankScaling RANKS PROPS WIDTH HEIGHT LATENCY_US:MB_PER_S...: a frame of a scene that is split
// over processes, on each of some simulated networks (MB_PER_S 0: no limit). Prints one line of
// JSON: per frame the processor's time of the busiest rank, bytes and messages of all ranks and of
// the busiest, and for each network its time on the slowest rank.
#include "WaterRankScene.h"
#include "WaterSocketRanks.h"
#include "WaterTestScene.h"

#include "vtkWaterReflectionPass.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

namespace
{
constexpr unsigned int kPatience = 120; // s, until a process that waits for another is ended

struct Network
{
  double Latency; // s
  double SecondsPerByte;
};

struct Task
{
  int Ranks;
  int Props;
  int Size[2];
  std::vector<Network> Networks;
};

double ProcessorTime()
{
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

bool Run(const WaterSocketRank& self, const Task& task)
{
  constexpr int kResolution = 48; // drawing a ball takes time
  WaterTestScene scene;
  scene.Window->SetSize(task.Size[0], task.Size[1]);
  WaterAddBalls(scene, task.Props, task.Ranks, kResolution, self.Rank);
  scene.AddWater();
  auto* pass = scene.Water->GetReflectionPass();
  pass->SetController(self.Controller);
  scene.Window->Render(); // shaders are built
  // processor's time, bytes, messages; then the networks' times
  std::vector<double> mine(3 + task.Networks.size());
  const double frames = static_cast<double>(task.Networks.size());
  WaterSocketCommunicator* line = self.Communicator;
  for (size_t i = 0; i < task.Networks.size(); ++i)
  {
    scene.Renderer->GetActiveCamera()->Azimuth(2.0);
    self.Controller->Barrier();
    line->Latency = task.Networks[i].Latency;
    line->SecondsPerByte = task.Networks[i].SecondsPerByte;
    line->Clock = 0.0;
    const double before[3] = { ProcessorTime(), static_cast<double>(line->BytesSent),
      static_cast<double>(line->MessagesSent) };
    scene.Window->Render();
    mine[0] += (ProcessorTime() - before[0]) / frames;
    mine[1] += (static_cast<double>(line->BytesSent) - before[1]) / frames;
    mine[2] += (static_cast<double>(line->MessagesSent) - before[2]) / frames;
    mine[3 + i] = line->Clock;
    scene.Renderer->GetActiveCamera()->Azimuth(-2.0); // each network gets the same view
    scene.Window->Render();
  }
  const auto size = static_cast<vtkIdType>(mine.size());
  std::vector<double> sum(mine.size());
  std::vector<double> most(mine.size());
  self.Controller->Reduce(mine.data(), sum.data(), size, vtkCommunicator::SUM_OP, 0);
  self.Controller->Reduce(mine.data(), most.data(), size, vtkCommunicator::MAX_OP, 0);
  if (self.Rank == 0)
  {
    std::printf("{\"ranks\": %d, \"props\": %d, \"pixels\": %lld, \"work\": %.6f, \"bytes\": %.0f, "
                "\"bytes_most\": %.0f, \"messages\": %.0f, \"messages_most\": %.0f, \"network\": [",
      task.Ranks, task.Props, static_cast<long long>(pass->GetNumberOfPixelsJoined()), most[0],
      sum[1], most[1], sum[2], most[2]);
    for (size_t i = 3; i < most.size(); ++i)
    {
      std::printf("%s%.9f", i > 3 ? ", " : "", most[i]);
    }
    std::printf("]}\n");
    std::fflush(stdout);
  }
  return std::string(scene.Water->GetLastError()).empty() &&
    pass->GetDecision() == vtkWaterReflectionPass::RENDERED;
}
}

int main(int argc, char* argv[])
{
  if (argc < 6)
  {
    std::fprintf(stderr, "usage: %s RANKS PROPS WIDTH HEIGHT LATENCY_US:MB_PER_S...\n", argv[0]);
    return EXIT_FAILURE;
  }
  Task task = { std::atoi(argv[1]), std::atoi(argv[2]), { std::atoi(argv[3]), std::atoi(argv[4]) },
    {} };
  for (int i = 5; i < argc; ++i)
  {
    double latency = 0.0;
    double speed = 0.0;
    if (std::sscanf(argv[i], "%lf:%lf", &latency, &speed) != 2)
    {
      std::fprintf(stderr, "no network: %s\n", argv[i]);
      return EXIT_FAILURE;
    }
    task.Networks.push_back({ 1e-6 * latency, speed > 0.0 ? 1e-6 / speed : 0.0 });
  }
  const bool isGood = WaterRunRanks(
    task.Ranks, kPatience, [&](const WaterSocketRank& self) { return Run(self, task); });
  return isGood ? EXIT_SUCCESS : EXIT_FAILURE;
}
