// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPasses: the chain of passes that a user has given to a renderer.
#ifndef vtkWaterPasses_h
#define vtkWaterPasses_h

#include <functional>

class vtkRenderPass;

namespace vtkWaterPasses
{
// Calls back for each pass of a chain once, as far as VTK's own passes lead; until the function
// returns true.
void Visit(vtkRenderPass* first, const std::function<bool(vtkRenderPass*)>& function);

// May a pass of a chain draw into colours of more than 8 bits, as a tone mapping does? Of passes
// that nobody knows it is said.
bool MayKeepFloats(vtkRenderPass* first);

// What a vtkWaterReflectionPass renders after the reflections; defined by that class.
vtkRenderPass* DelegateOf(vtkRenderPass* waterPass);
}

#endif
