// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterGL.h: GL's names and functions through the loader that this VTK uses. State that VTK
// caches is set through vtkOpenGLState only.
#ifndef vtkWaterGL_h
#define vtkWaterGL_h

#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#endif
