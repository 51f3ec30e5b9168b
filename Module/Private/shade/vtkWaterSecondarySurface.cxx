// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSecondarySurface.h"

#include "vtkPolyDataMapper.h"

#include <cstring>

namespace
{
// VTK 9.1 warns of deprecated shader code whenever vtkOpenGLPolyDataMapper copies itself, which
// only adds to its superclass what a selection needs.
void Copy(vtkMapper* from, vtkMapper* to)
{
  if (std::strcmp(from->GetClassName(), "vtkOpenGLPolyDataMapper") == 0)
  {
    static_cast<vtkPolyDataMapper*>(to)->vtkPolyDataMapper::ShallowCopy(from);
  }
  else
  {
    to->ShallowCopy(from);
  }
  if (from->GetNumberOfInputConnections(0) > 0) // a vtkDataSetMapper does not copy it
  {
    to->SetInputConnection(from->GetInputConnection(0, 0));
  }
}
}

//------------------------------------------------------------------------------
vtkMapper* vtkWaterSecondarySurface::Follow(vtkMapper* own)
{
  if (this->Own != own)
  {
    this->Own = own;
    this->OwnTime = 0;
    this->Mapper.TakeReference(own->NewInstance());
  }
  if (this->OwnTime != own->GetMTime())
  {
    Copy(own, this->Mapper);
    this->OwnTime = own->GetMTime();
  }
  return this->Mapper;
}

//------------------------------------------------------------------------------
void vtkWaterSecondarySurface::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Surface.ReleaseGraphicsResources(window);
  if (this->Mapper)
  {
    this->Mapper->ReleaseGraphicsResources(window);
  }
}
