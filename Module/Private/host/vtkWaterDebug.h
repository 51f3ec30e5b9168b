// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterDebug: messages for those who switch an object's debugging on (DebugOn). VTK's own macro
// for them is empty in release builds, which is where drivers are met.
#ifndef vtkWaterDebug_h
#define vtkWaterDebug_h

class vtkObject;

namespace vtkWaterDebug
{
// Returns whether it was said.
bool Say(vtkObject* object, const char* text);
}

#endif
