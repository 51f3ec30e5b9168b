// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFrameThread: what the frames of one thread share: the key on the props, and which window
// was drawn last.
#ifndef vtkWaterFrameThread_h
#define vtkWaterFrameThread_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkWaterClipProbe.h"
#include "vtkWaterFrame.h"
#include "vtkWaterShaderHook.h"
#include "vtkWeakPointer.h"

#include <map>
#include <memory>
#include <vector>

class vtkCallbackCommand;
class vtkRenderWindow;
class vtkRenderer;

struct vtkWaterFrameThread
{
  // It lives as long as the thread.
  static vtkWaterFrameThread& Get();

  vtkWaterFrameThread();
  ~vtkWaterFrameThread();

  // Forgets the frames of renderers that are gone.
  void Prune();

  // A frame for a window begins: whatever its props hold for other windows is freed.
  //
  // props  of the renderer: at least those that another one has, too
  void SwitchTo(vtkRenderer* renderer, const std::vector<vtkProp*>& props);

  // A frame has ended: what a new window would free in the middle of its own is freed.
  //
  // props  as above
  static void PrepareForNewWindows(vtkRenderer* renderer, const std::vector<vtkProp*>& props);

  vtkNew<vtkWaterShaderHook> Hook;
  vtkWaterClipProbe ClipProbe;
  std::map<vtkRenderer*, std::unique_ptr<vtkWaterFrame>> Frames;

private:
  void WatchOtherWindows(vtkProp* prop, vtkRenderWindow* window);
  void SetLastWindow(vtkRenderWindow* window);

  // that a frame was begun for; nullptr: another one with props of it has been drawn since
  vtkWeakPointer<vtkRenderWindow> LastWindow;
  vtkSmartPointer<vtkCallbackCommand> Elsewhere; // of the renderers of such windows
};

#endif
