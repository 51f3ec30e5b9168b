// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSurfaceData.cxx: the part of vtkWaterSurfaceShader that shows arrays of a mesh: a
// current, matter in the water, foam, and the depth that ends it at the shore.
#include "vtkActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkShaderProgram.h"
#include "vtkWaterMeshTraits.h"
#include "vtkWaterSurfaceShader.h"
#include "vtkWaterUncutMesh.h"
#include "vtkWaterUniforms.h"
#include "water_flow.h"
#include "water_foam_measure.h"
#include "water_lookup.h"
#include "water_plan.h"
#include "water_plane.h"
#include "water_units.h"

#include <algorithm>

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetVertexData(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkOpenGLVertexArrayObject* vertices)
{
  const vtkWaterSnapshot& water = *this->Water;
  vtkPolyDataMapper* drawn = vtkWaterMeshTraits::AsPolyDataMapper(mapper);
  vtkPolyData* mesh = drawn ? drawn->GetInput() : nullptr;
  if (this->Has(WATER_FEATURE_FLOW))
  {
    this->SetFlowParameters(program);
    this->Flow.Add(mesh, vtkWaterVertexData::Flow(), water.FlowArrayName, program, vertices);
  }
  if (this->Has(WATER_FEATURE_MATTER))
  {
    this->SetMatterParameters(program);
    this->Matter.Add(mesh, vtkWaterVertexData::Matter(), water.MatterArrayName, program, vertices);
    this->TellWrong(this->Matter, "MatterArrayName", water.MatterArrayName, this->MatterWrong);
  }
  if (this->Has(WATER_FEATURE_FOAM_DATA))
  {
    double ends[2];
    water_foam_measure_ends(static_cast<water_foam_measure>(water.FoamMeasure), ends);
    vtkWaterUniforms::Set2(program, "waterFoamEnds", ends);
    this->Foam.Add(
      mesh, vtkWaterVertexData::Foam(water.FoamMeasure), water.FoamArrayName, program, vertices);
    this->TellWrong(this->Foam, "FoamArrayName", water.FoamArrayName, this->FoamWrong);
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::CutShore(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkOpenGLVertexArrayObject* vertices)
{
  vtkPolyDataMapper* drawn = vtkWaterMeshTraits::AsPolyDataMapper(mapper);
  auto* mesh = vtkWaterUncutMesh::SafeDownCast(drawn ? drawn->GetInput() : nullptr);
  static const char* const attribute = "waterShoreMC";
  if (mesh && vertices && this->Has(WATER_FEATURE_SHORE) && program->IsAttributeUsed(attribute))
  {
    this->ShoreClip.Set(this->Shore.Add(mesh->GetDistances(), attribute, program, vertices));
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::TellWrong(const vtkWaterVertexData& data, const char* setting,
  const std::string& name, std::string& said) const
{
  if (said == name || data.GetWrong().empty())
  {
    return;
  }
  said = name; // a solver's next steps are likely wrong, too
  vtkWarningWithObjectMacro(
    this->Water->Actor, << setting << ": in the array '" << name << "' " << data.GetWrong() << ".");
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetFlowParameters(vtkShaderProgram* program)
{
  namespace uniforms = vtkWaterUniforms;
  const vtkWaterSnapshot& water = *this->Water;
  water_plane unit;
  water_axes axes;
  if (water_plane_normalise(&water.Plane, &unit) != WATER_OK)
  {
    return; // there is no plan then
  }
  water_lookup_axes(&unit, this->Drawn.Plan->side, water.Origin, &axes);
  double across[3];
  double down[3];
  water_flow_ways(
    &axes, water.Mesh.ToWorld, water.FlowPeriod, water.Look.MetresPerUnit, across, down);
  const water_flow flow = water_flow_at(water.Time, water.FlowPeriod);
  const double layers[3] = { flow.gone[0], flow.gone[1], flow.weight };
  uniforms::Set3(program, "waterFlowAcross", across);
  uniforms::Set3(program, "waterFlowDown", down);
  uniforms::Set3(program, "waterFlowLayers", layers);
  uniforms::Set(program, "waterFlowLikeness", water.FlowLikeness);
  double bands[WATER_CASCADES_MAX][4] = {};
  for (size_t i = 0; i < WATER_CASCADES_MAX; ++i)
  {
    std::copy_n(water.FlowBands[i], 2, bands[i]);
  }
  uniforms::Set4s(program, "waterFlowBands", WATER_CASCADES_MAX, bands);
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetMatterParameters(vtkShaderProgram* program)
{
  namespace uniforms = vtkWaterUniforms;
  const water_medium& clear = this->Water->Look.Medium;
  const water_medium& matter = this->Water->Matter;
  double deepColor[3];
  double extinction[3];
  this->FindDeepColor(deepColor);
  this->FindExtinction(extinction);
  uniforms::Set3(program, "waterClearDeepColor", deepColor);
  uniforms::Set3(program, "waterClearExtinction", extinction);
  double ofMatter[3];
  water_medium_extinction(&matter, ofMatter);
  const std::pair<const char*, const double*> others[] = { { "waterClearScattering",
                                                             clear.scattering },
    { "waterMatterExtinction", ofMatter }, { "waterMatterScattering", matter.scattering } };
  for (const auto& [name, perUnit] : others)
  {
    double dimmed[3];
    this->Dim(perUnit, dimmed);
    uniforms::Set3(program, name, dimmed);
  }
  uniforms::Set3(program, "waterDaylight", this->Drawn.Plan->daylight);
  uniforms::Set(program, "waterMatterIsDeep", this->Water->Look.HasDeepColor ? 0 : 1);
}
