// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterQueryResult: what a query of GL has counted, asked so that nobody waits for ever: GL's
// own wait does, where a driver has lost the query or its context.
#ifndef vtkWaterQueryResult_h
#define vtkWaterQueryResult_h

#include "vtkType.h"

namespace vtkWaterQueryResult
{
// -1: not known yet.
vtkIdType Get(unsigned int query);

// Does any query count what is drawn now, whosever it is?
bool IsAnyAwaited();

// Waits until all that came before is drawn, a second at most. -1: it is not known even then.
vtkIdType Wait(unsigned int query);
}

#endif
