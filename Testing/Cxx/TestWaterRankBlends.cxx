// SPDX-License-Identifier: BSD-3-Clause
// Edges of translucent props that ranks blend in a multisampled mirrored view are as smooth as
// those of one process. Each rank has a slanted pane and a post, which only the water shows. The
// processes are forked and talk over sockets: no MPI is needed.
#include "WaterOrderedScene.h"
#include "WaterSocketRanks.h"

#include "vtkTransform.h"
#include "vtkVersionMacros.h"

#include <cstdlib>

namespace
{
constexpr int kRanks = 2;
constexpr int kSamples = 4;             // of windows and views; what llvmpipe has
constexpr unsigned int kPatience = 100; // s, until a process that waits for another is ended

struct Scene : public WaterTestScene
{
  // rank     whose part it is; -1: all of it
  // isPlain  translucent props are blended as they are drawn; else VTK does it in any order, by
  //          framebuffers of its own, which have no samples
  Scene(int rank, bool isPlain)
  {
    this->Window->SetMultiSamples(kSamples);
    this->Window->SetSize(200, 150);
    this->Renderer->GradientBackgroundOff();
    this->Renderer->SetBackground(0.2, 0.5, 0.9);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0) // VTK 9.3 has the second alone
    this->Renderer->SetUseOIT(!isPlain);
#else
    (void)isPlain;
#endif
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, -14.0, 5.0); // onto the water alone
    camera->SetFocalPoint(0.0, -8.0, 0.0);
    camera->SetClippingRange(0.5, 80.0);
    for (int part = kRanks - 1; part >= 0; --part) // far ones first
    {
      if (rank < 0 || part == rank)
      {
        this->AddPart(part);
      }
    }
    this->Water->SetSheetBounds(-40.0, 40.0, -40.0, 40.0);
    this->Water->GetWaterProperty()->SetReflectanceModeToConstant();
    this->Water->GetWaterProperty()->SetReflectance(1.0);
    this->Water->GetReflectionPass()->SetMultiSamples(kSamples);
    this->Renderer->AddActor(this->Water);
  }

private:
  // What stands in a slice of space: 0 is the nearest.
  void AddPart(int part)
  {
    const double y = -4.0 + 4.0 * part;
    vtkNew<vtkPlaneSource> pane;
    pane->SetOrigin(-2.0, 0.0, -2.0);
    pane->SetPoint1(2.0, 0.0, -2.0);
    pane->SetPoint2(-2.0, 0.0, 2.0);
    vtkNew<vtkTransform> place;
    place->Translate(4.5 * part - 2.5, y, 5.0); // beside each other in the picture
    place->RotateY(20.0 + 25.0 * part);         // edges cross the pixels
    vtkNew<vtkCubeSource> post;
    post->SetXLength(0.3);
    post->SetYLength(0.3);
    post->SetZLength(7.0);
    for (const bool isPane : { true, false })
    {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(isPane ? pane->GetOutputPort() : post->GetOutputPort());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->SetUserTransform(place);
      actor->SetPosition(0.0, isPane ? 0.0 : 1.0, 0.0);
      actor->GetProperty()->SetColor(isPane ? 0.9 - 0.8 * part : 0.9, part, isPane ? 0.1 : 0.9);
      actor->GetProperty()->SetOpacity(isPane ? 0.6 : 1.0);
      actor->GetProperty()->LightingOff();
      this->Renderer->AddActor(actor);
    }
  }
};

std::vector<unsigned char> Show(Scene& scene)
{
  scene.Window->Render();
  return WaterRead(scene.Window);
}

bool Compare(vtkMultiProcessController* controller, bool isPlain)
{
  Scene scene(controller->GetLocalProcessId(), isPlain);
  scene.Water->GetReflectionPass()->SetController(controller);
  const std::vector<unsigned char> picture = Show(scene);
  const std::string error = scene.Water->GetLastError();
  std::cerr << error;
  if (controller->GetLocalProcessId() != 0)
  {
    return error.empty();
  }
  Scene serial(-1, isPlain);
  Scene alone(0, isPlain); // what the water shows of one rank
  const std::vector<unsigned char> expected = Show(serial);
  WaterLeave(isPlain ? "blends in order" : "blends", picture, scene.Window);
  WaterLeave(isPlain ? "serial blends in order" : "serial blends", expected, serial.Window);
  const WaterDifference found = WaterCompare(picture, expected);
  const WaterDifference shown = WaterCompare(Show(alone), expected);
  constexpr double kRms = 0.25;    // of 255
  constexpr double kShare = 0.001; // both kinds of edges in a pixel
  std::cout << (isPlain ? "blended in their order: RMS " : "in any order: RMS ") << found.Rms
            << " of 255 (limit: " << kRms << "), share of pixels off " << found.Share
            << " (limit: " << kShare << "); of one rank alone: " << shown.Rms << ", " << shown.Share
            << std::endl;
  return error.empty() && found.Rms <= kRms && found.Share <= kShare && shown.Rms > 5.0;
}

bool Run(const WaterSocketRank& self)
{
  const bool isGood = Compare(self.Controller, false);
  return Compare(self.Controller, true) && isGood;
}
}

int TestWaterRankBlends(int, char*[])
{
  return WaterRunRanks(kRanks, kPatience, Run) ? EXIT_SUCCESS : EXIT_FAILURE;
}
