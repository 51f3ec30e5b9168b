// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterPeel.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"
#include "vtkWaterGL.h"
#include "vtkWaterShaderHook.h"

//------------------------------------------------------------------------------
void vtkWaterPeel::BindDepth(vtkOpenGLRenderWindow* window, unsigned int handle)
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglActiveTexture(
    GL_TEXTURE0 + static_cast<unsigned int>(vtkWaterShaderHook::GetPeelUnit(window)));
  glBindTexture(GL_TEXTURE_2D, handle);
  state->vtkglActiveTexture(GL_TEXTURE0);
}

//------------------------------------------------------------------------------
bool vtkWaterPeel::Begin(vtkOpenGLRenderWindow* window, vtkWaterTarget& reflection)
{
  if (!this->Target.EnsureAs(window, reflection, false) || !this->Target.Bind())
  {
    return false;
  }
  this->BindDepth(window, reflection.GetDepth()->GetHandle());
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterPeel::End(vtkOpenGLRenderWindow* window)
{
  this->BindDepth(window, 0);
}
