// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterWarmUp: builds the shader of a water that has not been in view yet, at the end of the
// first frame without it, so that the frame in which it comes into view need not wait for the
// driver. On hardware only: software renderers build it for the state that it is drawn in.
#ifndef vtkWaterWarmUp_h
#define vtkWaterWarmUp_h

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <vector>

class vtkRenderer;
class vtkWaterSource;

class vtkWaterWarmUp
{
public:
  explicit vtkWaterWarmUp(vtkWaterSource& water);
  ~vtkWaterWarmUp();

  // Called whenever a renderer may be about to leave the water out.
  void Expect();

  // The shader is there.
  void SetIsDone();
  bool GetIsDone() const { return this->IsDone; }
  // The water is being drawn for it, without a pixel.
  bool GetIsDrawing() const { return this->IsDrawing; }

private:
  vtkWaterWarmUp(const vtkWaterWarmUp&) = delete;
  void operator=(const vtkWaterWarmUp&) = delete;

  class Command;

  void EndFrame(vtkRenderer* renderer);

  vtkWaterSource& Water;
  vtkSmartPointer<Command> Observer; // of these renderers' EndEvent
  std::vector<vtkWeakPointer<vtkRenderer>> Renderers;
  bool IsDone = false;
  bool IsDrawing = false;
};

#endif
