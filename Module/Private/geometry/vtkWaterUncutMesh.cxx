// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterUncutMesh.h"

#include "vtkObjectFactory.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
vtkStandardNewMacro(vtkWaterUncutMesh);

//------------------------------------------------------------------------------
vtkWaterUncutMesh::vtkWaterUncutMesh() = default;

//------------------------------------------------------------------------------
vtkWaterUncutMesh::~vtkWaterUncutMesh() = default;

//------------------------------------------------------------------------------
void vtkWaterUncutMesh::SetWetBounds(const double bounds[6])
{
  std::copy_n(bounds, 6, this->CellsBounds);
  this->CellsBoundsTime.Modified(); // VTK does not walk over all cells then
}
#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_END
#endif
