// SPDX-License-Identifier: BSD-3-Clause
// A scene that is split over processes and composited by VTK's own sort-last renderer shows the
// picture of one process. The processes are forked and talk over sockets: no MPI is needed.
#include "WaterPictures.h"
#include "WaterRankScene.h"
#include "WaterSocketRanks.h"
#include "WaterTestScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkCompositedSynchronizedRenderers.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkWaterGL.h"
#include "vtkWaterReflectionPass.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{
constexpr int kRanks = 3;
constexpr unsigned int kPatience = 100; // s, until a process that waits for another is ended
constexpr double kShare = 0.0002;       // of the pixels, that may be off by more than 1 of 255

std::vector<unsigned char> Show(WaterTestScene& scene)
{
  scene.Window->Render();
  return WaterRead(scene.Window);
}

void Fill(WaterTestScene& scene, bool isWet, bool isClear)
{
  scene.AddThings<vtkPolyDataMapper>();
  scene.AddWater();
  scene.Water->SetVisibility(isWet);
  scene.Water->GetWaterProperty()->SetRefraction(isClear);
}

void KeepPart(WaterTestScene& scene, int rank)
{
  WaterKeepProps(scene, [rank](vtkActor*, int number) { return number % kRanks == rank; });
}

// What one rank renders; on the root its share of pixels off, elsewhere 0.
double Compare(vtkMultiProcessController* controller, bool isWet, bool isClear)
{
  WaterTestScene scene;
  Fill(scene, isWet, isClear);
  KeepPart(scene, controller->GetLocalProcessId());
  scene.Water->GetReflectionPass()->SetController(controller);
  vtkNew<vtkCompositedSynchronizedRenderers> together;
  together->SetRenderer(scene.Renderer);
  together->SetParallelController(controller);
  together->SetRootProcessId(0);
  const std::vector<unsigned char> picture = Show(scene);
  if (controller->GetLocalProcessId() != 0)
  {
    return 0.0;
  }
  WaterTestScene serial;
  Fill(serial, isWet, isClear);
  return WaterCompare(picture, Show(serial)).Share;
}

