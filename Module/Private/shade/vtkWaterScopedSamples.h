// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterScopedSamples.h: reading multisampled textures, overwriting colour and depth, and drawing
// into one sample of each pixel.
#ifndef vtkWaterScopedSamples_h
#define vtkWaterScopedSamples_h

#include "vtkOpenGLState.h"
#include "vtkWaterGL.h"
#include "vtkWaterScopedPlainDraws.h"

// Draws overwrite depth, too, while an object of this class lives, in a part of a framebuffer.
struct vtkWaterScopedOverwrite
{
  vtkWaterScopedOverwrite(vtkOpenGLState* state, const int part[4])
    : Plain(state)
    , DepthMask(state)
    , DepthFunc(state)
  {
    state->vtkglEnable(GL_DEPTH_TEST); // without it no depth is written
    state->vtkglDepthFunc(GL_ALWAYS);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglViewport(part[0], part[1], part[2], part[3]);
  }

  vtkWaterScopedPlainDraws Plain;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunc;
};

// Multisampled textures are bound to the first units while an object of this class lives: a target
// of its own there, which VTK's textures do not have.
struct vtkWaterScopedSamples
{
  vtkWaterScopedSamples(vtkOpenGLState* state, unsigned int color, unsigned int depth)
    : State(state)
    , Active(state)
  {
    this->Bind(color, depth);
  }
  ~vtkWaterScopedSamples() { this->Bind(0, 0); }

  void Bind(unsigned int color, unsigned int depth)
  {
    this->State->vtkglActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, depth);
    this->State->vtkglActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, color);
  }

  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglActiveTexture Active;
};

// Draws change one sample of each pixel, which glSampleMaski chooses, while an object of this class
// lives.
struct vtkWaterScopedSampleMask
{
  explicit vtkWaterScopedSampleMask(vtkOpenGLState* state)
    : Multisample(state, GL_MULTISAMPLE)
  {
    state->vtkglEnable(GL_MULTISAMPLE); // without it all samples are changed
    glEnable(GL_SAMPLE_MASK);           // VTK does not keep track of it
  }
  ~vtkWaterScopedSampleMask()
  {
    glSampleMaski(0, ~0u);
    glDisable(GL_SAMPLE_MASK);
  }

  vtkOpenGLState::ScopedglEnableDisable Multisample;
};

#endif
