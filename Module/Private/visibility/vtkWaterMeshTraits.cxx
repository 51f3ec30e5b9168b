// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterMeshTraits.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkDataSetMapper.h"
#include "vtkImageData.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkWaterAccess.h"
#include "vtkWaterAccessBlocks.h"
#include "vtkWaterProps.h"

#include <algorithm>
#include <cstring>

namespace
{
bool HasAlpha(vtkTexture* texture)
{
  vtkImageData* image = texture->GetInput();
  return !image || image->GetScalarType() != VTK_UNSIGNED_CHAR ||
    image->GetNumberOfScalarComponents() != 3 ||
    texture->GetColorMode() == VTK_COLOR_MODE_MAP_SCALARS; // its table may have holes
}
}

//------------------------------------------------------------------------------
vtkOpenGLPolyDataMapper* vtkWaterMeshTraits::AsPolyDataMapper(vtkAbstractMapper* mapper)
{
  return mapper && std::strcmp(mapper->GetClassName(), "vtkOpenGLPolyDataMapper") == 0
    ? static_cast<vtkOpenGLPolyDataMapper*>(mapper)
    : nullptr;
}

//------------------------------------------------------------------------------
vtkOpenGLPolyDataMapper* vtkWaterMeshTraits::AsBlocksMapper(vtkAbstractMapper* mapper)
{
  return mapper &&
      std::strcmp(mapper->GetClassName(), vtkWaterAccess::BlocksMapper::ClassName()) == 0
    ? static_cast<vtkOpenGLPolyDataMapper*>(mapper)
    : nullptr;
}

//------------------------------------------------------------------------------
bool vtkWaterMeshTraits::HasOwnShaders(vtkAbstractMapper* mapper, vtkActor* actor)
{
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  return shaders->GetNumberOfShaderReplacements() > 0 || shaders->HasVertexShaderCode() ||
    shaders->HasGeometryShaderCode() || mapper->HasObserver(vtkCommand::UpdateShaderEvent);
}

//------------------------------------------------------------------------------
bool vtkWaterMeshTraits::IsDrawnAsItIs(vtkMapper* mapper, vtkActor* actor)
{
  return mapper && (AsPolyDataMapper(mapper) || vtkDataSetMapper::SafeDownCast(mapper)) &&
    !HasOwnShaders(mapper, actor);
}

//------------------------------------------------------------------------------
void vtkWaterMeshTraits::ReadShiftAndScale(
  vtkAbstractMapper* mapper, double shift[3], double scale[3])
{
  std::fill_n(shift, 3, 0.0);
  std::fill_n(scale, 3, 1.0);
  vtkOpenGLPolyDataMapper* ofMesh = AsPolyDataMapper(mapper);
  ofMesh = ofMesh ? ofMesh : AsBlocksMapper(mapper);
  vtkOpenGLVertexBufferObject* vertices =
    ofMesh ? vtkWaterAccess::PolyDataMapper::VerticesOf(ofMesh) : nullptr;
  if (vertices && vertices->GetCoordShiftAndScaleEnabled() && vertices->GetShift().size() == 3 &&
    vertices->GetScale().size() == 3)
  {
    std::copy_n(vertices->GetShift().begin(), 3, shift);
    std::copy_n(vertices->GetScale().begin(), 3, scale);
  }
}

//------------------------------------------------------------------------------
bool vtkWaterMeshTraits::CanBeCut(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkActor* actor)
{
  return actor && AsPolyDataMapper(mapper) && vtkWaterProps::IsInWorld(actor) &&
    actor->GetProperty()->GetRepresentation() == VTK_SURFACE &&
    !actor->IsRenderingTranslucentPolygonalGeometry() &&
    !program->IsUniformUsed("PrimitiveIDOffset") && !HasOwnShaders(mapper, actor);
}

