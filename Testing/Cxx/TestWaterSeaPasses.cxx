// SPDX-License-Identifier: BSD-3-Clause
// The slopes of a wind sea that a GPU makes are those that the processor makes: for tiles of many
// sizes, with and without a period, now and after years. What a GPU cannot, or refuses, the
// processor does instead, and GL's state is as it was.
#include "WaterTestScene.h"

#include "vtkWaterGL.h"
#include "vtkWaterSea.h"

#include "vtkLogger.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOutputWindow.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <vector>

namespace
{
constexpr double kLimit = 2e-5;               // of the rms slope
constexpr int kFields = 2;                    // slopes and what else is in numbers of 32 bits
constexpr double kHalf = 1.0 / 1024.0 + 1e-6; // the last of the 11 bits of such a number
constexpr double kLeastHalf = 1.0 / 16384.0;  // the smallest that has them all

const water_sea kSea = { WATER_SEA_JONSWAP, WATER_SPREAD_DONELAN_BANNER, 7.0, 0.5, 2e4,
  std::numeric_limits<double>::infinity(), 3.3, 10.0 };

water_cascades MakeTile(size_t size, double period)
{
  water_cascades made = water_cascades();
  made.count = 1;
  made.tiles[0] = { size, 0.25 * static_cast<double>(size), period, 3, 0.0, 0.0 };
  return made;
}

vtkOpenGLRenderWindow* Current(WaterTestScene& scene)
{
  scene.Window->Render();
  scene.Window->MakeCurrent();
  return vtkOpenGLRenderWindow::SafeDownCast(scene.Window);
}

void Pretend(bool isSoftware)
{
  setenv("VTK_WATER_SOFTWARE", isSoftware ? "1" : "0", 1);
}

// The first of the texture's layers.
std::vector<float> Read(vtkTextureObject* texture, size_t size, int level)
{
  const size_t layer = 4 * (size >> level) * (size >> level);
  std::vector<float> texels(layer * texture->GetDepth());
  texture->Activate();
  glGetTexImage(GL_TEXTURE_2D_ARRAY, level, GL_RGBA, GL_FLOAT, texels.data());
  texture->Deactivate();
  texels.resize(layer);
  return texels;
}

double Largest(const std::vector<float>& found, const std::vector<float>& right, size_t first)
{
  double largest = 0.0;
  for (size_t i = first; i < right.size(); i += i % 2 ? 3 : 1) // two of four
  {
    const double error = std::abs(static_cast<double>(found[i]) - static_cast<double>(right[i]));
    largest = std::isfinite(error) ? std::max(largest, error) : error;
  }
  return largest;
}

double Rms(const std::vector<float>& texels)
{
  double sum = 0.0;
  for (size_t i = 0; i < texels.size(); i += 4)
  {
    sum += static_cast<double>(texels[i + 2]) + static_cast<double>(texels[i + 3]);
  }
  return std::sqrt(4.0 * sum / static_cast<double>(texels.size()));
}

bool CheckClose(const std::string& name, double value, double limit)
{
  const bool holds = value <= limit;
  std::cout << name << ": " << value << " (limit <= " << limit << ") " << (holds ? "ok" : "FAILED")
            << std::endl;
  return holds;
}

bool CheckSlopes(vtkOpenGLRenderWindow* window, size_t size, double period)
{
  vtkWaterSea gpu;
  vtkWaterSea processor;
  const water_cascades tile = MakeTile(size, period);
  double worst = 0.0;
  double worstSquare = 0.0;
  bool ok = true;
  for (double time : { 0.0, 0.125, 1e3, -12345.678, 1e6, 1.7e9 })
  {
    gpu.Update(tile, kSea, time);
    processor.Update(tile, kSea, time);
    for (int level : { 0, 1 })
    {
      Pretend(false);
      const auto found = Read(gpu.Upload(window, kFields), size, level);
      Pretend(true);
      const auto right = Read(processor.Upload(window, kFields), size, level);
      const double rms = Rms(right);
      ok &= rms > 1e-3 && !gpu.GetDetour() && !processor.GetDetour();
      worst = std::max(worst, Largest(found, right, 0) / rms);
      worstSquare = std::max(worstSquare, Largest(found, right, 2) / (rms * rms));
    }
  }
  const std::string name =
    "size " + std::to_string(size) + ", period " + std::to_string(static_cast<int>(period));
  ok &= WaterCheck(name + ": each has its own way", ok, true);
  ok &= CheckClose(name + ": worst slope, of the rms slope", worst, kLimit);
  ok &= WaterCheck(name + ": the roundings are not the processor's", worst > 0.0, true);
  // a square has twice the error, and slopes are up to five times their rms
  ok &= CheckClose(name + ": worst square", worstSquare, 10.0 * kLimit);
  gpu.ReleaseGraphicsResources(window);
  processor.ReleaseGraphicsResources(window);
  return ok;
}

// One sea whose size, waves and time change as it goes.
bool CheckChanges(vtkOpenGLRenderWindow* window)
{
  vtkWaterSea gpu;
  bool ok = true;
  for (size_t size : { size_t(32), size_t(64), size_t(32) })
  {
    for (double wind : { 5.0, 9.0 })
    {
      water_sea sea = kSea;
      sea.wind_speed = wind;
      vtkWaterSea processor;
      gpu.Update(MakeTile(size, 0.0), sea, wind);
      processor.Update(MakeTile(size, 0.0), sea, wind);
      Pretend(false);
      const auto found = Read(gpu.Upload(window, kFields), size, 0);
      Pretend(true);
      const auto right = Read(processor.Upload(window, kFields), size, 0);
      ok &= CheckClose("changed to size " + std::to_string(size) + ", wind " +
          std::to_string(static_cast<int>(wind)),
        Largest(found, right, 0) / Rms(right), kLimit);
      processor.ReleaseGraphicsResources(window);
    }
  }
  gpu.ReleaseGraphicsResources(window);
  return ok;
}

// Slopes alone have 16 bits; drivers round up, down or to the nearest.
bool CheckHalf(vtkOpenGLRenderWindow* window)
{
  vtkWaterSea sea;
  constexpr size_t size = 64;
  sea.Update(MakeTile(size, 0.0), kSea, 2.0);
  Pretend(false);
  const auto found = Read(sea.Upload(window, 1), size, 0);
  const auto right = Read(sea.Upload(window, kFields), size, 0);
  double worst = 0.0;
  for (size_t i = 0; i < right.size(); ++i)
  {
    const double error = std::abs(static_cast<double>(found[i]) - static_cast<double>(right[i]));
    worst = std::max(worst, error / (std::abs(static_cast<double>(right[i])) + kLeastHalf));
  }
  bool ok = WaterCheck("drawn", !sea.GetDetour() && Rms(right) > 1e-3, true);
  ok &= CheckClose("slopes alone: worst error, of the number", worst, kHalf);
  ok &= WaterCheck("slopes alone have 16 bits", worst > 0.0, true);
  sea.ReleaseGraphicsResources(window);
  return ok;
}

// The texture is the processor's own, and the reason is given.
bool CheckDetour(const std::string& name, vtkOpenGLRenderWindow* window, vtkWaterSea& sea,
  size_t size, double time, const char* says)
{
  vtkWaterSea processor;
  sea.Update(MakeTile(size, 0.0), kSea, time);
  processor.Update(MakeTile(size, 0.0), kSea, time);
  Pretend(false);
  const auto found = Read(sea.Upload(window, 1), size, 1);
  const std::string said = sea.GetDetour() ? sea.GetDetour() : "";
  Pretend(true);
  const auto right = Read(processor.Upload(window, 1), size, 1);
  bool ok = WaterCheck(name + ": says '" + said + "'", said.find(says) != std::string::npos, true);
  ok &= WaterCheck(name + ": the texture is the processor's", found == right, true);
  processor.ReleaseGraphicsResources(window);
  return ok;
}

bool CheckDetours(vtkOpenGLRenderWindow* window)
{
  vtkWaterSea sea;
  bool ok = CheckDetour("a large prime factor", window, sea, 34, 1.0, "prime factor");
  ok &= CheckDetour("a large time", window, sea, 32, 1e15, "time is too large");
  sea.Update(MakeTile(32, 0.0), kSea, 1e3);
  Pretend(false);
  sea.Upload(window, 1);
  ok &= WaterCheck("after the large time it is the GPU's again", sea.GetDetour() == nullptr, true);
  GLuint query = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  ok &= CheckDetour("while samples are counted", window, sea, 32, 2.0, "query");
  glEndQuery(GL_SAMPLES_PASSED);
  GLuint samples = 1;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
  glDeleteQueries(1, &query);
  ok &= WaterCheck<GLuint>("samples of the passes", samples, 0);
  sea.ReleaseGraphicsResources(window);
  return ok;
}

int refused = 0;

PFNGLSHADERSOURCEPROC shaderSource = nullptr;
void ShaderSource(GLuint shader, GLsizei count, const GLchar* const* text, const GLint* lengths)
{
  if (count == 1 && std::strstr(text[0], "waterFftPass"))
  {
    ++refused;
    const GLchar* const wrong[1] = { "#version 150\n#error refused\n" };
    shaderSource(shader, 1, wrong, nullptr);
    return;
  }
  shaderSource(shader, count, text, lengths);
}

PFNGLCHECKFRAMEBUFFERSTATUSPROC checkStatus = nullptr;
GLenum CheckStatus(GLenum)
{
  ++refused;
  return GL_FRAMEBUFFER_UNSUPPORTED;
}

// A driver that refuses is asked once in a window.
template <typename Function>
bool CheckRefusal(const std::string& name, Function& slot, Function& driver, Function own)
{
  WaterTestScene scene; // every new window fills the loader again
  vtkOpenGLRenderWindow* window = Current(scene);
  vtkWaterSea sea;
  driver = slot;
  slot = own;
  refused = 0;
  bool ok = CheckDetour(name, window, sea, 64, 1.0, "rejects");
  ok &= CheckDetour(name + ", then", window, sea, 64, 2.0, "rejects");
  ok &= WaterCheck(name + ": refused", refused, 1);
  slot = driver;
  WaterTestScene other;
  sea.Update(MakeTile(64, 0.0), kSea, 3.0);
  Pretend(false);
  sea.Upload(Current(other), 1);
  ok &= WaterCheck<std::string>(
    name + ": in another window", sea.GetDetour() ? sea.GetDetour() : "drawn", "drawn");
  sea.ReleaseGraphicsResources(other.Window);
  return ok;
}

std::vector<int> ReadState()
{
  std::vector<int> numbers;
  for (GLenum name : { GL_DEPTH_TEST, GL_BLEND, GL_SCISSOR_TEST, GL_CULL_FACE, GL_STENCIL_TEST })
  {
    numbers.push_back(glIsEnabled(name));
  }
  for (GLenum name : { GL_DRAW_FRAMEBUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING, GL_DRAW_BUFFER,
         GL_DEPTH_WRITEMASK, GL_ACTIVE_TEXTURE, GL_VERTEX_ARRAY_BINDING, GL_UNPACK_ALIGNMENT,
         GL_PIXEL_UNPACK_BUFFER_BINDING })
  {
    GLint number = 0;
    glGetIntegerv(name, &number);
    numbers.push_back(number);
  }
  for (GLenum name : { GL_VIEWPORT, GL_SCISSOR_BOX, GL_COLOR_WRITEMASK })
  {
    GLint four[4] = {};
    glGetIntegerv(name, four);
    numbers.insert(numbers.end(), four, four + 4);
  }
  return numbers;
}

// In the middle of a frame anything may be set.
bool CheckState(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLState* state = window->GetState();
  vtkWaterSea sea;
  Pretend(false);
  bool ok = true;
  for (int round = 0; round < 3; ++round) // with uploads and without
  {
    const bool isOn = round % 2 == 0;
    for (GLenum name : { GL_DEPTH_TEST, GL_BLEND, GL_SCISSOR_TEST, GL_CULL_FACE, GL_STENCIL_TEST })
    {
      state->SetEnumState(name, isOn);
    }
    state->vtkglColorMask(isOn, !isOn, isOn, !isOn);
    state->vtkglDepthMask(isOn);
    state->vtkglViewport(1, 2, 3 + round, 4);
    state->vtkglScissor(5, 6, 7, 8 + round);
    state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(round));
    const std::vector<int> before = ReadState();
    sea.Update(MakeTile(32, 0.0), kSea, round);
    vtkTextureObject* texture = sea.Upload(window, 1);
    const std::vector<int> after = ReadState();
    for (size_t i = 0; i < before.size(); ++i)
    {
      ok &= WaterCheck(
        "round " + std::to_string(round) + ", state " + std::to_string(i), after[i], before[i]);
    }
    ok &= WaterCheck("drawn", !sea.GetDetour() && Rms(Read(texture, 32, 0)) > 1e-3, true);
  }
  state->Reset();
  sea.ReleaseGraphicsResources(window);
  return ok;
}
}

int TestWaterSeaPasses(int, char*[])
{
  bool ok = true;
  {
    WaterTestScene scene;
    vtkOpenGLRenderWindow* window = Current(scene);
    for (size_t size : { 4, 6, 14, 22, 32, 64, 96, 128, 250, 256 })
    {
      for (double period : { 0.0, 60.0 })
      {
        ok &= CheckSlopes(window, size, period);
      }
    }
    ok &= CheckHalf(window);
    ok &= CheckChanges(window);
    ok &= CheckDetours(window);
    ok &= CheckState(window);
  }
  // VTK prints the shader, for one
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  ok &= CheckRefusal<PFNGLSHADERSOURCEPROC>("shader", glShaderSource, shaderSource, ShaderSource);
  ok &= CheckRefusal<PFNGLCHECKFRAMEBUFFERSTATUSPROC>(
    "framebuffer", glCheckFramebufferStatus, checkStatus, CheckStatus);
  unsetenv("VTK_WATER_SOFTWARE");
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
