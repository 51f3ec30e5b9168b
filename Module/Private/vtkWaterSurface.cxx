// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSurface.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkWaterActor.h"
#include "vtkWaterBodyFS.h"
#include "vtkWaterCalmFS.h"
#include "vtkWaterDeepFS.h"
#include "vtkWaterFacetsFS.h"
#include "vtkWaterGL.h"
#include "vtkWaterLookupFS.h"
#include "vtkWaterNoSeaFS.h"
#include "vtkWaterOffsetFS.h"
#include "vtkWaterOptics.h"
#include "vtkWaterPointFS.h"
#include "vtkWaterProperty.h"
#include "vtkWaterRippleFS.h"
#include "vtkWaterSea.h"
#include "vtkWaterSeaFS.h"
#include "vtkWaterSurfaceFS.h"
#include "vtkWaterUniforms.h"
#include "vtkWaterWavesFS.h"
#include "water_waves.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr double kFarUp = 1e30; // for a float
constexpr int kRestSteps = 3;   // of Newton's method, to the point at rest of steep waves
constexpr double kFlat[4] = { 0.0, 0.0, 0.0, 0.0 };
}

//------------------------------------------------------------------------------
int vtkWaterSurface::GetStages(vtkWaterProperty* property)
{
  int stages = 0;
  // a calm reflection has no reasons: those come with the rays
  if (property->GetNumberOfWaves() > 0 || property->GetSea() ||
    property->GetOutput() != vtkWaterProperty::COLOR)
  {
    stages |= property->GetSea() ? WAVES | SEA : WAVES;
    stages |= property->GetLookup() == vtkWaterProperty::RAY_TRACED ? RAY_TRACED : OFFSET;
  }
  if (property->GetRefraction() && property->GetOpacity() >= 1.0)
  {
    stages |= BODY;
  }
  return stages;
}

//------------------------------------------------------------------------------
std::string vtkWaterSurface::GetShader(vtkWaterProperty* property)
{
  const int stages = GetStages(property);
  std::vector<const char*> files{ vtkWaterOptics, vtkWaterPointFS };
  if (stages & WAVES)
  {
    files.push_back(vtkWaterWavesFS);
    files.push_back(stages & SEA ? vtkWaterSeaFS : vtkWaterNoSeaFS);
    files.push_back(vtkWaterRippleFS);
    files.push_back(stages & RAY_TRACED ? vtkWaterLookupFS : vtkWaterOffsetFS);
  }
  else
  {
    files.push_back(vtkWaterCalmFS);
  }
  files.push_back(stages & BODY ? vtkWaterBodyFS : vtkWaterDeepFS);
  files.push_back(vtkWaterFacetsFS);
  files.push_back(vtkWaterSurfaceFS);
  std::string source;
  for (const char* file : files)
  {
    source += file;
    source += "\n";
  }
  return source;
}

//------------------------------------------------------------------------------
bool vtkWaterSurface::UpdateStages(vtkWaterProperty* property)
{
  const int stages = GetStages(property);
  const bool isOther = stages != this->BuiltStages;
  this->BuiltStages = stages;
  return isOther;
}

//------------------------------------------------------------------------------
void vtkWaterSurface::UploadWaves(vtkWaterActor* water)
{
  const water_plan& plan = *this->Drawn.Plan;
  const std::vector<water_wave_term> terms = water->GetWaveTerms();
  // a table is never empty
  std::vector<water_wave_row> rows(std::max<size_t>(terms.size(), 1), water_wave_row());
  water_waves_rows(terms.data(), terms.size(), plan.origin_xy[0], plan.origin_xy[1], rows.data());
  std::vector<float> table;
  this->IsSteep = false;
  for (const water_wave_row& row : rows)
  {
    table.insert(table.end(),
      { row.k[0], row.k[1], row.amplitude, row.phase, row.steepness, 0.0f, 0.0f, 0.0f });
    this->IsSteep = this->IsSteep || row.steepness > 0.0f;
  }
  this->WaveCount = static_cast<int>(terms.size());
  auto* window = static_cast<vtkOpenGLRenderWindow*>(this->Drawn.Renderer->GetRenderWindow());
  if (!this->Waves || this->Waves->GetContext() != window)
  {
    this->Waves = vtkSmartPointer<vtkTextureObject>::New();
    this->Waves->SetContext(window);
    this->Waves->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Waves->SetMagnificationFilter(vtkTextureObject::Nearest);
  }
  this->Waves->Create2DFromRaw(
    2, static_cast<unsigned int>(rows.size()), 4, VTK_FLOAT, table.data());
}

