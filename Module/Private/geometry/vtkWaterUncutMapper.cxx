// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterUncutMapper.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkWaterPolygons.h"
#include "vtkWaterUncutMesh.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
vtkStandardNewMacro(vtkWaterUncutMapper);

//------------------------------------------------------------------------------
vtkWaterUncutMapper::vtkWaterUncutMapper() = default;

//------------------------------------------------------------------------------
vtkWaterUncutMapper::~vtkWaterUncutMapper() = default;

//------------------------------------------------------------------------------
void vtkWaterUncutMapper::BuildIBO(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* mesh)
{
  auto* uncut = vtkWaterUncutMesh::SafeDownCast(mesh);
  vtkPolyData* solved = uncut ? uncut->GetSolvedMesh() : nullptr;
  vtkProperty* property = actor->GetProperty();
  const bool isPlain = property->GetRepresentation() == VTK_SURFACE &&
    !property->GetEdgeVisibility() && !property->GetVertexVisibility() &&
    !mesh->GetPointData()->GetAttribute(vtkDataSetAttributes::EDGEFLAG);
  // values of cells are found by the number of a triangle, in VTK's own list
  if (!solved || !isPlain || this->HaveCellScalars || this->HaveCellNormals)
  {
    if (this->Listed != Key())
    {
      this->IBOBuildState.Clear(); // it does not tell the two lists apart
    }
    this->Listed = Key();
    this->vtkOpenGLPolyDataMapper::BuildIBO(renderer, actor, mesh);
    return;
  }
  vtkCellArray* cells = solved->GetPolys();
  const Key now = { reinterpret_cast<vtkMTimeType>(cells), vtkWaterCellsTime(cells),
    solved->GetPoints()->GetMTime() };
  if (now == this->Listed)
  {
    return;
  }
  this->IBOBuildState.Clear(); // other points may have made triangles of what was a line
  this->vtkOpenGLPolyDataMapper::BuildIBO(renderer, actor, solved);
  this->Listed = now;
  ++this->Lists;
}

//------------------------------------------------------------------------------
void vtkWaterUncutMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Listed = Key();
  this->vtkOpenGLPolyDataMapper::ReleaseGraphicsResources(window);
}
#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_END
#endif
