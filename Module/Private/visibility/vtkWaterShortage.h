// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterShortage: what a mirrored view had no memory for. It is drawn all the same, with more in
// it than the water shows.
#ifndef vtkWaterShortage_h
#define vtkWaterShortage_h

#include <cstddef>

struct vtkWaterShortage
{
  const char* What = nullptr; // nullptr: there was enough
  size_t TriangleCount = 0;   // of the mesh that it was wanted for; 0: of none
};

#endif
