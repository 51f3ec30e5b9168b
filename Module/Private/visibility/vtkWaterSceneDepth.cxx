// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSceneDepth.h"

#include "vtkOpenGLState.h"
#include "vtkWaterGL.h"

//------------------------------------------------------------------------------
void vtkWaterSceneDepth::Find(vtkOpenGLState* state)
{
  this->HasDepths = false;
  GLint framebuffer = 0;
  GLint samples = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  glGetIntegerv(GL_SAMPLES, &samples);
  if (framebuffer == 0 || samples > 0)
  {
    return;
  }
  GLint type = GL_NONE;
  glGetFramebufferAttachmentParameteriv(
    GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
  this->HasDepths = type == GL_TEXTURE;
  state->vtkglGetIntegerv(GL_VIEWPORT, this->Viewport);
}
