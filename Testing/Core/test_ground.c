// SPDX-License-Identifier: BSD-3-Clause
// test_ground.c: terrains and basins have ground under all of their water, what stands in it has
// not.
#include "test_main.h"

#include "water_ground.h"

#include <math.h>

static const double scene[6] = { -2.0, 2.0, -1.0, 1.0, -1.0, 1.0 };
static const water_plane level = { { 0.0, 0.0, 2.0 }, 0.0 };

static water_ground begun(void)
{
  water_ground ground;
  assert_int_equal(water_ground_begin(&level, scene, &ground), WATER_OK);
  return ground;
}

static water_footprint nothing(void)
{
  water_footprint footprint;
  water_footprint_begin(&footprint);
  return footprint;
}

static void add(
  const water_ground* ground, double x, double y, double height, water_footprint* footprint)
{
  const double point[3] = { x, y, height };
  water_ground_see_point(ground, point, footprint);
}

typedef double (*height_of)(double x, double y);

static double hills(double x, double y)
{
  return 0.3 * sin(3.0 * x) * cos(2.0 * y) - 0.05;
}

static double nowhere(double x, double y)
{
  (void)x;
  (void)y;
  return (double)NAN;
}

// A thing over the scene's bounds, or the part of them that is in an ellipse, from its base to its
// height; without a base it is a surface.
static water_ground ground_of(height_of height, height_of base, int points, bool is_round)
{
  water_ground ground = begun();
  water_footprint thing = nothing();
  for (int i = 0; i <= points; ++i)
  {
    for (int j = 0; j <= points; ++j)
    {
      const double x = -2.0 + 4.0 * i / points;
      const double y = -1.0 + 2.0 * j / points;
      if (!is_round || 0.25 * x * x + y * y <= 1.0)
      {
        add(&ground, x, y, height(x, y), &thing);
        add(&ground, x, y, base(x, y), &thing);
      }
    }
  }
  water_ground_add_thing(&thing, NULL, &ground);
  return ground;
}

static bool has_ground(height_of height, height_of base, int points, bool is_round, double level_at)
{
  const water_ground ground = ground_of(height, base, points, is_round);
  return water_ground_is_under(&ground, level_at);
}

static double flat_base(double x, double y)
{
  (void)x;
  (void)y;
  return -1.0;
}

static double deck(double x, double y)
{
  (void)x;
  (void)y;
  return 0.4;
}

static double pyramid(double x, double y)
{
  return 0.5 - 1.5 * fmax(0.5 * fabs(x), fabs(y));
}

static double dome(double x, double y)
{
  return -1.0 + 2.0 * sqrt(fmax(1.0 - 0.25 * x * x - y * y, 0.0));
}

static double hull(double x, double y)
{
  return -dome(x, y) - 0.6;
}

static double half_cylinder(double x, double y)
{
  (void)x;
  return -1.0 + sqrt(fmax(1.0 - y * y, 0.0));
}

static double gable_roof(double x, double y)
{
  (void)x;
  return 0.5 - 1.5 * fabs(y);
}

static double island(double x, double y)
{
  return 0.8 * exp(-4.0 * (0.25 * x * x + y * y)) - 0.3;
}

static double cone(double x, double y)
{
  return 0.6 - hypot(0.5 * x, y);
}

static double shore(double x, double y)
{
  (void)y;
  return 0.2 * x;
}

TEST(terrain_is_ground)
{
  const height_of lands[4] = { hills, island, cone, shore };
  for (int i = 0; i < 4; ++i)
  {
    assert_true(has_ground(lands[i], nowhere, 100, false, 0.0));
    assert_true(has_ground(lands[i], nowhere, 12, false, 0.0));
    assert_true(has_ground(lands[i], nowhere, 100, false, -5.0));  // it stands in the dry
    assert_true(has_ground(lands[i], flat_base, 200, false, 0.0)); // with a skirt
  }
}

TEST(solids_are_objects)
{
  const height_of tops[5] = { pyramid, dome, deck, half_cylinder, gable_roof };
  for (int i = 0; i < 5; ++i)
  {
    for (double level_at = -0.9; level_at < 0.4; level_at += 0.1)
    {
      assert_false(has_ground(tops[i], flat_base, 200, false, level_at));
      assert_false(has_ground(tops[i], flat_base, 200, true, level_at));
    }
  }
  assert_false(has_ground(deck, hull, 200, false, 0.0));
}

