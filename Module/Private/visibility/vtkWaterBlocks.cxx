// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterBlocks.h"

#include "vtkActor.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPolyData.h"
#include "vtkWaterAccess.h"
#include "vtkWaterAccessBlocks.h"
#include "vtkWaterMeshTraits.h"

#include <new>

//------------------------------------------------------------------------------
vtkWaterBlocks::~vtkWaterBlocks()
{
  this->TakeBack();
}

//------------------------------------------------------------------------------
void vtkWaterBlocks::Hide(const water_plan& plan, vtkAbstractMapper* anyMapper, vtkProp* prop)
{
  this->TakeBack(); // of other primitives, or another part of an assembly
  // asked of every prop: what tells most is asked first
  vtkOpenGLPolyDataMapper* mapper = vtkWaterMeshTraits::AsBlocksMapper(anyMapper);
  auto* actor = mapper ? vtkActor::SafeDownCast(prop) : nullptr;
  if (!actor || !vtkWaterAccess::PolyDataMapper::AreTrianglesNext(mapper) ||
    !vtkWaterMeshTraits::CanLeaveBlocksOut(mapper, actor))
  {
    return;
  }
  double origin[3];
  double scale[3];
  vtkWaterMeshTraits::ReadShiftAndScale(mapper, origin, scale);
  water_clusters_view view;
  water_clusters_view_make(
    &plan, &this->Target, 0, 1, false, &actor->GetMatrix()->Element[0][0], origin, &view);
  this->Mapper = mapper;
  bool areAllDrawn = false;
  try
  {
    vtkWaterAccess::BlocksMapper::ForEach(
      mapper, [&](vtkPolyData* data, bool& isVisible, bool hasTexture) {
        areAllDrawn = areAllDrawn || hasTexture;
        if (isVisible && water_clusters_place(&view, data->GetBounds()) == WATER_BOX_OUTSIDE)
        {
          this->Hidden.push_back(data); // first: it may throw
          isVisible = false;
        }
      });
  }
  catch (const std::bad_alloc&)
  {
    areAllDrawn = true;
  }
  if (areAllDrawn)
  {
    this->TakeBack();
  }
}

//------------------------------------------------------------------------------
void vtkWaterBlocks::TakeBack()
{
  if (!this->Hidden.empty())
  {
    // in the mapper's order; a block that is gone is passed over
    auto next = this->Hidden.begin();
    vtkWaterAccess::BlocksMapper::ForEach(
      this->Mapper, [&](vtkPolyData* data, bool& isVisible, bool) {
        if (next != this->Hidden.end() && *next == data)
        {
          isVisible = true;
          ++next;
        }
      });
    this->Hidden.clear();
  }
  this->Mapper = nullptr;
}
