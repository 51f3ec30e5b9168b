// SPDX-License-Identifier: BSD-3-Clause
// fuzz_input.h: makes numbers out of the fuzzer's bytes; after the last byte all of them are 0.
#ifndef fuzz_input_h
#define fuzz_input_h

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef struct fuzz_input
{
  const uint8_t* bytes;
  size_t left;
} fuzz_input;

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size);

// What a header promises; a broken promise is a crash.
#define PROMISED(claim)                                                                            \
  do                                                                                               \
  {                                                                                                \
    if (!(claim))                                                                                  \
    {                                                                                              \
      abort();                                                                                     \
    }                                                                                              \
  } while (0)

static inline void fuzz_raw(fuzz_input* from, void* to, size_t size)
{
  memset(to, 0, size);
  const size_t taken = size < from->left ? size : from->left;
  memcpy(to, from->bytes, taken);
  from->bytes += taken;
  from->left -= taken;
}

static inline uint8_t fuzz_byte(fuzz_input* from)
{
  uint8_t byte;
  fuzz_raw(from, &byte, sizeof byte);
  return byte;
}

static inline bool fuzz_bool(fuzz_input* from)
{
  return fuzz_byte(from) & 1;
}

// At most limit - 1.
static inline size_t fuzz_below(fuzz_input* from, size_t limit)
{
  uint16_t number;
  fuzz_raw(from, &number, sizeof number);
  return number % limit;
}

static inline int fuzz_int(fuzz_input* from)
{
  int number;
  fuzz_raw(from, &number, sizeof number);
  return fuzz_bool(from) ? number : (int)fuzz_below(from, 5000) - 2;
}

// Any double, one that is at home in a scene, or one from the edges.
static inline double fuzz_double(fuzz_input* from)
{
  static const double edges[16] = { 0.0, -0.0, 1.0, -1.0, 0.5, 1e-12, -1e-12, 1e9, -1e9, DBL_MAX,
    -DBL_MAX, DBL_MIN, DBL_EPSILON, (double)INFINITY, (double)-INFINITY, (double)NAN };
  const uint8_t kind = fuzz_byte(from);
  if (kind < 64)
  {
    return edges[kind % 16];
  }
  if (kind < 192)
  {
    int16_t small;
    fuzz_raw(from, &small, sizeof small);
    return small / 256.0 * (kind & 1 ? 1e-3 : 1.0) * (kind & 2 ? 1e3 : 1.0);
  }
  double any;
  fuzz_raw(from, &any, sizeof any);
  return any;
}

// A number that is good where it is used, or near that, or any: without bytes, the good one.
static inline double fuzz_near(fuzz_input* from, double good)
{
  const uint8_t kind = fuzz_byte(from);
  if (kind < 128)
  {
    return good;
  }
  if (kind < 192)
  {
    int16_t small;
    fuzz_raw(from, &small, sizeof small);
    return good + small / 256.0;
  }
  return fuzz_double(from);
}

static inline void fuzz_doubles(fuzz_input* from, double* to, size_t count)
{
  for (size_t i = 0; i < count; ++i)
  {
    to[i] = fuzz_double(from);
  }
}

// The arithmetic may give anything, but it must be computed.
static inline void fuzz_use(const void* bytes, size_t size)
{
  static volatile uint8_t sink;
  const uint8_t* at = bytes;
  for (size_t i = 0; i < size; ++i)
  {
    sink = (uint8_t)(sink ^ at[i]);
  }
}

#endif