// Between its base and its top it is an island with cliffs, and the sea is around it.
TEST(a_block_of_land_is_ground_with_water_over_it)
{
  assert_false(has_ground(hills, flat_base, 200, false, -0.5));
  assert_true(has_ground(hills, flat_base, 200, false, -0.2));
  assert_true(has_ground(hills, flat_base, 200, false, 1.0));
}

TEST(round_things_are_not_ground)
{
  assert_false(has_ground(hills, nowhere, 100, true, 0.0));
}

static double is_row_of_boxes(double x, double y)
{
  (void)y;
  return fmod(x + 2.2, 1.0) <= 0.4 ? 0.3 : (double)NAN;
}

TEST(things_in_a_row_are_not)
{
  assert_false(has_ground(is_row_of_boxes, nowhere, 100, false, 0.0));
}

TEST(few_points_are_no_ground)
{
  assert_false(has_ground(hills, nowhere, 1, false, 0.0)); // four corners
  water_ground ground = begun();
  assert_false(water_ground_is_under(&ground, 0.0));
}

TEST(a_bed_under_the_water_is_ground)
{
  const double beds[5][6] = {
    { -1.9, 1.9, -0.9, 0.9, -2.0, -1.0 }, // wide and under it
    { -1.9, 1.9, -0.9, 0.9, -2.0, 0.1 },  // stands out
    { -1.0, 1.0, -0.9, 0.9, -2.0, -1.0 }, // as wide as half of it
    { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 },  // empty
    { -1.9, 1.9, -0.9, 0.9, -2.0, (double)NAN },
  };
  for (int i = 0; i < 5; ++i)
  {
    water_ground ground = begun();
    water_ground_add_bounds(beds[i], &ground);
    assert_true(water_ground_is_under(&ground, 0.0) == (i == 0));
  }
}

// Wholly under water a slab is a bed; a pyramid, a dome and a column are none.
TEST(what_may_be_a_bed)
{
  const struct
  {
    height_of top;
    height_of base;
    bool is_bed;
  } things[] = { { hills, nowhere, true }, { hills, flat_base, true },
    { pyramid, flat_base, false }, { dome, flat_base, false }, { deck, flat_base, false },
    { deck, hills, true } };
  for (size_t i = 0; i < sizeof things / sizeof things[0]; ++i)
  {
    water_ground ground = ground_of(things[i].top, things[i].base, 200, false);
    water_footprint thing = nothing();
    for (int j = 0; j < 201 * 201; ++j)
    {
      const double x = -2.0 + 0.02 * (j % 201);
      const double y = -1.0 + 0.01 * (j / 201);
      add(&ground, x, y, things[i].top(x, y), &thing);
      add(&ground, x, y, things[i].base(x, y), &thing);
    }
    assert_int_equal(water_ground_add_thing(&thing, NULL, &ground), things[i].is_bed);
    assert_int_equal(water_ground_is_under(&ground, 2.0), things[i].is_bed);
  }
  water_ground ground = begun();
  const water_footprint empty = nothing();
  assert_true(water_ground_add_thing(&empty, NULL, &ground)); // a volume has bounds and no points
}

TEST(numbers_that_are_none_count_nothing)
{
  water_ground ground = begun();
  water_footprint thing = nothing();
  for (int i = 0; i < 1000; ++i)
  {
    const double t = (i % 250) / 250.0;
    const double x = i < 250 ? -2.0 + 4.0 * t : i < 500 ? 2.0 : i < 750 ? 2.0 - 4.0 * t : -2.0;
    const double y = i < 250 ? -1.0 : i < 500 ? -1.0 + 2.0 * t : i < 750 ? 1.0 : 1.0 - 2.0 * t;
    add(&ground, x, y, (double)NAN, &thing);
    add(&ground, x, (double)NAN, 0.0, &thing);
  }
  water_ground_add_thing(&thing, NULL, &ground);
  assert_false(water_ground_is_under(&ground, 0.0));
}

// Twice the area of a quadrilateral in the plane; positive if it is counter-clockwise.
static double area_of(const double part[12])
{
  return (part[6] - part[0]) * (part[10] - part[4]) - (part[9] - part[3]) * (part[7] - part[1]);
}

