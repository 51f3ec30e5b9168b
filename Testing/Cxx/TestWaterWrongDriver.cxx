// SPDX-License-Identifier: BSD-3-Clause
// A driver that does what it should not, and says nothing: clip distances that do not cut, or cut
// everything; no timer queries; queries that are never answered; framebuffers that are gone. The
// picture is the right one, by a slower way, or the plain one; that is said once, to those who
// debug. The driver's functions are replaced in the loader that VTK calls them through.
#include "WaterFaultyScene.h"

#include "../../Module/Private/host/vtkWaterGL.h"

#include "vtkLogger.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkWaterReflectionPass.h"

#include <cmath>
#include <functional>
#include <string>

namespace
{
int met = 0;

// Keeps what is said.
class Listener : public vtkOutputWindow
{
public:
  static Listener* New();
  vtkTypeMacro(Listener, vtkOutputWindow);
  void DisplayText(const char* text) override { this->Said.emplace_back(text); }
  void DisplayDebugText(const char* text) override { this->Said.emplace_back(text); }

  std::vector<std::string> Said;
};
vtkStandardNewMacro(Listener);

const char* distance = ""; // in place of what a shader writes
PFNGLSHADERSOURCEPROC shaderSource = nullptr;
void ShaderSource(GLuint shader, GLsizei count, const GLchar* const* text, const GLint* lengths)
{
  const std::string written = "gl_ClipDistance[0] =";
  std::string source(text[0]);
  const size_t place = source.find(written);
  if (count != 1 || place == std::string::npos)
  {
    shaderSource(shader, count, text, lengths);
    return;
  }
  ++met;
  source.replace(place, written.size(), written + distance);
  const GLchar* const wrong[1] = { source.c_str() };
  shaderSource(shader, 1, wrong, nullptr);
}

int waited = 0;  // for what never comes
int answers = 0; // that still come
PFNGLGETQUERYOBJECTUIVPROC queryUnsigned = nullptr;
void QueryUnsigned(GLuint asked, GLenum name, GLuint* value)
{
  if (answers > 0)
  {
    answers -= name == GL_QUERY_RESULT ? 1 : 0;
    queryUnsigned(asked, name, value);
    return;
  }
  ++met;
  waited += name == GL_QUERY_RESULT ? 1 : 0;
  *value = 0;
}

PFNGLGETQUERYOBJECTIVPROC querySigned = nullptr;
void QuerySigned(GLuint, GLenum name, GLint* value)
{
  ++met;
  waited += name == GL_QUERY_RESULT ? 1 : 0;
  *value = 0;
}

PFNGLGETQUERYIVPROC query = nullptr;
void Query(GLenum target, GLenum name, GLint* value)
{
  query(target, name, value);
  if (name == GL_QUERY_COUNTER_BITS)
  {
    ++met;
    *value = 0;
  }
}

PFNGLCHECKFRAMEBUFFERSTATUSPROC checkStatus = nullptr;
GLenum CheckStatus(GLenum)
{
  ++met;
  return GL_FRAMEBUFFER_UNDEFINED;
}

// A function of the loader is another one while an object of this class lives.
template <typename Function>
struct Replaced
{
  Replaced(Function& slot, Function& driver, Function own)
    : Slot(slot)
    , Driver(slot)
  {
    driver = slot;
    slot = own;
  }
  ~Replaced() { this->Slot = this->Driver; }

