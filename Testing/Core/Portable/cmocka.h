// SPDX-License-Identifier: BSD-3-Clause
// cmocka.h: what the tests of the core use of cmocka, for platforms that have none to install.
//
// The same names and output as cmocka's own, which is preferred where it is (script/platforms gives
// this folder as cmocka_DIR). It is a single C11 header: a failed assertion prints its place and
// leaves the test by longjmp.
#ifndef water_portable_cmocka_h
#define water_portable_cmocka_h

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

struct CMUnitTest
{
  const char* name;
  void (*test_func)(void** state);
  int (*setup_func)(void** state);
  int (*teardown_func)(void** state);
  void* initial_state;
};

static jmp_buf cmocka_leave;
static const char* cmocka_filter;

#define print_message(...) ((void)printf(__VA_ARGS__))
#define print_error(...) ((void)fprintf(stderr, __VA_ARGS__))

static inline void cmocka_check(bool holds, const char* what, const char* file, int line)
{
  if (!holds)
  {
    print_error("%s:%d: error: %s\n", file, line, what);
    longjmp(cmocka_leave, 1);
  }
}

static inline void cmocka_check_integers(
  bool is_equal, uintmax_t a, uintmax_t b, const char* file, int line)
{
  if ((a == b) != is_equal)
  {
    print_error("%s:%d: error: 0x%jx %s 0x%jx\n", file, line, a, is_equal ? "!=" : "==", b);
    longjmp(cmocka_leave, 1);
  }
}

static inline bool cmocka_is_in_range(uintmax_t value, uintmax_t least, uintmax_t most)
{
  return value >= least && value <= most;
}

#define fail() cmocka_check(false, "fail()", __FILE__, __LINE__)
#define assert_true(c) cmocka_check((c) ? true : false, #c, __FILE__, __LINE__)
#define assert_false(c) cmocka_check((c) ? false : true, "not " #c, __FILE__, __LINE__)
#define assert_null(p) cmocka_check((p) == NULL, #p " is null", __FILE__, __LINE__)
#define assert_non_null(p) cmocka_check((p) != NULL, #p, __FILE__, __LINE__)
#define assert_ptr_equal(a, b)                                                                     \
  cmocka_check((const void*)(a) == (const void*)(b), #a " == " #b, __FILE__, __LINE__)
#define assert_int_equal(a, b)                                                                     \
  cmocka_check_integers(true, (uintmax_t)(a), (uintmax_t)(b), __FILE__, __LINE__)
#define assert_int_not_equal(a, b)                                                                 \
  cmocka_check_integers(false, (uintmax_t)(a), (uintmax_t)(b), __FILE__, __LINE__)
#define assert_string_equal(a, b)                                                                  \
  cmocka_check(strcmp((a), (b)) == 0, #a " == " #b, __FILE__, __LINE__)
#define assert_string_not_equal(a, b)                                                              \
  cmocka_check(strcmp((a), (b)) != 0, #a " != " #b, __FILE__, __LINE__)
#define assert_memory_equal(a, b, size)                                                            \
  cmocka_check(memcmp((a), (b), (size)) == 0, #a " == " #b, __FILE__, __LINE__)
#define assert_memory_not_equal(a, b, size)                                                        \
  cmocka_check(memcmp((a), (b), (size)) != 0, #a " != " #b, __FILE__, __LINE__)
#define assert_in_range(value, least, most)                                                        \
  cmocka_check(cmocka_is_in_range((uintmax_t)(value), (uintmax_t)(least), (uintmax_t)(most)),      \
    #value " in [" #least ", " #most "]", __FILE__, __LINE__)

static inline void cmocka_set_test_filter(const char* pattern)
{
  cmocka_filter = pattern;
}

// A pattern with * and ?, as in cmocka.
static inline bool cmocka_is_meant(const char* pattern, const char* name)
{
  if (*pattern == '*')
  {
    return cmocka_is_meant(pattern + 1, name) || (*name && cmocka_is_meant(pattern, name + 1));
  }
  return *name ? (*pattern == '?' || *pattern == *name) && cmocka_is_meant(pattern + 1, name + 1)
               : !*pattern;
}

static inline bool cmocka_run_one(const struct CMUnitTest* test)
{
  void* state = test->initial_state;
  print_message("[ RUN      ] %s\n", test->name);
  (void)fflush(stdout);             // before what a crash would take with it
  volatile bool has_passed = false; // read after a longjmp
  if (setjmp(cmocka_leave) == 0)
  {
    test->test_func(&state);
    has_passed = true;
  }
  print_message("[  %s  ] %s\n", has_passed ? "     OK" : "FAILED", test->name);
  return has_passed;
}

// Number of the tests that failed.
static inline int cmocka_run_tests(const struct CMUnitTest* tests, size_t count)
{
  int passed = 0;
  int failed = 0;
  for (size_t i = 0; i < count; ++i)
  {
    if (!cmocka_filter || cmocka_is_meant(cmocka_filter, tests[i].name))
    {
      int* counter = cmocka_run_one(&tests[i]) ? &passed : &failed;
      ++*counter;
    }
  }
  print_message("[  PASSED  ] %d test(s).\n[  FAILED  ] %d test(s).\n", passed, failed);
  return failed;
}

#define cmocka_run_group_tests(tests, setup, teardown)                                             \
  ((void)(setup), (void)(teardown), cmocka_run_tests((tests), sizeof(tests) / sizeof((tests)[0])))

#endif
