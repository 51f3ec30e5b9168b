// SPDX-License-Identifier: BSD-3-Clause
// BenchmarkReflection: what a mirror costs, as ratios of medians of interleaved frames.
//
//   frame with water / (plain frame + the same mirrored view rendered by hand)       limit 1.1
//   frame with the pass installed and no water / the same frame without the pass     limit 1.02
//
// 300 actors, 800 x 600, VTK's default lighting, no multisampling. The camera moves before every
// frame, so that nothing can be used again. Kinds of frames take turns, in another random order in
// every round: what slows the machine down slows them all.
//
// The first ratio is taken twice: with VTK's default property, which has no highlights, and with
// highlights, for which the shader of the props has more to compute.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMinimalStandardRandomSequence.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkTimerLog.h>
#include <vtkWaterActor.h>
#include <vtkWaterOffScreen.h>
#include <vtkWaterProperty.h>
#include <vtkWaterReflectionPass.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace
{
const int ACTORS = 300;
const int SIZE[2] = { 800, 600 };
const int SEED = 20261121;
const int WARM_UP = 5; // frames of each kind that are not counted
const double LAKE = 12.0;
const double HIGHLIGHTS = 0.5; // specular coefficient
const double EYE[3] = { 0.0, -25.0, 8.0 };

// One kind of frame: a window of its own over a scene of its own, always the same one.
struct Frame
{
  explicit Frame(const std::string& name, double specular = 0.0)
    : Name(name)
    , Specular(specular)
  {
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(SIZE[0], SIZE[1]);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(0.6, 0.7, 0.8);
    this->AddActors();
    this->LookFrom(EYE[2]);
  }

  // Spheres over the lake: none is cut by it, as cutting by hand would make the other side slower.
  void AddActors()
  {
    vtkNew<vtkMinimalStandardRandomSequence> random;
    random->SetSeed(SEED);
    auto next = [&](double low, double high) {
      random->Next();
      return random->GetRangeValue(low, high);
    };
    for (int i = 0; i < ACTORS; ++i)
    {
      vtkNew<vtkSphereSource> source;
      source->SetThetaResolution(16);
      source->SetPhiResolution(16);
      source->SetRadius(0.4);
      const double x = next(-10.0, 10.0);
      const double y = next(-10.0, 10.0);
      source->SetCenter(x, y, next(0.4, 4.4));
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(source->GetOutputPort());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->GetProperty()->SetColor(next(0.2, 1.0), 0.5, 0.5);
      actor->GetProperty()->SetSpecular(this->Specular);
      actor->GetProperty()->SetSpecularPower(20.0);
      this->Renderer->AddActor(actor);
    }
  }

  // height < 0: the mirrored view of the eye at -height
  void LookFrom(double height)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(EYE[0], EYE[1], height);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 0.0, height < 0.0 ? -1.0 : 1.0);
    camera->SetClippingRange(5.0, 60.0);
    this->Step = height < 0.0 ? -0.1 : 0.1; // view up is mirrored, too
  }

  void AddWater()
  {
    this->Water = vtkSmartPointer<vtkWaterActor>::New();
    this->Water->SetSheetBounds(-LAKE, LAKE, -LAKE, LAKE);
    this->Renderer->AddActor(this->Water);
  }

  // An ordinary actor where the other frame has its water.
  void AddPlane()
  {
    vtkNew<vtkPlaneSource> source;
    source->SetOrigin(-LAKE, -LAKE, 0.0);
    source->SetPoint1(LAKE, -LAKE, 0.0);
    source->SetPoint2(-LAKE, LAKE, 0.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
  }

  double Render()
  {
    this->Renderer->GetActiveCamera()->Azimuth(this->Step);
    const double begin = vtkTimerLog::GetUniversalTime();
    this->Window->Render();
    this->Window->WaitForCompletion();
    return 1000.0 * (vtkTimerLog::GetUniversalTime() - begin);
  }

  std::string Name;
  double Specular;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkWaterActor> Water;
  double Step = 0.0;
  std::vector<double> Times;
  double Median = 0.0; // ms
};

