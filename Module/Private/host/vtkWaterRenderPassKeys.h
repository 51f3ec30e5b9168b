// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterRenderPassKeys: puts a pass into the RenderPasses lists of props, and takes it out again.
//
// A mapper asks the passes of its prop's list to change its shaders, and builds them anew whenever
// the list changes: so a list must be the same in the mirrored and in the main view.
#ifndef vtkWaterRenderPassKeys_h
#define vtkWaterRenderPassKeys_h

#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <map>
#include <vector>

class vtkCallbackCommand;
class vtkObjectBase;
class vtkOpenGLRenderPass;
class vtkProp;
class vtkRenderWindow;
class vtkRenderer;

class vtkWaterRenderPassKeys
{
public:
  // key  the pass; not held, it owns this object
  explicit vtkWaterRenderPassKeys(vtkOpenGLRenderPass* key);
  ~vtkWaterRenderPassKeys();

  // Puts the key on a prop, once.
  void Add(vtkProp* prop);

  // Puts the key on every visible prop of the renderer until the frame ends (its EndEvent,
  // or the StartEvent of the next).
  void HoldUntilEndOfFrame(vtkRenderer* renderer);

  // A number of the frame for which the renderer's props are held, never used twice; 0: they are
  // not held.
  vtkMTimeType GetFrame(vtkRenderer* renderer) const;

  // The window of the frame that began last; nullptr: none has, or it is gone.
  vtkRenderWindow* GetWindow() const;

  // Is a prop being drawn for a shadow map, by a light's camera?
  static bool IsBakingShadows(vtkProp* prop);

private:
  vtkWaterRenderPassKeys(const vtkWaterRenderPassKeys&) = delete;
  void operator=(const vtkWaterRenderPassKeys&) = delete;

  struct HeldFrame
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    std::vector<vtkSmartPointer<vtkProp>> Props;
    vtkSmartPointer<vtkCallbackCommand> Observer; // nullptr: not held
    vtkTimeStamp Frame;
  };

  bool Has(vtkProp* prop) const;
  void Remove(vtkProp* prop);
  void WatchOtherWindows(vtkProp* prop, vtkRenderWindow* window);
  void EndFrame(HeldFrame& held);

  vtkOpenGLRenderPass* Key;
  std::map<vtkRenderer*, HeldFrame> HeldFrames;
  // that a frame was held for; nullptr: another one with props of it has been drawn since
  vtkWeakPointer<vtkRenderWindow> LastWindow;
  vtkSmartPointer<vtkCallbackCommand> Elsewhere; // of the renderers of such windows
};

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
