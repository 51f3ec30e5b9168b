// SPDX-License-Identifier: BSD-3-Clause
// A driver that refuses the shader of a prop because of the lines that reflections put into it: the
// prop is drawn as without water, in the same frame, and is not reflected; the water says so once.
// When the cause is gone, the next picture is right.
//
// The driver's function is replaced in the loader that VTK calls it through; the user's own shaders
// that clash with those lines need no such thing.
#include "WaterFaultyScene.h"

#include "../../Module/Private/host/vtkWaterGL.h"

#include "vtkAssembly.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLogger.h"
#include "vtkOutputWindow.h"
#include "vtkProp3DFollower.h"
#include "vtkShaderProperty.h"
#include "vtkWaterReflectionPass.h"

#include <cstring>
#include <functional>

namespace
{
const char* const kMark = "// of the refused prop";

PFNGLSHADERSOURCEPROC shaderSource = nullptr;
void ShaderSource(GLuint shader, GLsizei count, const GLchar* const* text, const GLint* lengths)
{
  if (count == 1 && std::strstr(text[0], kMark) && std::strstr(text[0], "waterHeadlight"))
  {
    const GLchar* const wrong[1] = { "#version 150\n#error the mark\n" };
    shaderSource(shader, 1, wrong, nullptr);
    return;
  }
  shaderSource(shader, count, text, lengths);
}

enum Kind
{
  ALONE,
  PART,       // of an assembly
  INSIDE,     // of a prop that does not say so
  SHARED_KEYS // with all other columns
};

struct RefusedScene : public FaultyScene
{
  explicit RefusedScene(Kind kind = ALONE)
  {
    // the second column, in view and in the reflection
    this->Actor = vtkActor::SafeDownCast(this->Renderer->GetViewProps()->GetItemAsObject(1));
    this->Prop = this->Actor;
    if (kind == SHARED_KEYS)
    {
      vtkNew<vtkInformation> keys;
      vtkPropCollection* props = this->Renderer->GetViewProps();
      for (int i = 0; i < props->GetNumberOfItems(); ++i)
      {
        auto* prop = vtkProp::SafeDownCast(props->GetItemAsObject(i));
        if (prop != this->Water)
        {
          prop->SetPropertyKeys(keys);
        }
      }
    }
    if (kind == PART)
    {
      vtkNew<vtkAssembly> assembly;
      assembly->AddPart(this->Actor);
      this->Prop = assembly;
    }
    if (kind == INSIDE)
    {
      vtkNew<vtkProp3DFollower> follower;
      follower->SetProp3D(this->Actor);
      follower->SetOrigin(this->Actor->GetCenter()); // turns where it stands
      follower->SetCamera(this->Renderer->GetActiveCamera());
      this->Prop = follower;
    }
    if (this->Prop != this->Actor)
    {
      this->Renderer->RemoveViewProp(this->Actor);
      this->Renderer->AddViewProp(this->Prop);
    }
  }

  // The water does not reflect the prop.
  void LeaveOut(bool isOut)
  {
    if (!this->Prop->GetPropertyKeys())
    {
      this->Prop->SetPropertyKeys(vtkNew<vtkInformation>());
    }
    this->Prop->GetPropertyKeys()->Set(vtkWaterReflectionPass::NOT_REFLECTED(), isOut ? 1 : 0);
  }

