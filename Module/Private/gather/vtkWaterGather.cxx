// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterGather.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkWaterActor.h"
#include "vtkWaterProperty.h"
#include "water_optics.h"
#include "water_plane.h"
#include "water_waves.h"

#include <algorithm>
#include <functional>

namespace
{
// May VTK draw a water nearer to the eye than it is, before things that are in front of it? It does
// with what resolves coincident topology by offsets of less than 0, as those of its lines and
// points are by default; and nobody knows where the user's own shaders put it.
bool MayBePulled(vtkWaterActor* water)
{
  vtkShaderProperty* shaders = water->GetShaderProperty();
  const bool hasOwnShaders = shaders->GetNumberOfShaderReplacements() > 0 ||
    shaders->HasVertexShaderCode() || shaders->HasGeometryShaderCode() ||
    shaders->HasFragmentShaderCode();
  vtkProperty* property = water->GetProperty();
  const bool isSurface = property->GetRepresentation() == VTK_SURFACE;
  const int resolution = vtkMapper::GetResolveCoincidentTopology();
  double factor = 0.0;
  double units = 0.0;
  water->GetMapper()->GetCoincidentTopologyPolygonOffsetParameters(factor, units);
  const bool isPulled = !isSurface || !(factor >= 0.0) || !(units >= 0.0);
  const bool hasOffsets = resolution == VTK_RESOLVE_POLYGON_OFFSET ||
    (isSurface && property->GetEdgeVisibility()); // whatever the resolution
  return hasOwnShaders || (hasOffsets && isPulled) ||
    (resolution == VTK_RESOLVE_SHIFT_ZBUFFER &&
      vtkMapper::GetResolveCoincidentTopologyZShift() < 0.0);
}
}

//------------------------------------------------------------------------------
bool vtkWaterGather::AreCoplanar(vtkWaterActor* a, vtkWaterActor* b)
{
  const water_plane planes[2] = { ReadPlane(a), ReadPlane(b) };
  water_plane units[2];
  return water_plane_normalise(&planes[0], &units[0]) == WATER_OK &&
    water_plane_normalise(&planes[1], &units[1]) == WATER_OK &&
    std::equal(units[0].normal, units[0].normal + 3, units[1].normal) &&
    units[0].offset == units[1].offset;
}

//------------------------------------------------------------------------------
bool vtkWaterGather::AreInOnePlane(vtkWaterActor* a, vtkWaterActor* b)
{
  const water_plane planes[2] = { ReadPlane(a), ReadPlane(b) };
  water_plane units[2];
  double origins[2][3];
  ReadPlaneOrigin(a, origins[0]);
  ReadPlaneOrigin(b, origins[1]);
  return a == b ||
    (water_plane_normalise(&planes[0], &units[0]) == WATER_OK &&
      water_plane_normalise(&planes[1], &units[1]) == WATER_OK &&
      water_plane_is_same(
        &units[0], &units[1], vtkMath::Norm(origins[0]) + vtkMath::Norm(origins[1])));
}

//------------------------------------------------------------------------------
water_scene vtkWaterGather::ReadSecondary(
  vtkRenderer* renderer, vtkWaterActor* water, const water_camera& eye)
{
  water_scene scene = water_scene();
  scene.eye = eye;
  scene.plane = ReadPlane(water);
  ReadPlaneOrigin(water, scene.plane_origin);
  scene.look = ReadLook(water->GetWaterProperty());
  vtkMath::UninitializeBounds(scene.surface_bounds);
  if (const double* bounds = water->GetBounds())
  {
    std::copy(bounds, bounds + 6, scene.surface_bounds);
  }
  renderer->GetEnvironmentUp(scene.environment_up);
  renderer->GetEnvironmentRight(scene.environment_right);
  return scene;
}

//------------------------------------------------------------------------------
std::vector<vtkWaterActor*> vtkWaterGather::FindWaters(vtkProp** props, int count)
{
  std::vector<vtkWaterActor*> waters;
  for (int i = 0; i < count; ++i)
  {
    vtkWaterActor* water = vtkWaterActor::SafeDownCast(props[i]);
    if (water && (waters.empty() || AreCoplanar(waters.front(), water)))
    {
      waters.push_back(water);
    }
  }
  return waters;
}

