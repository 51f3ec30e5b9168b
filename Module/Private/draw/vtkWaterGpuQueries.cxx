// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterGpuQueries.h"

#include "vtkOpenGLRenderTimer.h"
#include "vtkWaterDebug.h"
#include "vtkWaterGL.h"
#include "vtkWaterQueryResult.h"

namespace
{
// Drivers of OpenGL 3.2 need not have them, and VTK calls their functions all the same. Some have
// the functions and a clock of no bits.
bool HasTimers()
{
  if (!vtkOpenGLRenderTimer::IsSupported() || !glQueryCounter || !glGetQueryObjectui64v)
  {
    return false;
  }
  GLint bits = 0;
  glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
  return bits > 0;
}
}

//------------------------------------------------------------------------------
vtkWaterGpuQueries::vtkWaterGpuQueries() = default;

//------------------------------------------------------------------------------
vtkWaterGpuQueries::~vtkWaterGpuQueries() = default;

//------------------------------------------------------------------------------
void vtkWaterGpuQueries::Use(vtkWindow* window)
{
  if (window != this->Window)
  {
    this->Window = window;
    this->Triangles = 0; // a name of the other context
    this->HasCounted = false;
  }
}

//------------------------------------------------------------------------------
void vtkWaterGpuQueries::Begin(int part, vtkWindow* window)
{
  this->Use(window);
  this->IsMissing = this->IsOn && !HasTimers();
  if (!this->IsOn || this->IsMissing)
  {
    return;
  }
  this->GetTime(part); // keeps what is there
  this->Timers[part] = std::make_unique<vtkOpenGLRenderTimer>();
  this->Timers[part]->Start();
}

//------------------------------------------------------------------------------
void vtkWaterGpuQueries::End(int part)
{
  if (this->Timers[part] && this->Timers[part]->Started() && !this->Timers[part]->Stopped())
  {
    this->Timers[part]->Stop();
  }
}

//------------------------------------------------------------------------------
double vtkWaterGpuQueries::GetTime(int part)
{
  vtkOpenGLRenderTimer* timer = this->Timers[part].get();
  if (timer && timer->Stopped() && timer->Ready())
  {
    this->Times[part] = static_cast<double>(timer->GetElapsedMilliseconds());
  }
  return this->Times[part];
}

//------------------------------------------------------------------------------
void vtkWaterGpuQueries::SayMissing(vtkObject* told)
{
  if (this->IsMissing && !this->IsSaid)
  {
    this->IsSaid = vtkWaterDebug::Say(told,
      "this driver has no timer queries; times of the GPU stay NaN, and quality by a time budget "
      "stays as it is.");
  }
}

//------------------------------------------------------------------------------
void vtkWaterGpuQueries::BeginCounting(vtkWindow* window)
{
  this->Use(window);
  GLint current = 0;
  glGetQueryiv(GL_PRIMITIVES_GENERATED, GL_CURRENT_QUERY, &current);
  if (!this->IsOn || current != 0)
  {
    return;
  }
  if (this->Triangles == 0)
  {
    glGenQueries(1, &this->Triangles);
  }
  this->Fragments.Begin(window);
  glBeginQuery(GL_PRIMITIVES_GENERATED, this->Triangles);
  this->IsCounting = true;
  this->HasCounted = false;
}

//------------------------------------------------------------------------------
void vtkWaterGpuQueries::EndCounting()
{
  if (this->IsCounting)
  {
    glEndQuery(GL_PRIMITIVES_GENERATED);
    this->Fragments.End();
    this->IsCounting = false;
    this->HasCounted = true;
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterGpuQueries::GetTriangles()
{
  return this->HasCounted ? vtkWaterQueryResult::Wait(this->Triangles) : -1;
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterGpuQueries::GetFragments()
{
  return this->HasCounted ? this->Fragments.WaitForSamples() : -1;
}

//------------------------------------------------------------------------------
void vtkWaterGpuQueries::ReleaseGraphicsResources()
{
  for (auto& timer : this->Timers)
  {
    timer.reset(); // deletes its queries
  }
  this->Fragments.ReleaseGraphicsResources();
  if (this->Triangles != 0)
  {
    glDeleteQueries(1, &this->Triangles);
  }
  this->Triangles = 0;
  this->HasCounted = this->IsCounting = false;
}
