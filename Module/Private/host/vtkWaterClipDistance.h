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
  void On() { glEnable(GL_CLIP_DISTANCE0); }
  void Off() { glDisable(GL_CLIP_DISTANCE0); }
};

#endif