// A rank's strip of a surface, of as many as there are parts; with waves it is not flat.
void SetMesh(vtkWaterActor* water, int part, int parts, double height)
{
  vtkNew<vtkPlaneSource> source;
  vtkNew<vtkPolyData> mesh;
  if (part < parts)
  {
    const double width = 18.0 / parts;
    const double left = -9.0 + part * width;
    source->SetOrigin(left, -8.0, 0.0);
    source->SetPoint1(left + width, -8.0, 0.0);
    source->SetPoint2(left, 14.0, 0.0);
    source->SetResolution(40, 60);
    source->Update();
    mesh->DeepCopy(source->GetOutput());
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    point[2] = height * std::sin(1.3 * point[0]) * std::cos(0.7 * point[1]);
    mesh->GetPoints()->SetPoint(i, point);
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  water->SetMapper(mapper);
}

// Errors that are expected are not printed.
void Hush(vtkObject* object)
{
  vtkNew<vtkCallbackCommand> nothing;
  nothing->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  object->AddObserver(vtkCommand::ErrorEvent, nothing);
}

// A rank of a scene that is not composited: what its water says is asked, and that it ends.
struct Part
{
  explicit Part(vtkMultiProcessController* controller)
    : Rank(controller->GetLocalProcessId())
    , IsLast(Rank == kRanks - 1)
  {
    Fill(this->Scene, true, false);
    KeepPart(this->Scene, this->Rank);
    this->Scene.Water->GetReflectionPass()->SetController(controller);
    Hush(this->Scene.Water);
  }

  // Shows a frame: is this what is wrong with its water? Empty: nothing is, and it reflects.
  bool Says(const char* when, const std::string& expected)
  {
    Show(this->Scene);
    const std::string error = this->Scene.Water->GetLastError();
    const std::string decision = this->Scene.Water->GetReflectionPass()->GetDecisionAsString();
    const bool isRight = expected.empty()
      ? error.empty() && (decision == "rendered" || decision.find("used again") == 0)
      : error.find(expected) != std::string::npos;
    if (!isRight)
    {
      std::cerr << when << ", rank " << this->Rank << ": " << decision << ", error: \"" << error
                << "\", expected: \"" << expected << "\"" << std::endl;
    }
    return isRight;
  }

  WaterTestScene Scene;
  int Rank;
  bool IsLast;
};

// Each rank has a strip of a surface that is not flat, or flat on one rank, or nothing.
bool ShowsMeshes(vtkMultiProcessController* controller)
{
  bool isGood = true;
  for (const bool isClear : { false, true })
  {
    Part waves(controller);
    waves.Scene.Water->GetWaterProperty()->SetRefraction(isClear);
    SetMesh(waves.Scene.Water, waves.Rank, kRanks, waves.IsLast ? 0.0 : 0.05);
    isGood = waves.Says("strips with waves", "") && isGood;
    Part halves(controller);
    halves.Scene.Water->GetWaterProperty()->SetRefraction(isClear);
    SetMesh(halves.Scene.Water, halves.Rank, kRanks - 1, 0.0);
    isGood = halves.Says("a rank without surface", "") && isGood;
  }
  return isGood;
}

// The same of how the extent is chosen, and of the rank's part of the space.
bool SaysDifferentParts(Part& part)
{
  vtkWaterActor* water = part.Scene.Water;
  vtkWaterReflectionPass* pass = water->GetReflectionPass();
  if (part.IsLast)
  {
    water->SetSheetToAutomatic();
  }
  bool isGood = part.Says("an extent of its own", "automatic");
  water->SetSheetToAutomatic();
  isGood = part.Says("extents by the ground", "") && isGood;
  water->GetPlane()->SetOrigin(0.0, 0.0, 0.1);
  isGood = part.Says("another level", "") && isGood;
  water->GetPlane()->SetNormal(0.0, 0.1, 1.0);
  isGood = part.Says("another plane", "") && isGood;
  water->GetPlane()->SetNormal(0.0, 0.0, 1.0);
  water->GetPlane()->SetOrigin(0.0, 0.0, 0.0);
  water->ResetSheetBounds();
  const double all[6] = { -99.0, 99.0, -99.0, 99.0, -99.0, 99.0 };
  if (part.IsLast)
  {
    pass->SetRankRegion(all);
  }
  isGood = part.Says("a region of its own", "RankRegion") && isGood;
  pass->SetRankRegion(all);
  isGood = part.Says("regions of all", "") && isGood;
  Hush(pass);
  const double none[6] = { -99.0, 99.0, vtkMath::Nan(), 99.0, -99.0, 99.0 };
  pass->SetRankRegion(none);
  isGood = part.Says("a region that is none", "") && isGood;
  isGood = std::equal(all, all + 6, pass->GetRankRegion()) && isGood;
  pass->ResetRankRegion();
  return part.Says("no regions", "") && isGood;
}

// An eye under water sees haze where a rank has nothing. Engines that leave out pixels without a
// depth need one there, and whatever is drawn later the usual range of depths.
bool HasDepthOfHaze(vtkMultiProcessController* controller)
{
  bool isGood = true;
  for (const bool isBlended : { false, true })
  {
    Part part(controller);
    part.Scene.Water->GetWaterProperty()->RefractionOn();
    part.Scene.Water->SetSheetToHorizon();
    part.Scene.Water->GetReflectionPass()->SetFarthestRank(isBlended ? 0 : -1);
    part.Scene.Renderer->GetActiveCamera()->SetPosition(3.0, -15.0, -0.9);
    part.Scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, -2.0);
    isGood = part.Says("from below", "") && isGood;
    const int* size = part.Scene.Window->GetSize();
    std::vector<float> depths(static_cast<size_t>(size[0] * size[1]));
    part.Scene.Window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depths.data());
    const float farthest = *std::max_element(depths.begin(), depths.end());
    const bool isRight = isBlended ? farthest >= 1.0f : farthest < 1.0f && farthest > 0.999999f;
    double range[2];
    glGetDoublev(GL_DEPTH_RANGE, range);
    isGood = isGood && isRight && range[0] == 0.0 && range[1] == 1.0;
    std::cerr << (isRight ? "" : "no depth of haze\n");
  }
  return isGood;
}

