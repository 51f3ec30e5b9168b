// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterRenderPassKeys.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkWaterAccess.h"
#include "vtkWaterProps.h"

#include <algorithm>

namespace
{
using Passes = std::vector<vtkSmartPointer<vtkObjectBase>>;

Passes GetPasses(vtkProp* prop)
{
  Passes passes;
  vtkInformation* keys = prop->GetPropertyKeys();
  if (keys && keys->Has(vtkOpenGLRenderPass::RenderPasses()))
  {
    const int count = keys->Length(vtkOpenGLRenderPass::RenderPasses());
    for (int i = 0; i < count; ++i)
    {
      passes.emplace_back(keys->Get(vtkOpenGLRenderPass::RenderPasses(), i));
    }
  }
  return passes;
}

void SetPasses(vtkProp* prop, const Passes& passes)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  // one by one: Append counts a reference twice, and only this Remove takes back both
  for (vtkObjectBase* pass : GetPasses(prop))
  {
    keys->Remove(vtkOpenGLRenderPass::RenderPasses(), pass);
  }
  for (vtkObjectBase* pass : passes)
  {
    keys->Append(vtkOpenGLRenderPass::RenderPasses(), pass);
  }
}

}

//------------------------------------------------------------------------------
bool vtkWaterRenderPassKeys::Has(vtkProp* prop, vtkOpenGLRenderPass* key)
{
  const Passes passes = GetPasses(prop);
  return std::find(passes.begin(), passes.end(), key) != passes.end();
}

//------------------------------------------------------------------------------
bool vtkWaterRenderPassKeys::HasOthers(vtkProp* prop, vtkOpenGLRenderPass* key)
{
  const Passes passes = GetPasses(prop);
  return std::any_of(
    passes.begin(), passes.end(), [key](vtkObjectBase* pass) { return pass != key; });
}

//------------------------------------------------------------------------------
void vtkWaterRenderPassKeys::Add(vtkProp* prop, vtkOpenGLRenderPass* key)
{
  if (Has(prop, key))
  {
    return;
  }
  if (!prop->GetPropertyKeys())
  {
    // silently: a key for a frame is no change of the prop
    vtkWaterAccess::Prop::PropertyKeysOf(prop) = vtkInformation::New();
  }
  prop->GetPropertyKeys()->Append(vtkOpenGLRenderPass::RenderPasses(), key);
}

//------------------------------------------------------------------------------
void vtkWaterRenderPassKeys::Remove(vtkProp* prop, vtkOpenGLRenderPass* key)
{
  Remove(prop->GetPropertyKeys(), key);
}

//------------------------------------------------------------------------------
void vtkWaterRenderPassKeys::Remove(vtkInformation* keys, vtkOpenGLRenderPass* key)
{
  if (keys && keys->Has(vtkOpenGLRenderPass::RenderPasses()))
  {
    keys->Remove(vtkOpenGLRenderPass::RenderPasses(), key);
    if (keys->Length(vtkOpenGLRenderPass::RenderPasses()) == 0)
    {
      keys->Remove(vtkOpenGLRenderPass::RenderPasses());
    }
  }
}

//------------------------------------------------------------------------------
bool vtkWaterRenderPassKeys::IsBakingShadows(vtkProp* prop)
{
  const Passes passes = GetPasses(prop);
  return std::any_of(passes.begin(), passes.end(),
    [](vtkObjectBase* pass) { return pass->IsA("vtkShadowMapBakerPass"); });
}

//------------------------------------------------------------------------------
vtkWaterForeignKeysSuspended::vtkWaterForeignKeysSuspended(
  vtkOpenGLRenderPass* key, vtkRenderer* renderer)
{
  const Passes alone{ key };
  vtkWaterProps::ForEach(renderer->GetViewProps(), [&](vtkProp* prop) {
    Passes passes = GetPasses(prop);
    if (!passes.empty() && passes != alone)
    {
      SetPasses(prop, alone);
      this->Saved.push_back(SavedKeys{ prop, std::move(passes) });
    }
  });
}

//------------------------------------------------------------------------------
vtkWaterForeignKeysSuspended::~vtkWaterForeignKeysSuspended()
{
  for (SavedKeys& saved : this->Saved)
  {
    SetPasses(saved.Prop, saved.Passes);
  }
}
