// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterUncutMesh: a mesh with land that is cut at the shore while it is drawn
// (water_shore_draw.h).
//
// Its cells are those of the solver's mesh, so VTK keeps them on the graphics card. Points far from
// all water lie in one point of it, so that what only looks at points sees the water alone.
#ifndef vtkWaterUncutMesh_h
#define vtkWaterUncutMesh_h

#include "vtkFloatArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkWaterUncutMesh : public vtkPolyData
{
public:
  static vtkWaterUncutMesh* New();
  vtkTypeMacro(vtkWaterUncutMesh, vtkPolyData);

  // One for each point: water_shore_distances.
  void SetDistances(vtkFloatArray* distances) { this->Distances = distances; }
  vtkFloatArray* GetDistances() const { return this->Distances; }

  // Points and polygons as the solver has them, if they are those of this mesh; else nullptr.
  void SetSolvedMesh(vtkPolyData* mesh) { this->SolvedMesh = mesh; }
  vtkPolyData* GetSolvedMesh() const { return this->SolvedMesh; }

  // The z of a point is so many times its level.
  void SetHeightScale(double scale) { this->HeightScale = scale; }
  double GetHeightScale() const { return this->HeightScale; }

  // Has a cell any water?
  bool HasWater(const vtkIdType* points, vtkIdType count) const
  {
    const float* distances = this->Distances->GetPointer(0);
    return std::any_of(
      points, points + count, [distances](vtkIdType point) { return distances[point] > 0.0f; });
  }

  // The bounds of the water, which mappers ask for. After all other changes of the mesh.
  void SetWetBounds(const double bounds[6]);

protected:
  vtkWaterUncutMesh();
  ~vtkWaterUncutMesh() override;

private:
  vtkWaterUncutMesh(const vtkWaterUncutMesh&) = delete;
  void operator=(const vtkWaterUncutMesh&) = delete;

  vtkSmartPointer<vtkFloatArray> Distances;
  vtkSmartPointer<vtkPolyData> SolvedMesh;
  double HeightScale = 1.0;
};
#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_END
#endif

#endif