  int GetFate(int fate) { return this->Water->GetReflectionPass()->GetFateCount(fate); }

  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkProp> Prop;
};

void SetShader(RefusedScene& scene, const std::string& declarations)
{
  scene.Actor->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Normal::Dec", true, declarations + "\n//VTK::Normal::Dec", false);
}

// says     in the error
// make     makes the driver refuse the prop's shader
// unmake   and not any more
bool Check(const std::string& name, const std::string& says,
  const std::function<void(RefusedScene&)>& make, const std::function<void(RefusedScene&)>& unmake,
  Kind kind = ALONE)
{
  RefusedScene expected(kind == SHARED_KEYS ? ALONE : kind); // this alone is left out
  expected.LeaveOut(true);
  const auto plain = expected.Picture();
  RefusedScene scene(kind);
  const auto right = scene.Picture();
  make(scene);
  const auto faulty = scene.Picture();
  bool ok = WaterCheck(name + ": fate", scene.GetFate(vtkWaterReflectionPass::REFUSED), 1);
  ok &= WaterCheck(name + ": the prop is drawn and not reflected", WaterSame(faulty, plain), true);
  ok &= WaterCheck(name + ": which is another picture", right == plain, false);
  for (int i = 0; i < 3; ++i)
  {
    scene.Renderer->GetActiveCamera()->Azimuth(i == 1 ? -10 : 5);
    scene.Picture();
  }
  scene.Prop->SetPropertyKeys(vtkNew<vtkInformation>());
  ok &= WaterCheck(name + ": and so it stays", WaterSame(scene.Picture(), plain), true);
  ok &= WaterCheck<size_t>(name + ": errors", scene.Errors.size(), 1);
  const bool isSaid = !scene.Errors.empty() &&
    scene.Errors[0].find("rejects a shader of a prop (vtkOpenGLActor") != std::string::npos &&
    scene.Errors[0].find(says) != std::string::npos;
  ok &= WaterCheck(name + ": the error names the prop and says \"" + says + "\"", isSaid, true);
  if (!isSaid && !scene.Errors.empty())
  {
    std::cout << scene.Errors[0] << std::endl;
  }
  unmake(scene);
  ok &= WaterCheck(name + ": right afterwards", WaterSame(scene.Picture(), right), true);
  ok &= WaterCheck(name + ": fate afterwards", scene.GetFate(vtkWaterReflectionPass::REFUSED), 0);
  ok &= WaterCheck<size_t>(name + ": errors afterwards", scene.Errors.size(), 1);
  return ok;
}

void RefuseMarked(RefusedScene& scene)
{
  shaderSource = glShaderSource;
  glShaderSource = ShaderSource;
  SetShader(scene, kMark);
}

void RefuseNothing(RefusedScene& scene)
{
  glShaderSource = shaderSource;
  scene.Actor->GetProperty()->Modified();
}

// Only the eye's view draws the prop: it is lost there before anybody knows.
bool CheckUnreflected(const std::string& name, Kind kind)
{
  RefusedScene scene(kind);
  scene.LeaveOut(true);
  const auto right = scene.Picture();
  RefuseMarked(scene);
  bool ok = WaterCheck(name + ": the picture", WaterSame(scene.Picture(), right), true);
  ok &= WaterCheck<size_t>(name + ": errors", scene.Errors.size(), 1);
  RefuseNothing(scene);
  ok &= WaterCheck(name + ": right afterwards", WaterSame(scene.Picture(), right), true);
  return ok;
}

// A shader that is wrong without the lines, too, fares as without water: the prop is not there. VTK
// before 9.3 crashes where it fails twice.
//
// isNew  from the prop's first frame on
bool CheckBroken(const std::string& name, bool isNew)
{
  RefusedScene expected;
  const auto right = expected.Picture();
  expected.Actor->VisibilityOff();
  const auto without = expected.Picture();
  RefusedScene scene;
  if (!isNew)
  {
    scene.Picture();
  }
  SetShader(scene, "#error of the user");
  bool ok = WaterCheck(name + ": the prop is not there", WaterSame(scene.Picture(), without), true);
  scene.Renderer->GetActiveCamera()->Azimuth(5);
  scene.Picture();
  scene.Renderer->GetActiveCamera()->Azimuth(-5);
  ok &= WaterCheck(name + ": and so it stays", WaterSame(scene.Picture(), without), true);
  ok &= WaterCheck<size_t>(name + ": errors", scene.Errors.size(), 1);
  scene.Actor->GetShaderProperty()->ClearAllFragmentShaderReplacements();
  ok &= WaterCheck(name + ": right afterwards", WaterSame(scene.Picture(), right), true);
  return ok;
}
}

int TestWaterRefusedProps(int, char*[])
{
  // VTK prints the shader, for one
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  bool ok = Check("refused", "the mark", RefuseMarked, RefuseNothing);
  ok &= Check("part of an assembly", "the mark", RefuseMarked, RefuseNothing, PART);
  ok &= Check("inside of a follower", "the mark", RefuseMarked, RefuseNothing, INSIDE);
  ok &= Check("shared keys", "the mark", RefuseMarked, RefuseNothing, SHARED_KEYS);
  ok &= Check(
    "clash of names", "waterClipWindow",
    [](RefusedScene& scene) { SetShader(scene, "uniform float waterClipWindow;"); },
    [](RefusedScene& scene) {
      scene.Actor->GetShaderProperty()->ClearAllFragmentShaderReplacements();
    });
  ok &= CheckUnreflected("not reflected anyway", ALONE);
  ok &= CheckUnreflected("not reflected anyway, shared keys", SHARED_KEYS);
  ok &= CheckBroken("wrong anyway", false);
  ok &= CheckBroken("wrong from the start", true);
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
