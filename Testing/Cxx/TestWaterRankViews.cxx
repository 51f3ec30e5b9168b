// SPDX-License-Identifier: BSD-3-Clause
// What a water looks up beside its mirrored view is that of all ranks: the sun view (shadows on the
// water), the own view of clear water, and the sky view (a dome seen by rays of waves). So is the
// ground by which a sheet chooses its extent. Each rank
// has some of the things; the picture that they make together by depth is compared with the serial
// one. The processes are forked and talk over sockets: no MPI is needed.
#include "WaterBasin.h"
#include "WaterPictures.h"
#include "WaterRankScene.h"
#include "WaterSocketRanks.h"

#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkLight.h"
#include "vtkPointData.h"
#include "vtkWaterReflectionPass.h"

#include <cstdlib>
#include <cstring>
#include <vector>

namespace
{
constexpr unsigned int kPatience = 200; // s, until a process that waits for another is ended
constexpr double kShare = 0.0002;       // of all pixels, off by more than 1 of 255
constexpr double kApart = 0.005;        // the same with what one rank has alone, at least

enum View
{
  SUN_VIEW,
  OWN_VIEW,
  SKY_VIEW,
  GROUND
};

struct Look
{
  const char* Name;
  View Wanted;
  bool HasWaves;
};

constexpr int kOfMany = 3; // own view with waves
const Look kLooks[] = { { "shadows on glitter", SUN_VIEW, false },
  { "shadows on waves", SUN_VIEW, true }, { "own view", OWN_VIEW, false },
  { "own view with waves", OWN_VIEW, true }, { "sky view", SKY_VIEW, true },
  { "extent by the ground", GROUND, false } };

// A floor of many boxes. Some are not reflected; others have a ball high over the water that is
// reflected in their place. An own view shows neither difference.
void AddBed(vtkRenderer* renderer)
{
  for (int i = 0; i < 36; ++i)
  {
    vtkNew<vtkCubeSource> box;
    box->SetCenter(3.0 * (i % 6) - 7.5, 3.6 * (i / 6) - 6.0, -1.5);
    box->SetXLength(2.9);
    box->SetYLength(3.5);
    box->SetZLength(0.3 + 0.3 * (i % 4));
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(box->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.9 - 0.2 * (i % 5), 0.3 + 0.1 * (i % 7), 0.2 + 0.2 * (i % 4));
    actor->GetProperty()->LightingOff();
    vtkNew<vtkInformation> keys;
    if (i % 5 == 1)
    {
      keys->Set(vtkWaterReflectionPass::NOT_REFLECTED(), 1);
    }
    else if (i % 5 == 3)
    {
      vtkNew<vtkSphereSource> ball;
      ball->SetCenter(3.0 * (i % 6) - 7.5, 6.0, 3.0);
      vtkNew<vtkPolyDataMapper> ballMapper;
      ballMapper->SetInputConnection(ball->GetOutputPort());
      vtkNew<vtkActor> standIn;
      standIn->SetMapper(ballMapper);
      keys->Set(vtkWaterReflectionPass::STAND_IN(), standIn);
    }
    actor->SetPropertyKeys(keys);
    renderer->AddActor(actor);
  }
}

// A basin, in many parts. The floor of some is under the water, and its rim is over it.
void AddBasin(vtkRenderer* renderer)
{
  for (int i = 0; i < 36; ++i)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(WaterMakeBasin(3.0 * (i % 6) - 9.0, 3.0 * (i / 6) - 9.0, 3.0, 12));
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.6, 0.5, 0.3);
    renderer->AddActor(actor);
  }
}

// A sphere around everything, of many colours.
vtkSmartPointer<vtkActor> MakeDome()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(70.0);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(48);
  sphere->Update();
  vtkPolyData* made = sphere->GetOutput();
  vtkNew<vtkFloatArray> colors;
  for (vtkIdType i = 0; i < made->GetNumberOfPoints(); ++i)
  {
    const double* at = made->GetPoint(i);
    colors->InsertNextValue(static_cast<float>(std::sin(0.1 * at[2]) + std::cos(0.13 * at[0])));
  }
  made->GetPointData()->SetScalars(colors);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(made);
  mapper->SetScalarRange(-2.0, 2.0);
  auto dome = vtkSmartPointer<vtkActor>::New();
  dome->SetMapper(mapper);
  dome->GetProperty()->LightingOff();
  return dome;
}

struct Scene : public WaterTestScene
{
  // rank: whose things it has; -1: all
  Scene(const Look& look, int rank, int ranks)
  {
    this->Window->SetSize(200, 150);
    this->AddThings<vtkPolyDataMapper>();
    if (look.Wanted == SKY_VIEW)
    {
      this->Renderer->AddActor(MakeDome());
      this->Renderer->GetActiveCamera()->SetClippingRange(1.0, 200.0);
    }
    if (look.Wanted == OWN_VIEW)
    {
      AddBed(this->Renderer);
    }
    if (look.Wanted == GROUND)
    {
      AddBasin(this->Renderer);
    }
    vtkPropCollection* props = this->Renderer->GetViewProps();
    this->Changed = vtkActor::SafeDownCast(props->GetItemAsObject(4)); // on every rank
    const int count = props->GetNumberOfItems();
    WaterKeepProps(*this, [&](vtkActor*, int number) { // the dome is the last rank's
      return rank < 0 || ranks - 1 - (count - 1 - number) % ranks == rank;
    });
    vtkNew<vtkLight> sun;
    sun->SetPosition(8.0, look.Wanted == SUN_VIEW ? 12.0 : -9.0, 9.0); // shadows are on this side
    sun->SetFocalPoint(0.0, 0.0, 0.0);
    sun->SetIntensity(look.Wanted == SUN_VIEW ? 6.0 : 1.0);
    this->Renderer->AddLight(sun);
    this->AddWater();
    vtkWaterProperty* water = this->Water->GetWaterProperty();
    water->SetMetresPerUnit(1.0);
    if (look.Wanted == GROUND)
    {
      this->Water->SetSheetToAutomatic();
    }
    if (look.HasWaves)
    {
      water->AddWave(look.Wanted == SKY_VIEW ? 0.1 : 0.04, 2.1, 30.0);
      water->AddWave(0.03, 1.3, 75.0);
    }
    if (look.Wanted == SUN_VIEW)
    {
      water->SetSlopeVariance(0.3, 0.3);
      water->ShadowsOn();
      water->SetWaveGeometry(look.HasWaves);
    }
    else if (look.Wanted == OWN_VIEW)
    {
      water->RefractionOn();
      water->SetRefractionSourceToOwnView();
    }
  }

