// SPDX-License-Identifier: BSD-3-Clause
// fuzz_waves.c: any waves, at any time and place.
#include "fuzz_input.h"

#include "water_normals.h"
#include "water_waves.h"

enum
{
  WAVES = 6
};

static void fuzz_normals(fuzz_input* from)
{
  water_normal_map map;
  map.size = fuzz_near(from, 1.0);
  map.speed = fuzz_near(from, 0.0);
  map.direction_rad = fuzz_near(from, 0.0);
  map.strength = fuzz_near(from, 1.0);
  double place[2];
  const double x = fuzz_double(from);
  const double y = fuzz_double(from);
  const double time = fuzz_double(from);
  if (water_normals_check(&map) == WATER_OK)
  {
    water_normals_place(&map, x, y, time, place);
    if (isfinite(x) && isfinite(y) && fabs(x) < 1e15 && fabs(y) < 1e15 && fabs(map.speed) < 1e6 &&
      fabs(time) < 1e9)
    {
      PROMISED(place[0] >= 0.0 && place[0] < 1.0 && place[1] >= 0.0 && place[1] < 1.0);
    }
  }
  unsigned char pixels[64];
  float texels[4 * 16];
  fuzz_raw(from, pixels, sizeof pixels);
  const size_t channels = fuzz_bool(from) ? 3 : 4;
  water_normals_texels(pixels, channels, 16, texels);
  for (int i = 0; i < 64; ++i)
  {
    PROMISED(fabsf(texels[i]) <= 400.0f);
  }
}

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
  fuzz_input from = { bytes, size };
  fuzz_normals(&from);
  double number = 0.0;
  if (water_waves_omega(fuzz_double(&from), fuzz_double(&from), &number) == WATER_OK)
  {
    PROMISED(number >= 0.0);
  }
  if (water_waves_wavenumber(fuzz_double(&from), fuzz_double(&from), &number) == WATER_OK)
  {
    PROMISED(isfinite(number) && number >= 0.0);
  }
  water_wave waves[WAVES];
  water_wave_term terms[WAVES];
  water_wave_row rows[WAVES];
  const size_t count = fuzz_below(&from, WAVES + 1);
  for (size_t i = 0; i < count; ++i)
  {
    waves[i].amplitude = fuzz_near(&from, 0.01);
    waves[i].wavelength = fuzz_near(&from, 1.0);
    waves[i].direction_rad = fuzz_near(&from, 0.0);
    waves[i].phase_rad = fuzz_near(&from, 0.0);
    waves[i].steepness = fuzz_near(&from, 0.5);
  }
  size_t bad_index = 0;
  const double depth = fuzz_near(&from, 1.0);
  const double time = fuzz_near(&from, 0.0);
  if (water_waves_at(waves, count, depth, time, terms, &bad_index) != WATER_OK)
  {
    PROMISED(count == 0 || bad_index < count);
    return 0;
  }
  double height = 0.0;
  double other = 0.0;
  water_waves_rms(waves, count, &height, &other);
  water_waves_reach(waves, count, &height, &other);
  PROMISED(water_waves_looked_up(waves, count) >= 0.0);
  PROMISED(!(water_waves_number(waves, count) < 0.0));
  const double x = fuzz_near(&from, 0.0);
  const double y = fuzz_near(&from, 0.0);
  double rest[2];
  water_wave_point point;
  if (water_waves_find(terms, count, x, y, rest, &point) == WATER_OK)
  {
    PROMISED(isfinite(x) && isfinite(y) && isfinite(point.displacement[2]));
    PROMISED(point.normal[2] >= 0.0 && point.jacobian >= 0.0);
    double slope[2] = { fuzz_double(&from), fuzz_double(&from) };
    water_waves_tilt(slope, point.normal);
    water_waves_point(terms, count, x, y, &point);
    water_waves_rows(terms, count, x, y, rows);
    fuzz_use(rows, count * sizeof *rows);
  }
  return 0;
}