//------------------------------------------------------------------------------
bool vtkWaterMeshTraits::CanLeaveBlocksOut(vtkOpenGLPolyDataMapper* blocks, vtkActor* actor)
{
  vtkMapper* parent = vtkWaterAccess::BlocksMapper::ParentOf(blocks); // has the user's observers
  return parent && vtkWaterProps::IsInWorld(actor) &&
    actor->GetProperty()->GetRepresentation() == VTK_SURFACE &&
    !actor->GetProperty()->GetEdgeVisibility() && // wide edges reach beyond their triangles
    !actor->IsRenderingTranslucentPolygonalGeometry() && !HasOwnShaders(parent, actor) &&
    !HasOwnShaders(blocks, actor);
}

//------------------------------------------------------------------------------
bool vtkWaterMeshTraits::HasOwnDepths(vtkMapper* mapper, vtkActor* actor)
{
  const int resolution = vtkMapper::GetResolveCoincidentTopology();
  double factor = 0.0;
  double units = 0.0;
  if (resolution == VTK_RESOLVE_POLYGON_OFFSET || actor->GetProperty()->GetEdgeVisibility())
  {
    mapper->GetCoincidentTopologyPolygonOffsetParameters(factor, units);
  }
  else if (resolution == VTK_RESOLVE_SHIFT_ZBUFFER)
  {
    units = vtkMapper::GetResolveCoincidentTopologyZShift();
  }
  return factor != 0.0 || units != 0.0 || actor->GetShaderProperty()->HasFragmentShaderCode();
}

//------------------------------------------------------------------------------
bool vtkWaterMeshTraits::IsOpaqueEverywhere(vtkActor* actor)
{
  if (actor->GetForceOpaque() || actor->GetBackfaceProperty() ||
    actor->HasTranslucentPolygonalGeometry() ||
    (actor->GetTexture() && HasAlpha(actor->GetTexture())))
  {
    return false;
  }
  const auto& textures = actor->GetProperty()->GetAllTextures();
  return std::none_of(textures.begin(), textures.end(),
    [](const std::pair<const std::string, vtkTexture*>& named) { return HasAlpha(named.second); });
}

//------------------------------------------------------------------------------
bool vtkWaterMeshTraits::IsSolid(vtkPolyDataMapper* mapper, vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  return IsOpaqueEverywhere(actor) && !property->GetBackfaceCulling() &&
    !property->GetFrontfaceCulling() && mapper->GetNumberOfClippingPlanes() == 0;
}

//------------------------------------------------------------------------------
bool vtkWaterMeshTraits::ShowsScalars(vtkAbstractMapper* mapper)
{
  auto* shown = vtkMapper::SafeDownCast(mapper);
  vtkDataSet* data = shown && shown->GetScalarVisibility() ? shown->GetInput() : nullptr;
  int isOfCells = 0;
  return data &&
    vtkAbstractMapper::GetAbstractScalars(data, shown->GetScalarMode(), shown->GetArrayAccessMode(),
      shown->GetArrayId(), shown->GetArrayName(), isOfCells) != nullptr;
}

//------------------------------------------------------------------------------
vtkPolyData* vtkWaterMeshTraits::FindPolygons(vtkMapper* mapper)
{
  auto* ofData = vtkDataSetMapper::SafeDownCast(mapper);
  if (ofData && vtkPolyData::SafeDownCast(ofData->GetInput()))
  {
    return static_cast<vtkPolyData*>(ofData->GetInput()); // it is drawn as it is
  }
  vtkPolyDataMapper* drawn =
    AsPolyDataMapper(ofData ? static_cast<vtkMapper*>(ofData->GetPolyDataMapper()) : mapper);
  return drawn ? drawn->GetInput() : nullptr;
}

//------------------------------------------------------------------------------
bool vtkWaterMeshTraits::HasTrianglesOnly(
  vtkPolyData* mesh, vtkMapper* mapper, vtkProperty* property)
{
  return mesh && mesh->GetNumberOfVerts() == 0 && mesh->GetNumberOfLines() == 0 &&
    mesh->GetNumberOfStrips() == 0 && !mapper->GetSelection() && !property->GetVertexVisibility() &&
    !property->GetEdgeVisibility();
}

//------------------------------------------------------------------------------
bool vtkWaterMeshTraits::HasTrianglesOnly(vtkPolyDataMapper* mapper, vtkProperty* property)
{
  return HasTrianglesOnly(mapper->GetInput(), mapper, property);
}