  std::vector<unsigned char> Show()
  {
    this->Window->Render();
    return WaterRead(this->Window);
  }

  vtkSmartPointer<vtkActor> Changed; // some rank has it
};

// The picture of all ranks, by depth: on rank 0.
std::vector<unsigned char> Compose(vtkMultiProcessController* controller, Scene& scene)
{
  std::vector<unsigned char> picture = scene.Show();
  const int* size = scene.Window->GetSize();
  vtkNew<vtkFloatArray> found;
  scene.Window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, found);
  std::vector<float> depths(found->GetPointer(0), found->GetPointer(0) + picture.size() / 4);
  constexpr int tag = 11;
  if (controller->GetLocalProcessId() != 0)
  {
    controller->Send(picture.data(), static_cast<vtkIdType>(picture.size()), 0, tag);
    controller->Send(depths.data(), static_cast<vtkIdType>(depths.size()), 0, tag);
    return picture;
  }
  std::vector<unsigned char> other(picture.size());
  std::vector<float> others(depths.size());
  for (int rank = 1; rank < controller->GetNumberOfProcesses(); ++rank)
  {
    controller->Receive(other.data(), static_cast<vtkIdType>(other.size()), rank, tag);
    controller->Receive(others.data(), static_cast<vtkIdType>(others.size()), rank, tag);
    for (size_t i = 0; i < depths.size(); ++i)
    {
      if (others[i] < depths[i]) // the lower rank's of equal ones
      {
        depths[i] = others[i];
        std::memcpy(&picture[4 * i], &other[4 * i], 4);
      }
    }
  }
  return picture;
}

// Do the ranks together show what one process shows?
bool IsSerial(const std::string& name, const std::vector<unsigned char>& picture, Scene& serial)
{
  const std::vector<unsigned char> expected = serial.Show();
  const WaterDifference found = WaterCompare(picture, expected);
  WaterLeave(name, picture, serial.Window);
  WaterLeave(name + " serial", expected, serial.Window);
  const bool isGood = found.Share <= kShare;
  std::cout << name << ": share of pixels off " << found.Share << " (limit: " << kShare << ") "
            << (isGood ? "ok" : "FAILED") << std::endl;
  return isGood;
}

bool Compare(vtkMultiProcessController* controller, const Look& look)
{
  const int rank = controller->GetLocalProcessId();
  const int ranks = controller->GetNumberOfProcesses();
  const std::string name = std::to_string(ranks) + " ranks, " + look.Name;
  const bool isRoot = rank == 0;
  Scene scene(look, rank, ranks);
  vtkWaterReflectionPass* pass = scene.Water->GetReflectionPass();
  pass->SetController(controller);
  Scene serial(look, isRoot ? -1 : 0, ranks);
  const std::vector<unsigned char> first = Compose(controller, scene);
  bool isGood = !isRoot || IsSerial(name, first, serial);
  isGood =
    WaterCheck(name + ", pixels are joined", pass->GetNumberOfPixelsJoined() > 0, true) && isGood;
  for (int i = 0; i < 2; ++i) // a mapper makes its colours in the first frame
  {
    (void)Compose(controller, scene);
  }
  isGood =
    WaterCheck(name + ", joined when used again", pass->GetNumberOfPixelsJoined(), vtkIdType(0)) &&
    isGood;
  scene.Changed->VisibilityOff(); // one rank has it
  serial.Changed->VisibilityOff();
  const std::vector<unsigned char> changed = Compose(controller, scene);
  isGood = (!isRoot || IsSerial(name + ", changed", changed, serial)) && isGood;
  std::cerr << scene.Water->GetLastError();
  pass->SetController(nullptr);
  const std::vector<unsigned char> alone = Compose(controller, scene);
  if (isRoot)
  {
    const double apart = WaterCompare(alone, serial.Show()).Share;
    std::cout << name << ": share of pixels off if nothing is joined " << apart
              << " (limit: " << kApart << ")" << std::endl;
    isGood = isGood && apart >= kApart;
  }
  return isGood && scene.Water->GetLastError()[0] == '\0';
}

bool Run(const WaterSocketRank& self)
{
  bool isGood = true;
  for (const Look& look : kLooks)
  {
    isGood = Compare(self.Controller, look) && isGood;
  }
  return isGood;
}

// How depths of many ranks are joined does not depend on what is seen.
bool RunOne(const WaterSocketRank& self)
{
  return Compare(self.Controller, kLooks[kOfMany]);
}
}

int TestWaterRankViews(int, char*[])
{
  const bool isGood = WaterRunRanks(4, kPatience, Run); // of 2 the other tests are
  return WaterRunRanks(8, kPatience, RunOne) && isGood ? EXIT_SUCCESS : EXIT_FAILURE;
}
