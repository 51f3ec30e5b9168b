// SPDX-License-Identifier: BSD-3-Clause
// BenchmarkLookup: what finding a reflection on waves costs, as ratios of medians of interleaved
// frames. The time of a lookup is that of a frame with the lake less that of a frame with a puddle,
// in which the mirrored view is drawn just the same.
//
//   ray traced / calm lookup on the same waves       limit 2.2 for the default quality
//
// 60 boxes in and over the water, three waves, 800 x 600, no multisampling. The camera moves before
// every frame; kinds of frames take turns, in another random order in every round.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkMinimalStandardRandomSequence.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTimerLog.h>
#include <vtkWaterActor.h>
#include <vtkWaterOffScreen.h>
#include <vtkWaterProperty.h>

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
const int BOXES = 60;
const int SIZE[2] = { 800, 600 };
const int SEED = 20261121;
const int WARM_UP = 5; // frames of each kind that are not counted
const double LAKE = 60.0;
const double PUDDLE = 0.01;
const double LIMIT = 2.2;

struct Frame
{
  Frame(const std::string& name, double size)
    : Name(name)
  {
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(SIZE[0], SIZE[1]);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(0.6, 0.7, 0.8);
    vtkNew<vtkMinimalStandardRandomSequence> random;
    random->SetSeed(SEED);
    auto next = [&](double low, double high) {
      random->Next();
      return random->GetRangeValue(low, high);
    };
    for (int i = 0; i < BOXES; ++i)
    {
      vtkNew<vtkCubeSource> source;
      source->SetXLength(next(0.1, 0.8));
      source->SetYLength(next(0.1, 0.8));
      source->SetZLength(next(0.5, 4.0));
      const double x = next(-8.0, 8.0);
      const double y = next(-8.0, 8.0);
      source->SetCenter(x, y, next(0.0, 2.0));
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(source->GetOutputPort());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->GetProperty()->SetColor(next(0.2, 1.0), 0.5, 0.5);
      this->Renderer->AddActor(actor);
    }
    this->Water->SetSheetBounds(-size, size, -size, size);
    this->GetLook()->AddWave(0.0127, 2.0, 20.0, 10.0);
    this->GetLook()->AddWave(0.0064, 1.2, 80.0, 200.0);
    this->GetLook()->AddWave(0.0032, 0.75, 140.0, 90.0);
    this->Renderer->AddActor(this->Water);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(2.0, -13.0, 4.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetClippingRange(0.5, 150.0);
  }

  vtkWaterProperty* GetLook() { return this->Water->GetWaterProperty(); }

  double Render()
  {
    this->Renderer->GetActiveCamera()->Azimuth(0.1);
    const double begin = vtkTimerLog::GetUniversalTime();
    this->Window->Render();
    this->Window->WaitForCompletion();
    return 1000.0 * (vtkTimerLog::GetUniversalTime() - begin);
  }

  std::string Name;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkWaterActor> Water;
  std::vector<double> Times;
  double Median = 0.0; // ms
};
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 200;
  if (rounds < 1)
  {
    std::cerr << "usage: BenchmarkLookup [rounds]\n"
                 "Exit status 1: the limit was exceeded.\n";
    return 2;
  }
#ifdef __GLIBC__
  mallopt(M_TRIM_THRESHOLD, 1 << 30); // as in BenchmarkReflection.cxx
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
#endif
  if (!vtkWaterOffScreen::EnableIfNeeded())
  {
    std::cerr << vtkWaterOffScreen::GetReason() << "\n";
    return 2;
  }
  Frame puddle("puddle", PUDDLE);
  Frame calm("calm lookup", LAKE);
  calm.GetLook()->SetLookupToFixedOffset();
  calm.GetLook()->SetOffsetScale(0.0);
  Frame fast("ray traced, fast", LAKE);
  fast.GetLook()->SetRayTraceQualityToFast();
  Frame normal("ray traced, default", LAKE);
  Frame high("ray traced, high", LAKE);
  high.GetLook()->SetRayTraceQualityToHigh();

  std::vector<Frame*> frames{ &puddle, &calm, &fast, &normal, &high };
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
  std::cout << BOXES << " boxes, " << SIZE[0] << " x " << SIZE[1] << ", medians of " << rounds
            << " frames of each kind, seed " << SEED << "\n";
  for (Frame* frame : { &puddle, &calm, &fast, &normal, &high })
  {
    const auto middle = frame->Times.begin() + static_cast<ptrdiff_t>(frame->Times.size() / 2);
    std::nth_element(frame->Times.begin(), middle, frame->Times.end());
    frame->Median = *middle;
    std::cout << frame->Name << ": " << frame->Median << " ms\n";
  }
  for (Frame* frame : { &fast, &normal, &high })
  {
    std::cout << frame->Name << " / calm lookup: "
              << (frame->Median - puddle.Median) / (calm.Median - puddle.Median) << "\n";
  }
  const double ratio = (normal.Median - puddle.Median) / (calm.Median - puddle.Median);
  std::cout << "limit for the default: " << LIMIT << std::endl;
  return ratio <= LIMIT ? EXIT_SUCCESS : EXIT_FAILURE;
}
