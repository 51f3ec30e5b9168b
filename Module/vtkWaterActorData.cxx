// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterActorData.cxx: the part of vtkWaterActor that names arrays of a mesh: a current, matter
// in the water, foam.
#include "vtkMath.h"
#include "vtkWaterActorInternals.h"
#include "vtkWaterCompat.h"
#include "vtkWaterUncutMesh.h"
#include "vtkWaterVertexData.h"
#include "water_cascade.h"
#include "water_flow.h"
#include "water_medium.h"

#include <algorithm>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
void vtkWaterActor::SetFlowArrayName(const std::string& name)
{
  if (this->FlowArrayName != name)
  {
    this->FlowArrayName = name;
    this->Internal->FlowError.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetMatterArrayName(const std::string& name)
{
  if (this->MatterArrayName != name)
  {
    this->MatterArrayName = name;
    this->Internal->MatterError.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetMatter(
  const char* name, double (&member)[3], const std::array<double, 3>& given)
{
  const auto isGood = [](double value) { return value >= 0.0 && value <= WATER_COEFFICIENT_MAX; };
  if (!std::all_of(given.begin(), given.end(), isGood))
  {
    vtkErrorMacro(<< name << " is (" << given[0] << ", " << given[1] << ", " << given[2]
                  << "); every channel must be finite, not negative and at most 1e9. It stays ("
                  << member[0] << ", " << member[1] << ", " << member[2] << ").");
    return;
  }
  if (!std::equal(given.begin(), given.end(), member))
  {
    std::copy(given.begin(), given.end(), member);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetMatterAbsorption(double red, double green, double blue)
{
  this->SetMatter("MatterAbsorption", this->MatterAbsorption, { red, green, blue });
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetMatterScattering(double red, double green, double blue)
{
  this->SetMatter("MatterScattering", this->MatterScattering, { red, green, blue });
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetFoamArrayName(const std::string& name)
{
  if (this->FoamArrayName != name)
  {
    this->FoamArrayName = name;
    this->Internal->FoamError.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetFoamMeasure(int measure)
{
  vtkWaterSetInRange(FoamMeasure, measure, COVER, BREAKING_INDEX);
}

//------------------------------------------------------------------------------
const char* vtkWaterActor::GetFoamMeasureAsString() const
{
  static const char* const names[] = { "COVER", "FROUDE_NUMBER", "BREAKING_INDEX" };
  return names[this->FoamMeasure];
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetFlowPeriod(double seconds)
{
  vtkWaterSetInRange(FlowPeriod, seconds, WATER_FLOW_PERIOD_MIN, WATER_FLOW_PERIOD_MAX);
}

//------------------------------------------------------------------------------
bool vtkWaterActor::Internals::CanUse(const vtkWaterVertexData::Use& use, const std::string& name,
  const char* setting, const char* without, std::string& said)
{
  if (name.empty())
  {
    return false;
  }
  const std::string wrong = vtkWaterVertexData::Check(
    this->Self->UsesOwnSheet() ? nullptr : this->Self->GetMapper(), use, name);
  const std::string before = said;
  said = wrong.empty() ? wrong : std::string(setting) + ": " + wrong + ". " + without;
  if (said != before && !said.empty()) // once, until it is mended
  {
    vtkErrorWithObjectMacro(this->Self, << said);
  }
  return wrong.empty();
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::ReadMatter(vtkWaterSnapshot& water)
{
  const vtkWaterActor& self = *this->Self;
  if (!this->CanUse(vtkWaterVertexData::Matter(), self.MatterArrayName, "MatterArrayName",
        "The water is clear.", this->MatterError))
  {
    return;
  }
  water.Features = water_features_with_matter(water.Features);
  water.MatterArrayName = self.MatterArrayName;
  for (int i = 0; i < 3; ++i)
  {
    water.Matter.absorption[i] = self.MatterAbsorption[i] * water.Look.MetresPerUnit;
    water.Matter.scattering[i] = self.MatterScattering[i] * water.Look.MetresPerUnit;
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::ReadFoam(vtkWaterSnapshot& water)
{
  const vtkWaterActor& self = *this->Self;
  water.Look.HasFoamData = this->CanUse(vtkWaterVertexData::Foam(self.FoamMeasure),
    self.FoamArrayName, "FoamArrayName", "There is no foam from data.", this->FoamError);
  water.FoamArrayName = self.FoamArrayName;
  water.FoamMeasure = self.FoamMeasure;
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::ReadData(vtkWaterSnapshot& water)
{
  if (water.Look.HasFoamData)
  {
    water.Features = water_features_with_foam_data(water.Features);
  }
  vtkMapper* mapper = this->Self->GetMapper();
  if (mapper->GetNumberOfInputConnections(0) > 0 &&
    vtkWaterUncutMesh::SafeDownCast(mapper->GetInputDataObject(0, 0)))
  {
    water.Features = water_features_with_shore(water.Features);
  }
  this->ReadFlow(water);
  this->ReadMatter(water);
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::ReadFlow(vtkWaterSnapshot& water)
{
  if (!this->CanUse(vtkWaterVertexData::Flow(), this->Self->FlowArrayName, "FlowArrayName",
        "There is no current.", this->FlowError))
  {
    return;
  }
  water.Features = water_features_with_flow(water.Features);
  water.FlowArrayName = this->Self->FlowArrayName;
  water.FlowPeriod = this->Self->FlowPeriod;
  const vtkWaterLook& look = water.Look;
  double longest = look.WaveNumber > 0.0 ? 2.0 * vtkMath::Pi() / look.WaveNumber : 0.0;
  for (const vtkWaterNormalMaps::Layer& layer : look.NormalMaps)
  {
    longest = std::max(longest, 0.5 * layer.Map.size); // two waves a side
  }
  water.FlowLikeness = water_flow_likeness(longest);
  for (size_t i = 0; look.Has.has_sea && i < look.Cascades.count; ++i)
  {
    double band[2]; // per m
    water_cascades_band(&look.Cascades, &look.Sea, i, band);
    water.FlowBands[i][0] = band[0] * look.MetresPerUnit;
    water.FlowBands[i][1] = band[1] * look.MetresPerUnit;
  }
  if ((water.Features & WATER_FEATURE_FLOW) != 0)
  {
    // where the current is slower further on it makes waves steeper
    water.Look.SlopeLookedUp = std::numeric_limits<double>::infinity();
  }
}
VTK_ABI_NAMESPACE_END
