// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterClipDistance: GL's first clip distance, which VTK knows nothing of. It is on while a
// shader that writes the distance draws, and never for one that does not: what it cuts is undefined
// then.
#ifndef vtkWaterClipDistance_h
#define vtkWaterClipDistance_h

#include "vtkWaterGL.h"

class vtkWaterClipDistance
{
public:
  void On() { this->Set(true); }
  void Off() { this->Set(false); }
  bool GetIsOn() const { return this->IsOn; }

  // A state that changes from draw to draw costs more than what it is for.
  void Set(bool isOn)
  {
    if (this->IsOn != isOn)
    {
      isOn ? glEnable(GL_CLIP_DISTANCE0) : glDisable(GL_CLIP_DISTANCE0);
      this->IsOn = isOn;
    }
  }

private:
  bool IsOn = false;
};

#endif
