// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterHorizon.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"
#include "water_horizon.h"
#include "water_plane.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace
{
bool AreEqual(const vtkWaterHorizon::Place& a, const vtkWaterHorizon::Place& b)
{
  return std::memcmp(&a.Eye, &b.Eye, sizeof a.Eye.world_to_view + sizeof a.Eye.view_to_clip) == 0 &&
    a.Eye.parallel == b.Eye.parallel &&
    std::equal(a.Plane.normal, a.Plane.normal + 3, b.Plane.normal) &&
    a.Plane.offset == b.Plane.offset && a.HasKept == b.HasKept &&
    std::equal(a.Kept, a.Kept + 4, b.Kept) && std::equal(a.ToLocal, a.ToLocal + 16, b.ToLocal);
}
}

struct vtkWaterHorizon::Sheet
{
  Sheet();
  void Lay(const Place& place);
  void Add(const double foot[3], const double corner[3]);

  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkCamera> Camera;
  bool IsSecondEye = false;
  vtkNew<vtkPoints> Points; // in double precision: scenes may lie far from the origin
  vtkNew<vtkDoubleArray> Normals;
  vtkNew<vtkPolyData> Data;
  vtkNew<vtkPolyDataMapper> Mapper;
  Place Laid;
  bool IsSeen = false;
};

//------------------------------------------------------------------------------
vtkWaterHorizon::Sheet::Sheet()
{
  this->Points->SetDataTypeToDouble();
  this->Normals->SetNumberOfComponents(3);
  this->Normals->SetName("Normals");
  this->Data->SetPoints(this->Points);
  this->Data->GetPointData()->SetNormals(this->Normals);
  this->Mapper->SetInputData(this->Data);
  this->Mapper->ScalarVisibilityOff();
  if (auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(this->Mapper))
  {
    mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::ALWAYS_AUTO_SHIFT_SCALE);
  }
}

//------------------------------------------------------------------------------
void vtkWaterHorizon::Sheet::Add(const double foot[3], const double corner[3])
{
  const double world[4] = { foot[0] + corner[0], foot[1] + corner[1], foot[2] + corner[2], 1.0 };
  double local[4];
  vtkMatrix4x4::MultiplyPoint(this->Laid.ToLocal, world, local);
  this->Points->InsertNextPoint(local);
}

//------------------------------------------------------------------------------
void vtkWaterHorizon::Sheet::Lay(const Place& place)
{
  if (AreEqual(place, this->Laid))
  {
    return;
  }
  this->Laid = place;
  water_horizon horizon;
  this->IsSeen =
    water_horizon_make(&place.Eye, &place.Plane, place.HasKept ? place.Kept : nullptr, &horizon);
  this->Points->Reset();
  this->Normals->Reset();
  vtkNew<vtkCellArray> cells;
  for (int part = 0; part < WATER_HORIZON_PARTS; ++part)
  {
    const int count = horizon.counts[part];
    if (count > 0)
    {
      cells->InsertNextCell(count);
    }
    for (int i = 0; i < count; ++i)
    {
      cells->InsertCellPoint(this->Points->GetNumberOfPoints());
      this->Add(horizon.foot, horizon.corners[part][i]);
    }
  }
  // Two points of no cell put the middle of all under the eye. Floats count from there
  // (ALWAYS_AUTO_SHIFT_SCALE), so that corners near the eye are as exact as those far away.
  const double* reach = horizon.reach;
  const double back[3] = { -reach[0], -reach[1], -reach[2] };
  this->Add(horizon.foot, reach);
  this->Add(horizon.foot, back);
  water_plane unit = water_plane();
  water_plane_normalise(&place.Plane, &unit);
  for (vtkIdType i = 0; i < this->Points->GetNumberOfPoints(); ++i)
  {
    this->Normals->InsertNextTuple(unit.normal);
  }
  this->Data->SetPolys(cells);
  this->Points->Modified();
  this->Normals->Modified();
  this->Data->Modified();
}

//------------------------------------------------------------------------------
vtkWaterHorizon::vtkWaterHorizon() = default;

//------------------------------------------------------------------------------
vtkWaterHorizon::~vtkWaterHorizon() = default;

//------------------------------------------------------------------------------
vtkWaterHorizon::Sheet& vtkWaterHorizon::Find(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const bool isSecondEye = camera->GetStereo() && !camera->GetLeftEye();
  auto found = std::find_if(this->Sheets.begin(), this->Sheets.end(), [&](const auto& sheet) {
    return sheet->Renderer == renderer && sheet->Camera == camera &&
      sheet->IsSecondEye == isSecondEye;
  });
  if (found == this->Sheets.end())
  {
    // one of an eye that is no more, with its buffers
    found = std::find_if(this->Sheets.begin(), this->Sheets.end(),
      [](const auto& sheet) { return !sheet->Renderer || !sheet->Camera; });
  }
  if (found == this->Sheets.end())
  {
    this->Sheets.push_back(std::make_unique<Sheet>());
    found = std::prev(this->Sheets.end());
  }
  (*found)->Renderer = renderer;
  (*found)->Camera = camera;
  (*found)->IsSecondEye = isSecondEye;
  return **found;
}

//------------------------------------------------------------------------------
vtkPolyDataMapper* vtkWaterHorizon::Lay(vtkRenderer* renderer, const Place& place)
{
  Sheet& sheet = this->Find(renderer);
  sheet.Lay(place);
  return sheet.IsSeen ? sheet.Mapper.Get() : nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterHorizon::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const auto& sheet : this->Sheets)
  {
    sheet->Mapper->ReleaseGraphicsResources(window);
  }
}
