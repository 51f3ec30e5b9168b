// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSecondaryLookup: what the other waters in a mirrored view look up, if they reflect the
// scene there. The mirrored view's reflection implements it.
#ifndef vtkWaterSecondaryLookup_h
#define vtkWaterSecondaryLookup_h

#include "vtkWaterSurfaceShader.h"

class vtkProp;

class vtkWaterSecondaryLookup
{
public:
  virtual ~vtkWaterSecondaryLookup() = default;

  // The inputs of another water's draw, from its secondary view.
  //
  // Returns false if it has none in this frame: it reflects the sky alone.
  virtual bool Find(const vtkProp* water, vtkWaterSurfaceShader::Inputs& inputs) = 0;
};

#endif
