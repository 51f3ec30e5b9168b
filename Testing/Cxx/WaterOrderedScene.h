// SPDX-License-Identifier: BSD-3-Clause
// WaterOrderedScene.h: the test scene, divided between ranks by planes, for engines that blend the
// ranks' pictures from the farthest to the nearest; and its serial picture.
#ifndef WaterOrderedScene_h
#define WaterOrderedScene_h

#include "WaterPictures.h"
#include "WaterRankScene.h"
#include "WaterTestScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDummyController.h"
#include "vtkMultiProcessController.h"
#include "vtkPlaneSource.h"
#include "vtkSmartPointer.h"
#include "vtkWaterReflectionPass.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <vector>

// Where space is divided: the ranks 0 and 1 are near (y < kWaterCutY), 2 and 3 far; 1 and 3 are on
// the right (x > kWaterCutX). Of two ranks 0 is near, and 1 far.
constexpr double kWaterCutY = 0.25;
constexpr double kWaterCutX = 1.25;

inline int WaterRankAt(const double position[3], int ranks)
{
  const int far = position[1] > kWaterCutY ? 1 : 0;
  return ranks < 4 ? far * (ranks - 1) : 2 * far + (position[0] > kWaterCutX ? 1 : 0);
}

// What is compared.
struct WaterOrderedLook
{
  const char* Name;
  bool IsWet;
  bool IsClear;
  bool IsEndless; // to the horizon
  bool HasGlass;  // upright panes, of which each rank has one
  double Limit;   // root mean square of the difference, of 255; 0: no pixel is off by more than 1
  bool IsTranslucent = false; // water with an Opacity below 1
  bool IsSubmerged = false;   // the eye is under the water
  bool IsFaint = false;       // the water's actor has an opacity below 1
  bool IsPlain = false;       // the ranks' waters differ in a second frame: an error
};

inline std::vector<WaterOrderedLook> WaterOrderedLooks()
{
  return { { "dry", false, false, false, false, 0.0 },
    { "opaque water", true, false, false, false, 0.0 },
    { "clear water", true, true, false, false, 0.0 },
    { "opaque water to the horizon", true, false, true, false, 0.0 },
    { "clear water to the horizon", true, true, true, false, 0.0 },
    { "dry with panes", false, false, false, true, 1.0 },
    { "opaque water with panes", true, false, false, true, 1.0 },
    { "clear water with panes", true, true, false, true, 1.0 },
    { "translucent water", true, false, false, false, 1.0, true }, // blended, as panes are
    { "translucent water to the horizon", true, false, true, false, 1.0, true },
    { "translucent water with panes", true, false, false, true, 1.0, true },
    { "water of a translucent actor", true, false, false, false, 1.0, false, false, true },
    // it hides what the ranks that do not show it have under it
    { "plain translucent water", true, false, false, false, 8.0, true, false, false, true },
    { "clear water from below", true, true, true, false, 0.0, false, true },
    { "clear water from below with panes", true, true, true, true, 1.0, false, true } };
}

struct WaterOrderedScene : public WaterTestScene
{
  // rank: whose part it is; -1: all of it
  WaterOrderedScene(const WaterOrderedLook& look, int rank, int ranks)
  {
    this->Window->SetSize(160, 120);
    this->Window->SetAlphaBitPlanes(1); // pictures are blended by it
    this->AddThings<vtkPolyDataMapper>();
    if (look.HasGlass)
    {
      this->AddPanes();
    }
    this->AddWater();
    if (look.IsEndless)
    {
      this->Water->SetSheetToHorizon();
    }
    this->Water->SetVisibility(look.IsWet);
    this->Water->GetWaterProperty()->SetRefraction(look.IsClear);
    this->Water->GetWaterProperty()->SetOpacity(look.IsTranslucent ? 0.6 : 1.0);
    this->Water->GetProperty()->SetOpacity(look.IsFaint ? 0.6 : 1.0);
    if (look.IsPlain)
    {
      vtkNew<vtkCallbackCommand> nothing; // the error is asked for, not printed
      nothing->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
      this->Water->AddObserver(vtkCommand::ErrorEvent, nothing);
    }
    if (look.IsSubmerged)
    {
      this->Renderer->GetActiveCamera()->SetPosition(3, -15, -0.9);
      this->Renderer->GetActiveCamera()->SetFocalPoint(0, 0, -0.3);
      this->Water->GetWaterProperty()->SetDeepColor(0.1, 0.4, 0.5); // a haze that shows
      this->Water->GetWaterProperty()->SetAbsorption(0.1, 0.05, 0.03);
    }
    this->Renderer->SetUseDepthPeeling(1);
    this->Renderer->SetMaximumNumberOfPeels(20);
    this->Renderer->SetOcclusionRatio(0.0);
    if (rank >= 0)
    {
      WaterKeepProps(*this,
        [&](vtkActor* actor, int) { return WaterRankAt(actor->GetCenter(), ranks) == rank; });
    }
  }

  std::vector<vtkSmartPointer<vtkObject>> Kept; // of the engine

