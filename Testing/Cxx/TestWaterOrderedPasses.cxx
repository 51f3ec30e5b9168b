// SPDX-License-Identifier: BSD-3-Clause
// A scene whose parts are blended in their order by VTK's vtkCompositeZPass and
// vtkCompositeRGBAPass shows the picture of one process: with opaque and clear water, and with
// translucent panes. The processes are forked and talk over sockets: no MPI is needed.
#include "WaterOrderedPasses.h"
#include "WaterSocketRanks.h"

#include <cstdlib>

int TestWaterOrderedPasses(int, char*[])
{
  constexpr unsigned int kPatience = 100; // s, until a process that waits for another is ended
  // a background that is not black, or not transparent, would hide the ranks behind
  const WaterEngine engine = { "vtkCompositeRGBAPass", true, true, WaterArrangePasses };
  bool isGood = true;
  for (const int ranks : { 2, 4 })
  {
    isGood =
      WaterRunRanks(ranks, kPatience,
        [&](const WaterSocketRank& self) { return WaterCheckEngine(engine, self.Controller); }) &&
      isGood;
  }
  return isGood ? EXIT_SUCCESS : EXIT_FAILURE;
}
