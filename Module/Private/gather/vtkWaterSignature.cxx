// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSignature.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkVersionMacros.h"
#include "vtkWaterPropRecords.h"
#include "vtkWaterProps.h"

#include <algorithm>
#include <cstring>

//------------------------------------------------------------------------------
void vtkWaterSignature::Read(vtkRenderer* renderer)
{
  this->Values.clear();
  this->AddRenderer(renderer);
  this->AddNumber(renderer->GetRenderWindow()->GetDesiredUpdateRate()); // volumes sample by it
  this->Add(static_cast<vtkMTimeType>(vtkMapper::GetResolveCoincidentTopology()));
  double offsets[6] = {};
  vtkMapper::GetResolveCoincidentTopologyPolygonOffsetParameters(offsets[0], offsets[1]);
  vtkMapper::GetResolveCoincidentTopologyLineOffsetParameters(offsets[2], offsets[3]);
  vtkMapper::GetResolveCoincidentTopologyPointOffsetParameter(offsets[4]);
  offsets[5] = vtkMapper::GetResolveCoincidentTopologyZShift();
  for (const double offset : offsets)
  {
    this->AddNumber(offset);
  }

  vtkLightCollection* lights = renderer->GetLights();
  this->Values.emplace_back(lights, lights->GetMTime());
  vtkCollectionSimpleIterator it;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    vtkMatrix4x4* matrix = light->GetTransformMatrix();
    this->Values.emplace_back(
      light, std::max(light->GetMTime(), matrix ? matrix->GetMTime() : vtkMTimeType(0)));
  }
  this->Textures.Clear();
  this->Textures.AddTexture(renderer->GetEnvironmentTexture());
  this->Textures.AddTexture(renderer->GetBackgroundTexture());
  this->Textures.AddTexture(renderer->GetRightBackgroundTexture());
}

//------------------------------------------------------------------------------
void vtkWaterSignature::AddNumber(double value)
{
  vtkMTimeType bits = 0;
  std::memcpy(&bits, &value, std::min(sizeof bits, sizeof value));
  this->Add(bits);
}

//------------------------------------------------------------------------------
void vtkWaterSignature::AddSky(const water_sky& sky, const vtkWaterSkyTextures& textures)
{
  for (vtkTexture* texture : { textures.Screen.Get(), textures.Map.Get(), textures.Floor.Get() })
  {
    this->Textures.AddTexture(texture);
  }
  this->Add(static_cast<vtkMTimeType>(sky.screen));
  this->Add(static_cast<vtkMTimeType>(sky.map.kind));
  for (int i = 0; i < 3; ++i) // a kept background's are not the renderer's
  {
    this->AddNumber(sky.bottom[i]);
    this->AddNumber(sky.top[i]);
  }
  for (const double value : sky.map.to_map)
  {
    this->AddNumber(value); // a renderer's rotation of its surroundings is not in its other numbers
  }
}

//------------------------------------------------------------------------------
void vtkWaterSignature::AddShadows(
  vtkRenderer* renderer, vtkShadowMapPass* pass, vtkWaterPropRecords& records)
{
  this->Values.emplace_back(pass, pass->GetMTime());
  this->Values.emplace_back(
    pass->GetShadowMapBakerPass(), pass->GetShadowMapBakerPass()->GetMTime());
  for (size_t i = 0; i < records.GetCount(); ++i)
  {
    vtkProp* prop = records.GetProp(i);
    if (prop->GetVisibility() && !vtkWaterProps::IsOverlay(prop))
    {
      this->AddProp(prop, records.GetOwnStamp(renderer, i));
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterSignature::AddRenderer(vtkRenderer* renderer)
{
  // One by one: its time says too much, as any change of the camera counts, and taking a picture of
  // the window changes it twice.
  for (int i = 0; i < 3; ++i)
  {
    this->AddNumber(renderer->GetBackground()[i]);
    this->AddNumber(renderer->GetBackground2()[i]);
    this->AddNumber(renderer->GetAmbient()[i]);
    this->AddNumber(renderer->GetEnvironmentUp()[i]);
    this->AddNumber(renderer->GetEnvironmentRight()[i]);
  }
  this->AddNumber(renderer->GetBackgroundAlpha());
  this->AddNumber(renderer->GetOcclusionRatio());
  for (const int flag : { static_cast<int>(renderer->GetGradientBackground()),
         static_cast<int>(renderer->GetTexturedBackground()),
         static_cast<int>(renderer->GetTwoSidedLighting()),
         static_cast<int>(renderer->GetUseDepthPeeling()),
         static_cast<int>(renderer->GetUseDepthPeelingForVolumes()),
         static_cast<int>(renderer->GetMaximumNumberOfPeels()),
         static_cast<int>(renderer->GetUseImageBasedLighting()),
         static_cast<int>(renderer->GetUseSSAO()), static_cast<int>(renderer->GetUseShadows()),
         static_cast<int>(renderer->GetUseHiddenLineRemoval()) })
  {
    this->Add(static_cast<vtkMTimeType>(flag));
  }
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 5, 0)
  this->Add(renderer->GetUseOIT() ? 1 : 0);
#endif
  auto* openGL = vtkOpenGLRenderer::SafeDownCast(renderer);
  this->Add(openGL && openGL->GetUseSphericalHarmonics() ? 1 : 0);
}

//------------------------------------------------------------------------------
bool vtkWaterSignature::IsSameAs(const vtkWaterSignature& other) const
{
  return this->Textures.AreSameAs(other.Textures) && this->Values == other.Values;
}
