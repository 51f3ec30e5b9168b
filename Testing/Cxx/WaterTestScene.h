// SPDX-License-Identifier: BSD-3-Clause
// WaterTestScene.h: the small scene that the C++ tests share: columns and a ball standing in water.
#ifndef WaterTestScene_h
#define WaterTestScene_h

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkWaterActor.h"
#include "vtkWaterProperty.h"

#include <iostream>
#include <string>

// Prints a figure with its limit; true when it holds.
template <typename Value>
bool WaterCheck(const std::string& name, const Value& value, const Value& expected)
{
  const bool holds = value == expected;
  std::cout << name << ": " << value << " (limit = " << expected << ") "
            << (holds ? "ok" : "FAILED") << std::endl;
  return holds;
}

inline vtkSmartPointer<vtkRenderWindow> WaterTestWindow()
{
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  return window;
}

struct WaterTestScene
{
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkWaterActor> Water;

  // window: one that scenes before this one were rendered in; Mesa has compiled their shaders
  explicit WaterTestScene(vtkRenderWindow* window = WaterTestWindow())
    : Window(window)
  {
    this->Window->SetSize(300, 225);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->GradientBackgroundOn();
    this->Renderer->SetBackground(0.85, 0.88, 0.9);
    this->Renderer->SetBackground2(0.25, 0.45, 0.75);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(3, -15, 4);
    camera->SetFocalPoint(0, 0, 0.5);
    camera->SetViewUp(0, 0, 1);
    camera->SetClippingRange(1, 60);
  }
  ~WaterTestScene() { this->Window->RemoveRenderer(this->Renderer); } // others may use the window

  // Adds columns and a ball, drawn by mappers of the given class.
  template <typename Mapper>
  void AddThings()
  {
    for (int i = 0; i < 9; ++i)
    {
      vtkNew<vtkCubeSource> column;
      column->SetCenter((i % 3) * 2.5 - 2.5, (i / 3) * 2.5 - 1, 0.5);
      column->SetXLength(0.8);
      column->SetYLength(0.8);
      column->SetZLength(2 + 0.4 * i);
      this->AddThing<Mapper>(column, 0.3 + 0.07 * i, 0.85 - 0.07 * i, 0.45);
    }
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(3.5, -4, 0.3);
    ball->SetRadius(0.9);
    ball->SetThetaResolution(32);
    ball->SetPhiResolution(32);
    this->AddThing<Mapper>(ball, 0.9, 0.5, 0.2);
  }

  void AddWater()
  {
    this->Water->SetSheetBounds(-9, 9, -8, 14);
    this->Renderer->AddActor(this->Water);
  }

private:
  template <typename Mapper>
  void AddThing(vtkPolyDataAlgorithm* source, double red, double green, double blue)
  {
    vtkNew<Mapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(red, green, blue);
    this->Renderer->AddActor(actor);
  }
};

#endif