void Measure(std::vector<Frame*> frames, int rounds)
{
  std::mt19937 generator(SEED);
  for (int round = -WARM_UP; round < rounds; ++round)
  {
    std::shuffle(frames.begin(), frames.end(), generator);
    for (Frame* frame : frames)
    {
      const double time = frame->Render();
      if (round >= 0)
      {
        frame->Times.push_back(time);
      }
    }
  }
  for (Frame* frame : frames)
  {
    const auto middle = frame->Times.begin() + static_cast<ptrdiff_t>(frame->Times.size() / 2);
    std::nth_element(frame->Times.begin(), middle, frame->Times.end());
    frame->Median = *middle;
    std::cout << frame->Name << ": " << frame->Median << " ms\n";
  }
}

bool Report(const std::string& name, double ratio, double limit)
{
  std::cout << name << ": " << ratio << " (limit " << limit << ")" << std::endl;
  return ratio <= limit;
}

bool MeasureWater(int rounds, double specular)
{
  std::cout << "specular " << specular << "\n";
  Frame plain("plain frame", specular);
  Frame withPlane("plain frame with a plane in place of the water", specular);
  withPlane.AddPlane();
  Frame mirrored("mirrored view by hand", specular);
  mirrored.LookFrom(-EYE[2]);
  Frame water("frame with water", specular);
  water.AddWater();
  Measure({ &plain, &withPlane, &mirrored, &water }, rounds);

  vtkWaterReflectionPass* pass = water.Water->GetReflectionPass();
  std::cout << "mirrors rendered: " << pass->GetNumberOfReflectionRenders() << " in "
            << rounds + WARM_UP << " frames, of " << pass->GetNumberOfPropsReflected()
            << " actors\n";
  if (pass->GetNumberOfReflectionRenders() != rounds + WARM_UP ||
    pass->GetNumberOfPropsReflected() < ACTORS / 2)
  {
    std::cout << "the water did not reflect the scene in every frame\n";
    return false;
  }
  std::cout << "frame with water / (plain frame with a plane + mirrored view): "
            << water.Median / (withPlane.Median + mirrored.Median) << "\n";
  const double ratio = water.Median / (plain.Median + mirrored.Median);
  if (specular > 0.0)
  {
    // no limit: the view by hand is cheaper than the same view, as its headlight moves with it
    std::cout << "frame with water / (plain frame + mirrored view), highlights: " << ratio << "\n";
    return true;
  }
  return Report("frame with water / (plain frame + mirrored view)", ratio, 1.1);
}

bool MeasureIdlePass(int rounds)
{
  Frame none("no pass");
  Frame chain("vtkRenderStepsPass");
  chain.Renderer->SetPass(vtkNew<vtkRenderStepsPass>());
  Frame installed("water pass over vtkRenderStepsPass, no water");
  vtkNew<vtkWaterReflectionPass> pass;
  pass->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
  installed.Renderer->SetPass(pass);
  Measure({ &none, &chain, &installed }, rounds);
  std::cout << "pass installed, no water / no pass at all: " << installed.Median / none.Median
            << "\n";
  return Report(
    "pass installed, no water / the same chain without it", installed.Median / chain.Median, 1.02);
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 200;
  if (rounds < 1)
  {
    std::cerr << "usage: BenchmarkReflection [rounds]\n"
                 "Exit status 1: a limit was exceeded.\n";
    return 2;
  }
#ifdef __GLIBC__
  // Mesa's software renderer takes some 32 MB for every view it draws and frees them again. Whether
  // they go back to the kernel, and cost 8,000 page faults in the next frame, depends on what
  // happens to lie at the top of the heap: a quarter of a frame's time, from one run to the next.
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
#endif
  if (!vtkWaterOffScreen::EnableIfNeeded())
  {
    std::cerr << vtkWaterOffScreen::GetReason() << "\n";
    return 2;
  }
  std::cout << ACTORS << " actors, " << SIZE[0] << " x " << SIZE[1] << ", medians of " << rounds
            << " frames of each kind, seed " << SEED << "\n";
  bool isCheap = MeasureWater(rounds, 0.0);
  isCheap = MeasureWater(rounds, HIGHLIGHTS) && isCheap;
  isCheap = MeasureIdlePass(2 * rounds) && isCheap; // a finer limit
  return isCheap ? EXIT_SUCCESS : EXIT_FAILURE;
}
