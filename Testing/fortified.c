// SPDX-License-Identifier: BSD-3-Clause
// fortified.c: compiles only with checked calls of the C library (cmake/WaterHardening.cmake).
#if !defined(__OPTIMIZE__) || !defined(_FORTIFY_SOURCE) || _FORTIFY_SOURCE < 2
#error "built without checked calls of the C library"
#endif

int water_is_fortified(void);

int water_is_fortified(void)
{
  return _FORTIFY_SOURCE;
}
