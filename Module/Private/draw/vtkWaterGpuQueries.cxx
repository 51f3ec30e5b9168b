// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterGpuQueries.h"

#include "vtkOpenGLRenderTimer.h"
#include "vtkWaterGL.h"

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
  if (!this->IsOn || !vtkOpenGLRenderTimer::IsSupported())
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
    this->Times[part] = timer->GetElapsedMilliseconds();
  }
  return this->Times[part];
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
  if (!this->HasCounted)
  {
    return -1;
  }
  GLuint count = 0;
  glGetQueryObjectuiv(this->Triangles, GL_QUERY_RESULT, &count);
  return static_cast<vtkIdType>(count);
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
