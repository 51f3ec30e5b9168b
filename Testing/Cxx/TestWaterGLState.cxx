// SPDX-License-Identifier: BSD-3-Clause
// The mirrored view leaves the GL state as it found it: seen by two props that are asked for their
// share of render time, which is when the mirror is drawn, before and after the water.
#include "WaterTestScene.h"

#include "vtkCullerCollection.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkWaterReflectionPass.h"

#include <vector>

namespace
{
// GL's numbers for what is compared.
constexpr unsigned int kEnables[] = { 0x0B71, 0x0BE2, 0x0C11,
  0x0B44 }; // depth, blend, scissor, cull
constexpr unsigned int kViewport = 0x0BA2;
constexpr unsigned int kScissorBox = 0x0C10;
constexpr unsigned int kDrawFramebuffer = 0x8CA6;
constexpr unsigned int kReadFramebuffer = 0x8CAA;
constexpr unsigned int kDepthFunc = 0x0B74;
constexpr unsigned int kDepthWriteMask = 0x0B72;
constexpr unsigned int kBlendSourceRGB = 0x80C9;
constexpr unsigned int kActiveTexture = 0x84E0;

std::vector<std::vector<int>> states;

// An actor that notes the GL state when the renderer allots its time.
class NotingActor : public vtkActor
{
public:
  static NotingActor* New();
  vtkTypeMacro(NotingActor, vtkActor);

  void SetAllocatedRenderTime(double seconds, vtkViewport* viewport) override
  {
    this->Superclass::SetAllocatedRenderTime(seconds, viewport);
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(viewport->GetVTKWindow());
    vtkOpenGLState* state = window->GetState();
    std::vector<int> noted;
    for (unsigned int name : kEnables)
    {
      noted.push_back(state->GetEnumState(name));
    }
    for (unsigned int name : { kDrawFramebuffer, kReadFramebuffer, kDepthFunc, kDepthWriteMask,
           kBlendSourceRGB, kActiveTexture })
    {
      int value = 0;
      state->vtkglGetIntegerv(name, &value);
      noted.push_back(value);
    }
    for (unsigned int name : { kViewport, kScissorBox })
    {
      int box[4];
      state->vtkglGetIntegerv(name, box);
      noted.insert(noted.end(), box, box + 4);
    }
    states.push_back(noted);
  }
  void Render(vtkRenderer*, vtkMapper*) override {}
};
vtkStandardNewMacro(NotingActor);
}

int TestWaterGLState(int, char*[])
{
  WaterTestScene scene;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkSphereSource> ball;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<NotingActor> first;
  first->SetMapper(mapper);
  vtkNew<NotingActor> last;
  last->SetMapper(mapper);
  scene.Renderer->GetCullers()->RemoveAllItems(); // they would sort the props
  scene.Renderer->AddActor(first);
  scene.AddThings<vtkPolyDataMapper>();
  scene.AddWater();
  scene.Renderer->AddActor(last);
  for (int samples : { 0, 4 })
  {
    scene.Water->GetReflectionPass()->SetMultiSamples(samples);
    scene.Window->Render();
    scene.Renderer->GetActiveCamera()->Azimuth(1);
  }
  bool ok = WaterCheck<size_t>("states noted", states.size(), 4);
  ok &= WaterCheck<vtkIdType>(
    "mirrors", scene.Water->GetReflectionPass()->GetNumberOfReflectionRenders(), 2);
  for (size_t frame = 0; ok && frame < 2; ++frame)
  {
    for (size_t i = 0; i < states[0].size(); ++i)
    {
      ok &= WaterCheck(
        "frame " + std::to_string(frame) + ", state " + std::to_string(i) + " after the mirror",
        states[2 * frame + 1][i], states[2 * frame][i]);
    }
  }
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
