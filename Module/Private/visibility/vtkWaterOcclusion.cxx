// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterOcclusion.h"

#include "vtkWaterGL.h"
#include "vtkWaterQueryResult.h"

//------------------------------------------------------------------------------
void vtkWaterOcclusion::Begin(vtkWindow* window)
{
  if (window != this->Window)
  {
    this->Window = window;
    this->Query = 0; // a name of the other context
    this->HasCounted = false;
  }
  GLint current = 0;
  glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &current);
  if (current != 0)
  {
    return; // depth peeling counts, too
  }
  if (this->Query == 0)
  {
    glGenQueries(1, &this->Query);
  }
  glBeginQuery(GL_SAMPLES_PASSED, this->Query);
  this->IsCounting = true;
  this->HasCounted = false;
}

//------------------------------------------------------------------------------
void vtkWaterOcclusion::End()
{
  if (this->IsCounting)
  {
    glEndQuery(GL_SAMPLES_PASSED);
    this->IsCounting = false;
    this->HasCounted = true;
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterOcclusion::GetSamples(vtkWindow* window)
{
  return this->HasCounted && window == this->Window ? vtkWaterQueryResult::Get(this->Query) : -1;
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterOcclusion::WaitForSamples()
{
  return this->HasCounted ? vtkWaterQueryResult::Wait(this->Query) : -1;
}

//------------------------------------------------------------------------------
void vtkWaterOcclusion::ReleaseGraphicsResources()
{
  this->End(); // in the middle of a draw a deleted query would count on
  if (this->Query != 0)
  {
    glDeleteQueries(1, &this->Query);
  }
  this->Query = 0;
  this->HasCounted = this->IsCounting = false;
}
