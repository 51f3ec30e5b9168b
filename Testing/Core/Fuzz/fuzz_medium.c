// SPDX-License-Identifier: BSD-3-Clause
// fuzz_medium.c: presets by any name, any body of water, any course of a time budget; texts of any
// number.
#include "fuzz_input.h"

#include "water_medium.h"
#include "water_plan.h"
#include "water_preset.h"
#include "water_quality.h"

static void fuzz_light(fuzz_input* from)
{
  water_medium medium;
  double dirs[2][3];
  double out[3];
  for (int i = 0; i < 3; ++i)
  {
    medium.absorption[i] = fuzz_near(from, 0.1);
    medium.scattering[i] = fuzz_near(from, 0.1);
    dirs[0][i] = fuzz_near(from, i == 2 ? -1.0 : 0.0);
    dirs[1][i] = fuzz_near(from, i == 2 ? 1.0 : 0.0);
  }
  const double eta = fuzz_near(from, 1.333);
  if (water_medium_refract(dirs[0], dirs[1], eta, out) == WATER_OK)
  {
    PROMISED(fabs(hypot(hypot(out[0], out[1]), out[2]) - 1.0) < 1e-5);
  }
  if (water_medium_check(&medium) == WATER_OK)
  {
    water_medium_reflectance(&medium, out);
    for (int i = 0; i < 3; ++i)
    {
      PROMISED(out[i] >= 0.0 && out[i] <= 0.33);
    }
    const double depth = fabs(fuzz_double(from));
    water_medium_transmittance(&medium, depth, out);
    water_medium_inscatter(&medium, depth, fuzz_double(from), fuzz_double(from), 0.08, out);
    (void)water_medium_path(depth, fuzz_double(from), eta);
    (void)water_medium_apparent_depth(depth, fuzz_double(from), eta);
  }
}

static void fuzz_budget(fuzz_input* from)
{
  water_quality_state state;
  memset(&state, 0, sizeof state);
  state.step = fuzz_int(from);
  const int finest = fuzz_int(from);
  for (int frame = 0; frame < 200 && from->left > 0; ++frame)
  {
    const water_status status =
      water_quality_for_budget(&state, finest, fuzz_near(from, 10.0), fuzz_near(from, 8.0));
    PROMISED(status == WATER_OK ? state.step >= 0 && state.step < WATER_QUALITY_STEPS
                                : status == WATER_BAD_TIME_BUDGET);
    PROMISED(state.patience >= 0 && state.patience <= 6);
  }
}

static void fuzz_shares(fuzz_input* from)
{
  double areas[8];
  double shares[8];
  const size_t count = fuzz_below(from, 9);
  fuzz_doubles(from, areas, count);
  const double budget = fuzz_double(from);
  if (water_quality_share(areas, count, budget, shares) == WATER_OK)
  {
    double sum = 0.0;
    for (size_t i = 0; i < count; ++i)
    {
      sum += shares[i];
    }
    // where neither a share vanishes nor the sum overflows
    const bool is_plain = budget > 1e-290 && budget < 1e290;
    PROMISED(!is_plain || sum == 0.0 || fabs(sum / budget - 1.0) < 1e-12);
  }
}

static void fuzz_name(fuzz_input* from)
{
  char name[64];
  fuzz_raw(from, name, sizeof name - 1);
  name[sizeof name - 1] = '\0';
  water_preset preset;
  if (water_preset_find(name, &preset) == WATER_OK)
  {
    PROMISED(strcmp(name, preset.name) == 0 && water_medium_check(&preset.medium) == WATER_OK);
  }
  const int number = fuzz_int(from);
  PROMISED(strlen(water_status_text((water_status)number)) > 0);
  PROMISED(strlen(water_cull_reason_text((water_cull_reason)number)) > 0);
  PROMISED(strlen(water_decision_text((water_decision)number)) > 0);
  PROMISED(strlen(water_type_text((water_type)number)) > 0);
  water_medium medium;
  const bool is_type = number >= 0 && number < WATER_TYPE_COUNT;
  PROMISED((water_type_medium((water_type)number, &medium) == WATER_OK) == is_type);
  PROMISED((water_preset_name((size_t)number) != NULL) == ((size_t)number < water_preset_count()));
}

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
  fuzz_input from = { bytes, size };
  static void (*const parts[])(fuzz_input*) = { fuzz_light, fuzz_budget, fuzz_shares, fuzz_name };
  parts[fuzz_byte(&from) % 4](&from);
  return 0;
}
