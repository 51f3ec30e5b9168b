// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPropFacts: what is known of a prop when it is drawn, and a draw that does not ask for it
// again. See Documentation/decisions/015-prop-records.md.
#ifndef vtkWaterPropFacts_h
#define vtkWaterPropFacts_h

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkWeakPointer.h"

struct vtkWaterPropFacts
{
  bool MayBeCut = true;    // by the clip at the water
  bool IsUpToDate = false; // an actor whose data are
  bool IsOpaque = false;   // an actor, all of it
};

// While an object of this class lives, VTK does not check whether data are up to date and whether
// an actor is opaque: these checks take a third of the draw of a small actor. No event is sent.
class vtkWaterScopedFacts
{
public:
  vtkWaterScopedFacts(vtkProp* prop, const vtkWaterPropFacts& facts);
  ~vtkWaterScopedFacts();

private:
  vtkWaterScopedFacts(const vtkWaterScopedFacts&) = delete;
  void operator=(const vtkWaterScopedFacts&) = delete;

  vtkWeakPointer<vtkMapper> Mapper; // the user's observers may drop both
  vtkWeakPointer<vtkActor> Actor;
  vtkTypeBool WasStatic = 0;
  bool WasForced = false;
};

#endif
