// SPDX-License-Identifier: BSD-3-Clause
// What a rank is told of a frame when it cannot reach the others: its own scene. And what tells its
// controllers apart, whichever pass has them.
#include "WaterSocketRanks.h"
#include "WaterTestScene.h"

#include "vtkWaterRanks.h"

#include <algorithm>

int TestWaterLostRanks(int, char*[])
{
  const WaterSockets sockets = WaterConnect(2);
  if (sockets.empty())
  {
    return EXIT_FAILURE;
  }
  const WaterSocketRank self(sockets, 0); // nobody has the other end
  vtkWaterRanks ranks;
  ranks.SetController(self.Controller);
  water_rank_frame mine = water_rank_frame();
  const double own[6] = { -1.0, 1.0, -2.0, 2.0, -3.0, 3.0 };
  std::copy_n(own, 6, mine.scene_bounds);
  double bounds[6] = { 7.0, 7.0, 7.0, 7.0, 7.0, 7.0 };
  bool areGone = true;
  vtkWaterError error;
  bool ok =
    WaterCheck("frames of lost ranks", ranks.JoinFrames(mine, bounds, &areGone, error), false);
  ok &= WaterCheck("an error", error.Text.empty(), false);
  ok &= WaterCheck("the bounds are its own", std::equal(own, own + 6, bounds), true);

  vtkWaterRanks others;
  others.SetController(self.Controller);
  ok &= WaterCheck("stamps differ", others.GetStamp() != ranks.GetStamp(), true);
  const vtkMTimeType stamp = ranks.GetStamp();
  ranks.SetController(nullptr);
  ok &= WaterCheck("no stamp of one", ranks.GetStamp(), vtkMTimeType(0));
  ranks.SetController(self.Controller);
  ok &= WaterCheck("a stamp anew", ranks.GetStamp() > stamp, true);
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
