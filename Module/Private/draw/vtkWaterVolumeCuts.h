// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterVolumeCuts: cuts volumes that the CPU casts at the water while an object of this
// class lives. It hands VTK a finished picture, which no shader can cut; a clipping plane does.
#ifndef vtkWaterVolumeCuts_h
#define vtkWaterVolumeCuts_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkAbstractMapper;
class vtkPlane;
class vtkPlaneCollection;
class vtkProp;
struct water_plan;

class vtkWaterVolumeCuts
{
public:
  vtkWaterVolumeCuts(const water_plan& plan, const std::vector<vtkProp*>& props);
  ~vtkWaterVolumeCuts();
  vtkWaterVolumeCuts(const vtkWaterVolumeCuts&) = delete;
  vtkWaterVolumeCuts& operator=(const vtkWaterVolumeCuts&) = delete;

private:
  struct Cut
  {
    vtkSmartPointer<vtkAbstractMapper> Mapper;
    vtkSmartPointer<vtkPlaneCollection> Planes; // with the water's
    vtkPlaneCollection* Own;                    // the mapper's, which keeps its reference
  };
  void Add(vtkProp* volume);

  vtkNew<vtkPlane> Plane;
  std::vector<Cut> Cuts;
};

#endif
