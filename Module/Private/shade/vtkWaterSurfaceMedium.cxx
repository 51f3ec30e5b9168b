// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSurfaceMedium.cxx: the part of vtkWaterSurfaceShader that knows what lies under the
// water: its medium, what is seen through it, and the light that waves gather there.
#include "vtkActor.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkTextureObject.h"
#include "vtkWaterFog.h"
#include "vtkWaterRanks.h"
#include "vtkWaterSurfaceShader.h"
#include "vtkWaterUniforms.h"
#include "water_daylight.h"
#include "water_haze.h"
#include "water_lookup.h"
#include "water_plan.h"
#include "water_shafts.h"
#include "water_units.h"

#include <algorithm>
#include <functional>

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::FindDeepColor(double color[3]) const
{
  const vtkWaterLook& look = this->Water->Look;
  std::copy_n(look.DeepColor, 3, color);
  if (this->Drawn.Plan && !look.HasDeepColor)
  {
    water_daylight_deep_color(&look.Medium, this->Drawn.Plan->daylight, color);
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::FindExtinction(double extinction[3]) const
{
  this->Dim(this->Water->Look.Extinction, extinction);
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::Dim(const double coefficients[3], double dimmed[3]) const
{
  const vtkWaterLook& look = this->Water->Look;
  const double depth = this->Drawn.Plan ? this->Drawn.Plan->bed_depth : 0.0;
  water_units_dim(coefficients, depth, look.SceneDiagonal, look.NaturalDepth, look.Bed, dimmed);
}

//------------------------------------------------------------------------------
bool vtkWaterSurfaceShader::HasOwnView() const
{
  return this->Drawn.OwnView.Color && this->Water->WantsOwnView();
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::BeginMedium(const int viewport_px[4])
{
  const bool hadFailed = this->Backdrop.GetHasFailed();
  int part_px[4];
  water_lookup_under(&this->Plan, this->IsFlat, viewport_px + 2, part_px);
  // fog is drawn over all of the picture, and wants each pixel's mean
  const double* heightClip = this->Drawn.AddsFog ? nullptr : this->Plan.plane_clip;
  if (this->Drawn.Ranks)
  {
    // what lies flat on one rank may not on another
    int samples = vtkWaterBackdrop::CountSamples();
    this->HasBackdrop = this->Drawn.Ranks->JoinRects(part_px, samples) &&
      this->Backdrop.CopyOfAll(
        *this->Drawn.Ranks, this->GetWindow(), viewport_px, part_px, samples, heightClip);
  }
  else
  {
    this->HasBackdrop = this->Backdrop.Copy(this->GetWindow(), viewport_px, part_px, heightClip);
  }
  if (this->Backdrop.GetHasFailed() && !hadFailed) // said once
  {
    vtkErrorWithObjectMacro(this->Water->Actor,
      "the GPU provides no textures for the refracted scene. The water shows its plain colour.");
  }
  const Beyond& own = this->Drawn.OwnView;
  const bool isOwn = this->HasOwnView();
  const bool hasLayer = isOwn && own.Translucent.Color;
  vtkTextureObject* ownColor = hasLayer ? own.Translucent.Opaque : own.Color;
  this->Use("waterSceneColor", isOwn ? ownColor : this->Backdrop.GetColor());
  this->Use("waterSceneDepth", isOwn ? own.Depth : this->Backdrop.GetDepth());
  if (this->Has(WATER_FEATURE_OPEN))
  {
    this->Use("waterPictureDepth", this->Backdrop.GetDepth());
  }
  if (hasLayer)
  {
    this->Use("waterBelowColor", own.Translucent.Color);
    this->Use("waterBelowDepth", own.Translucent.Depth);
  }
  std::fill_n(this->PictureScale, 2, 1.0);
  if (isOwn)
  {
    std::copy_n(own.PictureScale, 2, this->PictureScale);
  }
  if (vtkWaterSampleSpread* samples = this->Backdrop.GetSpread())
  {
    this->Use("waterSceneSeen", samples->GetSeen());
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::DrawFog()
{
  double deepColor[3];
  double extinction[3];
  this->FindDeepColor(deepColor);
  this->FindExtinction(extinction);
  const auto setLight = [this](vtkShaderProgram* program) {
    this->SetHazeParameters(program);
    if (this->HasShafts)
    {
      this->SetShaftParameters(program);
    }
  };
  vtkWaterFog::Cover cover = vtkWaterFog::ALL;
  if (const vtkWaterRanks* ranks = this->Drawn.Ranks)
  {
    cover = ranks->ShowsWater() ? vtkWaterFog::ALL_AND_OPAQUE : vtkWaterFog::PROPS;
    cover = ranks->AreBlended() ? cover : vtkWaterFog::ALL_WITH_DEPTH;
  }
  this->Drawn.Fog->Draw(this->Drawn.Renderer, this->Plan, this->Backdrop, deepColor, extinction,
    this->HasShafts, cover, setLight);
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::SetHazeParameters(vtkShaderProgram* program)
{
  if (!this->Has(WATER_FEATURE_MEDIUM))
  {
    return;
  }
  namespace uniforms = vtkWaterUniforms;
  const vtkWaterLook& look = this->Water->Look;
  const water_plan& plan = *this->Drawn.Plan;
  const double depth = plan.is_submerged ? plan.plane_view[3] : 0.0;
  const double up = plan.side == WATER_BELOW ? -1.0 : 1.0;
  water_haze_input input = water_haze_input();
  water_medium_reflectance(&look.Medium, input.deep);
  this->FindExtinction(input.extinction);
  input.medium = look.Medium;
  input.index = look.Optics.index_of_refraction;
  for (int i = 0; i < 3; ++i)
  {
    input.deep[i] *= plan.daylight[i];
    input.daylight[i] = plan.daylight[i];
    input.sun_color[i] = plan.has_sun ? plan.sun_color[i] : 0.0;
    input.sun_dir[i] = plan.has_sun ? plan.sun_dir[i] : 0.0;
  }
  input.sun_dir[2] *= up;
  const double share = look.HasDeepColor ? 0.0 : water_haze_share(input.extinction[1], depth);
  uniforms::Set(program, "waterHazeShare", share);
  water_haze haze = water_haze();
  if (share > 0.0) // else the deep colour is all
  {
    water_haze_find(&input, &haze);
  }
  const double sunDir[3] = { haze.sun_dir[0], haze.sun_dir[1], up * haze.sun_dir[2] };
  uniforms::Set(program, "waterHazeDepth", depth);
  uniforms::Set3(program, "waterHazeDiffuse", haze.diffuse);
  uniforms::Set3(program, "waterHazeSun", sunDir);
  uniforms::Set3(program, "waterHazeOfParticles", haze.particles);
  uniforms::Set3(program, "waterHazeOfMolecules", haze.molecules);
  uniforms::Set4s(program, "waterHazeSky", 3, haze.sky);
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::BeginLight(const int viewport_px[4])
{
  if (this->Drawn.Plan && this->Has(WATER_FEATURE_CAUSTICS))
  {
    this->BeginCaustics(viewport_px);
    this->BeginShafts(viewport_px);
  }
  if (this->HasBackdrop && this->Drawn.AddsFog)
  {
    this->DrawFog();
  }
}

//------------------------------------------------------------------------------
water_caustics_input vtkWaterSurfaceShader::FindCausticsInput(const int viewport_px[4]) const
{
  const vtkWaterLook& look = this->Water->Look;
  water_caustics_input input = water_caustics_input();
  input.index = look.Optics.index_of_refraction;
  input.slope_rms = look.SlopeRMS;
  double extinction[3];
  this->FindExtinction(extinction);
  input.extinction = *std::min_element(extinction, extinction + 3);
  std::copy_n(viewport_px + 2, 2, input.viewport_px);
  input.max_texture_px = vtkTextureObject::GetMaximumTextureSize(this->GetWindow());
  input.is_software = !this->Has(WATER_FEATURE_HARDWARE_MEDIUM);
  input.port_radius = this->Has(WATER_FEATURE_PORT) ? look.DomePortRadius : 0.0;
  return input;
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::BeginShafts(const int viewport_px[4])
{
  const water_caustics_input input = this->FindCausticsInput(viewport_px);
  if (!this->HasBackdrop || !(this->Water->Look.LightShafts > 0.0) ||
    !water_shafts_plan(&this->Plan, &input, &this->Shafts))
  {
    return; // none are seen
  }
  const bool hadFailed = this->ShaftLight.GetHasFailed();
  const vtkWaterCaustics::Picture none{ nullptr, nullptr, nullptr };
  this->HasShafts = this->ShaftLight.Draw(this->GetWindow(), this->Shafts.light, none,
    GetPhotonShader(this->Features),
    [this](vtkShaderProgram* program) { this->SetPhotonParameters(program); });
  if (this->HasShafts)
  {
    this->Use("waterShaftLight", this->ShaftLight.GetLight());
    this->ShaftLight.GetLight()->Activate();
  }
  else if (this->ShaftLight.GetHasFailed() && !hadFailed) // said once
  {
    vtkErrorWithObjectMacro(this->Water->Actor,
      "the GPU provides no textures for light shafts, or rejects their shaders. The water shows no "
      "light shafts (SetLightShafts).");
  }
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceShader::BeginCaustics(const int viewport_px[4])
{
  vtkOpenGLRenderWindow* window = this->GetWindow();
  const water_caustics_input input = this->FindCausticsInput(viewport_px);
  if (!this->HasBackdrop || !(this->Water->Look.Caustics > 0.0) ||
    !water_caustics_plan(&this->Plan, &input, &this->Light))
  {
    return; // nothing gathers light
  }
  const bool hadFailed = this->Caustics.GetHasFailed();
  const std::string shader = GetPhotonShader(this->Features);
  const vtkWaterCaustics::Picture picture{ this->Backdrop.GetDepth(), this->Plan.plane_clip,
    this->Plan.clip_w };
  this->HasLight = this->Caustics.Draw(window, this->Light, picture, shader,
    [this](vtkShaderProgram* program) { this->SetPhotonParameters(program); });
  if (this->HasLight)
  {
    this->Use("waterCausticLight", this->Caustics.GetLight());
    this->Use("waterBed", this->Caustics.GetBed());
    this->Caustics.GetLight()->Activate();
    this->Caustics.GetBed()->Activate();
  }
  else if (this->Caustics.GetHasFailed() && !hadFailed) // said once
  {
    vtkErrorWithObjectMacro(this->Water->Actor,
      "the GPU provides no textures for caustics, or rejects their shaders. The water shows no "
      "caustics (SetCaustics).");
  }
}
