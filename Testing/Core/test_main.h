// SPDX-License-Identifier: BSD-3-Clause
// test_main.h: what a file of tests is made of: TEST for each, and TESTS with all their names at
// its end.
//
// A program runs all of its tests, or those that its argument names: a name, or a pattern with *
// and
// ?. A test that TESTS forgets is an unused variable, which the compiler refuses.
#ifndef test_main_h
#define test_main_h

// cmocka.h wants these before it
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#ifndef assert_int_in_range // cmocka before 2.0 has one for all integers, which 2.0 deprecates
#define assert_int_in_range assert_in_range
#endif

#define TEST(name)                                                                                 \
  static void name##_body(void);                                                                   \
  static void name##_run(void** state)                                                             \
  {                                                                                                \
    (void)state;                                                                                   \
    name##_body();                                                                                 \
  }                                                                                                \
  static const struct CMUnitTest name = { #name, name##_run, NULL, NULL, NULL };                   \
  static void name##_body(void)

#define TESTS(...)                                                                                 \
  int main(int argc, char** argv)                                                                  \
  {                                                                                                \
    const struct CMUnitTest tests[] = { __VA_ARGS__ };                                             \
    return tests_are_chosen(argc, argv, tests, sizeof tests / sizeof tests[0])                     \
      ? cmocka_run_group_tests(tests, NULL, NULL)                                                  \
      : 2;                                                                                         \
  }

// Fails with both numbers; NaN never passes.
#define ASSERT_CLOSE(actual, expected, tolerance)                                                  \
  do                                                                                               \
  {                                                                                                \
    const double actual_ = (actual);                                                               \
    const double expected_ = (expected);                                                           \
    if (!(fabs(actual_ - expected_) <= (tolerance)))                                               \
    {                                                                                              \
      print_error("%s is %.17g, not %.17g\n", #actual, actual_, expected_);                        \
      fail();                                                                                      \
    }                                                                                              \
  } while (0)

static inline bool test_is_meant(const char* pattern, const char* name)
{
  if (*pattern == '*')
  {
    return test_is_meant(pattern + 1, name) || (*name && test_is_meant(pattern, name + 1));
  }
  return *name ? (*pattern == '?' || *pattern == *name) && test_is_meant(pattern + 1, name + 1)
               : !*pattern;
}

// Chooses tests by the arguments of the program. Returns false, and prints the names, when that
// leaves none.
static inline bool tests_are_chosen(
  int argc, char** argv, const struct CMUnitTest* tests, size_t count)
{
  if (argc < 2)
  {
    return true;
  }
  cmocka_set_test_filter(argv[1]);
  for (size_t i = 0; i < count && argc == 2; ++i)
  {
    if (test_is_meant(argv[1], tests[i].name))
    {
      return true;
    }
  }
  fprintf(stderr, "usage: %s [test], a name or a pattern of these:\n", argv[0]);
  for (size_t i = 0; i < count; ++i)
  {
    fprintf(stderr, "  %s\n", tests[i].name);
  }
  return false;
}

#endif
