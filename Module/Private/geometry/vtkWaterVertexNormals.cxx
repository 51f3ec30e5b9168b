// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterVertexNormals.h"

#include "vtkFloatArray.h"
#include "vtkPolyData.h"
#include "vtkWaterPolygons.h"
#include "vtkWaterShoreCells.h"
#include "water_polygon.h"

#include <algorithm>
#include <vector>

//------------------------------------------------------------------------------
vtkSmartPointer<vtkFloatArray> vtkWaterVertexNormals(
  vtkPolyData* mesh, const vtkWaterShoreCells* shore)
{
  const auto isLand = [shore](vtkIdType cell) {
    return shore && shore->Kinds[static_cast<size_t>(cell)] == vtkWaterShoreCells::Dry;
  };
  const vtkIdType count = mesh->GetNumberOfPoints();
  const auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  normals->Fill(0.0);
  float* all = normals->GetPointer(0);
  const vtkWaterPlaces places(mesh->GetPoints());
  vtkCellArray* cells = mesh->GetPolys();
  std::vector<float> ofCells(3 * static_cast<size_t>(cells->GetNumberOfCells()));
  vtkWaterForBlocks(cells->GetNumberOfCells(), [&](vtkIdType, vtkIdType begin, vtkIdType end) {
    std::vector<double> corners;
    vtkWaterForCells(
      cells, begin, end, [&](vtkIdType cell, const vtkIdType* points, vtkIdType cornerCount) {
        if (isLand(cell))
        {
          return;
        }
        corners.resize(3 * static_cast<size_t>(cornerCount));
        for (vtkIdType i = 0; i < cornerCount; ++i)
        {
          places.Get(points[i], &corners[3 * static_cast<size_t>(i)]);
        }
        double normal[3];
        water_polygon_normal(corners.data(), static_cast<size_t>(cornerCount), normal);
        std::copy_n(normal, 3, &ofCells[3 * static_cast<size_t>(cell)]);
      });
  });
  vtkWaterForEachCell(cells, [&](vtkIdType cell, const vtkIdType* points, vtkIdType cornerCount) {
    if (isLand(cell))
    {
      return;
    }
    const float* normal = &ofCells[3 * static_cast<size_t>(cell)];
    for (vtkIdType i = 0; i < cornerCount; ++i)
    {
      float* sum = all + 3 * points[i];
      sum[0] += normal[0];
      sum[1] += normal[1];
      sum[2] += normal[2];
    }
  });
  vtkSMPTools::For(0, count, [all](vtkIdType begin, vtkIdType end) {
    water_polygon_unit_normals(all + 3 * begin, static_cast<size_t>(end - begin));
  });
  return normals;
}
