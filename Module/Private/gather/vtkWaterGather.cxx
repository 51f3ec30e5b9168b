// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterGather.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkSkybox.h"
#include "vtkTextureObject.h"
#include "vtkWaterGL.h"
#include "vtkWaterPropRecords.h"
#include "vtkWaterSea.h"
#include "water_daylight.h"
#include "water_lookup.h"
#include "water_optics.h"
#include "water_secondary.h"
#include "water_waves.h"

#include <algorithm>
#include <new>

namespace
{
// May VTK draw a water nearer to the eye than it is, before things that are in front of it? It does
// with what resolves coincident topology by offsets of less than 0, as those of its lines and
// points are by default; and nobody knows where the user's own shaders put it.
bool MayBePulled(vtkActor* water)
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

// Height of the waves that move a water's surface, over the plane where the eye is.
double ReadSurfaceHeight(vtkRenderer* renderer, const vtkWaterSnapshot& water)
{
  water_grid_view view;
  water_wave_point point;
  double rest[2];
  if (!vtkWaterGather::ReadView(renderer, water, &view))
  {
    return 0.0;
  }
  const double* xy = view.origin_xy;
  if ((water.Features & WATER_FEATURE_SEA_MOVES) == 0)
  {
    return water_waves_find(water.Waves.data(), water.Waves.size(), xy[0], xy[1], rest, &point) ==
        WATER_OK
      ? point.displacement[2]
      : 0.0;
  }
  // an eye that no wave reaches needs no height, which would cost a frame some milliseconds
  const vtkWaterLook& look = water.Look;
  if (!(view.eye_height <= look.WaveHeightMax))
  {
    return 0.0;
  }
  try
  {
    water.Sea->Update(look.Cascades, look.Sea, water.Time);
    const water_cascade_surface surface =
      water.Sea->GetSurface(look.SeaChoppiness, 1.0 / look.MetresPerUnit);
    const water_wave_others others = { water_cascades_add, &surface, look.WaveReach };
    if (water_waves_find_all(
          water.Waves.data(), water.Waves.size(), &others, xy[0], xy[1], rest, &point) == WATER_OK)
    {
      return point.displacement[2];
    }
  }
  catch (const std::bad_alloc&)
  {
    return 0.0; // the surface says it, and is drawn flat
  }
  return 0.0;
}

// The brightest scene light that is on; nullptr: there is none.
vtkLight* FindSun(vtkRenderer* renderer)
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

void ReadSun(vtkRenderer* renderer, water_scene& scene)
{
  if (vtkLight* sun = FindSun(renderer))
  {
    scene.has_sun = true;
    std::transform(sun->GetTransformedPosition(), sun->GetTransformedPosition() + 3,
      sun->GetTransformedFocalPoint(), scene.sun_dir, std::minus<double>());
    std::copy_n(sun->GetDiffuseColor(), 3, scene.sun_diffuse);
    scene.sun_intensity = sun->GetIntensity();
  }
}

void ReadLights(vtkRenderer* renderer, water_scene& scene)
{
  vtkCollectionSimpleIterator it;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(it))
  {
    if (light->GetSwitch() && !light->GetPositional()) // lamps do not light all of the water
    {
      double dir[3];
      std::transform(light->GetTransformedPosition(), light->GetTransformedPosition() + 3,
        light->GetTransformedFocalPoint(), dir, std::minus<double>());
      water_daylight_add_light(
        scene.plane.normal, dir, light->GetDiffuseColor(), light->GetIntensity(), scene.light);
    }
  }
}

void ReadEnvironment(vtkRenderer* renderer, water_scene& scene)
{
  renderer->GetEnvironmentUp(scene.environment_up);
  renderer->GetEnvironmentRight(scene.environment_right);
}
}

//------------------------------------------------------------------------------
void vtkWaterGather::ReadAsSecondary(vtkRenderer* renderer, const water_plan& mirrored)
{
  this->PictureEye = ReadCamera(renderer);
  water_secondary_view(&mirrored, &this->PictureEye, this->IsRough, &this->Scene);
  this->HasMarchedRays = this->IsRough;
  this->WantsPeel = false;
  this->IsAveraged = false;
}

