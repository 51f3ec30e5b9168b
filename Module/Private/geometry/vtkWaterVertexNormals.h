// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterVertexNormals: smooth normals of a mesh of polygons, one per point.
//
// They are those of vtkPolyDataNormals without splitting and without reordering: the mean direction
// of the unit normals of the polygons at a point. That filter needs half of the time that a step of
// a large mesh takes, because it lists the cells of each point first.
#ifndef vtkWaterVertexNormals_h
#define vtkWaterVertexNormals_h

#include "vtkSmartPointer.h"
#include "vtkWaterKept.h"

class vtkPolyData;
struct vtkWaterCellBlocks;
struct vtkWaterShoreCells;

// (0, 0, 0) at points without a polygon that has an area.
//
// shore  polygons without water are left out; nullptr: there are none
// kept   the array is of these; nullptr: it is new
// blocks of the mesh's cells, if they are known: several threads are faster then
vtkSmartPointer<vtkFloatArray> vtkWaterVertexNormals(vtkPolyData* mesh,
  const vtkWaterShoreCells* shore = nullptr, vtkWaterKept<vtkFloatArray>* kept = nullptr,
  const vtkWaterCellBlocks* blocks = nullptr);

#endif
