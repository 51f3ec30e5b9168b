// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterQueryResult.h"

#include "vtkWaterGL.h"

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
