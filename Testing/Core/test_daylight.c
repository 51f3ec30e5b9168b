// SPDX-License-Identifier: BSD-3-Clause
// test_daylight.c: the display's encoding, the light of sky and lights, and what water makes of it.
#include "test_scene.h"

#include "water_daylight.h"
#include "water_preset.h"

static const double white[3] = { 1.0, 1.0, 1.0 };
static const double up[3] = { 0.0, 0.0, 2.0 };

static water_sky water_sky_of(double bottom, double top)
{
  const water_sky sky = { { bottom, bottom, bottom }, { top, top, top }, 1.0, true };
  return sky;
}

// Values of the standard: 18 % grey is 118 of 255, half of the light 188; there and back is no way.
TEST(encoding_is_the_standards)
{
  ASSERT_CLOSE(255.0 * water_display_encode(0.18), 117.6, 0.1);
  ASSERT_CLOSE(255.0 * water_display_encode(0.5), 187.5, 0.1);
  ASSERT_CLOSE(water_display_encode(0.001), 0.01292, 1e-12);
  ASSERT_CLOSE(water_display_encode(1.0), 1.0, 1e-12);
  for (double value = 0.0; value <= 1.0; value += 1.0 / 64.0)
  {
    ASSERT_CLOSE(water_display_encode(water_display_decode(value)), value, 1e-7);
  }
}

TEST(the_straight_part_of_the_encoding_has_its_end)
{
  ASSERT_CLOSE(water_display_decode(0.04045), 0.04045 / 12.92, 1e-13);
  ASSERT_CLOSE(water_display_encode(0.0031308), 0.0031308 * 12.92, 1e-13);
}

TEST(values_outside_are_clamped)
{
  ASSERT_CLOSE(water_display_encode(-1.0), 0.0, 0.0);
  ASSERT_CLOSE(water_display_encode(7.0), 1.0, 1e-12);
  ASSERT_CLOSE(water_display_encode((double)NAN), 0.0, 0.0);
  ASSERT_CLOSE(water_display_decode(7.0), 1.0, 1e-12);
  ASSERT_CLOSE(water_display_decode((double)NAN), 0.0, 0.0);
}

// A light at 60 degrees from the normal brings half of its light, at any length of the vectors; one
// that is under the plane brings none.
TEST(lights_add_by_lamberts_law)
{
  const double high[3] = { 0.0, 0.0, 5.0 };
  const double low[3] = { 0.0, 10.0 * sqrt(3.0), 10.0 };
  const double under[3] = { 0.0, 1.0, -1.0 };
  const double red[3] = { 1.0, 0.5, 0.0 };
  double daylight[3] = { 0.0, 0.0, 0.0 };
  water_daylight_add_light(up, high, red, 2.0, daylight);
  ASSERT_CLOSE(daylight[0], 2.0, 1e-12);
  ASSERT_CLOSE(daylight[1], 1.0, 1e-12);
  ASSERT_CLOSE(daylight[2], 0.0, 0.0);
  water_daylight_add_light(up, low, white, 1.0, daylight);
  ASSERT_CLOSE(daylight[0], 2.5, 1e-12);
  ASSERT_CLOSE(daylight[2], 0.5, 1e-12);
  water_daylight_add_light(up, under, white, 1.0, daylight);
  ASSERT_CLOSE(daylight[2], 0.5, 1e-12);
}

TEST(lights_that_are_none_add_nothing)
{
  const double nowhere[3] = { 0.0, 0.0, 0.0 };
  const double endless[3] = { 0.0, 0.0, (double)INFINITY };
  const double high[3] = { 0.0, 0.0, 1.0 };
  double daylight[3] = { 0.25, 0.5, 0.75 };
  water_daylight_add_light(up, nowhere, white, 1.0, daylight);
  water_daylight_add_light(nowhere, high, white, 1.0, daylight);
  water_daylight_add_light(up, endless, white, 1.0, daylight);
  water_daylight_add_light(up, high, white, -1.0, daylight);
  water_daylight_add_light(up, high, white, (double)NAN, daylight);
  ASSERT_CLOSE(daylight[0], 0.25, 0.0);
  ASSERT_CLOSE(daylight[1], 0.5, 0.0);
  ASSERT_CLOSE(daylight[2], 0.75, 0.0);
}

// The sky's part is its mean, not of what the display shows but of the light.
TEST(sky_adds_the_mean_of_its_light)
{
  water_sky sky = water_sky_of(0.0, 1.0);
  double daylight[3] = { 0.0, 0.0, 0.0 };
  water_daylight_add_sky(&sky, daylight);
  ASSERT_CLOSE(daylight[0], 0.5, 1e-12);
  sky = water_sky_of(118.0 / 255.0, 118.0 / 255.0);
  water_daylight_add_sky(&sky, daylight);
  ASSERT_CLOSE(daylight[1], 0.5 + 0.181, 1e-3);
}

