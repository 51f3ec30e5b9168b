// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFramebuffers.h: what is asked of framebuffers.
#ifndef vtkWaterFramebuffers_h
#define vtkWaterFramebuffers_h

#include "vtkOpenGLFramebufferObject.h"

namespace vtkWaterFramebuffers
{
// Is the framebuffer that is bound complete?
inline bool IsComplete()
{
  const char* reason = nullptr;
  return vtkOpenGLFramebufferObject::GetFrameBufferStatus(
           vtkOpenGLFramebufferObject::GetBothMode(), reason) != 0;
}
}

#endif
