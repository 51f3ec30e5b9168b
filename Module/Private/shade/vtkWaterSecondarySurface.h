// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSecondarySurface: what draws a water in the
// mirrored views of others: a surface and a mapper of its own, so that neither its shader nor what
// is kept for its own picture changes twice a frame.
#ifndef vtkWaterSecondarySurface_h
#define vtkWaterSecondarySurface_h

#include "vtkMapper.h"
#include "vtkSmartPointer.h"
#include "vtkWaterSurfaceShader.h"

class vtkWaterSecondarySurface
{
public:
  vtkWaterSurfaceShader Surface;

  // A mapper that draws what the water's own does, at rest.
  vtkMapper* Follow(vtkMapper* own);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkSmartPointer<vtkMapper> Mapper;
  vtkSmartPointer<vtkMapper> Own; // that it follows
  vtkMTimeType OwnTime = 0;
};

#endif