//------------------------------------------------------------------------------
void vtkWaterSurface::Begin(vtkWaterActor* water, const Frame& frame)
{
  this->Drawn = frame;
  this->Property = water->GetWaterProperty();
  this->HasBackdrop = false;
  std::fill(std::begin(this->Active), std::end(this->Active), nullptr);
  auto* window = static_cast<vtkOpenGLRenderWindow*>(frame.Renderer->GetRenderWindow());
  int drawn[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, drawn);
  this->Active[0] = frame.Reflection;
  if (frame.Plan && (this->BuiltStages & BODY))
  {
    this->HasBackdrop = this->Backdrop.Copy(window, drawn);
    this->Active[1] = this->Backdrop.GetColor();
    this->Active[2] = this->Backdrop.GetDepth();
  }
  if (frame.Plan && (this->BuiltStages & WAVES))
  {
    this->UploadWaves(water);
    this->Active[3] = this->Waves;
    this->Active[4] = frame.ReflectionDepth;
  }
  this->Sea = nullptr;
  if (frame.Plan && (this->BuiltStages & SEA))
  {
    vtkWaterSea* sea = water->GetSeaAtTime();
    this->Active[5] = sea->Upload(window);
    this->Sea = sea;
  }
  if (frame.Plan && frame.Plan->decision == WATER_REFLECT)
  {
    // where pixel meets texel, one texel is the same as four
    const bool isAligned = !(this->BuiltStages & WAVES) && frame.IsFlat &&
      std::equal(drawn + 2, drawn + 4, frame.Plan->texture_px);
    const int filter = isAligned ? vtkTextureObject::Nearest : vtkTextureObject::Linear;
    frame.Reflection->SetMinificationFilter(filter);
    frame.Reflection->SetMagnificationFilter(filter);
  }
  for (vtkTextureObject* texture : this->Active)
  {
    if (texture)
    {
      texture->Activate();
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurface::End()
{
  for (vtkTextureObject* texture : this->Active)
  {
    if (texture)
    {
      texture->Deactivate();
    }
  }
  this->Property = nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterSurface::SetParameters(vtkShaderProgram* program)
{
  namespace uniforms = vtkWaterUniforms;
  if (!this->Property)
  {
    return; // drawn by somebody else than vtkWaterActor::Render: nothing to say
  }
  const water_plan* plan = this->Drawn.Plan;
  const bool hasView = plan && (this->HasBackdrop || !(this->BuiltStages & BODY));
  uniforms::Set(program, "waterReflection", this->Active[0]);
  uniforms::Set(program, "waterSceneColor", this->Active[1]);
  uniforms::Set(program, "waterSceneDepth", this->Active[2]);
  uniforms::Set(program, "waterWaves", this->Active[3]);
  uniforms::Set(program, "waterReflectionDepth", this->Active[4]);
  uniforms::Set(program, "waterSea", this->Active[5]);
  uniforms::Set(program, "waterHasView", hasView ? 1 : 0);
  uniforms::Set(program, "waterIsReflecting", plan && plan->decision == WATER_REFLECT ? 1 : 0);
  uniforms::Set(program, "waterOpacity", this->Property->GetOpacity());
  uniforms::Set(program, "waterOutput", this->Property->GetOutput());
  uniforms::Set3(program, "waterDeepColor", this->Property->GetDeepColor());
  if (plan)
  {
    this->SetViewParameters(program);
    this->SetReflectionParameters(program);
    this->SetSkyParameters(program);
  }
  if (plan && this->Sea)
  {
    this->SetSeaParameters(program);
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurface::SetViewParameters(vtkShaderProgram* program)
{
  namespace uniforms = vtkWaterUniforms;
  const water_plan& plan = *this->Drawn.Plan;
  int viewport[4];
  this->Drawn.Renderer->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const double inverse[4] = { static_cast<double>(viewport[0]), static_cast<double>(viewport[1]),
    1.0 / viewport[2], 1.0 / viewport[3] };
  uniforms::Set4(program, "waterViewport", inverse);
  uniforms::Set4(program, "waterNormalClip", plan.normal_clip);
  uniforms::Set4(program, "waterPlaneClip", this->Drawn.IsFlat ? kFlat : plan.plane_clip);
  uniforms::SetMatrix3(program, "waterNdcToRay", plan.ndc_to_ray);
  uniforms::SetMatrix3(program, "waterNdcToPlane", plan.ndc_to_plane);
  uniforms::SetMatrix4x3(program, "waterDirToEye", plan.dir_to_eye);
  uniforms::Set(program, "waterSide", plan.side == WATER_BELOW ? -1.0 : 1.0);
  uniforms::Set(program, "waterEta", plan.eta);
  uniforms::Set(program, "waterReflectance", plan.reflectance);
  uniforms::Set4(program, "waterHeightClip", plan.plane_clip);
  uniforms::Set4(program, "waterClipW", plan.clip_w);
  uniforms::Set(program, "waterWaveCount", this->WaveCount);
  uniforms::Set(program, "waterRestSteps", this->IsSteep ? kRestSteps : 0);
  uniforms::Set3(program, "waterExtinction", this->Property->GetExtinction());
}

//------------------------------------------------------------------------------
void vtkWaterSurface::SetReflectionParameters(vtkShaderProgram* program)
{
  namespace uniforms = vtkWaterUniforms;
  const water_plan& plan = *this->Drawn.Plan;
  if (plan.decision != WATER_REFLECT)
  {
    return;
  }
  uniforms::Set(program, "waterDepthScale", plan.depth_scale);
  uniforms::Set2(program, "waterMapScale", plan.map_scale);
  uniforms::SetMatrix4x3(program, "waterDirToMap", plan.dir_to_map);
  uniforms::Set(program, "waterMapTop", std::min(plan.map_top, kFarUp));
  uniforms::Set(program, "waterMapZInfinity", plan.map_z_infinity);
  uniforms::Set2(program, "waterMapTolerance", plan.map_tolerance);
  uniforms::Set(program, "waterSteps", this->Property->GetRayTraceSteps());
  uniforms::Set(program, "waterProbes", this->Property->GetRayTraceProbes());
  uniforms::Set(program, "waterLookup", this->Property->GetLookup());
  uniforms::Set(program, "waterOffsetScale", this->Property->GetOffsetScale());
}

//------------------------------------------------------------------------------
void vtkWaterSurface::SetSkyParameters(vtkShaderProgram* program)
{
  vtkOpenGLRenderer* renderer = this->Drawn.Renderer;
  const water_plan& plan = *this->Drawn.Plan;
  const bool hasGradient = renderer->GetGradientBackground() && !renderer->GetTexturedBackground();
  const double* bottom = renderer->GetBackground();
  const double* top = hasGradient ? renderer->GetBackground2() : bottom;
  // a skybox hides the background; what it shows is in the map only
  const double isKnown = std::isfinite(plan.map_top) ? 1.0 : 0.0;
  const double bottomKnown[4] = { bottom[0], bottom[1], bottom[2], isKnown };
  const double topKnown[4] = { top[0], top[1], top[2], isKnown };
  vtkWaterUniforms::Set4(program, "waterSkyBottom", bottomKnown);
  vtkWaterUniforms::Set4(program, "waterSkyTop", topKnown);
}

//------------------------------------------------------------------------------
void vtkWaterSurface::SetSeaParameters(vtkShaderProgram* program)
{
  const water_tile& tile = this->Sea->GetTile();
  double place[2] = { 0.0, 0.0 };
  water_tile_place(&tile, this->Drawn.Plan->origin_xy[0], this->Drawn.Plan->origin_xy[1], place);
  const double placeAndScale[4] = { place[0], place[1], 1.0 / tile.length,
    0.5 / static_cast<double>(tile.size) };
  vtkWaterUniforms::Set4(program, "waterSeaTile", placeAndScale);
  vtkWaterUniforms::Set2(program, "waterSeaLeftOut", this->Sea->GetLeftOut());
}

//------------------------------------------------------------------------------
void vtkWaterSurface::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Waves && window)
  {
    this->Waves->ReleaseGraphicsResources(window);
  }
  this->Waves = nullptr;
  this->Backdrop.ReleaseGraphicsResources(window);
}
