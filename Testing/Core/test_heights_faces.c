// SPDX-License-Identifier: BSD-3-Clause
// test_heights_faces.c: cells whose level is their own bed are dry, and a shore is not.
#include "test_main.h"

#include "water_heights.h"

// Faces of a slope, of 4 corners each: dry ones with their own bed as the level, and a shore.
static water_heights_faces faces_of(size_t dry, size_t shore, double rough)
{
  water_heights_faces faces = { 0 };
  for (size_t i = 0; i < dry + shore; ++i)
  {
    const double x = i < dry ? 0.1 * (double)i : 0.0;
    const double beds[4] = { x, x + 1.0, x + 1.0, x };
    const double share = fmod(0.61803 * (double)i, 1.0);
    const double level = i < dry ? x + 0.5 + rough * (share - 0.5) : 0.01 + 0.98 * share;
    water_heights_add_face(level, beds, 4, 0.001, &faces);
  }
  return faces;
}

TEST(levels_of_dry_faces_are_found)
{
  const water_heights_faces land = faces_of(300, 100, 0.1);
  assert_true(land.cut == 400 && land.at_bed >= 300);
  assert_true(water_heights_are_beds(&land));
}

// Nor on land that is too rough for the mean of its corners to be its bed.
TEST(a_shore_is_no_dry_land)
{
  const water_heights_faces shore = faces_of(0, 400, 0.0);
  assert_true(shore.cut == 400 && shore.at_bed > 60 && shore.at_bed < 100);
  assert_true(!water_heights_are_beds(&shore));
  const water_heights_faces rough = faces_of(300, 0, 0.9);
  assert_true(!water_heights_are_beds(&rough));
}

// A level that is exactly the mean of the corners is dry already.
TEST(dry_faces_that_are_not_shown_are_no_matter)
{
  const water_heights_faces land = faces_of(300, 0, 0.0);
  assert_true(land.at_bed == 300 && land.wet == 0);
  assert_true(!water_heights_are_beds(&land));
}

// A level lake in a regular grid, whose shore is in the middle of its faces.
TEST(a_level_shore_is_no_dry_land)
{
  water_heights_faces faces = { 0 };
  for (int i = 0; i < 100; ++i)
  {
    const double beds[4] = { 0.0, 1.0, 1.0, 0.0 };
    water_heights_add_face(0.55, beds, 4, 0.001, &faces);
  }
  assert_true(faces.cut == 100 && faces.at_bed == 100);
  assert_true(!water_heights_are_beds(&faces));
}

TEST(a_few_faces_and_those_without_values_tell_nothing)
{
  const water_heights_faces few = faces_of(19, 0, 0.1);
  const water_heights_faces enough = faces_of(80, 0, 0.1);
  assert_true(few.cut == 19 && !water_heights_are_beds(&few));
  assert_true(water_heights_are_beds(&enough));
  for (int wet = 9; wet < 11; ++wet) // of 80 whose level is their bed
  {
    water_heights_faces film = { 0 };
    for (int i = 0; i < 80; ++i)
    {
      const double beds[2] = { 1.0 * i, 1.0 * i + 1.0 };
      water_heights_add_face(i + 0.5 + (i < wet ? 0.01 : 0.0), beds, 2, 0.001, &film);
    }
    assert_true(water_heights_are_beds(&film) == (wet == 10));
  }
  water_heights_faces none = { 0 };
  const double beds[3] = { 0.0, 1.0, (double)NAN };
  water_heights_add_face(0.5, beds, 3, 0.0, &none);
  water_heights_add_face(0.5, beds, 0, 0.0, &none);
  water_heights_add_face((double)NAN, beds, 2, 0.0, &none);
  water_heights_add_face(0.0, beds, 2, 0.0, &none);
  water_heights_add_face(1.0, beds, 2, 0.0, &none);
  assert_true(none.cut == 0 && !water_heights_are_beds(&none));
}

// Faces of a relief of 1 whose level is their bed's mean, from low to high; the others are cut well
// over it.
static water_heights_faces films(int at_bed, int others, double low, double high)
{
  water_heights_faces faces = { 0 };
  for (int i = 0; i < at_bed + others; ++i)
  {
    const double mean = i < at_bed ? low + (high - low) * i / (at_bed - 1.0) : 0.0;
    const double beds[2] = { mean - 0.5, mean + 0.5 };
    water_heights_add_face(mean + (i < at_bed ? 0.01 : 0.4), beds, 2, 0.001, &faces);
  }
  return faces;
}

// Each limit by itself: more than half of the faces, 20 of them, levels over more than four
// reliefs.
TEST(limits_of_dry_faces_are_exact)
{
  const water_heights_faces half = films(40, 40, 0.0, 9.0);
  const water_heights_faces more = films(41, 40, 0.0, 9.0);
  assert_true(half.at_bed == 40 && half.cut == 80);
  assert_false(water_heights_are_beds(&half));
  assert_true(water_heights_are_beds(&more));
  const water_heights_faces twenty = films(20, 0, -3.0, 3.0); // also about 0
  assert_true(twenty.cut == 20 && water_heights_are_beds(&twenty));
  water_heights_faces flat = { .cut = 64, .at_bed = 64, .wet = 64, .relief = 64.0, .high = 4.0 };
  assert_false(water_heights_are_beds(&flat));
  flat.high = 4.001;
  assert_true(water_heights_are_beds(&flat));
  water_heights_faces near = { 0 };
  const double beds[2] = { 0.0, 10.0 };
  water_heights_add_face(
    6.0, beds, 2, 1.0, &near); // a tenth of the relief over the mean, and as deep as a dry place
  assert_true(near.at_bed == 1 && near.wet == 0);
}

TESTS(limits_of_dry_faces_are_exact, levels_of_dry_faces_are_found,
  dry_faces_that_are_not_shown_are_no_matter, a_shore_is_no_dry_land, a_level_shore_is_no_dry_land,
  a_few_faces_and_those_without_values_tell_nothing)