//------------------------------------------------------------------------------
water_camera vtkWaterGather::ReadCamera(vtkRenderer* renderer)
{
  water_camera eye;
  vtkCamera* camera = renderer->GetActiveCamera();
  const double* view = &camera->GetModelViewTransformMatrix()->Element[0][0];
  std::copy(view, view + 16, eye.world_to_view);
  const double* projection =
    &camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1)->Element[0][0];
  std::copy(projection, projection + 16, eye.view_to_clip);
  eye.parallel = camera->GetParallelProjection() != 0;
  return eye;
}

//------------------------------------------------------------------------------
water_plane vtkWaterGather::ReadPlane(vtkWaterActor* water)
{
  // by value and gradient, as planes may have an offset or a transform besides
  const double worldOrigin[3] = { 0.0, 0.0, 0.0 };
  water_plane plane;
  water->GetPlane()->FunctionGradient(worldOrigin, plane.normal);
  plane.offset = water->GetPlane()->FunctionValue(worldOrigin);
  return plane;
}

//------------------------------------------------------------------------------
void vtkWaterGather::ReadPlaneOrigin(vtkWaterActor* water, double origin[3])
{
  const water_plane plane = ReadPlane(water);
  water_plane unit;
  water->GetPlane()->GetOrigin(origin);
  if (water->GetPlane()->FunctionValue(origin) != 0.0 &&
    water_plane_normalise(&plane, &unit) == WATER_OK)
  {
    water_plane_project(&unit, origin, origin);
  }
}

//------------------------------------------------------------------------------
vtkLight* vtkWaterGather::FindSun(vtkRenderer* renderer)
{
  vtkLight* sun = nullptr;
  vtkCollectionSimpleIterator it;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(it))
  {
    if (light->GetSwitch() && light->LightTypeIsSceneLight() && light->GetIntensity() > 0.0 &&
      (!sun || light->GetIntensity() > sun->GetIntensity()))
    {
      sun = light;
    }
  }
  return sun;
}

//------------------------------------------------------------------------------
bool vtkWaterGather::ReadView(vtkRenderer* renderer, vtkWaterActor* water, water_grid_view* view)
{
  const water_camera eye = ReadCamera(renderer);
  const water_plane plane = ReadPlane(water);
  double origin[3];
  ReadPlaneOrigin(water, origin);
  return water_grid_view_make(&eye, &plane, origin, view) == WATER_OK;
}

//------------------------------------------------------------------------------
double vtkWaterGather::ReadSurfaceHeight(vtkRenderer* renderer, vtkWaterActor* water)
{
  const std::vector<water_wave_term> terms = water->GetWaveTerms();
  water_grid_view view;
  water_wave_point point;
  double rest[2];
  return ReadView(renderer, water, &view) &&
      water_waves_find(
        terms.data(), terms.size(), view.origin_xy[0], view.origin_xy[1], rest, &point) == WATER_OK
    ? point.displacement[2]
    : 0.0;
}

//------------------------------------------------------------------------------
water_look vtkWaterGather::ReadLook(vtkWaterProperty* property)
{
  water_look look;
  look.index_of_refraction = property->GetIndexOfRefraction();
  look.reflectance = property->GetReflectance();
  look.constant_reflectance = property->GetReflectanceMode() == vtkWaterProperty::CONSTANT;
  return look;
}

