// SPDX-License-Identifier: BSD-3-Clause
// consumer.cxx: a sphere over water, rendered off-screen.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkWaterActor.h>
#include <vtkWaterReflectionPass.h>

#include <iostream>

int main()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.0, 0.0, 4.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);

  vtkNew<vtkWaterActor> water;
  water->SetLevel(2.0);
  water->SetSheetBounds(-5.0, 5.0, -5.0, 5.0);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->AddActor(water);
  renderer->GetActiveCamera()->SetPosition(0.0, -10.0, 6.0);
  renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 3.0);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetSize(200, 150);
  window->AddRenderer(renderer);
  window->Render();

  vtkWaterReflectionPass* pass = water->GetReflectionPass();
  std::cout << "window " << window->GetClassName() << "\n"
            << "level " << water->GetLevel() << "\n"
            << "mirror " << pass->GetDecisionAsString() << " " << pass->GetNumberOfPropsReflected()
            << std::endl;
  return 0;
}