// Water that only scatters sends back a third: 0.33 is 155 of 255 on the display.
TEST(deep_color_is_what_comes_back)
{
  const water_medium milk = { { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } };
  const double dark[3] = { 0.0, 0.0, 0.0 };
  const double bright[3] = { 100.0, 100.0, 100.0 };
  double color[3];
  water_daylight_deep_color(&milk, white, color);
  ASSERT_CLOSE(255.0 * color[0], 155.5, 0.5);
  water_daylight_deep_color(&milk, dark, color);
  ASSERT_CLOSE(color[0] + color[1] + color[2], 0.0, 0.0);
  water_daylight_deep_color(&milk, bright, color);
  ASSERT_CLOSE(color[2], 1.0, 1e-12);
}

// Under a white sky and a sun no water of a preset is black, and the default is blue: above 60 of
// 255 in blue, more green than red.
TEST(waters_are_not_black_under_the_sky)
{
  const double noon[3] = { 1.6, 1.6, 1.6 };
  double natural[3];
  double color[3];
  water_medium medium;
  water_preset_default(&medium, natural);
  water_daylight_deep_color(&medium, noon, color);
  assert_true(255.0 * color[2] > 60.0 && color[2] > color[1] && color[1] > color[0]);
  for (size_t i = 0; i < water_preset_count(); ++i)
  {
    water_preset preset;
    assert_int_equal(water_preset_find(water_preset_name(i), &preset), WATER_OK);
    water_daylight_deep_color(&preset.medium, noon, color);
    assert_true(preset.look.constant_reflectance || 255.0 * fmax(color[1], color[2]) > 60.0);
  }
}

// The plan's daylight is that of its lights and of its sky.
TEST(plan_has_the_scenes_daylight)
{
  water_scene scene = pool(5.0);
  scene.sky = water_sky_of(0.0, 1.0);
  scene.light[0] = 1.0;
  const water_plan plan = plan_of(&scene, NULL);
  ASSERT_CLOSE(plan.daylight[0], 1.5, 1e-12);
  ASSERT_CLOSE(plan.daylight[2], 0.5, 1e-12);
}

// A light without a direction, from behind, or of an intensity that is no light adds nothing.
TEST(lights_that_do_not_shine_add_nothing)
{
  const double none[3] = { 0.0, 0.0, 0.0 };
  const double below[3] = { 0.0, 0.0, -1.0 };
  const double far_off[3] = { 0.0, 0.0, INFINITY };
  double daylight[3] = { 0.5, 0.5, 0.5 };
  water_daylight_add_light(up, none, white, 1.0, daylight);
  water_daylight_add_light(up, below, white, 1.0, daylight);
  water_daylight_add_light(up, far_off, white, 1.0, daylight);
  water_daylight_add_light(up, up, white, 0.0, daylight);
  water_daylight_add_light(up, up, white, -1.0, daylight);
  water_daylight_add_light(up, up, white, NAN, daylight);
  water_daylight_add_light(up, up, white, INFINITY, daylight);
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(daylight[i], 0.5, 0.0);
  }
}

// Without a sun foam is a white card under all light; with one the sun's part is the shader's.
TEST(foam_is_lit_by_the_daylight)
{
  const double daylight[3] = { 0.0, 0.5, 3.0 };
  double light[3];
  const double low[3] = { 0.866, 0.0, 0.5 }; // the cosine to the plane is half
  const double under[3] = { 0.0, 0.0, -1.0 };
  const double sun[3] = { 0.5 * WATER_FOAM_SUN, WATER_FOAM_SUN, 0.0 };
  const double suns[2][3] = { { 2.0 * WATER_FOAM_SUN, 0.0, 0.0 }, { 0.0, 0.0, 4.0 } };
  double same[3];
  water_daylight_foam(daylight, sun, NULL, light);
  water_daylight_foam(daylight, sun, under, same);
  ASSERT_CLOSE(light[0], WATER_FOAM_SKY, 0.0);
  ASSERT_CLOSE(light[1], water_display_encode(0.5), 0.0);
  ASSERT_CLOSE(light[2], 1.0, 1e-12);
  ASSERT_CLOSE(same[2], light[2], 0.0); // a sun under the plane lights nothing
  water_daylight_foam(daylight, sun, low, light);
  ASSERT_CLOSE(light[2], 0.5 * (1.0 + WATER_FOAM_SKY), 1e-12);
  for (int i = 0; i < 6; ++i)
  {
    water_daylight_foam(daylight, suns[i / 3], low, light);
    ASSERT_CLOSE(light[i % 3], WATER_FOAM_SKY, 1e-12);
  }
}

TESTS(the_straight_part_of_the_encoding_has_its_end, foam_is_lit_by_the_daylight,
  lights_that_do_not_shine_add_nothing, encoding_is_the_standards, values_outside_are_clamped,
  lights_add_by_lamberts_law, lights_that_are_none_add_nothing, sky_adds_the_mean_of_its_light,
  deep_color_is_what_comes_back, waters_are_not_black_under_the_sky, plan_has_the_scenes_daylight)
