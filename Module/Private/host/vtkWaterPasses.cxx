// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterPasses.h"

#include "vtkCameraPass.h"
#include "vtkImageProcessingPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSequencePass.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <set>

namespace
{
// Those that draw into what is bound, or into textures of bytes, and lead to no others than Visit
// knows. A class derived from one has another name, and may do anything.
const char* const kOfBytes[] = { "vtkCameraPass", "vtkClearZPass", "vtkDefaultPass",
  "vtkDepthOfFieldPass", "vtkGaussianBlurPass", "vtkLightsPass", "vtkOpaquePass",
  "vtkOpenGLFXAAPass", "vtkOverlayPass", "vtkPointFillPass", "vtkRenderStepsPass",
  "vtkSequencePass", "vtkSobelGradientMagnitudePass", "vtkTranslucentPass", "vtkVolumetricPass",
  "vtkWaterReflectionPass" };

// visited  chains may lead back to themselves
bool VisitOnce(vtkRenderPass* pass, const std::function<bool(vtkRenderPass*)>& function,
  std::set<vtkRenderPass*>& visited)
{
  if (!pass || !visited.insert(pass).second)
  {
    return false;
  }
  const auto visit = [&](vtkRenderPass* next) { return VisitOnce(next, function, visited); };
  if (function(pass))
  {
    return true;
  }
  if (auto* sequence = vtkSequencePass::SafeDownCast(pass))
  {
    vtkRenderPassCollection* parts = sequence->GetPasses();
    for (int i = 0; parts && i < parts->GetNumberOfItems(); ++i)
    {
      if (visit(vtkRenderPass::SafeDownCast(parts->GetItemAsObject(i))))
      {
        return true;
      }
    }
    return false;
  }
  if (auto* camera = vtkCameraPass::SafeDownCast(pass))
  {
    return visit(camera->GetDelegatePass());
  }
  if (auto* image = vtkImageProcessingPass::SafeDownCast(pass))
  {
    return visit(image->GetDelegatePass());
  }
  if (pass->IsA("vtkWaterReflectionPass"))
  {
    return visit(vtkWaterPasses::DelegateOf(pass));
  }
  auto* steps = vtkRenderStepsPass::SafeDownCast(pass);
  return steps &&
    (visit(steps->GetOpaquePass()) || visit(steps->GetCameraPass()) ||
      visit(steps->GetLightsPass()) || visit(steps->GetTranslucentPass()) ||
      visit(steps->GetVolumetricPass()) || visit(steps->GetOverlayPass()) ||
      visit(steps->GetPostProcessPass()));
}
}

//------------------------------------------------------------------------------
void vtkWaterPasses::Visit(
  vtkRenderPass* first, const std::function<bool(vtkRenderPass*)>& function)
{
  std::set<vtkRenderPass*> visited;
  VisitOnce(first, function, visited);
}

//------------------------------------------------------------------------------
bool vtkWaterPasses::MayKeepFloats(vtkRenderPass* first)
{
  bool mayKeep = false;
  Visit(first, [&mayKeep](vtkRenderPass* pass) {
    const char* name = pass->GetClassName();
    mayKeep = std::none_of(std::begin(kOfBytes), std::end(kOfBytes),
      [name](const char* known) { return std::strcmp(name, known) == 0; });
    return mayKeep;
  });
  return mayKeep;
}
