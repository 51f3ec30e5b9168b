// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterTranslucentLayer.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkWaterGL.h"
#include "vtkWaterShaderHook.h"
#include "vtkWaterTranslucent.h"
#include "vtkWaterUniforms.h"
#include "vtkWaterVolumeDepthFS.h"
#include "water_volume_planes.h"

#include <algorithm>

namespace
{
void DrawPolygons(vtkRenderer* renderer, const std::vector<vtkProp*>& props)
{
  for (vtkProp* prop : props)
  {
    prop->RenderTranslucentPolygonalGeometry(renderer);
  }
}
}

//------------------------------------------------------------------------------
bool vtkWaterTranslucentLayer::IsNeeded(
  const std::vector<vtkProp*>& props, const std::vector<vtkProp*>& others)
{
  return vtkWaterTranslucent::HasPolygons(props) ||
    std::any_of(others.begin(), others.end(), vtkWaterProps::HoldsVolume);
}

//------------------------------------------------------------------------------
bool vtkWaterTranslucentLayer::Keep(vtkOpenGLRenderWindow* window, vtkWaterTarget& reflection)
{
  if (!this->Opaque.EnsureAs(window, reflection, false) ||
    !this->Layer.EnsureAs(window, reflection, true))
  {
    return false;
  }
  window->GetState()->vtkglDisable(GL_SCISSOR_TEST); // which cuts copies
  this->Opaque.CopyFrom(reflection, GL_COLOR_BUFFER_BIT);
  this->Layer.CopyFrom(reflection, GL_DEPTH_BUFFER_BIT);
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterTranslucentLayer::KeepDepth(
  vtkOpenGLRenderWindow* window, vtkWaterTarget& reflection, bool hasSamples, bool hasOpaque)
{
  if (!this->Layer.EnsureAs(window, reflection, hasSamples) ||
    (hasOpaque && !this->Opaque.EnsureAs(window, reflection, false)))
  {
    return false;
  }
  window->GetState()->vtkglDisable(GL_SCISSOR_TEST); // which cuts copies
  if (hasOpaque)
  {
    this->Opaque.CopyFrom(reflection, GL_COLOR_BUFFER_BIT, true);
  }
  this->Layer.CopyFrom(reflection, GL_DEPTH_BUFFER_BIT, !hasSamples);
  return true;
}

//------------------------------------------------------------------------------
vtkOpenGLFramebufferObject* vtkWaterTranslucentLayer::Resolve()
{
  this->Layer.Resolve();
  return this->Layer.GetResolved();
}

//------------------------------------------------------------------------------
void vtkWaterTranslucentLayer::Draw(vtkRenderer* renderer, vtkWaterShaderHook* hook,
  const water_plan& plan, std::vector<vtkProp*>& props, vtkWaterTranslucent& translucent)
{
  this->DrawColors(renderer, props, translucent);
  this->DrawDepths(renderer, hook, plan, props);
  static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())
    ->GetState()
    ->vtkglDisable(GL_SCISSOR_TEST);
  this->Layer.Resolve();
}

//------------------------------------------------------------------------------
void vtkWaterTranslucentLayer::DrawColors(
  vtkRenderer* renderer, std::vector<vtkProp*>& props, vtkWaterTranslucent& translucent)
{
  vtkOpenGLState* state =
    static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  translucent.DrawPolygons(renderer, props, this->Layer.GetFramebuffer());
  if (!translucent.LeavesAlpha())
  {
    this->DrawAlpha(renderer, props);
  }
  translucent.DrawVolumes(renderer, props);
}

//------------------------------------------------------------------------------
void vtkWaterTranslucentLayer::DrawAlpha(vtkRenderer* renderer, const std::vector<vtkProp*>& props)
{
  vtkOpenGLState* state =
    static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
  const vtkOpenGLState::ScopedglColorMask colorMask(state);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  DrawPolygons(renderer, props); // whatever their order
}

//------------------------------------------------------------------------------
void vtkWaterTranslucentLayer::DrawDepths(vtkRenderer* renderer, vtkWaterShaderHook* hook,
  const water_plan& plan, const std::vector<vtkProp*>& props)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglColorMask colorMask(state);
  const vtkOpenGLState::ScopedglDepthMask depthMask(state);
  const vtkOpenGLState::ScopedglDepthFunc depthFunc(state);
  const vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglEnable(GL_DEPTH_TEST);
  hook->SetDepthWriter(state);
  DrawPolygons(renderer, props);
  hook->SetDepthWriter(nullptr);
  for (vtkProp* prop : props)
  {
    if (vtkWaterProps::HoldsVolume(prop))
    {
      for (const vtkWaterProps::Box& box : vtkWaterProps::GetVolumeBoxes(prop))
      {
        this->DrawVolumeDepth(window, plan, box);
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterTranslucentLayer::DrawVolumeDepth(
  vtkOpenGLRenderWindow* window, const water_plan& plan, const vtkWaterProps::Box& box)
{
  double sides[WATER_VOLUME_PLANES_COUNT][4];
  if (water_volume_planes_make(&plan, box.Bounds.data(), box.BoxToWorld.data(), sides) != WATER_OK)
  {
    return;
  }
  vtkShaderProgram* program = this->VolumeDepth.Ready(window, vtkWaterVolumeDepthFS);
  if (!program)
  {
    return;
  }
  float values[WATER_VOLUME_PLANES_COUNT][4];
  std::copy(&sides[0][0], &sides[0][0] + 4 * WATER_VOLUME_PLANES_COUNT, &values[0][0]);
  program->SetUniform4fv("waterSides", WATER_VOLUME_PLANES_COUNT, values);
  vtkWaterUniforms::Set4(program, "waterReflectionW", plan.reflection_w);
  window->GetState()->vtkglDepthMask(GL_TRUE); // actors may have left another
  this->VolumeDepth.Draw();
}

//------------------------------------------------------------------------------
void vtkWaterTranslucentLayer::MakeLevels()
{
  this->Opaque.MakeLevels();
  this->Layer.MakeLevels();
}

//------------------------------------------------------------------------------
void vtkWaterTranslucentLayer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Opaque.ReleaseGraphicsResources(window);
  this->Layer.ReleaseGraphicsResources(window);
  this->VolumeDepth.ReleaseGraphicsResources();
}
