// SPDX-License-Identifier: BSD-3-Clause
// A driver that refuses shaders, framebuffers or memory: the water says so once and shows its plain
// colour, all else is as without water, and the next picture is right again once the cause is gone.
// Without memory for its own view, clear water shows what the picture has.
// The driver's functions are replaced in the loader that VTK calls them through.
#include "WaterFaultyScene.h"

#include "../../Module/Private/host/vtkWaterGL.h"

#include "vtkDoubleArray.h"
#include "vtkLogger.h"
#include "vtkOutputWindow.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkTrivialProducer.h"
#include "vtkWaterLakes.h"
#include "vtkWaterReflectionPass.h"

#include <cstdlib>
#include <cstring>
#include <functional>

namespace
{
int refused = 0;

PFNGLSHADERSOURCEPROC shaderSource = nullptr;
void ShaderSource(GLuint shader, GLsizei count, const GLchar* const* text, const GLint* lengths)
{
  if (count == 1 && std::strstr(text[0], "waterFacets"))
  {
    ++refused;
    const GLchar* const wrong[1] = { "#version 150\n#error refused\n" };
    shaderSource(shader, 1, wrong, nullptr);
    return;
  }
  shaderSource(shader, count, text, lengths);
}

// VTK draws a mesh whose shader was refused without a program, and what that shows is the driver's
// choice.
int drawnWithout = 0;
int drawnCut = 0; // at the shore; llvmpipe cuts, too, where that is not enabled
PFNGLDRAWRANGEELEMENTSPROC drawElements = nullptr;
void DrawElements(
  GLenum mode, GLuint first, GLuint last, GLsizei count, GLenum type, const void* place)
{
  GLint program = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &program);
  drawnWithout += program == 0 && !glIsEnabled(GL_RASTERIZER_DISCARD) ? 1 : 0;
  drawnCut += glIsEnabled(GL_CLIP_DISTANCE0 + 1) ? 1 : 0;
  drawElements(mode, first, last, count, type, place);
}

PFNGLCHECKFRAMEBUFFERSTATUSPROC checkStatus = nullptr;
GLenum CheckStatus(GLenum)
{
  ++refused;
  return GL_FRAMEBUFFER_UNSUPPORTED;
}

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
PFNGLTEXIMAGE2DPROC texImage = nullptr;
void TexImage(GLenum target, GLint level, GLint format, GLsizei width, GLsizei height, GLint border,
  GLenum pixelFormat, GLenum type, const void* pixels)
{
  const bool isWanted = !pixels; // a target to draw into
  refused += isWanted ? 1 : 0;
  // a width below 0 is an error, and leaves the texture without an image
  texImage(target, level, format, isWanted ? -1 : width, height, border, pixelFormat, type, pixels);
}
#endif

// slot     of the loader, for the driver's function
// own      function in its place, which calls `driver`
// prepare  makes the driver be asked again
template <typename Function>
bool Check(const std::string& name, const std::string& says, Function& slot, Function& driver,
  Function own, const std::function<void(FaultyScene&)>& prepare)
{
  const auto plain = FaultyScene().Plain();
  FaultyScene scene;
  const auto right = scene.Picture(); // every new window fills the loader again
  driver = slot;
  slot = own;
  refused = 0;
  drawnWithout = 0;
  drawElements = glDrawRangeElements;
  glDrawRangeElements = DrawElements;
  prepare(scene);
  const auto faulty = scene.Picture();
  scene.Picture();
  slot = driver;
  glDrawRangeElements = drawElements;
  bool ok = WaterCheck(name + ": it was refused", refused > 0, true);
  ok &= WaterCheck<size_t>(name + ": errors", scene.Errors.size(), 1);
  const bool isSaid = !scene.Errors.empty() && scene.Errors[0].find(says) != std::string::npos;
  ok &= WaterCheck(name + ": says \"" + says + "\"", isSaid, true);
  ok &= WaterCheck(name + ": the picture is the plain one", WaterSame(faulty, plain), true);
  ok &= WaterCheck(name + ": which is another", right == plain, false);
  ok &= WaterCheck(name + ": draws without a program that are rasterised", drawnWithout, 0);
  prepare(scene);
  ok &= WaterCheck(name + ": and right afterwards", WaterSame(scene.Picture(), right), true);
  return ok;
}

void Release(FaultyScene& scene)
{
  scene.Water->ReleaseGraphicsResources(scene.Window);
}

// To a shader that has not been built in this window, and back.
void ToggleWaves(FaultyScene& scene)
{
  auto* look = scene.Water->GetWaterProperty();
  if (look->GetNumberOfWaves() > 0)
  {
    look->RemoveAllWaves();
  }
  else
  {
    look->AddWave(0.01, 2.0, 20.0);
  }
}

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
void ToggleRefraction(FaultyScene& scene)
{
  auto* look = scene.Water->GetWaterProperty();
  look->SetRefraction(!look->GetRefraction());
}
#endif

