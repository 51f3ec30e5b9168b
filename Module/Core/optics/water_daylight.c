// SPDX-License-Identifier: BSD-3-Clause
// water_daylight.c: the light that a scene's sky and lights bring to level water, and the colour
// that the water sends back of it.
#include "water_daylight.h"

#include "water_math.h"
#include "water_shared.h"

static double clamp_unit(double value)
{
  return fmin(fmax(value, 0.0), 1.0); // NaN becomes 0
}

double water_display_encode(double linear)
{
  return water_shared_encoded(linear);
}

double water_display_decode(double shown)
{
  const double value = clamp_unit(shown);
  return value <= 0.04045 ? value / 12.92 : pow((value + 0.055) / 1.055, 2.4);
}

void water_daylight_add_sky(const water_sky* sky, double daylight[3])
{
  for (int i = 0; i < 3; ++i)
  {
    daylight[i] += 0.5 * (water_display_decode(sky->bottom[i]) + water_display_decode(sky->top[i]));
  }
}

void water_daylight_add_light(const double normal[3], const double dir[3], const double color[3],
  double intensity, double daylight[3])
{
  const double lengths = water_vec3_length(normal) * water_vec3_length(dir);
  const double cosine = water_vec3_dot(normal, dir) / lengths;
  if (!(cosine > 0.0) || !isfinite(cosine) || !(intensity > 0.0) || !isfinite(intensity))
  {
    return;
  }
  for (int i = 0; i < 3; ++i)
  {
    daylight[i] += intensity * clamp_unit(color[i]) * fmin(cosine, 1.0);
  }
}

void water_daylight_deep_color(
  const water_medium* medium, const double daylight[3], double color[3])
{
  double reflectance[3];
  water_medium_reflectance(medium, reflectance);
  for (int i = 0; i < 3; ++i)
  {
    color[i] = water_display_encode(reflectance[i] * daylight[i]);
  }
}

void water_daylight_foam(
  const double daylight[3], const double sun_color[3], const double* sun_dir, double light[3])
{
  const double cosine = sun_dir ? fmax(sun_dir[2], 0.0) : 0.0;
  const double sun = cosine * fmax(sun_color[0], fmax(sun_color[1], sun_color[2]));
  const double share = fmin(sun / WATER_FOAM_SUN, 1.0);
  for (int i = 0; i < 3; ++i)
  {
    const double without = fmax(water_display_encode(daylight[i]), WATER_FOAM_SKY);
    light[i] = (1.0 - share) * without + share * WATER_FOAM_SKY;
  }
}