static bool is_inside(const double part[12], double x, double y)
{
  for (int i = 0; i < 4; ++i)
  {
    const double* from = part + 3 * i;
    const double* to = part + 3 * ((i + 1) % 4);
    if ((to[0] - from[0]) * (y - from[1]) - (to[1] - from[1]) * (x - from[0]) < -1e-12)
    {
      return false;
    }
  }
  return true;
}

static double wet_area(const water_ground* ground, double water_level)
{
  double area = 0.0;
  for (int i = 0; i < WATER_GROUND_CELLS * WATER_GROUND_CELLS; ++i)
  {
    double parts[24];
    const int count =
      water_ground_wet(ground, water_level, i % WATER_GROUND_CELLS, i / WATER_GROUND_CELLS, parts);
    assert_in_range(count, 0, 2);
    for (int j = 0; j < count; ++j)
    {
      assert_true(area_of(parts + 12 * j) > -1e-12);
      area += 0.5 * area_of(parts + 12 * j);
    }
  }
  return area;
}

static bool is_wet(const water_ground* ground, double water_level, double x, double y)
{
  const int column = (int)fmin((x + 2.0) / 4.0 * WATER_GROUND_CELLS, WATER_GROUND_CELLS - 1.0);
  const int row = (int)fmin((y + 1.0) / 2.0 * WATER_GROUND_CELLS, WATER_GROUND_CELLS - 1.0);
  double parts[24];
  const int count = water_ground_wet(ground, water_level, column, row, parts);
  return (count > 0 && is_inside(parts, x, y)) || (count > 1 && is_inside(parts + 12, x, y));
}

static double area_of_parts(const double* parts, int count)
{
  double area = 0.0;
  for (int j = 0; j < count; ++j)
  {
    assert_true(area_of(parts + 12 * j) > -1e-12);
    area += 0.5 * area_of(parts + 12 * j);
  }
  return area;
}

// The same, drawn in blocks.
static double block_area(const water_ground* ground, double water_level, int* part_count)
{
  water_blocks blocks;
  *part_count = 0;
  double area = 0.0;
  const bool is_any_dry = water_ground_find_blocks(ground, water_level, &blocks);
  bool has_none = false;
  for (int i = 0; i < WATER_GROUND_CELLS * WATER_GROUND_CELLS; ++i)
  {
    const int x = i % WATER_GROUND_CELLS;
    const int y = i / WATER_GROUND_CELLS;
    double parts[96];
    int count = 0;
    if (water_blocks_begins(&blocks, x, y))
    {
      count = water_ground_block(ground, water_level, &blocks, x, y, parts);
      const int cells = 1 << blocks.size[y][x];
      ASSERT_CLOSE(area_of_parts(parts, count),
        8.0 * cells * cells / (WATER_GROUND_CELLS * WATER_GROUND_CELLS), 1e-12);
      int middles = 0; // with the neighbours' vertices: halves of these sides, and the other sides
      for (int side = 0; side < 4; ++side)
      {
        middles += water_blocks_has_middle(&blocks, x, y, side) ? 1 : 0;
      }
      assert_int_equal(count, middles == 0 ? 1 : 4 + middles);
      for (int j = 0; j < count; ++j)
      {
        assert_true(area_of(parts + 12 * j) > 1e-9);
      }
    }
    else if (blocks.cell[y][x] == WATER_CELL_PART)
    {
      count = water_ground_wet(ground, water_level, x, y, parts);
    }
    has_none = has_none || blocks.cell[y][x] == WATER_CELL_NONE;
    area += area_of_parts(parts, count);
    *part_count += count;
  }
  assert_int_equal(is_any_dry, has_none);
  return area;
}

// Where nothing is known all of the scene is wet, at the level.
TEST(cells_cover_the_scene)
{
  const water_ground ground = begun();
  double parts[24];
  assert_int_equal(water_ground_wet(&ground, 0.25, 0, 0, parts), 1);
  ASSERT_CLOSE(parts[0], -2.0, 1e-12);
  ASSERT_CLOSE(parts[1], -1.0, 1e-12);
  ASSERT_CLOSE(parts[2], 0.25, 1e-12);
  ASSERT_CLOSE(wet_area(&ground, 0.25), 8.0, 1e-9);
}

