// SPDX-License-Identifier: BSD-3-Clause
// What ranks send each other is counted: the pixels of a mirrored view, as many bytes as the same
// part of a composited picture takes; 64 bytes a prop; nothing but the agreement while nothing
// changes; and as many calls whatever a rank sees.
#include "WaterSocketRanks.h"
#include "WaterTestScene.h"

#include "vtkPropCollection.h"
#include "vtkWaterReflectionPass.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace
{
constexpr unsigned int kPatience = 60; // s, until a process that waits for another is ended
constexpr double kBytesOfPixel = 8.0;  // of a picture: four of its colour, a float of its depth
constexpr double kMore = 1.1;          // than a picture of the rectangle takes
constexpr double kBytesOfProp = 64.0;

struct Sent
{
  double Bytes = 0.0;
  double Messages = 0.0;
};

// A frame of one rank, and what all have sent for it, on rank 0.
Sent Show(WaterTestScene& scene, const WaterSocketRank& self)
{
  WaterSocketCommunicator* line = self.Communicator;
  const double before[2] = { static_cast<double>(line->BytesSent),
    static_cast<double>(line->MessagesSent) };
  scene.Window->Render();
  const double mine[2] = { static_cast<double>(line->BytesSent) - before[0],
    static_cast<double>(line->MessagesSent) - before[1] };
  double all[2] = {};
  self.Controller->Reduce(mine, all, 2, vtkCommunicator::SUM_OP, 0);
  return Sent{ all[0], all[1] };
}

// A rank's columns of a city: `count` of them on all ranks, by turns or in a block.
void Fill(WaterTestScene& scene, int rank, int ranks, int count, bool isBlock)
{
  for (int i = 0; i < count; ++i)
  {
    if ((isBlock ? i * ranks / count : i % ranks) == rank)
    {
      vtkNew<vtkCubeSource> column;
      column->SetCenter(-8.5 + 17.0 * (i % 10) / 10, -7.0 + 20.0 * (i / 10) * 10 / count, 0.5);
      column->SetXLength(0.8);
      column->SetYLength(0.8);
      column->SetZLength(2 + 0.1 * (i % 17));
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(column->GetOutputPort());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      scene.Renderer->AddActor(actor);
    }
  }
  scene.AddWater();
}

bool CheckAtMost(const std::string& name, double value, double limit)
{
  const bool holds = value <= limit;
  std::cout << name << ": " << value << " (limit <= " << limit << ") " << (holds ? "ok" : "FAILED")
            << std::endl;
  return holds;
}

bool Run(const WaterSocketRank& self)
{
  const int rank = self.Rank;
  const int ranks = self.Ranks;
  bool isGood = true;
  double agreement[2] = {};
  for (int k = 0; k < 4; ++k)
  {
    const bool isBlock = k % 2 == 1;
    const int count = k < 2 ? 60 : 120;
    WaterTestScene scene;
    Fill(scene, rank, ranks, count, isBlock);
    auto* pass = scene.Water->GetReflectionPass();
    pass->SetController(self.Controller);
    const Sent first = Show(scene, self);
    const double pixels = static_cast<double>(pass->GetNumberOfPixelsJoined());
    const Sent still = Show(scene, self);
    const double joinedAgain = static_cast<double>(pass->GetNumberOfPixelsJoined());
    if (rank != 0)
    {
      continue;
    }
    // a picture that is composited travels once from every rank but the root
    const double picture = kBytesOfPixel * pixels * (ranks - 1);
    const std::string name = std::to_string(ranks) + " ranks, " + std::to_string(count) + " props" +
      (isBlock ? ", in blocks" : ", by turns");
    std::cout << name << ": " << pixels << " pixels, " << first.Messages
              << " messages; still: " << still.Bytes << " bytes, " << still.Messages << " messages"
              << std::endl;
    isGood = CheckAtMost(name + ": bytes of the view, of a picture's",
               (first.Bytes - still.Bytes) / picture, kMore) &&
      isGood;
    isGood = WaterCheck(name + ": pixels joined while nothing changes", joinedAgain, 0.0) && isGood;
    if (isBlock)
    {
      agreement[k / 2] = still.Bytes;
    }
  }
  if (rank == 0)
  {
    // each rank gets to know each prop
    const double bytes = (agreement[1] - agreement[0]) / 60.0 / ranks;
    isGood = CheckAtMost("bytes a prop and rank of the agreement", bytes, kBytesOfProp) && isGood;
  }
  return isGood;
}
}

int TestWaterRankBytes(int, char*[])
{
  bool isGood = true;
  for (const int ranks : { 2, 4 })
  {
    isGood = WaterRunRanks(ranks, kPatience, Run) && isGood;
  }
  return isGood ? EXIT_SUCCESS : EXIT_FAILURE;
}
