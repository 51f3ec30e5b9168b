// SPDX-License-Identifier: BSD-3-Clause
// FirstWater.cxx: a cone stands in water. Writes FirstWater.png, or the file that it is given.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWaterActor.h>
#include <vtkWaterOffScreen.h>
#include <vtkWindowToImageFilter.h>

#include <cstring>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc > 1 && argv[1][0] == '-')
  {
    std::cout << "usage: FirstWater [PICTURE.png]    default: FirstWater.png\n";
    return std::strcmp(argv[1], "--help") == 0 ? 0 : 2;
  }
  vtkWaterOffScreen::EnableIfNeeded(); // VTK before 9.4 wants help without a display

  // README: from here
  vtkNew<vtkConeSource> cone;
  cone->SetDirection(0.3, 0.0, 1.0);
  cone->SetResolution(64);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cone->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.90, 0.45, 0.25);

  vtkNew<vtkWaterActor> water;
  water->SetLevel(-0.2);
  water->SetSheetBounds(-9.0, 9.0, -9.0, 9.0); // without it: as wide as the scene

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.72, 0.80, 0.88);
  renderer->AddActor(actor);
  renderer->AddActor(water); // that is all
  // README: to here
  renderer->GetActiveCamera()->SetPosition(0.0, -3.5, 0.3);
  renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetSize(640, 400);
  window->AddRenderer(renderer);

  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(capture->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "FirstWater.png");
  writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    std::cerr << "FirstWater: " << writer->GetFileName() << " cannot be written\n";
    return 1;
  }
  return 0;
}
