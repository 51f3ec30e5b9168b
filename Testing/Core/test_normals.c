// SPDX-License-Identifier: BSD-3-Clause
// test_normals.c: the built-in normal map, and the motion of maps.
#include "test_scene.h"

#include "water_normals.h"

enum
{
  SIZE = 128
};

static unsigned char pixels[3 * SIZE * SIZE];
static unsigned char others[3 * SIZE * SIZE];

static double part(const unsigned char* map, size_t x, size_t y, size_t channel)
{
  return map[3 * ((y % SIZE) * SIZE + x % SIZE) + channel] / 127.5 - 1.0;
}

// Unit normals that point up, level on average, with the promised rms slope.
TEST(map_holds_unit_normals)
{
  water_normals_fill(SIZE, 1, pixels);
  double mean[2] = { 0.0, 0.0 };
  double square = 0.0;
  for (size_t i = 0; i < SIZE * SIZE; ++i)
  {
    const double n[3] = { part(pixels, i, i / SIZE, 0), part(pixels, i, i / SIZE, 1),
      part(pixels, i, i / SIZE, 2) };
    ASSERT_CLOSE(sqrt(dot(n, n)), 1.0, 0.01);
    assert_true(n[2] > 0.8);
    mean[0] += n[0] / n[2];
    mean[1] += n[1] / n[2];
    square += (n[0] * n[0] + n[1] * n[1]) / (n[2] * n[2]);
  }
  ASSERT_CLOSE(mean[0] / (SIZE * SIZE), 0.0, 0.01);
  ASSERT_CLOSE(mean[1] / (SIZE * SIZE), 0.0, 0.01);
  ASSERT_CLOSE(sqrt(square / (SIZE * SIZE)), 0.1, 0.015);
}

// The step over the edge is no larger than those inside: the map repeats without a seam.
TEST(map_repeats_without_a_seam)
{
  water_normals_fill(SIZE, 1, pixels);
  double inside = 0.0;
  double seam = 0.0;
  for (size_t y = 0; y < SIZE; ++y)
  {
    for (size_t x = 0; x < SIZE; ++x)
    {
      const double across = fabs(part(pixels, x + 1, y, 0) - part(pixels, x, y, 0));
      const double down = fabs(part(pixels, x, y + 1, 1) - part(pixels, x, y, 1));
      double* largest = x == SIZE - 1 || y == SIZE - 1 ? &seam : &inside;
      *largest = fmax(*largest, fmax(across, down));
    }
  }
  assert_true(seam <= 1.01 * inside);
  assert_true(inside < 0.2); // and it is smooth
}

TEST(seed_makes_the_map)
{
  water_normals_fill(SIZE, 1, pixels);
  water_normals_fill(SIZE, 1, others);
  assert_memory_equal(pixels, others, sizeof pixels);
  water_normals_fill(SIZE, 2, others);
  assert_memory_not_equal(pixels, others, sizeof pixels);
}

// A seed is a promise: pictures of today are compared with those of other days.
TEST(map_of_a_seed_stays_as_it_was)
{
  const int size = 64;
  const struct
  {
    int x, y;
    unsigned char texel[3];
  } cases[6] = { { 0, 0, { 126, 124, 255 } }, { 1, 0, { 122, 123, 255 } },
    { 0, 1, { 127, 121, 255 } }, { 17, 5, { 120, 120, 255 } }, { 40, 33, { 142, 134, 254 } },
    { 63, 63, { 131, 125, 255 } } };
  water_normals_fill((size_t)size, 1, pixels);
  for (int i = 0; i < 6; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      // the mathematics library of another system may round a number the other way
      const int level = pixels[3 * (cases[i].y * size + cases[i].x) + j];
      assert_int_in_range(level, cases[i].texel[j] - 1, cases[i].texel[j] + 1);
    }
  }
}

