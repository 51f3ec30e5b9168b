// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterGrid.h"

#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <algorithm>

namespace
{
bool AreEqual(const vtkWaterGrid::Place& a, const vtkWaterGrid::Place& b)
{
  // a view follows from these three
  return std::equal(a.View.dir_to_clip, a.View.dir_to_clip + 12, b.View.dir_to_clip) &&
    std::equal(a.View.foot_clip, a.View.foot_clip + 4, b.View.foot_clip) &&
    std::equal(a.View.axes.x_dir, a.View.axes.x_dir + 3, b.View.axes.x_dir) &&
    std::equal(a.View.axes.y_dir, a.View.axes.y_dir + 3, b.View.axes.y_dir) &&
    std::equal(a.View.axes.origin, a.View.axes.origin + 3, b.View.axes.origin) &&
    std::equal(a.View.origin_xy, a.View.origin_xy + 2, b.View.origin_xy) &&
    std::equal(a.Sheet, a.Sheet + 4, b.Sheet) && a.IsEndless == b.IsEndless &&
    a.Height == b.Height && a.Reach == b.Reach && a.Size == b.Size;
}
}

//------------------------------------------------------------------------------
vtkWaterGrid::vtkWaterGrid()
{
  this->Points->SetDataTypeToDouble();
  this->Cells->SetNumberOfComponents(2);
  this->Cells->SetName("waterCell");
  this->Grid->SetPoints(this->Points);
  this->Grid->GetPointData()->AddArray(this->Cells);
  this->Mapper->SetInputData(this->Grid);
  this->Mapper->ScalarVisibilityOff();
  // the points come anew with every view, and are exact near it
  if (auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(this->Mapper))
  {
    mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::ALWAYS_AUTO_SHIFT_SCALE);
  }
  this->Mapper->MapDataArrayToVertexAttribute(
    "waterCell", "waterCell", vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
}

//------------------------------------------------------------------------------
vtkWaterGrid::~vtkWaterGrid() = default;

//------------------------------------------------------------------------------
vtkPolyDataMapper* vtkWaterGrid::GetMapper()
{
  return this->Mapper;
}

//------------------------------------------------------------------------------
void vtkWaterGrid::Resize(int size)
{
  const vtkIdType side = size + 1;
  vtkNew<vtkCellArray> quads;
  quads->AllocateExact(
    static_cast<vtkIdType>(size) * size, 4 * static_cast<vtkIdType>(size) * size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    for (vtkIdType j = 0; j < size; ++j)
    {
      // rows follow each other at right angles to the left of a row's points: counter-clockwise
      const vtkIdType first = i * side + j;
      const vtkIdType quad[4] = { first, first + side, first + side + 1, first + 1 };
      quads->InsertNextCell(4, quad);
    }
  }
  this->Grid->SetPolys(quads);
}

//------------------------------------------------------------------------------
void vtkWaterGrid::Lay(const Place& place)
{
  if (AreEqual(place, this->Laid))
  {
    return;
  }
  if (place.Size != this->Laid.Size)
  {
    this->Resize(place.Size);
  }
  // two points without a cell put the centre of the points under the eye, where floats are exact:
  // an endless grid reaches a million times as far as the nearest points
  const vtkIdType laid = static_cast<vtkIdType>(place.Size + 1) * (place.Size + 1);
  const vtkIdType more = place.IsEndless ? 2 : 0;
  this->Points->SetNumberOfPoints(laid + more);
  this->Cells->SetNumberOfTuples(laid + more);
  this->Laid = place;
  auto* points = vtkDoubleArray::SafeDownCast(this->Points->GetData())->GetPointer(0);
  if (!water_grid_lay(&place.View, place.IsEndless ? nullptr : place.Sheet, place.Height,
        place.Reach, place.Size, points, this->Cells->GetPointer(0), this->RowDir))
  {
    std::fill(points, points + this->Points->GetData()->GetNumberOfValues(), 0.0); // shows nothing
  }
  for (vtkIdType i = 0; i < more; ++i)
  {
    this->Cells->SetTuple2(laid + i, 0.0, 0.0);
    water_grid_balance(
      &place.View, points, static_cast<size_t>(laid), i == 0 ? 1.0 : -1.0, points + 3 * (laid + i));
  }
  this->Points->GetData()->Modified();
  this->Points->Modified();
  this->Cells->Modified();
  this->Grid->Modified();
}
