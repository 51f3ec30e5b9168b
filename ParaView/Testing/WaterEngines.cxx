// SPDX-License-Identifier: BSD-3-Clause
// WaterEngines: what TestEngines.py starts with mpirun. ParaView's VTK has all engines that join
// the pictures of MPI's ranks; with each of them the water's picture is the serial one.
//
//   WaterEngines depth|blend|icet|icet-ordered
#include "WaterOrderedPasses.h"

#include "vtkBoundingBox.h"
#include "vtkCompositedSynchronizedRenderers.h"
#include "vtkIceTCompositePass.h"
#include "vtkMPIController.h"
#include "vtkOrderedCompositingHelper.h"
#include "vtkRenderStepsPass.h"

#include <cstdlib>
#include <iostream>
#include <map>
#include <string>

namespace
{
void SynchronizeRenderers(WaterOrderedScene& scene, vtkMultiProcessController* controller)
{
  vtkNew<vtkCompositedSynchronizedRenderers> together;
  together->SetRenderer(scene.Renderer);
  together->SetParallelController(controller);
  together->SetRootProcessId(0);
  scene.Kept.emplace_back(together);
}

// The box of each rank's part of the space.
std::vector<vtkBoundingBox> BoxesOf(int ranks)
{
  const double most = 20.0;
  std::vector<vtkBoundingBox> boxes;
  for (int rank = 0; rank < ranks; ++rank)
  {
    const int far = ranks > 3 ? rank / 2 : rank;
    const double y[2] = { far ? kWaterCutY : -most, far ? most : kWaterCutY };
    double x[2] = { -most, most };
    if (ranks > 3)
    {
      x[rank % 2 == 0] = kWaterCutX;
    }
    boxes.emplace_back(x[0], x[1], y[0], y[1], -most, most);
  }
  return boxes;
}

void ArrangeIceT(WaterOrderedScene& scene, vtkMultiProcessController* controller, bool isOrdered)
{
  vtkNew<vtkDepthPeelingPass> peeling; // panes and translucent water of one rank
  peeling->SetMaximumNumberOfPeels(20);
  peeling->SetOcclusionRatio(0.0);
  peeling->SetTranslucentPass(vtkNew<vtkTranslucentPass>());
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetTranslucentPass(peeling);
  vtkNew<vtkIceTCompositePass> pass;
  pass->SetController(controller);
  pass->SetRenderPass(steps);
  pass->SetDisplayRGBAResults(true);
  pass->SetRenderEmptyImages(true);
  vtkNew<vtkOrderedCompositingHelper> order;
  order->SetBoundingBoxes(BoxesOf(controller->GetNumberOfProcesses()));
  pass->SetUseOrderedCompositing(isOrdered);
  pass->SetOrderedCompositingHelper(order);
  scene.Renderer->SetPass(pass);
}

bool Check(const std::string& name, vtkMultiProcessController* controller)
{
  const auto iceT = [](bool isOrdered) {
    return [isOrdered](WaterOrderedScene& scene, vtkMultiProcessController* ranks) {
      ArrangeIceT(scene, ranks, isOrdered);
    };
  };
  const std::map<std::string, WaterEngine> engines = {
    { "depth", { "vtkCompositedSynchronizedRenderers", false, false, SynchronizeRenderers } },
    { "blend", { "vtkCompositeRGBAPass", true, true, WaterArrangePasses } },
    { "icet", { "vtkIceTCompositePass", false, true, iceT(false) } },
    { "icet-ordered", { "vtkIceTCompositePass, ordered", true, true, iceT(true) } }
  };
  const auto found = engines.find(name);
  if (found == engines.end())
  {
    std::cerr << "engine '" << name << "': depth, blend, icet or icet-ordered\n";
    return false;
  }
  return WaterCheckEngine(found->second, controller);
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  const bool isGood = Check(argc > 1 ? argv[1] : "", controller);
  int mine = isGood ? 1 : 0;
  int all = 0;
  controller->AllReduce(&mine, &all, 1, vtkCommunicator::MIN_OP);
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return all ? EXIT_SUCCESS : EXIT_FAILURE;
}
