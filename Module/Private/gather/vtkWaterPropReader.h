// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPropReader: a prop -> water_prop: what the plan must know of it.
#ifndef vtkWaterPropReader_h
#define vtkWaterPropReader_h

#include "water_types.h"

class vtkProp;
struct vtkWaterSnapshot;

namespace vtkWaterPropReader
{
// What is drawn for a prop in the mirrored view: the prop, or what stands in for it.
vtkProp* FindDrawn(vtkProp* prop);

// drawn      the prop or its stand-in, which has the place
// mirrored   the water that is mirrored at
// isRefused  the driver refuses its shader with the lines that reflections need
water_prop Read(vtkProp* prop, vtkProp* drawn, const vtkWaterSnapshot& mirrored, bool isRefused);
}

#endif
