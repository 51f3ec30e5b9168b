// SPDX-License-Identifier: BSD-3-Clause
// An actor that throws at the end of its draw in the mirrored view is drawn whole afterwards: what
// the mirrored view leaves out of a large mesh, and of blocks of composite data, is there again.
#include "WaterBlocks.h"
#include "WaterFaultyScene.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"

#include <stdexcept>

namespace
{
class ThrowingActor : public vtkOpenGLActor
{
public:
  static ThrowingActor* New();
  vtkTypeMacro(ThrowingActor, vtkOpenGLActor);
  bool Throws = false;
  int RenderOpaqueGeometry(vtkViewport* viewport) override
  {
    const int drawn = this->vtkOpenGLActor::RenderOpaqueGeometry(viewport);
    auto* renderer = vtkRenderer::SafeDownCast(viewport);
    if (this->Throws && renderer->GetActiveCamera()->GetPosition()[2] < 0.0)
    {
      throw std::runtime_error("of the user");
    }
    return drawn;
  }
};
vtkStandardNewMacro(ThrowingActor);

// A ball that is half under water.
vtkSmartPointer<vtkPolyDataMapper> MakeMesh()
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(-2.0, 3.0, 0.0);
  ball->SetRadius(3.0);
  ball->SetThetaResolution(140);
  ball->SetPhiResolution(140);
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputConnection(ball->GetOutputPort());
  return mapper;
}

bool Check(const std::string& name, vtkMapper* mapper)
{
  FaultyScene scene;
  vtkNew<ThrowingActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.7, 0.3);
  scene.Renderer->AddActor(actor);
  scene.Water->VisibilityOff();
  const std::vector<unsigned char> dry = scene.Picture();
  scene.Water->VisibilityOn();
  scene.Picture();
  scene.Renderer->GetActiveCamera()->Azimuth(2.0);
  actor->Throws = true;
  bool hasThrown = false;
  try
  {
    scene.Window->Render();
  }
  catch (const std::runtime_error&)
  {
    hasThrown = true;
  }
  actor->Throws = false;
  scene.Window->ClearInRenderStatus(); // or it renders no more
  bool ok = WaterCheck(name + ": it has thrown", hasThrown, true);
  scene.Renderer->GetActiveCamera()->Azimuth(-2.0);
  scene.Water->VisibilityOff();
  return WaterCheck(name + ": whole afterwards", WaterSame(scene.Picture(), dry), true) && ok;
}
}

int TestWaterThrowingActors(int, char*[])
{
  bool ok = Check("large mesh", MakeMesh());
  ok &= Check("blocks", WaterMakeBlocks(20));
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