//------------------------------------------------------------------------------
water_scene vtkWaterGather::ReadSecondary(vtkRenderer* renderer, const vtkWaterSnapshot& water,
  const water_camera& eye, const water_sky& sky)
{
  water_scene scene = water_scene();
  scene.eye = eye;
  scene.plane = water.Plane;
  std::copy_n(water.Origin, 3, scene.plane_origin);
  scene.look = water.Look.Optics;
  std::copy_n(water.Bounds, 6, scene.surface_bounds);
  scene.is_endless = water.IsEndless;
  scene.sky = sky;
  ReadEnvironment(renderer, scene);
  ReadLights(renderer, scene);
  return scene;
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
bool vtkWaterGather::HasSun(vtkRenderer* renderer)
{
  return FindSun(renderer) != nullptr;
}

//------------------------------------------------------------------------------
bool vtkWaterGather::ReadView(
  vtkRenderer* renderer, const vtkWaterSnapshot& water, water_grid_view* view)
{
  const water_camera eye = ReadCamera(renderer);
  return water_grid_view_make(&eye, &water.Plane, water.Origin, view) == WATER_OK;
}

//------------------------------------------------------------------------------
void vtkWaterGather::ReadWaters(
  vtkRenderer* renderer, const std::vector<vtkWaterSnapshotPointer>& waters)
{
  water_scene& scene = this->Scene;
  scene.is_flat = true;
  scene.hides_above = scene.hides_below = true;
  scene.has_environment = true; // what a mirrored view is drawn for by one of them, all use
  scene.look = waters.front()->Look.Optics;
  this->WaveNumber = 0.0;
  scene.calm_samples_min = 0;
  this->HasMarchedRays = false;
  this->WantsPeel = false;
  this->IsAveraged = false;
  this->IsRough = false;
  for (const vtkWaterSnapshotPointer& water : waters)
  {
    const vtkWaterLook& look = water->Look;
    const bool needsRays = water->NeedsRays();
    scene.has_waves = scene.has_waves || needsRays;
    scene.slope_rms = std::max(scene.slope_rms, look.SlopeRMS);
    scene.slope_max = std::max(scene.slope_max, look.SlopeLookedUp);
    scene.has_environment = scene.has_environment && look.Has.has_environment;
    this->IsRough = this->IsRough || water->IsRough();
    this->HasMarchedRays =
      this->HasMarchedRays || (needsRays && look.Has.lookup == WATER_LOOKUP_RAY_TRACED);
    this->IsAveraged = this->IsAveraged || (needsRays && look.RayTraceFootprint <= 0.0);
    this->WantsPeel = this->WantsPeel || (needsRays && water->WantsPeel());
    scene.calm_samples_min =
      std::max(scene.calm_samples_min, water_lookup_calm_samples(look.RayTraceRays));
    this->WaveNumber = std::max(this->WaveNumber, look.WaveNumber);
    // the faces of a user's mesh may look either way; the sheet's look along the normal
    vtkProperty* property = water->Actor->GetProperty();
    scene.is_flat =
      scene.is_flat && water->IsSheet && !water->IsDisplaced() && !MayBePulled(water->Actor);
    scene.hides_above = scene.hides_above && water->IsSheet && property->GetFrontfaceCulling() &&
      !property->GetBackfaceCulling(); // with both, VTK culls back faces
    scene.hides_below = scene.hides_below && water->IsSheet && property->GetBackfaceCulling();
    if (water->IsDisplaced())
    {
      scene.wave_height_max = std::max(scene.wave_height_max, look.WaveHeightMax);
      scene.surface_height = ReadSurfaceHeight(renderer, *water); // all have the same waves
    }
    if (water->IsSloped())
    {
      scene.wave_height_max = std::max(scene.wave_height_max, water->Mesh.Reach);
    }
    // each is shaded by its own; the mirrored view is left out only if none of them reflects
    water_optics_join(&look.Optics, &scene.look);
  }
}

//------------------------------------------------------------------------------
void vtkWaterGather::ReadSurface(const std::vector<vtkWaterSnapshotPointer>& waters)
{
  vtkBoundingBox surface;
  vtkMath::UninitializeBounds(this->Scene.surface_bounds);
  for (const vtkWaterSnapshotPointer& water : waters)
  {
    surface.AddBounds(water->Bounds);
    this->Scene.is_endless = this->Scene.is_endless || water->IsEndless;
  }
  if (surface.IsValid())
  {
    surface.GetBounds(this->Scene.surface_bounds);
  }
}

//------------------------------------------------------------------------------
void vtkWaterGather::ReadProps(vtkRenderer* renderer, const vtkWaterSnapshot& mirrored,
  const std::function<bool(vtkProp*)>& isRefused, vtkWaterPropRecords& records)
{
  records.Read(renderer, mirrored, isRefused);
  const size_t count = records.GetCount();
  this->Props.resize(count);
  this->DrawnProps.resize(count);
  for (size_t i = 0; i < count; ++i)
  {
    this->Props[i] = records.GetRead(i);
    this->DrawnProps[i] = records.GetDrawn(i);
  }
  this->Scene.props = this->Props.data();
  this->Scene.prop_count = count;
  this->ReadSkyboxes(renderer);
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  window->MakeCurrent(); // bringing pipelines up to date may have rendered another window
  this->Scene.max_texture_px = vtkTextureObject::GetMaximumTextureSize(window);
  glGetIntegerv(GL_MAX_SAMPLES, &this->Scene.max_samples);
}

//------------------------------------------------------------------------------
void vtkWaterGather::ReadSkyboxes(vtkRenderer* renderer)
{
  const uint32_t asked = WATER_PROP_IS_SKY | WATER_PROP_VISIBLE | WATER_PROP_NOT_REFLECTED;
  this->HasEmptySkybox = false;
  for (size_t i = 0; i < this->Props.size(); ++i)
  {
    if ((this->Props[i].flags & asked) == (WATER_PROP_IS_SKY | WATER_PROP_VISIBLE))
    {
      auto* skybox = vtkSkybox::SafeDownCast(this->DrawnProps[i]);
      const bool isRead =
        !skybox || vtkWaterSkyReader::ReadSkybox(renderer, skybox, this->Scene.sky, this->Sky);
      this->HasEmptySkybox = this->HasEmptySkybox || !isRead;
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterGather::Read(vtkRenderer* renderer, const std::vector<vtkWaterSnapshotPointer>& waters,
  const int viewport_px[2], const water_settings& settings, const vtkWaterFrameHints& hints)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const vtkWaterSnapshot& first = *waters.front();
  this->Scene = water_scene();
  this->Scene.eye = ReadCamera(renderer);
  this->Camera = renderer->GetActiveCamera();
  std::copy_n(viewport_px, 2, this->Scene.viewport_px);
  window->GetTileScale(this->Scene.tile_scale[0], this->Scene.tile_scale[1]);
  this->Scene.plane = first.Plane;
  std::copy_n(first.Origin, 3, this->Scene.plane_origin);
  this->Scene.settings = settings;
  this->Scene.has_scene_depth = hints.HasSceneDepth;
  this->Scene.is_software = hints.IsSoftware;
  this->Scene.may_tone_map = hints.MayToneMap;
  this->Scene.window_samples = window->GetMultiSamples();
  this->ReadWaters(renderer, waters);
  vtkWaterSkyReader::ReadBackground(renderer, this->Scene.sky, this->Sky);
  if (hints.Background && hints.Background->IsKept)
  {
    this->Scene.sky = hints.Background->Sky;
    this->Sky = hints.Background->Textures;
  }
  ReadEnvironment(renderer, this->Scene);
  ReadSun(renderer, this->Scene);
  ReadLights(renderer, this->Scene);
  this->ReadSurface(waters);
}
