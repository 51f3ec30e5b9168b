// SPDX-License-Identifier: BSD-3-Clause
// test_heights.h: what the tests of heights share.
#ifndef test_heights_h
#define test_heights_h

#include "test_main.h"

#include "water_heights.h"

static inline void assert_wrong(water_heights_verdict verdict, water_height wrong, double factor)
{
  assert_true(verdict.wrong == wrong);
  ASSERT_CLOSE(verdict.factor, factor, 1e-12);
}

#endif