// A map of 4 m that moves along the second axis with 0.5 m/s.
TEST(map_moves_with_time)
{
  const water_normal_map map = { 4.0, 0.5, 1.5707963267948966, 1.0 };
  double place[2];
  water_normals_place(&map, 1.0, 3.0, 0.0, place);
  ASSERT_CLOSE(place[0], 0.25, 1e-15);
  ASSERT_CLOSE(place[1], 0.75, 1e-15);
  water_normals_place(&map, 1.0, 3.0, 2.0, place);
  ASSERT_CLOSE(place[0], 0.25, 1e-15);
  ASSERT_CLOSE(place[1], 0.5, 1e-15);
  water_normals_place(&map, -1.0, -3.0, 0.0, place);
  ASSERT_CLOSE(place[0], 0.75, 1e-15);
  ASSERT_CLOSE(place[1], 0.25, 1e-15);
  water_normals_place(&map, 1.0, 3.0, 8e6, place); // whole maps
  ASSERT_CLOSE(place[1], 0.75, 1e-9);
}

// A map that moves along the first axis is met by a place later, and so along the second.
TEST(normal_map_moves_to_where_it_points)
{
  const water_normal_map map = { 4.0, 1.0, 0.0, 1.0 };
  double place[2];
  water_normals_place(&map, 3.0, 1.0, 1.0, place);
  ASSERT_CLOSE(place[0], 0.5, 1e-15);
  ASSERT_CLOSE(place[1], 0.25, 1e-15);
}

// A place just before a whole map is in [0, 1), too, where its share rounds up to 1.
TEST(place_is_under_one)
{
  const water_normal_map map = { 1.0, 0.0, 0.0, 1.0 };
  double place[2];
  water_normals_place(&map, -1e-20, -1e-300, 0.0, place);
  assert_true(place[0] == 0.0 && place[1] == 0.0);
}

// The normal of a slope of 1 along x; one that faces down is taken for a steep one.
TEST(texels_are_slopes_and_their_squares)
{
  const unsigned char map[8] = { 37, 128, 218, 255, 255, 128, 0, 0 };
  float texels[8];
  water_normals_texels(map, 4, 2, texels);
  ASSERT_CLOSE((double)texels[0], 1.0, 0.01);
  ASSERT_CLOSE((double)texels[1], 0.0, 0.01);
  ASSERT_CLOSE((double)texels[2], (double)texels[0] * (double)texels[0], 1e-6);
  ASSERT_CLOSE((double)texels[3], 0.0, 1e-4);
  ASSERT_CLOSE((double)texels[4], -20.0, 1e-6);
  ASSERT_CLOSE((double)texels[6], 400.0, 1e-4);
}

// All four numbers of all texels: slopes and squares.
TEST(texels_hold_both_slopes_and_squares)
{
  const unsigned char colors[6] = { 255, 51, 255, 0, 204, 255 };
  const float truth[8] = { -1.0f, 0.6f, 1.0f, 0.36f, 1.0f, -0.6f, 1.0f, 0.36f };
  float texels[8];
  water_normals_texels(colors, 3, 2, texels);
  for (int i = 0; i < 8; ++i)
  {
    ASSERT_CLOSE((double)texels[i], (double)truth[i], 1e-6);
  }
}

TEST(bad_numbers_are_named)
{
  const double bad[2] = { (double)NAN, (double)INFINITY };
  const water_normal_map good = { 4.0, 0.5, 1.0, 1.0 };
  assert_int_equal(water_normals_check(&good), WATER_OK);
  for (int i = 0; i < 2; ++i)
  {
    water_normal_map map = good;
    map.size = bad[i];
    assert_int_equal(water_normals_check(&map), WATER_BAD_NORMAL_MAP_SIZE);
    map = good;
    map.speed = bad[i];
    assert_int_equal(water_normals_check(&map), WATER_BAD_NORMAL_MAP_MOTION);
    map = good;
    map.direction_rad = bad[i];
    assert_int_equal(water_normals_check(&map), WATER_BAD_NORMAL_MAP_MOTION);
    map = good;
    map.strength = bad[i];
    assert_int_equal(water_normals_check(&map), WATER_BAD_NORMAL_MAP_STRENGTH);
  }
  water_normal_map map = good;
  map.size = 0.0;
  assert_int_equal(water_normals_check(&map), WATER_BAD_NORMAL_MAP_SIZE);
}

TESTS(map_holds_unit_normals, map_repeats_without_a_seam, seed_makes_the_map,
  map_of_a_seed_stays_as_it_was, map_moves_with_time, normal_map_moves_to_where_it_points,
  place_is_under_one, texels_are_slopes_and_their_squares, texels_hold_both_slopes_and_squares,
  bad_numbers_are_named)
