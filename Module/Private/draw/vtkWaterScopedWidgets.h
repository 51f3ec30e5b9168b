// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterScopedWidgets: draws of what widgets draw, without building it anew for the camera of the
// mirrored view.
//
// Their representations are sized in pixels, and are built when the camera is newer than what was
// built last. Built for the mirrored camera they would stay so in the picture, too: the user's is
// older. The bounds, which are gathered before, bring them up to date for the user's camera.
#ifndef vtkWaterScopedWidgets_h
#define vtkWaterScopedWidgets_h

#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"

#include <vector>

class vtkCamera;
class vtkProp;
class vtkRenderer;

// While an object of this class lives, the renderer's active camera, the mirrored one, is older
// than everything, if a prop is of a widget.
class vtkWaterScopedWidgets
{
public:
  vtkWaterScopedWidgets(vtkRenderer* renderer, vtkProp* prop);
  vtkWaterScopedWidgets(vtkRenderer* renderer, const std::vector<vtkProp*>& props);
  ~vtkWaterScopedWidgets();

private:
  vtkWaterScopedWidgets(const vtkWaterScopedWidgets&) = delete;
  void operator=(const vtkWaterScopedWidgets&) = delete;

  void Begin(vtkRenderer* renderer);

  vtkSmartPointer<vtkCamera> Camera; // nullptr: none is
  vtkTimeStamp Time;
};

#endif
