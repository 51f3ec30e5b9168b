// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterRenderPassKeys: puts a pass into the RenderPasses lists of props, and takes it out again.
//
// A mapper asks the passes of its prop's list to change its shaders, and builds them anew whenever
// the list changes: so a list must be the same in the mirrored and in the main view.
#ifndef vtkWaterRenderPassKeys_h
#define vtkWaterRenderPassKeys_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkInformation;
class vtkObjectBase;
class vtkOpenGLRenderPass;
class vtkProp;
class vtkRenderer;

namespace vtkWaterRenderPassKeys
{
bool Has(vtkProp* prop, vtkOpenGLRenderPass* key);
bool HasOthers(vtkProp* prop, vtkOpenGLRenderPass* key); // than that one

// Puts the key on a prop, once.
void Add(vtkProp* prop, vtkOpenGLRenderPass* key);
void Remove(vtkProp* prop, vtkOpenGLRenderPass* key);
void Remove(vtkInformation* keys, vtkOpenGLRenderPass* key);

// Is a prop being drawn for a shadow map, by a light's camera?
bool IsBakingShadows(vtkProp* prop);
}

// For a mirrored view that is drawn in the middle of the main one: other passes have put their keys
// on the props, which would act on framebuffers that are not bound now. While an object of this
// class lives, the renderer's props carry one key alone.
class vtkWaterForeignKeysSuspended
{
public:
  vtkWaterForeignKeysSuspended(vtkOpenGLRenderPass* key, vtkRenderer* renderer);
  ~vtkWaterForeignKeysSuspended();
  vtkWaterForeignKeysSuspended(const vtkWaterForeignKeysSuspended&) = delete;
  void operator=(const vtkWaterForeignKeysSuspended&) = delete;

private:
  struct SavedKeys
  {
    vtkSmartPointer<vtkProp> Prop;
    std::vector<vtkSmartPointer<vtkObjectBase>> Passes;
  };
  std::vector<SavedKeys> Saved;
};

#endif
