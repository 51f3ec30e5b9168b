// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterDebug.h"

#include "vtkObject.h"

#include <string>

//------------------------------------------------------------------------------
bool vtkWaterDebug::Say(vtkObject* object, const char* text)
{
  if (!object->GetDebug() || !vtkObject::GetGlobalWarningDisplay())
  {
    return false;
  }
  const std::string message = std::string(object->GetClassName()) + ": " + text;
  vtkOutputWindowDisplayDebugText(__FILE__, __LINE__, message.c_str(), object);
  return true;
}
