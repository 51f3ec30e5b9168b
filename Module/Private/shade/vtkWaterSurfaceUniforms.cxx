// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSurfaceUniforms.cxx: the part of vtkWaterSurfaceShader that writes the uniforms.
#include "vtkMath.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"
#include "vtkTexture.h"
#include "vtkTextureObject.h"
#include "vtkTextureUnitManager.h"
#include "vtkWaterGL.h"
#include "vtkWaterMeshTraits.h"
#include "vtkWaterRanks.h"
#include "vtkWaterShaderHook.h"
#include "vtkWaterSurfaceShader.h"
#include "vtkWaterUniforms.h"
#include "water_beyond.h"
#include "water_daylight.h"
#include "water_flatness.h"
#include "water_glitter.h"
#include "water_lookup.h"
#include "water_optics.h"
#include "water_plan.h"
#include "water_plane.h"
#include "water_ranks.h"
#include "water_sky.h"
#include "water_slopes.h"
#include "water_units.h"
#include "water_waves.h"
#include "water_whitecap.h"

#include <algorithm>

namespace
{
constexpr double kFarUp = 1e30; // for a float
constexpr double kFlat[4] = { 0.0, 0.0, 0.0, 0.0 };
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::PartSamplers(vtkShaderProgram* program)
{
  const int units = this->GetWindow()->GetTextureUnitManager()->GetNumberOfTextureUnits();
  for (const char* name : { "waterSea", "waterOldFoam", "waterNormalMap0", "waterNormalMap1" })
  {
    vtkWaterUniforms::Set(program, name, units - 2);
  }
  vtkWaterUniforms::Set(program, "waterSkyCube", units - 3);
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkOpenGLVertexArrayObject* vertices)
{
  namespace uniforms = vtkWaterUniforms;
  if (!this->Water)
  {
    return; // drawn by somebody else than vtkWaterActor::Render: nothing to say
  }
  const water_plan* plan = this->Drawn.Plan;
  const vtkWaterLook& look = this->Water->Look;
  const bool hasView = plan && (this->HasBackdrop || !this->Has(WATER_FEATURE_MEDIUM));
  this->PartSamplers(program);
  for (const auto& [name, texture] : this->Active)
  {
    uniforms::Set(program, name, texture);
  }
  for (const auto& [name, texture] : this->SkyTextures)
  {
    uniforms::Set(program, name, texture->GetTextureUnit());
  }
  uniforms::Set(program, "waterHasView", hasView ? 1 : 0);
  const bool isReflecting =
    plan && (water_plan_has_reflection(plan) || this->Has(WATER_FEATURE_ENVIRONMENT));
  uniforms::Set(program, "waterIsReflecting", isReflecting ? 1 : 0);
  uniforms::Set(program, "waterOpacity", look.Opacity);
  uniforms::Set(program, "waterDataOpacity", look.DataOpacity);
  vtkProperty* property = this->Water->Actor->GetProperty();
  uniforms::Set(program, "waterDataGain", property->GetAmbient() + property->GetDiffuse());
  uniforms::Set(program, "waterOutput", look.Output);
  double deepColor[3];
  this->FindDeepColor(deepColor);
  uniforms::Set3(program, "waterDeepColor", deepColor);
  uniforms::Set(program, "waterWaveCount", this->WaveCount);
  this->SetDisplacement(program);
  static const double cut[3] = { 0.0, 0.0, 0.0 };
  uniforms::Set3(
    program, "waterHorizonDepths", this->Water->IsEndless ? this->Drawn.HorizonDepths : cut);
  if (plan)
  {
    this->SetVertexHeights(program, mapper);
    this->SetViewParameters(program);
    this->SetReflectionParameters(program);
    this->SetSkyParameters(program);
    this->SetSunParameters(program);
    this->SetCausticParameters(program);
    this->SetShaftParameters(program);
    this->SetHazeParameters(program);
  }
  if (plan && this->Has(WATER_FEATURE_NORMAL_MAPS))
  {
    this->SetNormalMapParameters(program);
  }
  if (plan)
  {
    this->SetVertexData(program, mapper, vertices);
  }
  this->CutShore(program, mapper, vertices); // also where it shows its plain colour
  if (this->HasSea)
  {
    this->SetSeaParameters(program);
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetNoTexture(vtkShaderProgram* program, const char* name)
{
  // one that has a unit: with an own view, the picture's copy has none
  for (const auto& [used, texture] : this->Active)
  {
    const std::string sampler = used;
    if (texture && (sampler == "waterReflection" || sampler == "waterSceneColor"))
    {
      vtkWaterUniforms::Set(program, name, texture);
      return;
    }
  }
  // GL refuses to draw where samplers of two kinds name one unit, and unit 0 may have a cube map
  vtkWaterUniforms::Set(program, name, vtkWaterShaderHook::GetPeelUnit(this->GetWindow()));
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetViewParameters(vtkShaderProgram* program)
{
  namespace uniforms = vtkWaterUniforms;
  const water_plan& plan = *this->Drawn.Plan;
  int viewport[4];
  this->Drawn.Renderer->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const double inverse[4] = { static_cast<double>(viewport[0]), static_cast<double>(viewport[1]),
    1.0 / viewport[2], 1.0 / viewport[3] };
  uniforms::Set4(program, "waterViewport", inverse);
  uniforms::Set4(program, "waterNormalClip", plan.normal_clip);
  uniforms::Set4(program, "waterPlaneClip", this->IsFlat ? kFlat : plan.plane_clip);
  uniforms::SetMatrix3(program, "waterNdcToRay", plan.ndc_to_ray);
  uniforms::SetMatrix3(program, "waterNdcToPlane", plan.ndc_to_plane);
  uniforms::SetMatrix4x3(program, "waterDirToEye", plan.dir_to_eye);
  uniforms::Set(program, "waterIsEndless", this->Water->IsEndless ? 1 : 0);
  uniforms::Set4(program, "waterPixelDepth", plan.pixel_depth);
  uniforms::Set(program, "waterSide", plan.side == WATER_BELOW ? -1.0 : 1.0);
  // its own: the plan may have been made for several waters
  const vtkWaterLook& look = this->Water->Look;
  uniforms::Set(program, "waterEta", water_optics_eta(&look.Optics, plan.side));
  uniforms::Set(
    program, "waterReflectance", look.Optics.constant_reflectance ? look.Optics.reflectance : -1.0);
  this->SetMediumParameters(program);
  uniforms::Set(program, "waterRestSteps",
    water_waves_rest_steps(program->IsUniformUsed("waterAxesToClip"), this->IsSteep));
  uniforms::Set(program, "waterFootprint", look.RayTraceFootprint);
  const bool isSpread = this->Backdrop.GetSpread() != nullptr;
  uniforms::Set(program, "waterSceneHasSamples", isSpread ? 1 : 0);
  if (!isSpread)
  {
    this->SetNoTexture(program, "waterSceneSeen");
  }
  double sheet[4] = { -kFarUp, kFarUp, -kFarUp, kFarUp };
  for (int i = 0; i < 4 && this->Water->HasBorder; ++i)
  {
    sheet[i] = this->Water->Sheet[i] - plan.origin_xy[i / 2];
  }
  uniforms::Set4(program, "waterSheet", sheet);
  if (this->Has(WATER_FEATURE_HULLS))
  {
    const water_waterline_rows& rows = this->Water->Hulls->Rows;
    const double hulls[4] = { rows.middle[0] - plan.origin_xy[0],
      rows.middle[1] - plan.origin_xy[1], rows.half[0], rows.half[1] };
    uniforms::Set4(program, "waterHullRows", hulls);
    uniforms::Set(program, "waterHullAxis", rows.axis);
  }
  this->SetRegionParameters(program);
  uniforms::Set(program, "waterBedDepth", std::min(plan.bed_depth, kFarUp));
  uniforms::Set(program, "waterIsSubmerged", plan.is_submerged ? 1 : 0);
  uniforms::Set(program, "waterShoreSoftness",
    look.HasShoreSoftness ? look.ShoreSoftness
                          : water_units_soften(look.ShoreSoftness, plan.bed_depth));
  uniforms::Set(program, "waterPortRadius", look.DomePortRadius);
  uniforms::Set(program, "waterBufferIsSloped", this->Has(WATER_FEATURE_SLOPED) ? 1 : 0);
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetRegionParameters(vtkShaderProgram* program)
{
  if (this->Has(WATER_FEATURE_RANK_REGION) && this->Drawn.Ranks)
  {
    water_plane plane;
    double sides[6][4];
    water_plane_normalise(&this->Water->Plane, &plane);
    water_rank_region_sides(
      &plane, this->Water->Origin, this->Drawn.Plan, this->Drawn.Ranks->GetRegion(), sides);
    vtkWaterUniforms::Set4s(program, "waterRankSides", 6, sides);
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetMediumParameters(vtkShaderProgram* program)
{
  namespace uniforms = vtkWaterUniforms;
  const water_plan& plan = *this->Drawn.Plan;
  double extinction[3];
  this->FindExtinction(extinction);
  uniforms::Set3(program, "waterExtinction", extinction);
  double heightClip[4];
  double clipW[4];
  double dirToScene[12];
  water_beyond_row(plan.plane_clip, this->PictureScale, heightClip);
  water_beyond_row(plan.clip_w, this->PictureScale, clipW);
  water_beyond_dirs(plan.dir_to_eye, this->PictureScale, dirToScene);
  uniforms::Set2(program, "waterSceneScale", this->PictureScale);
  uniforms::Set4(program, "waterHeightClip", heightClip);
  uniforms::Set4(program, "waterClipW", clipW);
  uniforms::SetMatrix4x3(program, "waterDirToScene", dirToScene);
  const bool isOwn = this->HasOwnView(); // it has one sample a pixel
  uniforms::Set(program, "waterSceneIsOwnView", isOwn ? 1 : 0);
  uniforms::Set(program, "waterSceneIsMixed", !isOwn && this->Backdrop.GetIsMixed() ? 1 : 0);
  uniforms::Set(program, "waterSceneSide", isOwn ? 1 : this->Backdrop.GetSide());
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetDisplacement(vtkShaderProgram* program)
{
  namespace uniforms = vtkWaterUniforms;
  static const water_grid_view still = water_grid_view(); // moves nothing
  const water_grid_view& view = this->Drawn.View ? *this->Drawn.View : still;
  uniforms::SetMatrix4x3(program, "waterAxesToClip", view.dir_to_clip);
  uniforms::SetMatrix3(program, "waterClipToPlace", view.clip_to_place);
  uniforms::Set4(program, "waterHeightOfClip", view.height_clip);
  uniforms::Set2(program, "waterRowDir", this->Drawn.RowDir);
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetVertexHeights(vtkShaderProgram* program, vtkAbstractMapper* mapper)
{
  namespace uniforms = vtkWaterUniforms;
  double origin[3] = { 0.0, 0.0, 0.0 };
  double rise[4] = { 0.0, 0.0, 0.0, 0.0 };
  const vtkWaterMesh& mesh = this->Water->Mesh;
  const bool isSloped = this->Has(WATER_FEATURE_SLOPED);
  if ((!this->IsFlat || isSloped) && this->Has(WATER_FEATURE_MESH))
  {
    double shift[3];
    double scale[3];
    vtkWaterMeshTraits::ReadShiftAndScale(mapper, shift, scale);
    water_flatness_vertices(
      mesh.Height, this->Drawn.Plan->side, mesh.Bounds, shift, scale, origin, rise);
    if (isSloped)
    {
      this->SetVertexPlaces(program, shift, scale, origin);
    }
  }
  uniforms::Set3(program, "waterVertexOrigin", origin);
  uniforms::Set4(program, "waterVertexRise", rise);
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetVertexPlaces(
  vtkShaderProgram* program, const double shift[3], const double scale[3], const double origin[3])
{
  namespace uniforms = vtkWaterUniforms;
  const water_plan& plan = *this->Drawn.Plan;
  const vtkWaterMesh& mesh = this->Water->Mesh;
  water_plane unit;
  water_axes axes;
  double across[4];
  double down[4];
  double normals[9];
  if (water_plane_normalise(&this->Water->Plane, &unit) != WATER_OK)
  {
    return; // there is no plan then
  }
  water_lookup_axes(&unit, plan.side, this->Water->Origin, &axes);
  water_slopes_places(&axes, plan.origin_xy, mesh.ToWorld, across, down);
  water_slopes_normals(&axes, mesh.ToWorld, normals);
  water_flatness_row(across, shift, scale, origin, across);
  water_flatness_row(down, shift, scale, origin, down);
  uniforms::Set4(program, "waterVertexAcross", across);
  uniforms::Set4(program, "waterVertexDown", down);
  uniforms::SetMatrix3(program, "waterNormalToPlane", normals);
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetReflectionParameters(vtkShaderProgram* program)
{
  namespace uniforms = vtkWaterUniforms;
  const water_plan& plan = *this->Drawn.Plan;
  const vtkWaterLook& look = this->Water->Look;
  if (!water_plan_has_reflection(&plan))
  {
    return;
  }
  const double depths[2] = { plan.depth_scale, plan.depth_offset };
  uniforms::Set2(program, "waterDepthScale", depths);
  uniforms::Set2(program, "waterReflectionScale", plan.reflection_scale);
  const double texels[2] = { static_cast<double>(this->Drawn.Reflection->GetWidth()),
    static_cast<double>(this->Drawn.Reflection->GetHeight()) };
  uniforms::Set2(program, "waterReflectionTexels", texels);
  uniforms::SetMatrix4x3(program, "waterDirToReflection", plan.dir_to_reflection);
  uniforms::Set4(program, "waterReflectionHeight", plan.reflection_height);
  uniforms::Set4(program, "waterReflectionW", plan.reflection_w);
  uniforms::Set4(program, "waterWaterline", plan.reflection_waterline);
  uniforms::Set(program, "waterTexel", std::min(plan.reflection_texel, kFarUp));
  uniforms::Set(program, "waterSlack",
    water_waves_slack(std::max(look.WaveHeightMax, this->Water->Mesh.Reach)));
  const double top = this->Has(WATER_FEATURE_SKY_VIEW) ? plan.rest_top : plan.reflection_top;
  uniforms::Set(program, "waterReflectionTop", std::min(water_lookup_end(top), kFarUp));
  uniforms::Set(program, "waterReflectionZInfinity", plan.reflection_z_infinity);
  uniforms::Set2(program, "waterReflectionTolerance", plan.reflection_tolerance);
  uniforms::Set(program, "waterSteps", std::min(look.RayTraceSteps, this->Drawn.MostSteps));
  uniforms::Set(program, "waterProbes", std::min(look.RayTraceProbes, this->Drawn.MostProbes));
  uniforms::Set(program, "waterRays", look.RayTraceRays);
  uniforms::Set(program, "waterRayContrast", water_lookup_contrast(look.RayTraceRays));
  uniforms::Set(program, "waterLookup", look.Lookup);
  uniforms::Set(program, "waterOffsetScale", look.OffsetScale);
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetSkyParameters(vtkShaderProgram* program)
{
  const water_plan& plan = *this->Drawn.Plan;
  const water_plan* around = this->Has(WATER_FEATURE_SKY_VIEW) ? this->Drawn.SkyView.Plan : nullptr;
  const double isKnown = plan.is_sky_known || around ? 1.0 : 0.0;
  const double* bottom = plan.sky.bottom;
  const double* top = plan.sky.top;
  const double bottomKnown[4] = { bottom[0], bottom[1], bottom[2], isKnown };
  const double topKnown[4] = { top[0], top[1], top[2], isKnown };
  vtkWaterUniforms::Set4(program, "waterSkyBottom", bottomKnown);
  vtkWaterUniforms::Set4(program, "waterSkyTop", topKnown);
  vtkWaterUniforms::Set(program, "waterScreen", static_cast<int>(plan.sky.screen));
  int width;
  int height;
  int origin[2];
  this->Drawn.Renderer->GetTiledSizeAndOrigin(&width, &height, &origin[0], &origin[1]);
  const double border[2] = { 0.5 / width, 0.5 / height };
  vtkWaterUniforms::Set2(program, "waterScreenBorder", border);
  if (plan.sky.screen != WATER_SCREEN_PICTURE)
  {
    this->SetNoTexture(program, "waterScreenPicture");
  }
  const double brightest = plan.is_half_float ? kFarUp : 1.0; // as the picture that VTK draws
  const bool isOwn = HasOwnSky(*this->Water);
  const water_sky_map& map = *water_sky_of(&plan, isOwn);
  vtkWaterUniforms::Set(
    program, "waterSkyIsOneColor", water_sky_is_one_color(&plan, isOwn) && !around ? 1 : 0);
  if (around)
  {
    vtkWaterUniforms::SetMatrix3(program, "waterDirToSkyView", around->sky_view_dirs);
    vtkWaterUniforms::Set3(program, "waterSkyViewAt", around->sky_view_at);
    vtkWaterUniforms::Set2(program, "waterSkyViewNear", around->sky_view_near);
    vtkWaterUniforms::Set(program, "waterRestDepth", plan.rest_depth);
  }
  const double shown[3] = { map.exponent, map.level, brightest };
  vtkWaterUniforms::SetMatrix3(program, "waterDirToMap", map.to_map);
  vtkWaterUniforms::Set2(program, "waterMapLatitude", map.latitude);
  vtkWaterUniforms::Set3(program, "waterMapShown", shown);
  const water_sky_floor& floor = plan.sky_floor;
  const double floorShown[2] = { floor.exponent, brightest };
  vtkWaterUniforms::Set4(program, "waterFloorHeight", floor.height);
  vtkWaterUniforms::Set4(program, "waterFloorU", floor.u);
  vtkWaterUniforms::Set4(program, "waterFloorV", floor.v);
  vtkWaterUniforms::Set2(program, "waterFloorShown", floorShown);
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetSunParameters(vtkShaderProgram* program)
{
  namespace uniforms = vtkWaterUniforms;
  const water_plan& plan = *this->Drawn.Plan;
  const vtkWaterLook& look = this->Water->Look;
  double variance[3];
  water_glitter_covariance(
    look.SlopeVariance, vtkMath::RadiansFromDegrees(look.SlopeVariance[2]), variance);
  uniforms::Set3(program, "waterSunDir", plan.sun_dir);
  uniforms::Set3(program, "waterSunColor", plan.sun_color);
  uniforms::Set3(
    program, "waterSlopeVariance", this->Drawn.IsSecondary ? look.MeanSlopes : variance);
  uniforms::Set3(program, "waterAllVariance", look.MeanSlopes);
  uniforms::Set(program, "waterSunHidden", water_glitter_hidden(plan.sun_dir, look.MeanSlopes));
  uniforms::Set(program, "waterWavesAreDrawn", this->Has(WATER_FEATURE_DISPLACED) ? 1 : 0);
  uniforms::Set(program, "waterFoamDepth", look.FoamDepth);
  uniforms::Set(program, "waterFoamJacobian", look.FoamJacobian);
  uniforms::Set3(program, "waterFoamColor", look.FoamColor);
  double foamSky[3];
  water_daylight_foam(
    plan.daylight, plan.sun_color, plan.has_sun ? plan.sun_dir : nullptr, foamSky);
  uniforms::Set3(program, "waterFoamSky", foamSky);
  double pattern[2];
  water_lookup_pattern(plan.origin_xy, look.MetresPerUnit, pattern);
  uniforms::Set2(program, "waterPatternOrigin", pattern);
  uniforms::Set(program, "waterFoamUnit", look.MetresPerUnit);
  uniforms::Set(program, "waterFoamTurn", water_lookup_pattern_turn(this->Water->Time));
  uniforms::Set(program, "waterRollsOff", plan.rolls_off && look.RollsOff ? 1 : 0);
  const Shade& shade = this->Drawn.SunView;
  const double depth[3] = { shade.Scale, shade.Bottom, shade.Depth ? 1.0 : 0.0 };
  uniforms::Set3(program, "waterSunViewDepth", depth);
  if (this->Has(WATER_FEATURE_SHADOWS) && !shade.Depth)
  {
    this->SetNoTexture(program, "waterSunView");
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetCausticParameters(vtkShaderProgram* program)
{
  namespace uniforms = vtkWaterUniforms;
  uniforms::Set(program, "waterCaustics", this->HasLight ? this->Water->Look.Caustics : 0.0);
  uniforms::Set3(program, "waterCausticNear", this->Light.near);
  uniforms::Set4(program, "waterCausticTexel", this->Light.texel_of_ndc);
  uniforms::Set(program, "waterCausticMiddle", this->Light.middle);
  uniforms::Set2(program, "waterCalmWay", this->Light.calm_way);
  if (!this->HasLight && this->HasBackdrop) // not looked at, but a sampler needs a texture
  {
    this->SetNoTexture(program, "waterCausticLight");
    this->SetNoTexture(program, "waterBed");
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetShaftParameters(vtkShaderProgram* program)
{
  namespace uniforms = vtkWaterUniforms;
  uniforms::Set(program, "waterShafts", this->Water->Look.LightShafts);
  uniforms::Set(program, "waterShaftSteps", this->HasShafts ? this->Shafts.steps : 0);
  uniforms::Set3(program, "waterShaftPlace", this->Shafts.place_to_uv);
  uniforms::Set2(program, "waterShaftFade", this->Shafts.fade);
  uniforms::Set2(program, "waterShaftWay", this->Shafts.light.calm_way);
  uniforms::Set(program, "waterShaftDepth", this->Shafts.eye_depth);
  vtkTextureObject* light = this->HasShafts ? this->ShaftLight.GetLight() : nullptr;
  if (light)
  {
    uniforms::Set(program, "waterShaftLight", light);
  }
  else if (this->HasBackdrop) // without shafts not looked at, but a sampler needs a texture
  {
    this->SetNoTexture(program, "waterShaftLight");
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetPhotonParameters(vtkShaderProgram* program)
{
  namespace uniforms = vtkWaterUniforms;
  for (const auto& [name, texture] : this->Active)
  {
    uniforms::Set(program, name, texture);
  }
  uniforms::Set(program, "waterWaveCount", this->WaveCount);
  this->SetViewParameters(program);
  this->SetSunParameters(program);
  if (this->Has(WATER_FEATURE_NORMAL_MAPS))
  {
    this->SetNormalMapParameters(program);
  }
  if (this->HasSea)
  {
    this->SetSeaParameters(program);
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetNormalMapParameters(vtkShaderProgram* program)
{
  const auto& layers = this->Water->Look.NormalMaps;
  const char* const names[vtkWaterNormalMaps::Limit] = { "waterNormalMapPlace0",
    "waterNormalMapPlace1" };
  for (size_t i = 0; i < vtkWaterNormalMaps::Limit; ++i)
  {
    double values[4] = { 0.0, 0.0, 0.0, 0.0 };
    if (i < layers.size())
    {
      const water_normal_map& map = layers[i].Map;
      const double* origin = this->Drawn.Plan->origin_xy;
      water_normals_place(&map, origin[0], origin[1], this->Water->Time, values);
      values[2] = 1.0 / map.size;
      values[3] = map.strength;
    }
    vtkWaterUniforms::Set4(program, names[i], values);
  }
  vtkWaterUniforms::Set2(program, "waterNormalMapTexels", this->NormalMapTexels);
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetSeaParameters(vtkShaderProgram* program)
{
  namespace uniforms = vtkWaterUniforms;
  const vtkWaterLook& look = this->Water->Look;
  const water_cascades& cascades = look.Cascades;
  // both count from the point under the eye
  static const double here[2] = { 0.0, 0.0 };
  const double* seen = this->Drawn.Plan ? this->Drawn.Plan->origin_xy : here;
  const double* origin = this->Drawn.View ? this->Drawn.View->origin_xy : seen;
  double tiles[WATER_CASCADES_MAX][4] = {};
  double bands[WATER_CASCADES_MAX + 1][4] = {};
  double leans[WATER_CASCADES_MAX] = {};
  for (size_t i = 0; i <= WATER_CASCADES_MAX; ++i)
  {
    const double* from = look.SeaBeyond[std::min(i, cascades.count)];
    std::copy_n(from, 2, bands[i]);
    bands[i][3] = from[2];
    if (i < cascades.count)
    {
      leans[i] = water_cascades_lean(from, look.SeaBeyond[i + 1]);
      water_tile tile = cascades.tiles[i];
      tile.length /= look.MetresPerUnit;
      water_tile_place(&tile, origin[0], origin[1], tiles[i]);
      tiles[i][2] = 1.0 / tile.length;
      tiles[i][3] = 0.5 / static_cast<double>(tile.size);
      bands[i][2] = water_cascades_longest(&cascades, i) / look.MetresPerUnit;
    }
  }
  double warps[WATER_CASCADE_WARPS][4];
  for (size_t i = 0; i < WATER_CASCADE_WARPS; ++i)
  {
    water_cascades_warp_under(&cascades, i, look.MetresPerUnit, origin, warps[i]);
  }
  uniforms::Set(program, "waterSeaCount", static_cast<int>(cascades.count));
  uniforms::Set4s(program, "waterSeaWarps", WATER_CASCADE_WARPS, warps);
  uniforms::Set4s(program, "waterSeaTiles", WATER_CASCADES_MAX, tiles);
  uniforms::Set4s(program, "waterSeaBands", WATER_CASCADES_MAX + 1, bands);
  uniforms::Set3(program, "waterSeaLeans", leans);
  const bool isMoved = program->IsUniformUsed("waterAxesToClip"); // of the vertices
  const double chop[2] = { isMoved ? look.SeaChoppiness : -1.0, 1.0 };
  uniforms::Set2(program, "waterSeaChop", chop);
  const double move[2] = { look.SeaChoppiness / look.MetresPerUnit, 1.0 / look.MetresPerUnit };
  uniforms::Set2(program, "waterSeaMove", move);
  const double softness = water_whitecap_softness();
  const double whitecaps[2] = { look.WhitecapJacobian, softness * softness };
  uniforms::Set2(program, "waterWhitecaps", whitecaps);
  double newest;
  double old[4] = {};
  water_old_foam_at(&look.OldFoam, this->Water->Time, &newest, old);
  old[3] = 1.0 / static_cast<double>(std::max<size_t>(look.OldFoam.tile.size, 1));
  uniforms::Set4(program, "waterOldFoamWeights", old);
}
