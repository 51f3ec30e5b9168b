// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterRendererClass: what executes GL in the current context: the CPU, or a GPU. What
// pays on the one may cost on the other.
#ifndef vtkWaterRendererClass_h
#define vtkWaterRendererClass_h

namespace vtkWaterRendererClass
{
// Is GL executed by the CPU? Read from GL_RENDERER, as Mesa's and Google's renderers of that
// kind call themselves. The environment variable VTK_WATER_SOFTWARE (1 or 0) says otherwise.
bool IsSoftware();
}

#endif
