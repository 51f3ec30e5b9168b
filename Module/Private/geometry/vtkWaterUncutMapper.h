// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterUncutMapper: draws a vtkWaterUncutMesh, whose triangles stay on the graphics card from
// step to step.
//
// VTK 9.6 and older list the triangles anew when anything of a mesh has changed, which takes as
// long as a fifth of a plain surface's frame. VTK leaves out triangles whose corners lie in one
// place, as those of dry land do; a list of one step is then wrong in the next, and VTK 9.7 would
// keep it. So the triangles here are those of the solver's mesh.
#ifndef vtkWaterUncutMapper_h
#define vtkWaterUncutMapper_h

#include "vtkOpenGLPolyDataMapper.h"

#include <array>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkWaterUncutMesh;

// Still of VTK's class, for those who ask.
class vtkWaterUncutMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkWaterUncutMapper* New();

  void ReleaseGraphicsResources(vtkWindow* window) override;

  // For tests: how often triangles were listed.
  vtkIdType GetNumberOfLists() const { return this->Lists; }

protected:
  vtkWaterUncutMapper();
  ~vtkWaterUncutMapper() override;

  void BuildIBO(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* mesh) override;

private:
  vtkWaterUncutMapper(const vtkWaterUncutMapper&) = delete;
  void operator=(const vtkWaterUncutMapper&) = delete;

  using Key = std::array<vtkMTimeType, 3>;

  Key Listed{}; // what the triangles on the graphics card are of
  vtkIdType Lists = 0;
};
#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_END
#endif

#endif