  // A rank's part of the space.
  static void FindRegion(int rank, int ranks, double region[6])
  {
    const double endless = std::numeric_limits<double>::infinity();
    const bool isFar = ranks < 4 ? rank > 0 : rank > 1;
    const bool isLeft = ranks < 4 || rank % 2 == 0;
    const bool isRight = ranks < 4 || rank % 2 == 1;
    const double bounds[6] = { isLeft ? -endless : kWaterCutX, isRight ? endless : kWaterCutX,
      isFar ? kWaterCutY : -endless, isFar ? endless : kWaterCutY, -endless, endless };
    std::copy_n(bounds, 6, region);
  }

  // The rank that is farthest from the camera, which is at the near right: of four that of the far
  // left.
  static int GetFarthest(int ranks) { return ranks < 4 ? ranks - 1 : 2; }

  void Blacken()
  {
    this->Renderer->GradientBackgroundOff();
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
  }

  std::vector<unsigned char> Show()
  {
    this->Window->Render();
    return WaterRead(this->Window);
  }

private:
  void AddPanes()
  {
    for (int i = 0; i < 4; ++i)
    {
      vtkNew<vtkPlaneSource> pane;
      const double x = i % 2 == 0 ? -3.5 : 1.6;
      const double y = i < 2 ? -3.0 : 2.9;
      pane->SetOrigin(x, y, -1.0);
      pane->SetPoint1(x + 3.5, y, -1.0);
      pane->SetPoint2(x, y, 2.6);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(pane->GetOutputPort());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->GetProperty()->SetColor(0.3 * i, 0.2, 1.0 - 0.3 * i);
      actor->GetProperty()->SetOpacity(0.45);
      this->Renderer->AddActor(actor);
    }
  }
};

// An engine that joins the ranks' pictures on the root.
struct WaterEngine
{
  std::string Name;
  bool IsOrdered; // it blends the pictures in the order of the ranks
  bool IsBlack;   // it wants a black background
  // Makes a scene one of the engine's.
  std::function<void(WaterOrderedScene&, vtkMultiProcessController*)> Arrange;
};

// Shows each look on all ranks. Does each equal the serial picture as nearly as it does without
// water?
inline bool WaterCheckEngine(const WaterEngine& engine, vtkMultiProcessController* controller)
{
  constexpr double kShare = 0.0002;
  const int rank = controller->GetLocalProcessId();
  const int ranks = controller->GetNumberOfProcesses();
  bool isGood = true;
  WaterDifference floor = { 0.0, 0.0 };
  for (const WaterOrderedLook& look : WaterOrderedLooks())
  {
    if ((look.HasGlass || look.IsTranslucent || look.IsFaint) && !engine.IsOrdered)
    {
      continue; // an engine that compares depths does not blend what is translucent of several
                // ranks
    }
    WaterOrderedScene scene(look, rank, ranks);
    vtkWaterReflectionPass* pass = scene.Water->GetReflectionPass();
    pass->SetController(controller);
    pass->SetFarthestRank(engine.IsOrdered ? WaterOrderedScene::GetFarthest(ranks) : -1);
    if (engine.IsOrdered)
    {
      double region[6];
      WaterOrderedScene::FindRegion(rank, ranks, region);
      pass->SetRankRegion(region);
    }
    pass->KeepBackground(scene.Renderer); // whatever the engine makes of it
    if (engine.IsBlack)
    {
      scene.Blacken();
    }
    engine.Arrange(scene, controller);
    std::vector<unsigned char> picture = scene.Show();
    if (look.IsPlain)
    {
      scene.Water->GetWaterProperty()->SetReflectance(0.01 * (rank + 1));
      scene.Water->GetWaterProperty()->SetReflectanceModeToConstant();
      picture = scene.Show();
    }
    const std::string error = scene.Water->GetLastError();
    if (error.empty() == look.IsPlain)
    {
      std::cerr << engine.Name << ", " << look.Name << ", rank " << rank << ": " << error
                << std::endl;
      isGood = false;
    }
    if (rank != 0)
    {
      continue;
    }
    WaterOrderedScene serial(look, -1, ranks);
    if (engine.IsBlack)
    {
      serial.Water->GetReflectionPass()->KeepBackground(serial.Renderer);
      serial.Blacken();
    }
    vtkNew<vtkDummyController> mute; // without a communicator: an error
    mute->SetCommunicator(nullptr);
    serial.Water->GetReflectionPass()->SetController(look.IsPlain ? mute.Get() : nullptr);
    const std::vector<unsigned char> expected = serial.Show();
    const WaterDifference found = WaterCompare(picture, expected);
    WaterLeave(engine.Name + " " + look.Name, picture, scene.Window);
    WaterLeave(std::string("serial ") + look.Name, expected, serial.Window);
    floor = look.IsWet ? floor : found;
    isGood = isGood && floor.Share < 0.01; // or the engine is not set up as it should be
    const bool isNear = look.Limit > 0.0 ? found.Rms <= std::max(floor.Rms, 0.0) + look.Limit
                                         : found.Share <= floor.Share + kShare;
    std::cout << engine.Name << ", " << ranks << " ranks, " << look.Name << ": share of pixels off "
              << found.Share << ", RMS " << found.Rms << " of 255 (limit: "
              << (look.Limit > 0.0 ? floor.Rms + look.Limit : floor.Share + kShare) << ") "
              << (isNear ? "ok" : "FAILED") << std::endl;
    isGood = isNear && isGood;
  }
  return isGood;
}

#endif
