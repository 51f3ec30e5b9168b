// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBoundPicture.h: what is bound for drawing.
#ifndef vtkWaterBoundPicture_h
#define vtkWaterBoundPicture_h

#include "vtkTextureObject.h" // for its formats
#include "vtkWaterGL.h"

struct vtkWaterBoundPicture
{
  vtkWaterBoundPicture()
  {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &this->Framebuffer);
    glGetIntegerv(GL_DRAW_BUFFER, &this->Buffer);
    glGetIntegerv(GL_SAMPLES, &this->Samples);
  }

  int Get(int attachment, GLenum name) const
  {
    GLint value = 0;
    glGetFramebufferAttachmentParameteriv(
      GL_DRAW_FRAMEBUFFER, static_cast<GLenum>(attachment), name, &value);
    return value;
  }

  bool HasDepth() const
  {
    return !this->Framebuffer ||
      this->Get(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE;
  }

  int GetColorType() const
  {
    const GLenum name = GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE;
    const bool isFloat = this->Framebuffer && this->Get(this->Buffer, name) == GL_FLOAT;
    return isFloat ? VTK_FLOAT : VTK_UNSIGNED_CHAR;
  }

  int GetDepthFormat() const
  {
    if (!this->Framebuffer)
    {
      return vtkTextureObject::Fixed24;
    }
    if (this->Get(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT)
    {
      return vtkTextureObject::Float32;
    }
    const int bits = this->Get(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
    return bits == 16 ? vtkTextureObject::Fixed16
                      : (bits == 24 ? vtkTextureObject::Fixed24 : vtkTextureObject::Fixed32);
  }

  // Are colour and depth textures?
  bool HasTextures() const
  {
    const GLenum type = GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE;
    return this->Framebuffer && this->Get(this->Buffer, type) == GL_TEXTURE &&
      this->Get(GL_DEPTH_ATTACHMENT, type) == GL_TEXTURE;
  }
  unsigned int GetColorTexture() const
  {
    return static_cast<unsigned int>(
      this->Get(this->Buffer, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
  }
  unsigned int GetDepthTexture() const
  {
    return static_cast<unsigned int>(
      this->Get(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
  }

  // Do draws go into one colour alone?
  static bool HasOneBuffer()
  {
    GLint count = 1;
    glGetIntegerv(GL_MAX_DRAW_BUFFERS, &count);
    for (GLint i = 1; i < count; ++i)
    {
      GLint buffer = GL_NONE;
      glGetIntegerv(static_cast<GLenum>(GL_DRAW_BUFFER0 + i), &buffer);
      if (buffer != GL_NONE)
      {
        return false;
      }
    }
    return true;
  }

  GLint Framebuffer = 0;
  GLint Buffer = 0;
  GLint Samples = 0; // per pixel; 0: not multisampled
};

#endif
