// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterRendererClass.h"

#include "vtkWaterGL.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>

//------------------------------------------------------------------------------
bool vtkWaterRendererClass::IsSoftware()
{
  if (const char* said = std::getenv("VTK_WATER_SOFTWARE"))
  {
    return std::strcmp(said, "1") == 0;
  }
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::array<const char*, 3> names = { "llvmpipe", "softpipe", "SwiftShader" };
  return renderer && std::any_of(names.begin(), names.end(), [renderer](const char* name) {
    return std::strstr(renderer, name) != nullptr;
  });
}