// The samples of a triangle leave out no cell whose middle it covers.
TEST(triangles_are_seen_in_all_of_their_cells)
{
  double triangles[4][3][3] = { { { -2.0, -1.0, 0.0 }, { 2.0, -1.0, 0.0 }, { -2.0, 1.0, 0.0 } },
    { { 2.0, 1.0, 0.0 }, { -2.0, 0.9, 0.0 }, { -1.9, -1.0, 0.0 } },
    { { 0.1, 0.1, 0.0 }, { 0.9, 0.2, 0.0 }, { 0.3, 0.8, 0.0 } },
    { { 0.01, 0.0, 0.0 }, { 0.02, 0.0, 0.0 }, { 0.01, 0.01, 0.0 } } };
  const water_ground ground = begun();
  assert_int_equal(water_ground_across(&ground, triangles[3]), 1);
  for (int i = 0; i < 4; ++i)
  {
    double(*corner)[3] = triangles[i];
    water_footprint thing = nothing();
    const int across = water_ground_across(&ground, corner);
    assert_in_range(across, 1, 2 * WATER_GROUND_CELLS);
    const double side[2][2] = { { corner[1][0] - corner[0][0], corner[1][1] - corner[0][1] },
      { corner[2][0] - corner[0][0], corner[2][1] - corner[0][1] } };
    const double area = side[0][0] * side[1][1] - side[0][1] * side[1][0];
    for (int j = 0; j < across * across; ++j)
    {
      const double u = (j % across + 0.5) / across;
      const double v = (j / across + 0.5) / across;
      if (u + v <= 1.0)
      {
        add(&ground, corner[0][0] + u * side[0][0] + v * side[1][0],
          corner[0][1] + u * side[0][1] + v * side[1][1], 0.0, &thing);
      }
    }
    for (int j = 0; j < WATER_GROUND_CELLS * WATER_GROUND_CELLS; ++j)
    {
      const int column = j % WATER_GROUND_CELLS;
      const int row = j / WATER_GROUND_CELLS;
      const double x = -2.0 + 4.0 * (column + 0.5) / WATER_GROUND_CELLS - corner[0][0];
      const double y = -1.0 + 2.0 * (row + 0.5) / WATER_GROUND_CELLS - corner[0][1];
      const double u = (x * side[1][1] - y * side[1][0]) / area;
      const double v = (y * side[0][0] - x * side[0][1]) / area;
      const bool is_covered = u > 0.02 && v > 0.02 && u + v < 0.98;
      assert_true(!is_covered || water_footprint_has(&thing, column, row));
    }
  }
}