//------------------------------------------------------------------------------
void vtkWaterGather::Read(
  vtkRenderer* renderer, const std::vector<vtkWaterActor*>& waters, const int viewport_px[2])
{
  this->scene = water_scene();
  this->scene.eye = ReadCamera(renderer);
  this->camera = renderer->GetActiveCamera();
  std::copy(viewport_px, viewport_px + 2, this->scene.viewport_px);
  this->scene.plane = ReadPlane(waters.front());
  ReadPlaneOrigin(waters.front(), this->scene.plane_origin);
  this->scene.has_waves = false;
  this->scene.has_shadows = false;
  this->scene.slope_rms = 0.0;
  this->scene.slope_max = 0.0;
  this->scene.is_flat = true;
  this->WaveNumber = 0.0;
  this->HasMarchedRays = false;
  this->scene.hides_above = this->scene.hides_below = true;
  this->IsRough = std::any_of(waters.begin(), waters.end(),
    [](vtkWaterActor* water) { return water->GetWaterProperty()->IsRough(); });
  this->scene.wave_height_max = 0.0;
  this->scene.surface_height = 0.0;
  for (vtkWaterActor* water : waters)
  {
    vtkWaterProperty* property = water->GetWaterProperty();
    this->scene.has_waves = this->scene.has_waves || property->NeedsRays();
    this->scene.has_shadows = this->scene.has_shadows || property->LooksUpShadows();
    this->scene.slope_rms = std::max(this->scene.slope_rms, property->GetSlopeRMS());
    this->scene.slope_max = std::max(this->scene.slope_max, property->GetSlopeLookedUp());
    this->HasMarchedRays = this->HasMarchedRays ||
      (property->NeedsRays() && property->GetLookup() == vtkWaterProperty::RAY_TRACED);
    this->WaveNumber = std::max(this->WaveNumber, property->GetWaveNumber());
    // of a mesh of the user's nobody knows where its faces look; the sheet's look along the normal
    const bool isSheet = water->UsesOwnSheet() && water->GetIsIdentity();
    this->scene.is_flat =
      this->scene.is_flat && isSheet && !water->IsDisplaced() && !MayBePulled(water);
    this->scene.hides_above = this->scene.hides_above && isSheet &&
      water->GetProperty()->GetFrontfaceCulling() &&
      !water->GetProperty()->GetBackfaceCulling(); // with both, VTK culls back faces
    this->scene.hides_below =
      this->scene.hides_below && isSheet && water->GetProperty()->GetBackfaceCulling();
    if (water->IsDisplaced())
    {
      this->scene.wave_height_max =
        std::max(this->scene.wave_height_max, property->GetWaveHeightMax());
      this->scene.surface_height = ReadSurfaceHeight(renderer, water); // all have the same waves
    }
  }

  // what a mirrored view is drawn for by one of them, all use
  this->scene.has_environment = std::all_of(waters.begin(), waters.end(), [](vtkWaterActor* water) {
    return water->GetWaterProperty()->GetReflectionSource() == vtkWaterProperty::ENVIRONMENT;
  });
  renderer->GetEnvironmentUp(this->scene.environment_up);
  renderer->GetEnvironmentRight(this->scene.environment_right);
  if (vtkLight* sun = FindSun(renderer))
  {
    this->scene.has_sun = true;
    std::transform(sun->GetTransformedPosition(), sun->GetTransformedPosition() + 3,
      sun->GetTransformedFocalPoint(), this->scene.sun_dir, std::minus<double>());
  }

  vtkBoundingBox surface;
  vtkMath::UninitializeBounds(this->scene.surface_bounds);
  for (vtkWaterActor* water : waters)
  {
    if (const double* bounds = water->GetBounds())
    {
      surface.AddBounds(bounds);
    }
    const water_look look = ReadLook(water->GetWaterProperty());
    if (water == waters.front())
    {
      this->scene.look = look;
    }
    // each is shaded by its own; the reflection texture is left undrawn only if none of them
    // reflects
    water_optics_join(&look, &this->scene.look);
  }
  if (surface.IsValid())
  {
    surface.GetBounds(this->scene.surface_bounds);
  }

  this->props.clear();
  this->vtkProps.clear();
  vtkPropCollection* all = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  all->InitTraversal(it);
  while (vtkProp* prop = all->GetNextProp(it))
  {
    vtkProp* drawn = FindStandIn(prop);
    this->vtkProps.push_back(drawn);
    this->props.push_back(ReadProp(prop, drawn, waters.front()));
  }
  this->scene.props = this->props.data();
  this->scene.prop_count = this->props.size();
}
