// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterCompat.h: what differs between the supported VTK versions, and the setter all classes
// use.
#ifndef vtkWaterCompat_h
#define vtkWaterCompat_h

#include "vtkVersionMacros.h"

#ifndef VTK_ABI_NAMESPACE_BEGIN // VTK < 9.3
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

// Sets a member to a value in [low, high]. Another value, NaN included, is refused with an error
// that names it and the range; the last good value stays.
#define vtkWaterSetInRange(member, value, low, high)                                               \
  do                                                                                               \
  {                                                                                                \
    if (!((value) >= (low) && (value) <= (high)))                                                  \
    {                                                                                              \
      vtkErrorMacro(#member " is " << (value) << "; it must lie in [" << (low) << ", " << (high)   \
                                   << "]. It stays " << this->member << ".");                      \
    }                                                                                              \
    else if (this->member != (value))                                                              \
    {                                                                                              \
      this->member = (value);                                                                      \
      this->Modified();                                                                            \
    }                                                                                              \
  } while (false)

#endif
