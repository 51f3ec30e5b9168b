// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSceneDepth.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureUnitManager.h"
#include "vtkWaterGL.h"

//------------------------------------------------------------------------------
void vtkWaterSceneDepth::Find(vtkOpenGLState* state)
{
  this->Texture = 0;
  GLint framebuffer = 0;
  GLint samples = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  glGetIntegerv(GL_SAMPLES, &samples);
  if (framebuffer == 0 || samples > 0)
  {
    return;
  }
  GLint type = GL_NONE;
  GLint name = 0;
  glGetFramebufferAttachmentParameteriv(
    GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
  if (type == GL_TEXTURE)
  {
    glGetFramebufferAttachmentParameteriv(
      GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &name);
  }
  this->Texture = static_cast<unsigned int>(name);
  state->vtkglGetIntegerv(GL_VIEWPORT, this->Viewport);
}

//------------------------------------------------------------------------------
int vtkWaterSceneDepth::Activate(vtkOpenGLRenderWindow* window)
{
  this->Window = window;
  this->Unit = window->GetState()->GetTextureUnitManager()->Allocate();
  window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
  glBindTexture(GL_TEXTURE_2D, this->Texture);
  // whatever it was made with: a texture without all of its levels reads as 0
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  return this->Unit;
}

//------------------------------------------------------------------------------
void vtkWaterSceneDepth::Deactivate()
{
  this->Window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
  glBindTexture(GL_TEXTURE_2D, 0);
  this->Window->GetState()->GetTextureUnitManager()->Free(this->Unit);
  this->Unit = -1;
}