// What differs on one rank is said by all, and is over when it is mended.
bool SaysErrors(vtkMultiProcessController* controller)
{
  const char* const looks = "same plane, look";
  Part part(controller);
  vtkWaterActor* water = part.Scene.Water;
  vtkWaterProperty* property = water->GetWaterProperty();
  property->AddWave(0.05, 2.1, 30.0);
  bool isGood = part.Says("one wave", "");
  property->RemoveAllWaves();
  property->AddWave(0.05, 2.1, part.IsLast ? 200.0 : 30.0);
  isGood = part.Says("waves of other directions", looks) && isGood;
  property->RemoveAllWaves();
  isGood = part.Says("no waves", "") && isGood;
  property->SetShoreSoftness(part.IsLast ? 0.75 : 0.25);
  isGood = part.Says("other shores", looks) && isGood;
  property->SetShoreSoftness(0.25);
  vtkWaterReflectionPass* pass = water->GetReflectionPass();
  pass->SetFarthestRank(kRanks);
  isGood = part.Says("a farthest rank that does not exist", "FarthestRank must be one") && isGood;
  pass->SetFarthestRank(part.IsLast ? kRanks : kRanks - 1);
  isGood = part.Says("the number of the root counts", "") && isGood;
  pass->SetFarthestRank(-1);
  isGood = SaysDifferentParts(part) && isGood;
  for (const bool isClear : { false, true })
  {
    property->SetRefraction(isClear);
    isGood = part.Says("before the plane", "") && isGood;
    water->GetPlane()->SetNormal(0.0, 0.0, part.IsLast ? 0.0 : 1.0);
    isGood =
      part.Says("a plane without a normal", part.IsLast ? "ormal" : "without an error") && isGood;
    water->GetPlane()->SetNormal(0.0, 0.0, 1.0);
    isGood = part.Says("the plane is mended", "") && isGood;
  }
  return isGood;
}

// A rank that has deleted its water does not keep the others waiting; once all have, none asks.
bool Forgets(vtkMultiProcessController* controller)
{
  WaterTestScene scene;
  scene.AddThings<vtkPolyDataMapper>();
  KeepPart(scene, controller->GetLocalProcessId());
  Hush(scene.Renderer);
  bool isGood = true;
  {
    auto water = vtkSmartPointer<vtkWaterActor>::New();
    Hush(water);
    water->GetReflectionPass()->SetController(controller);
    water->SetSheetBounds(-9.0, 9.0, -8.0, 14.0);
    scene.Renderer->AddActor(water);
    Show(scene);
    isGood = std::string(water->GetLastError()).empty();
    const bool isLast = controller->GetLocalProcessId() == kRanks - 1;
    if (isLast)
    {
      scene.Renderer->RemoveActor(water);
      water = nullptr;
    }
    Show(scene);
    isGood = isGood &&
      (isLast || std::string(water->GetLastError()).find("same waters") != std::string::npos);
    if (water)
    {
      scene.Renderer->RemoveActor(water);
    }
  }
  Show(scene);
  if (controller->GetLocalProcessId() == 0)
  {
    Show(scene); // alone
  }
  std::cerr << (isGood ? "" : "a deleted water is not said\n");
  return isGood;
}

bool Run(const WaterSocketRank& self)
{
  vtkMultiProcessController* dummy = self.Controller;
  const double floor = Compare(dummy, false, false);
  const double opaque = Compare(dummy, true, false);
  const double clear = Compare(dummy, true, true);
  if (self.Rank == 0)
  {
    std::cout << "share of pixels off without water: " << floor << ", opaque: " << opaque
              << ", clear: " << clear << " (limit " << kShare << " more)" << std::endl;
  }
  bool isGood = opaque <= floor + kShare && clear <= floor + kShare;
  isGood = ShowsMeshes(dummy) && isGood;
  isGood = SaysErrors(dummy) && isGood;
  isGood = HasDepthOfHaze(dummy) && isGood;
  return Forgets(dummy) && isGood;
}
}

int TestWaterSortLast(int, char*[])
{
  return WaterRunRanks(kRanks, kPatience, Run) ? EXIT_SUCCESS : EXIT_FAILURE;
}
