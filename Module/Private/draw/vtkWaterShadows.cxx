// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterShadows.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRenderState.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkTextureObject.h"
#include "vtkWaterAccess.h"
#include "vtkWaterPasses.h"

#include <algorithm>
#include <iterator>

namespace
{
// Draws by a function.
class DrawPass : public vtkRenderPass
{
public:
  static DrawPass* New();
  vtkTypeMacro(DrawPass, vtkRenderPass);
  void Render(const vtkRenderState*) override { this->Function(); }

  std::function<void()> Function;
};
vtkStandardNewMacro(DrawPass);

// The maps that are in use: the picture is being drawn with them.
std::vector<vtkTextureObject*> GetActiveMaps(vtkShadowMapPass* pass)
{
  std::vector<vtkTextureObject*> active;
  if (auto* maps = pass->GetShadowMapBakerPass()->GetShadowMaps())
  {
    std::copy_if(maps->begin(), maps->end(), std::back_inserter(active),
      [](vtkTextureObject* map) { return map && map->GetTextureUnit() >= 0; });
  }
  return active;
}

// The pass draws something else while an object of this class lives. Afterwards it is as it was,
// also when it was drawing already: a nested mirrored view.
struct ScopedPass
{
  ScopedPass(vtkShadowMapPass* pass, vtkRenderPass* drawn)
    : Pass(pass)
    , Sequence(vtkWaterAccess::ShadowMapPass::OpaqueSequenceOf(pass))
    , User(this->Sequence)
    , Transforms(vtkWaterAccess::ShadowMapPass::TransformsOf(pass))
    , Active(GetActiveMaps(pass))
  {
    this->Sequence = drawn;
  }
  ~ScopedPass()
  {
    this->Sequence = this->User;
    vtkWaterAccess::ShadowMapPass::TransformsOf(this->Pass) = this->Transforms;
    for (vtkTextureObject* map : this->Active)
    {
      map->Activate(); // gets the unit that it has just given back
    }
  }

  vtkShadowMapPass* Pass;
  vtkRenderPass*& Sequence;
  vtkRenderPass* User;
  std::vector<double> Transforms;
  std::vector<vtkTextureObject*> Active;
};
}

//------------------------------------------------------------------------------
vtkShadowMapPass* vtkWaterShadows::Find(vtkRenderer* renderer)
{
  vtkShadowMapPass* pass = nullptr;
  if (renderer->GetPass())
  {
    vtkWaterPasses::Visit(renderer->GetPass(), [&pass](vtkRenderPass* next) {
      pass = vtkShadowMapPass::SafeDownCast(next);
      return pass != nullptr;
    });
  }
  else if (renderer->GetUseShadows())
  {
    vtkShadowMapPass*& own =
      vtkWaterAccess::OpenGLRenderer::ShadowMapPassOf(static_cast<vtkOpenGLRenderer*>(renderer));
    if (!own)
    {
      own = vtkShadowMapPass::New(); // as the renderer does when it comes to it
    }
    pass = own;
  }
  return pass && pass->GetShadowMapBakerPass() ? pass : nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterShadows::Bake(vtkRenderer* renderer, vtkShadowMapPass* pass)
{
  if (!GetActiveMaps(pass).empty())
  {
    return; // they were baked for the picture, in the middle of which the mirrored view is drawn
  }
  vtkRenderState state(renderer);
  state.SetPropArrayAndCount(
    vtkWaterAccess::Renderer::PropsOf(renderer), vtkWaterAccess::Renderer::PropCountOf(renderer));
  pass->GetShadowMapBakerPass()->Render(&state);
  // it leaves the lights where the last light's camera had them
  if (renderer->GetLightFollowCamera())
  {
    renderer->UpdateLightsGeometryToFollowCamera();
  }
  static_cast<vtkOpenGLRenderer*>(renderer)->UpdateLights();
}

//------------------------------------------------------------------------------
void vtkWaterShadows::Draw(vtkRenderer* renderer, vtkShadowMapPass* pass,
  std::vector<vtkProp*>& props, const std::function<void()>& draw)
{
  if (!pass || !pass->GetShadowMapBakerPass()->GetHasShadows())
  {
    draw();
    return;
  }
  vtkNew<DrawPass> drawn;
  drawn->Function = draw;
  vtkRenderState state(renderer);
  state.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  ScopedPass scopedPass(pass, drawn);
  pass->Render(&state);
}
