// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterReflectionPassInternals.h: what vtkWaterReflectionPass keeps, for its source files.
#ifndef vtkWaterReflectionPassInternals_h
#define vtkWaterReflectionPassInternals_h

#include "vtkCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWaterGather.h"
#include "vtkWaterMirroredView.h"
#include "vtkWaterOcclusion.h"
#include "vtkWaterReflectionPass.h"
#include "vtkWaterSignature.h"
#include "vtkWeakPointer.h"
#include "water_quality.h"

#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

struct vtkWaterReflectionPass::Internals
{
  struct View // what belongs to one eye of a renderer
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    vtkWaterMirroredView Mirror;
    water_plan DrawnPlan = water_plan(); // what the mirror shows was drawn by it
    vtkWaterSignature DrawnSignature;
    bool HasLevels = false;
    vtkWaterOcclusion Occlusion;
    water_quality_state Quality = water_quality_state(); // of the time budget
    int ErrorStep = WATER_QUALITY_NO_STEP;               // of the target error
  };
  using Eye = std::pair<vtkRenderer*, bool>; // is it the second of two?

  std::map<Eye, std::shared_ptr<View>> Views; // shared: a view in use outlives its release
  vtkWaterGather Gather;
  std::vector<water_cull_reason> Reasons;
  int ReasonCounts[WATER_CULL_REASON_COUNT] = {};
  water_plan Plan = water_plan();
  int MostSteps = VTK_INT_MAX; // of the march, in this frame
  int MostProbes = VTK_INT_MAX;
  vtkWeakPointer<vtkRenderer> PlannedFor;
  bool PlannedForSecondEye = false;
  std::vector<vtkWaterActor*> PlannedWaters; // compared only
  vtkMTimeType PlannedFrame = 0;
  std::set<vtkRenderer*> Rendering; // in the middle of Render
  bool HasCycle = false;
  bool IsVisiting = false; // the chain of delegates

  static bool IsSecondEye(vtkRenderer* renderer)
  {
    vtkCamera* camera = renderer->GetActiveCamera();
    return camera->GetStereo() && !camera->GetLeftEye();
  }

  std::shared_ptr<View> GetView(vtkRenderer* renderer)
  {
    const Eye eye(renderer, IsSecondEye(renderer));
    for (auto it = this->Views.begin(); it != this->Views.end();)
    {
      it = it->second->Renderer || it->first == eye ? std::next(it) : this->Views.erase(it);
    }
    std::shared_ptr<View>& view = this->Views[eye];
    if (!view)
    {
      view = std::make_shared<View>();
    }
    view->Renderer = renderer;
    return view;
  }

  View* GetPlannedView()
  {
    auto found = this->Views.find(Eye(this->PlannedFor, this->PlannedForSecondEye));
    return found == this->Views.end() ? nullptr : found->second.get();
  }

  // What the instruments of the planned view say, with the context that they measured in: another
  // window's may be current.
  template <typename Value, typename Question>
  Value Ask(Value none, Question question)
  {
    View* view = this->GetPlannedView();
    vtkRenderer* renderer = view ? view->Renderer.Get() : nullptr;
    auto* window =
      vtkOpenGLRenderWindow::SafeDownCast(renderer ? renderer->GetRenderWindow() : nullptr);
    if (!window)
    {
      return none;
    }
    window->PushContext();
    const Value value = question(view->Mirror.GetInstruments());
    window->PopContext();
    return value;
  }
};

#endif
