// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterClipDistance: one of GL's clip distances, which VTK knows nothing of. It is on while a
// shader that writes the distance draws, and never for one that does not: what it cuts is undefined
// then.
#ifndef vtkWaterClipDistance_h
#define vtkWaterClipDistance_h

#include "vtkWaterGL.h"

class vtkWaterClipDistance
{
public:
  // number  0: the water's plane in the mirrored view; 1: the shore
  explicit vtkWaterClipDistance(unsigned int number = 0)
    : Number(number)
  {
  }

  void On() { this->Set(true); }
  void Off() { this->Set(false); }
  bool GetIsOn() const { return this->IsOn; }

  // A state that changes from draw to draw costs more than what it is for.
  void Set(bool isOn)
  {
    if (this->IsOn != isOn)
    {
      const GLenum distance = GL_CLIP_DISTANCE0 + this->Number;
      isOn ? glEnable(distance) : glDisable(distance);
      this->IsOn = isOn;
    }
  }

private:
  unsigned int Number;
  bool IsOn = false;
};

#endif
