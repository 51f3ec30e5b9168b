// SPDX-License-Identifier: BSD-3-Clause
// A GPU computes a wind sea that was in the last picture before the props are drawn, so that it
// does not wait for them. It computes another sea when the water is drawn, once in a frame, and
// none that is not drawn.
#include "WaterTestScene.h"

#include "vtkWaterGL.h"

#include "vtkActorCollection.h"
#include "vtkCallbackCommand.h"

#include <cstdlib>
#include <vector>

namespace
{
int copied = 0; // layers of slopes

PFNGLCOPYTEXSUBIMAGE3DPROC copyLayer = nullptr;
void CopyLayer(GLenum target, GLint level, GLint x, GLint y, GLint layer, GLint left, GLint bottom,
  GLsizei width, GLsizei height)
{
  ++copied;
  copyLayer(target, level, x, y, layer, left, bottom, width, height);
}

// Renders a frame at a time. Returns the layers copied before the first prop was drawn, and in all.
std::vector<int> CopiedInFrame(WaterTestScene& scene, double time, int& atProp)
{
  copied = 0;
  atProp = -1;
  scene.Water->SetTime(time);
  scene.Window->Render();
  return { atProp, copied };
}
}

int TestWaterSeaAhead(int, char*[])
{
  WaterTestScene scene;
  scene.AddThings<vtkPolyDataMapper>();
  scene.AddWater();
  vtkWaterProperty* look = scene.Water->GetWaterProperty();
  look->SetSea(true);
  look->SetWindSpeed(5.0);
  look->SetSeaTileSize(32);
  vtkNew<vtkCallbackCommand> drawn;
  int atProp = -1;
  drawn->SetClientData(&atProp);
  drawn->SetCallback([](vtkObject*, unsigned long, void* place, void*) {
    int& at = *static_cast<int*>(place);
    at = at < 0 ? copied : at;
  });
  auto* thing = vtkActor::SafeDownCast(scene.Renderer->GetActors()->GetItemAsObject(0));
  thing->GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, drawn);
  setenv("VTK_WATER_SOFTWARE", "0", 1);
  scene.Window->Render(); // fills the loader
  copyLayer = glCopyTexSubImage3D;
  glCopyTexSubImage3D = CopyLayer;
  const int tiles = look->GetSeaCascades();
  using Layers = std::vector<int>;
  bool ok = WaterCheck("the second frame computes it first",
    CopiedInFrame(scene, 0.5, atProp) == Layers{ tiles, tiles }, true);
  ok &= WaterCheck("at the same time it is not computed again",
    CopiedInFrame(scene, 0.5, atProp) == Layers{ 0, 0 }, true);
  scene.Water->SetVisibility(false);
  ok &= WaterCheck("it is invisible", CopiedInFrame(scene, 1.0, atProp) == Layers{ 0, 0 }, true);
  scene.Water->SetVisibility(true);
  scene.Renderer->GetActiveCamera()->SetPosition(3, -15, 400);
  scene.Renderer->GetActiveCamera()->SetFocalPoint(3, -40, 430); // it is behind the eye
  CopiedInFrame(scene, 1.5, atProp);
  ok &= WaterCheck("it is out of view", CopiedInFrame(scene, 2.0, atProp)[1], 0);
  scene.Renderer->GetActiveCamera()->SetPosition(3, -15, 4);
  scene.Renderer->GetActiveCamera()->SetFocalPoint(0, 0, 0.5);
  const Layers back = CopiedInFrame(scene, 2.5, atProp);
  ok &= WaterCheck("back in view it is computed once", back[1], tiles);
  ok &= WaterCheck("and ahead again after that",
    CopiedInFrame(scene, 3.0, atProp) == Layers{ tiles, tiles }, true);
  glCopyTexSubImage3D = copyLayer;
  unsetenv("VTK_WATER_SOFTWARE");
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
