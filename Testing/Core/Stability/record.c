// SPDX-License-Identifier: BSD-3-Clause
// record.c: what the stress suite keeps of its cases.
#include "record.h"

#include <inttypes.h>
#include <math.h>

static const char* const texts[][3] = {
#define STRESS_PROPERTY_TEXT(name, text, condition, unit) { text, condition, unit },
  STRESS_PROPERTY_LIST(STRESS_PROPERTY_TEXT)
#undef STRESS_PROPERTY_TEXT
};

enum
{
  PRINTED_FAILURES = 10
};

static int decade_of(double condition)
{
  if (!(condition > 0.0))
  {
    return 0;
  }
  const double decade = fmin(floor(log10(condition)), 1000.0) - STRESS_FIRST_DECADE;
  return decade < 0.0 ? 0 : decade >= STRESS_DECADES ? STRESS_DECADES - 1 : (int)decade;
}

void stress_keep(
  stress_record* record, stress_property property, double condition, double error, double bound)
{
  const double size = fabs(error);
  const double ratio = size == 0.0 ? 0.0 : size / bound;
  stress_bin* bin = &record->bins[property][decade_of(condition)];
  ++bin->count;
  bin->most = fmax(bin->most, size);
  if (!(ratio <= bin->most_ratio))
  {
    bin->most_ratio = ratio;
    double most = 0.0;
    for (int i = 0; i < STRESS_DECADES; ++i)
    {
      most = fmax(most, record->bins[property][i].most_ratio);
    }
    if (!(ratio < most))
    {
      record->worst[property] = record->number;
    }
  }
  if (!(size <= bound) && record->failure_count++ < PRINTED_FAILURES)
  {
    printf("seed %" PRIu64 " case %" PRIu64 ": %s: error %.3g, bound %.3g, condition %.3g\n",
      record->seed, record->number, texts[property][0], error, bound, condition);
  }
}

static double largest_ratio(const stress_record* record, int property)
{
  double most = 0.0;
  for (int i = 0; i < STRESS_DECADES; ++i)
  {
    most = fmax(most, record->bins[property][i].most_ratio);
  }
  return most;
}

void stress_print(const stress_record* record)
{
  printf("%-56s %12s %10s %10s  %s\n", "property", "count", "error", "of bound", "worst case");
  for (int i = 0; i < STRESS_PROPERTY_COUNT; ++i)
  {
    uint64_t count = 0;
    double most = 0.0;
    for (int j = 0; j < STRESS_DECADES; ++j)
    {
      count += record->bins[i][j].count;
      most = fmax(most, record->bins[i][j].most);
    }
    printf("%-56s %12" PRIu64 " %10.3g %10.3f  %" PRIu64 "\n", texts[i][0], count, most,
      largest_ratio(record, i), record->worst[i]);
  }
}

void stress_write(const stress_record* record, FILE* file)
{
  for (int i = 0; i < STRESS_PROPERTY_COUNT; ++i)
  {
    for (int j = 0; j < STRESS_DECADES; ++j)
    {
      const stress_bin* bin = &record->bins[i][j];
      if (bin->count > 0)
      {
        fprintf(file, "%s\t%s\t%s\t%d\t%" PRIu64 "\t%.6g\t%.6g\n", texts[i][0], texts[i][1],
          texts[i][2], j + STRESS_FIRST_DECADE, bin->count, bin->most, bin->most_ratio);
      }
    }
  }
}
