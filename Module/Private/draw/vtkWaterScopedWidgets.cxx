// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterScopedWidgets.h"

#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkWaterAccess.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace
{
bool IsOfWidget(vtkProp* prop)
{
  return std::strcmp(prop->GetClassName(), "vtkOpenGLActor") != 0 && // the most frequent one
    prop->IsA("vtkWidgetRepresentation");
}
}

//------------------------------------------------------------------------------
vtkWaterScopedWidgets::vtkWaterScopedWidgets(vtkRenderer* renderer, vtkProp* prop)
{
  if (IsOfWidget(prop))
  {
    this->Begin(renderer);
  }
}

//------------------------------------------------------------------------------
vtkWaterScopedWidgets::vtkWaterScopedWidgets(
  vtkRenderer* renderer, const std::vector<vtkProp*>& props)
{
  if (std::any_of(props.begin(), props.end(), IsOfWidget))
  {
    this->Begin(renderer);
  }
}

//------------------------------------------------------------------------------
vtkWaterScopedWidgets::~vtkWaterScopedWidgets()
{
  if (this->Camera)
  {
    vtkWaterAccess::Object::TimeOf(this->Camera) = this->Time;
  }
}

//------------------------------------------------------------------------------
void vtkWaterScopedWidgets::Begin(vtkRenderer* renderer)
{
  auto* camera = static_cast<vtkOpenGLCamera*>(renderer->GetActiveCamera());
  vtkMatrix4x4* unused[3];
  vtkMatrix3x3* normals = nullptr;
  camera->GetKeyMatrices(renderer, unused[0], normals, unused[1], unused[2]); // while it is newer
  this->Camera = camera;
  this->Time = std::exchange(vtkWaterAccess::Object::TimeOf(camera), vtkTimeStamp());
}