// Water of a solver's mesh over a slope, and what it looks like when its shader is refused.
std::vector<unsigned char> RefusedShore(int cut, bool& isCutWhileDrawn)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-8.0, -6.0, 0.0);
  plane->SetPoint1(8.0, -6.0, 0.0);
  plane->SetPoint2(-8.0, 6.0, 0.0);
  plane->SetResolution(7, 5);
  plane->Update();
  vtkNew<vtkDoubleArray> depths;
  depths->SetName("h");
  vtkNew<vtkDoubleArray> bed;
  bed->SetName("zb");
  for (vtkIdType i = 0; i < plane->GetOutput()->GetNumberOfPoints(); ++i)
  {
    double point[3];
    plane->GetOutput()->GetPoint(i, point);
    bed->InsertNextValue(0.3 * point[0] + 0.1 * point[1]);
    depths->InsertNextValue(-bed->GetValue(i));
  }
  plane->GetOutput()->GetPointData()->AddArray(depths);
  plane->GetOutput()->GetPointData()->AddArray(bed);
  vtkNew<vtkTrivialProducer> source;
  source->SetOutput(plane->GetOutput());
  FaultyScene scene;
  scene.Renderer->RemoveActor(scene.Water);
  vtkNew<vtkWaterLakes> lakes;
  lakes->SetData(source->GetOutputPort(), "", "h", "zb");
  lakes->SetShoreCut(cut);
  lakes->AddTo(scene.Renderer);
  scene.Picture(); // every new window fills the loader again
  drawnCut = 0;
  drawElements = glDrawRangeElements;
  glDrawRangeElements = DrawElements;
  lakes->GetWater()->SetTime(1.0); // or nothing is drawn
  scene.Picture();
  glDrawRangeElements = drawElements;
  shaderSource = glShaderSource;
  glShaderSource = ShaderSource;
  lakes->GetWater()->GetWaterProperty()->AddWave(0.01, 2.0, 20.0); // another shader
  const auto first = scene.Picture();
  isCutWhileDrawn = lakes->GetIsShoreCutWhileDrawn();
  const auto second = scene.Picture();
  glShaderSource = shaderSource;
  return WaterSame(first, second) ? first : std::vector<unsigned char>();
}

// The plain colour ends at the shore as the water does.
bool CheckShore()
{
  setenv("VTK_WATER_SOFTWARE", "0", 1);
  refused = 0;
  bool isDrawn = false;
  bool isUncut = false;
  const auto right = RefusedShore(vtkWaterLakes::CUT_IN_FILTER, isDrawn);
  bool ok = WaterCheck("shore: the filter cuts", isDrawn, false);
  ok &= WaterCheck("shore: draws that are cut there", drawnCut, 0);
  const auto faulty = RefusedShore(vtkWaterLakes::CUT_WHILE_DRAWN, isUncut);
  unsetenv("VTK_WATER_SOFTWARE");
  ok &= WaterCheck("shore: cut while drawn", isUncut, true);
  ok &= WaterCheck("shore: draws that are cut", drawnCut, 1);
  ok &= WaterCheck("shore: it was refused", refused > 1, true);
  ok &= WaterCheck("shore: the plain colour ends there", WaterSame(faulty, right), true);
  return ok;
}

// The own view alone gets no framebuffer: the mirrored view has one already.
bool CheckOwnView()
{
  FaultyScene scene;
  auto* look = scene.Water->GetWaterProperty();
  look->SetRefraction(true);
  const auto ofPicture = scene.Picture();
  look->SetRefractionSourceToOwnView();
  checkStatus = glCheckFramebufferStatus;
  glCheckFramebufferStatus = CheckStatus;
  refused = 0;
  const auto faulty = scene.Picture();
  scene.Picture();
  glCheckFramebufferStatus = checkStatus;
  bool ok = WaterCheck("own view: it was refused", refused > 0, true);
  ok &= WaterCheck<size_t>("own view: errors", scene.Errors.size(), 1);
  const bool isSaid = !scene.Errors.empty() &&
    scene.Errors[0].find("own view of refraction: the GPU gave no framebuffer") !=
      std::string::npos;
  ok &= WaterCheck("own view: it is said", isSaid, true);
  ok &= WaterCheck("own view: the picture's is shown", WaterSame(faulty, ofPicture), true);
  const auto right = scene.Picture();
  ok &= WaterCheck("own view: and right afterwards", right == ofPicture, false);
  ok &= WaterCheck<vtkIdType>(
    "own view: rendered", scene.Water->GetReflectionPass()->GetNumberOfOwnViewRenders(), 1);
  return ok;
}
}

int TestWaterDriverFaults(int, char*[])
{
  // VTK prints the shader, for one
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  bool ok = Check<PFNGLSHADERSOURCEPROC>("shader", "rejects the water's shader", glShaderSource,
    shaderSource, ShaderSource, ToggleWaves);
  ok &= Check<PFNGLCHECKFRAMEBUFFERSTATUSPROC>("framebuffer", "no framebuffer for the reflection",
    glCheckFramebufferStatus, checkStatus, CheckStatus, Release);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  ok &= Check<PFNGLTEXIMAGE2DPROC>(
    "texture", "no framebuffer for the reflection", glTexImage2D, texImage, TexImage, Release);
  ok &= Check<PFNGLTEXIMAGE2DPROC>("texture of clear water", "no textures for the refracted scene",
    glTexImage2D, texImage, TexImage, ToggleRefraction);
#else
  std::cout << "textures: left out, this VTK calls glTexImage2D without a loader" << std::endl;
#endif
  ok &= CheckOwnView();
  ok &= CheckShore();
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