  Function& Slot;
  Function Driver;
};

// Has a window whose loader is filled, and has not asked its driver anything for water.
struct Scene : public FaultyScene
{
  Scene()
  {
    this->Water->VisibilityOff();
    this->Picture();
    this->Water->VisibilityOn();
    this->Water->DebugOn();
  }
  std::vector<unsigned char> Turn(double degrees)
  {
    this->Renderer->GetActiveCamera()->Azimuth(degrees);
    return this->Picture();
  }
};

bool IsSaidOnce(
  const std::string& name, const Listener* listener, const std::string& text, int times)
{
  int found = 0;
  for (const std::string& said : listener->Said)
  {
    found += said.find(text) != std::string::npos ? 1 : 0;
  }
  return WaterCheck(name + ": says \"" + text + "\", times", found, times);
}

int CountDifferent(const std::vector<unsigned char>& one, const std::vector<unsigned char>& other)
{
  int different = one.size() == other.size() ? 0 : 1;
  for (size_t i = 0; i < one.size() && one.size() == other.size(); ++i)
  {
    different += one[i] != other[i] ? 1 : 0;
  }
  return different;
}

bool CheckClip(const std::string& name, const char* written, Listener* listener)
{
  const auto right = Scene().Picture();
  Scene scene;
  listener->Said.clear();
  met = 0;
  distance = written;
  const Replaced<PFNGLSHADERSOURCEPROC> replaced(glShaderSource, shaderSource, ShaderSource);
  const auto first = scene.Picture();
  bool ok = WaterCheck(name + ": the probe's shader alone writes it", met, 1);
  ok &= WaterCheck(name + ": bytes of the picture that differ", CountDifferent(first, right), 0);
  scene.Turn(5.0);
  ok &= WaterCheck(name + ": and later", CountDifferent(scene.Turn(-5.0), right), 0);
  ok &= WaterCheck<size_t>(name + ": errors", scene.Errors.size(), 0);
  return ok & IsSaidOnce(name, listener, "does not clip correctly by clip distances", 1);
}

bool CheckRightClip(Listener* listener)
{
  listener->Said.clear();
  Scene scene;
  scene.Picture();
  return IsSaidOnce("a right driver", listener, "does not clip correctly by clip distances", 0);
}

// The times of the GPU are not known, and nobody waits for them.
bool CheckTimes(const std::string& name, Scene& scene, const std::vector<unsigned char>& right)
{
  vtkWaterReflectionPass* pass = scene.Water->GetReflectionPass();
  pass->InstrumentationOn();
  pass->SetQualityToTimeBudget();
  for (int i = 0; i < 4; ++i)
  {
    scene.Turn(3.0);
  }
  bool ok = WaterCheck(
    name + ": the reflection's time is NaN", std::isnan(pass->GetLastReflectionTime()), true);
  ok &=
    WaterCheck(name + ": the surface's time is NaN", std::isnan(pass->GetLastSurfaceTime()), true);
  const auto last = scene.Turn(-12.0);
  ok &= WaterCheck(name + ": bytes of the picture that differ", CountDifferent(last, right), 0);
  ok &= WaterCheck<size_t>(name + ": errors", scene.Errors.size(), 0);
  return ok;
}

bool CheckNoTimers(Listener* listener)
{
  const auto right = Scene().Picture();
  bool ok = true;
  {
    Scene scene;
    listener->Said.clear();
    PFNGLQUERYCOUNTERPROC counter = nullptr;
    const Replaced<PFNGLQUERYCOUNTERPROC> replaced(glQueryCounter, counter, nullptr);
    ok &= CheckTimes("no timer queries", scene, right);
    ok &= IsSaidOnce("no timer queries", listener, "no timer queries", 1);
  }
  Scene scene;
  listener->Said.clear();
  met = 0;
  const Replaced<PFNGLGETQUERYIVPROC> replaced(glGetQueryiv, query, Query);
  ok &= CheckTimes("timer queries of no bits", scene, right);
  ok &= WaterCheck("timer queries of no bits: it was asked", met > 0, true);
  return ok & IsSaidOnce("timer queries of no bits", listener, "no timer queries", 1);
}

bool CheckUnanswered()
{
  const auto right = Scene().Picture();
  Scene scene;
  met = waited = 0;
  const Replaced<PFNGLGETQUERYOBJECTUIVPROC> one(glGetQueryObjectuiv, queryUnsigned, QueryUnsigned);
  const Replaced<PFNGLGETQUERYOBJECTIVPROC> other(glGetQueryObjectiv, querySigned, QuerySigned);
  bool ok = CheckTimes("unanswered queries", scene, right);
  vtkWaterReflectionPass* pass = scene.Water->GetReflectionPass();
  ok &= WaterCheck<vtkIdType>(
    "unanswered queries: triangles", pass->GetNumberOfTrianglesReflected(), -1);
  ok &= WaterCheck<vtkIdType>(
    "unanswered queries: fragments", pass->GetNumberOfFragmentsReflected(), -1);
  ok &= WaterCheck("unanswered queries: somebody asked", met > 0, true);
  return ok & WaterCheck("unanswered queries: times that somebody waited", waited, 0);
}

// Of water behind a wall, which is asked for, and waited for.
bool CheckAnswersEnd(Listener* listener)
{
  Scene scene;
  vtkNew<vtkCubeSource> wall;
  wall->SetCenter(2.4, -12, 3);
  wall->SetXLength(9);
  wall->SetYLength(0.1);
  wall->SetZLength(9);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(wall->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
  const auto right = scene.Picture();
  scene.Picture();
  scene.Picture();
  bool ok = WaterCheck<int>("hidden water: decision",
    scene.Water->GetReflectionPass()->GetDecision(), vtkWaterReflectionPass::HIDDEN);
  listener->Said.clear();
  const Replaced<PFNGLGETQUERYOBJECTUIVPROC> one(glGetQueryObjectuiv, queryUnsigned, QueryUnsigned);
  for (int count = 0; count < 6; ++count)
  {
    answers = 3;
    scene.Picture();
    waited = 0;
    answers = count % 3;
    ok &= WaterCheck("no more answers of hidden water: bytes that differ",
      CountDifferent(scene.Picture(), right), 0);
    ok &= WaterCheck("no more answers of hidden water: times that somebody waited", waited, 0);
  }
  answers = 0;
  return ok &
    IsSaidOnce("no more answers", listener, "does not report whether the water is hidden", 1);
}

bool CheckLostFramebuffers()
{
  const auto plain = FaultyScene().Plain();
  Scene scene;
  const auto right = scene.Picture();
  met = 0;
  bool ok = true;
  {
    const Replaced<PFNGLCHECKFRAMEBUFFERSTATUSPROC> replaced(
      glCheckFramebufferStatus, checkStatus, CheckStatus);
    scene.Turn(3.0);
    scene.Turn(3.0);
    const auto faulty = scene.Turn(-6.0);
    ok &= WaterCheck("framebuffers lost: it is the plain picture, or the right one",
      faulty == plain || faulty == right, true);
    ok &= WaterCheck("framebuffers lost: at most one error", scene.Errors.size() <= 1, true);
  }
  scene.Turn(3.0);
  return ok & WaterCheck("framebuffers there again: right", scene.Turn(-3.0) == right, true);
}

bool CheckFinalized()
{
  Scene scene;
  const auto right = scene.Picture();
  bool ok = true;
  for (int i = 0; i < 3; ++i)
  {
    scene.Window->Finalize();
    ok &= WaterCheck(
      "finalized between frames: bytes that differ", CountDifferent(scene.Picture(), right), 0);
  }
  return ok & WaterCheck<size_t>("finalized between frames: errors", scene.Errors.size(), 0);
}
}

int TestWaterWrongDriver(int, char*[])
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<Listener> listener;
  vtkOutputWindow::SetInstance(listener);
  bool ok = CheckRightClip(listener);
  ok &= CheckClip("clip distances that are not heeded", " 1.0 + 0.0 *", listener);
  ok &= CheckClip("clip distances that cut everything", " -1.0 + 0.0 *", listener);
  ok &= CheckClip("clip distances that cut the other side", " -1.0 *", listener);
  ok &= CheckNoTimers(listener);
  ok &= CheckUnanswered();
  ok &= CheckAnswersEnd(listener);
  ok &= CheckLostFramebuffers();
  ok &= CheckFinalized();
  vtkOutputWindow::SetInstance(nullptr);
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
