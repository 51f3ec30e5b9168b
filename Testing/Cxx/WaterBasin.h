// SPDX-License-Identifier: BSD-3-Clause
// WaterBasin.h: a basin around the origin, or a part of it, whose floor is under the water and
// whose rim, from 7 m on, is over it.
#ifndef WaterBasin_h
#define WaterBasin_h

#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

// x, y   the corner of the part
// width  of it, along both axes
// count  of its cells along an axis
inline vtkSmartPointer<vtkPolyData> WaterMakeBasin(double x, double y, double width, int count)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(x, y, 0.0);
  plane->SetPoint1(x + width, y, 0.0);
  plane->SetPoint2(x, y + width, 0.0);
  plane->SetResolution(count, count);
  plane->Update();
  vtkSmartPointer<vtkPolyData> made = plane->GetOutput();
  for (vtkIdType i = 0; i < made->GetNumberOfPoints(); ++i)
  {
    double at[3];
    made->GetPoint(i, at);
    at[2] = 0.016 * (at[0] * at[0] + at[1] * at[1]) - 0.8;
    made->GetPoints()->SetPoint(i, at);
  }
  return made;
}

#endif
