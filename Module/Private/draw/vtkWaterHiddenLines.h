// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHiddenLines: opaque props as vtkHiddenLineRemovalPass draws them, which is not told what
// is known of each: wireframes last, and before that as surfaces into the depths alone.
#ifndef vtkWaterHiddenLines_h
#define vtkWaterHiddenLines_h

#include <cstddef>
#include <functional>
#include <vector>

class vtkProp;
class vtkRenderer;

namespace vtkWaterHiddenLines
{
// Does the renderer remove hidden lines? A pass of the user's does not.
bool AreRemoved(vtkRenderer* renderer);

// Draws all props, by their numbers; wireframes twice.
void Draw(vtkRenderer* renderer, const std::vector<vtkProp*>& props,
  const std::function<void(size_t)>& draw);
}

#endif
