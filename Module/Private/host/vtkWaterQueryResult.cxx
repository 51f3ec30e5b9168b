// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterQueryResult.h"

#include "vtkWaterGL.h"

#include <algorithm>
#include <array>

namespace
{
constexpr GLuint64 kPatience_ns = 1000000000;
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterQueryResult::Get(unsigned int query)
{
  GLuint isReady = 0;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &isReady);
  if (isReady == 0)
  {
    return -1;
  }
  GLuint count = 0;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
  return static_cast<vtkIdType>(count);
}

//------------------------------------------------------------------------------
bool vtkWaterQueryResult::IsAnyAwaited()
{
  const std::array<GLenum, 3> targets = { GL_SAMPLES_PASSED, GL_PRIMITIVES_GENERATED,
    GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN };
  return std::any_of(targets.begin(), targets.end(), [](GLenum target) {
    GLint current = 0;
    glGetQueryiv(target, GL_CURRENT_QUERY, &current);
    return current != 0;
  });
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterQueryResult::Wait(unsigned int query)
{
  const vtkIdType known = Get(query);
  GLsync fence = known < 0 ? glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0) : nullptr;
  if (!fence)
  {
    return known;
  }
  glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, kPatience_ns);
  glDeleteSync(fence);
  return Get(query);
}