// A plane without a normal and a scene without bounds have no ground.
TEST(bad_scenes_have_no_ground)
{
  const water_plane none = { { 0.0, 0.0, 0.0 }, 0.0 };
  const double empty[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  water_ground ground;
  assert_int_not_equal(water_ground_begin(&none, scene, &ground), WATER_OK);
  assert_false(water_ground_is_under(&ground, 0.0));
  assert_int_not_equal(water_ground_begin(&level, empty, &ground), WATER_OK);
  assert_false(water_ground_is_under(&ground, 0.0));
}

static double ridge(double x, double y)
{
  return 1.0 - fabs(x + 0.7 * y);
}

static double islands(double x, double y)
{
  return 0.4 * cos(5.0 * x) * cos(5.0 * y) - 0.1;
}

// All that is under the level is wet, and of what is over it all but a border of two to three
// cells.
TEST(ground_is_dry_where_it_stands_out)
{
  double (*const heights[2])(double, double) = { ridge, islands };
  const double widest[2] = { 0.19, 0.3 }; // m of height that the border holds
  for (int k = 0; k < 2; ++k)
  {
    water_ground ground = begun();
    water_footprint thing = nothing();
    for (int i = 0; i <= 400; ++i)
    {
      for (int j = 0; j <= 400; ++j)
      {
        const double x = -2.0 + 0.01 * i;
        const double y = -1.0 + 0.005 * j;
        add(&ground, x, y, heights[k](x, y), &thing);
      }
    }
    water_ground_add_thing(&thing, NULL, &ground);
    int wet_count = 0;
    for (int i = 0; i < 40000; ++i)
    {
      const double x = -1.99 + 3.98 * (i % 200) / 199.0;
      const double y = -0.99 + 1.98 * (i / 200) / 199.0;
      const double height = heights[k](x, y);
      const bool is = is_wet(&ground, 0.05, x, y);
      assert_true(is || height > 0.05);
      assert_true(!is || height < 0.05 + widest[k]);
      wet_count += is ? 1 : 0;
    }
    ASSERT_CLOSE(wet_area(&ground, 0.05), 8.0 * wet_count / 40000.0, 0.08);
    ASSERT_CLOSE(wet_area(&ground, 5.0), 8.0, 1e-9);
    int count = 0;
    ASSERT_CLOSE(block_area(&ground, 0.05, &count), wet_area(&ground, 0.05), 1e-9);
    assert_in_range(count, 1, WATER_GROUND_CELLS * WATER_GROUND_CELLS / 2);
    ASSERT_CLOSE(block_area(&ground, 5.0, &count), 8.0, 1e-9);
    assert_int_equal(count, 1);
  }
}

// What nobody knows is wet, up to what is known to be dry.
TEST(ground_is_wet_where_nothing_is_known)
{
  water_ground ground = begun();
  water_footprint thing = nothing();
  add(&ground, 0.0, 0.0, 1.0, &thing);
  water_ground_add_thing(&thing, NULL, &ground);
  ASSERT_CLOSE(wet_area(&ground, 0.0), 8.0, 1e-9);
  for (int i = 0; i <= 200; ++i)
  {
    for (int j = 0; j <= 200; ++j)
    {
      add(&ground, 0.01 * i, -1.0 + 0.01 * j, 1.0, &thing); // the half of it
    }
  }
  water_ground_add_thing(&thing, NULL, &ground);
  ASSERT_CLOSE(wet_area(&ground, 0.0), 4.0 + 2.0 * 2.0 * 4.0 / WATER_GROUND_CELLS, 0.13);
}

// What has few cells is a surface, whatever it looks like; nothing is wet of what has none.
TEST(little_is_known_of_few_cells)
{
  water_footprint thing = nothing();
  assert_int_equal(water_footprint_shape_of(&thing), WATER_FOOTPRINT_SURFACE);
  assert_true(isinf(water_footprint_wet_from(&thing)));
  assert_false(water_footprint_has(&thing, -1, 3));
  assert_false(water_footprint_has(&thing, 3, WATER_FOOTPRINT_CELLS));
  for (int i = 0; i < 16; ++i)
  {
    assert_int_equal(water_footprint_shape_of(&thing), WATER_FOOTPRINT_SURFACE);
    water_footprint_add(i % 4, i / 4, 0.0, &thing);
    water_footprint_add(i % 4, i / 4, 1.0 + i, &thing);
  }
  water_footprint_add(0, 0, 5.0, &thing);
  ASSERT_CLOSE(water_footprint_wet_from(&thing), 2.0, 1e-5);
}

static double tank(double x, double y)
{
  return fmax(fabs(0.5 * x), fabs(y)) < 0.95 ? -0.7 : 0.5;
}

TEST(beds_of_tanks_are_flat)
{
  const struct
  {
    height_of height;
    double level;
    bool is_flat;
  } beds[] = { { tank, 0.0, true }, { tank, -0.5, true }, { tank, -0.8, false },
    { deck, 1.0, true }, { hills, 0.0, false }, { island, 0.0, false }, { shore, 0.0, false },
    { cone, 0.0, false }, { hills, 5.0, true } };
  for (size_t i = 0; i < sizeof beds / sizeof beds[0]; ++i)
  {
    const water_ground ground = ground_of(beds[i].height, nowhere, 200, false);
    assert_int_equal(water_ground_is_flat(&ground, beds[i].level), beds[i].is_flat);
  }
  const water_ground ground = begun();
  assert_false(water_ground_is_flat(&ground, 0.0));
}

TESTS(beds_of_tanks_are_flat, terrain_is_ground, solids_are_objects,
  a_block_of_land_is_ground_with_water_over_it, round_things_are_not_ground,
  things_in_a_row_are_not, few_points_are_no_ground, a_bed_under_the_water_is_ground,
  what_may_be_a_bed, numbers_that_are_none_count_nothing, cells_cover_the_scene,
  triangles_are_seen_in_all_of_their_cells, bad_scenes_have_no_ground,
  ground_is_dry_where_it_stands_out, ground_is_wet_where_nothing_is_known,
  little_is_known_of_few_cells)
