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
#include "vtkWaterCell.h"
#include "vtkWaterDeepFS.h"
#include "vtkWaterDisplacedFS.h"
#include "vtkWaterFlatFS.h"
#include "vtkWaterGL.h"
#include "vtkWaterLookupFS.h"
#include "vtkWaterOffsetFS.h"
#include "vtkWaterOptics.h"
#include "vtkWaterPointFS.h"
#include "vtkWaterProperty.h"
#include "vtkWaterSurfaceFS.h"
#include "vtkWaterUniforms.h"
#include "vtkWaterWavesFS.h"
#include "vtkWaterWavesVS.h"
#include "water_waves.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr double kFarUp = 1e30; // for a float
constexpr int kRestSteps = 3;   // of Newton's method, to the point at rest of steep waves
constexpr int kChordSteps = 1;  // from the chord that a triangle is to the waves
constexpr double kSlack = 0.25; // in heights of the waves
constexpr double kFlat[4] = { 0.0, 0.0, 0.0, 0.0 };
}

//------------------------------------------------------------------------------
int vtkWaterSurface::GetStages(vtkWaterProperty* property)
{
  int stages = 0;
  // a calm reflection has no reasons: those come with the rays
  if (property->GetNumberOfWaves() > 0 || property->GetOutput() != vtkWaterProperty::COLOR)
  {
    stages |= WAVES;
    stages |= property->GetLookup() == vtkWaterProperty::RAY_TRACED ? RAY_TRACED : OFFSET;
  }
  if (property->GetWaveGeometry() && property->GetNumberOfWaves() > 0)
  {
    stages |= DISPLACED;
  }
  if (property->GetRefraction() && property->GetOpacity() >= 1.0)
  {
    stages |= BODY;
  }
  return stages;
}

//------------------------------------------------------------------------------
std::string vtkWaterSurface::GetShader(vtkWaterProperty* property, bool canDisplace)
{
  const int stages = GetStages(property);
  const bool isDisplaced = canDisplace && (stages & DISPLACED);
  std::vector<const char*> files{ vtkWaterOptics };
  if (isDisplaced)
  {
    files.push_back(vtkWaterCell);
  }
  files.push_back(isDisplaced ? vtkWaterDisplacedFS : vtkWaterFlatFS);
  files.push_back(vtkWaterPointFS);
  if (stages & WAVES)
  {
    files.push_back(vtkWaterWavesFS);
    files.push_back(stages & RAY_TRACED ? vtkWaterLookupFS : vtkWaterOffsetFS);
  }
  else
  {
    files.push_back(vtkWaterCalmFS);
  }
  files.push_back(stages & BODY ? vtkWaterBodyFS : vtkWaterDeepFS);
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
std::string vtkWaterSurface::GetVertexShader()
{
  return std::string(vtkWaterCell) + "\n" + vtkWaterWavesVS;
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
void vtkWaterSurface::UploadWaves(vtkWaterActor* water, const double origin[2])
{
  const std::vector<water_wave_term> terms = water->GetWaveTerms();
  // a table is never empty
  std::vector<water_wave_row> rows(std::max<size_t>(terms.size(), 1), water_wave_row());
  water_waves_rows(terms.data(), terms.size(), origin[0], origin[1], rows.data());
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
  if ((frame.Plan || frame.View) && (this->BuiltStages & WAVES))
  {
    // both count from the point under the eye
    this->UploadWaves(water, frame.View ? frame.View->origin_xy : frame.Plan->origin_xy);
    this->Active[3] = this->Waves;
    this->Active[4] = frame.ReflectionDepth;
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
  uniforms::Set(program, "waterHasView", hasView ? 1 : 0);
  uniforms::Set(program, "waterIsReflecting", plan && plan->decision == WATER_REFLECT ? 1 : 0);
  uniforms::Set(program, "waterOpacity", this->Property->GetOpacity());
  uniforms::Set(program, "waterOutput", this->Property->GetOutput());
  uniforms::Set3(program, "waterDeepColor", this->Property->GetDeepColor());
  uniforms::Set(program, "waterWaveCount", this->WaveCount);
  this->SetDisplacement(program);
  if (plan)
  {
    this->SetViewParameters(program);
    this->SetReflectionParameters(program);
    this->SetSkyParameters(program);
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
  const int flatSteps = this->IsSteep ? kRestSteps : 0;
  uniforms::Set(
    program, "waterRestSteps", program->IsUniformUsed("waterAxesToClip") ? kChordSteps : flatSteps);
  uniforms::Set3(program, "waterExtinction", this->Property->GetExtinction());
}

//------------------------------------------------------------------------------
void vtkWaterSurface::SetDisplacement(vtkShaderProgram* program)
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
  uniforms::Set4(program, "waterMapHeight", plan.map_height);
  uniforms::Set4(program, "waterMapW", plan.map_w);
  uniforms::Set(program, "waterTexel", std::min(plan.map_texel, kFarUp));
  uniforms::Set(program, "waterSlack", kSlack * this->Property->GetWaveHeightMax());
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
void vtkWaterSurface::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Waves && window)
  {
    this->Waves->ReleaseGraphicsResources(window);
  }
  this->Waves = nullptr;
  this->Backdrop.ReleaseGraphicsResources(window);
}
