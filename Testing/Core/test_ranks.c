// SPDX-License-Identifier: BSD-3-Clause
// test_ranks.c: what ranks agree on: the same for each of them, from what all of them sent.
#include "test_scene.h"

#include "water_plan.h"
#include "water_ranks.h"

static const water_rank_frame frame_of_nothing = { WATER_RANKS_FORMAT, sizeof(water_scene), 1.0,
  { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 } };
static const water_rank_frame frame_of_left = { WATER_RANKS_FORMAT, sizeof(water_scene), 1.0,
  { -4.0, -1.0, 2.0, 3.0, 0.0, 5.0 } };
static const water_rank_frame frame_of_right = { WATER_RANKS_FORMAT, sizeof(water_scene), 1.0,
  { 1.0, 6.0, -2.0, 2.5, 1.0, 7.0 } };

static const water_rank_view view_of_left = { 1.0, 77.0, 2.0, 8192.0, 0.0, 3.0,
  { -4.0, -1.0, 2.0, 3.0, 0.0, 0.0 } };
static const water_rank_view view_of_nothing = { 1.0, 77.0, 0.0, 16384.0, 1.0, 9.0,
  { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 } };
static const water_rank_view view_of_right = { 1.0, 77.0, 3.0, 4096.0, 0.0, 4.0,
  { 1.0, 6.0, -2.0, 2.5, 0.0, 0.0 } };

static void assert_bounds(const double actual[6], const double expected[6])
{
  for (int i = 0; i < 6; ++i)
  {
    ASSERT_CLOSE(actual[i], expected[i], 0.0);
  }
}

// The scene is as wide as that of all ranks, whatever their order; who has nothing, or numbers that
// are none, adds nothing.
TEST(bounds_of_all_ranks_are_joined)
{
  static const double all[6] = { -4.0, 6.0, -2.0, 3.0, 0.0, 7.0 };
  static const double none[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  water_rank_frame broken = frame_of_right;
  broken.scene_bounds[1] = INFINITY;
  const water_rank_frame orders[3][4] = { { frame_of_nothing, frame_of_left, broken,
                                            frame_of_right },
    { frame_of_right, frame_of_left, frame_of_nothing, frame_of_nothing },
    { frame_of_left, broken, frame_of_right, frame_of_right } };
  double bounds[6];
  size_t bad_rank = 99;
  for (int i = 0; i < 3; ++i)
  {
    assert_int_equal(water_ranks_join_frames(orders[i], 4, bounds, &bad_rank), WATER_OK);
    assert_bounds(bounds, all);
  }
  assert_int_equal(water_ranks_join_frames(&frame_of_nothing, 1, bounds, &bad_rank), WATER_OK);
  assert_bounds(bounds, none);
  assert_int_equal(bad_rank, 99);
}

// A rank of another version, or with another number of waters, is named; the version first, since
// what such a rank sends means something else.
TEST(rank_that_differs_is_named)
{
  water_rank_frame frames[4] = { frame_of_left, frame_of_nothing, frame_of_right, frame_of_left };
  double bounds[6];
  size_t bad_rank = 99;
  frames[1].water_count = 0.0;
  assert_int_equal(
    water_ranks_join_frames(frames, 4, bounds, &bad_rank), WATER_RANKS_DIFFERENT_WATERS);
  assert_int_equal(bad_rank, 1);
  frames[1].water_count = frames[0].water_count;
  frames[1].automatic = 5.0; // of as many waters, others choose their extent
  assert_int_equal(
    water_ranks_join_frames(frames, 4, bounds, &bad_rank), WATER_RANKS_DIFFERENT_WATERS);
  assert_int_equal(bad_rank, 1);
  frames[2].has_error = 1.0; // before anything is compared
  assert_int_equal(water_ranks_join_frames(frames, 4, bounds, &bad_rank), WATER_RANKS_BAD_WATER);
  assert_int_equal(bad_rank, 2);
  frames[3].format += 1.0;
  assert_int_equal(
    water_ranks_join_frames(frames, 4, bounds, &bad_rank), WATER_RANKS_DIFFERENT_VERSIONS);
  assert_int_equal(bad_rank, 3);
  frames[2].scene_size += 8.0;
  assert_int_equal(
    water_ranks_join_frames(frames, 4, bounds, &bad_rank), WATER_RANKS_DIFFERENT_VERSIONS);
  assert_int_equal(bad_rank, 2);
}

// The least limit, the longest time, all props; software on one rank is software for all.
TEST(facts_of_a_view_are_joined)
{
  static const double all[6] = { -4.0, 6.0, -2.0, 3.0, 0.0, 0.0 };
  static const size_t first[3] = { 0, 2, 2 };
  water_rank_view views[3] = { view_of_left, view_of_nothing, view_of_right };
  views[0].max_samples = 8.0;
  views[1].max_samples = 16.0;
  views[2].max_samples = 4.0;
  for (size_t rank = 0; rank < 3; ++rank)
  {
    water_ranks_view joined;
    size_t bad_rank = 99;
    assert_int_equal(water_ranks_join_views(views, 3, rank, &joined, &bad_rank), WATER_OK);
    assert_int_equal(joined.first_prop, first[rank]);
    assert_int_equal(joined.prop_count, 5);
    assert_int_equal(joined.max_texture_px, 4096);
    assert_int_equal(joined.max_samples, 4);
    assert_true(joined.is_software);
    ASSERT_CLOSE(joined.measured_ms, 9.0, 0.0);
    assert_bounds(joined.surface_bounds, all);
    assert_int_equal(bad_rank, 99);
  }
  const water_rank_view gpus[2] = { view_of_left, view_of_right };
  water_ranks_view joined;
  size_t bad_rank;
  assert_int_equal(water_ranks_join_views(gpus, 2, 1, &joined, &bad_rank), WATER_OK);
  assert_false(joined.is_software);
}

// Of a mesh each rank has a part: all of them plan for the steepest and the highest, whoever has
// it.
TEST(parts_of_a_mesh_are_joined)
{
  water_rank_view views[3] = { view_of_left, view_of_nothing, view_of_right };
  views[2].has_waves = 1.0;
  views[0].slope_rms = 0.25;
  views[2].slope_rms = 0.125;
  views[2].slope_max = INFINITY;
  views[0].wave_height_max = 0.5;
  views[2].wave_height_max = 1.5;
  views[0].is_averaged = 1.0;
  views[1].has_marched_rays = 1.0;
  views[2].wants_peel = 1.0;
  const water_scene root = lake();
  for (size_t rank = 0; rank < 3; ++rank)
  {
    water_ranks_view joined;
    size_t bad_rank;
    assert_int_equal(water_ranks_join_views(views, 3, rank, &joined, &bad_rank), WATER_OK);
    assert_true(joined.is_averaged);
    assert_true(joined.has_marched_rays);
    assert_true(joined.wants_peel);
    const water_scene scene = water_ranks_scene(&root, &joined, NULL);
    assert_true(scene.has_waves);
    ASSERT_CLOSE(scene.slope_rms, 0.25, 0.0);
    assert_true(isinf(scene.slope_max));
    ASSERT_CLOSE(scene.wave_height_max, 1.5, 0.0);
  }
}

// An error of one rank is one of all, before anything is compared.
TEST(error_of_one_rank_is_named)
{
  water_rank_view views[3] = { view_of_left, view_of_nothing, view_of_right };
  water_ranks_view joined;
  memset(&joined, 0, sizeof joined);
  size_t bad_rank = 99;
  views[1].digest += 1.0;
  views[2].has_error = 1.0;
  assert_int_equal(water_ranks_join_views(views, 3, 0, &joined, &bad_rank), WATER_RANKS_BAD_WATER);
  assert_int_equal(bad_rank, 2);
  assert_int_equal(joined.prop_count, 0);
}

// Asking ends once all have deleted their water; one that hides it may show it again.
TEST(all_waters_are_gone)
{
  water_rank_frame frames[2] = { frame_of_left, frame_of_right };
  frames[0].water_count = frames[1].water_count = 0.0;
  frames[1].is_gone = 1.0;
  assert_false(water_ranks_are_gone(frames, 2));
  frames[0].is_gone = 1.0;
  assert_true(water_ranks_are_gone(frames, 2));
  frames[0].water_count = 1.0;
  assert_false(water_ranks_are_gone(frames, 2));
}

// Ranks whose waters differ make no plan, and what was known stays.
TEST(waters_that_differ_are_refused)
{
  water_rank_view views[3] = { view_of_left, view_of_nothing, view_of_right };
  water_ranks_view joined;
  memset(&joined, 0, sizeof joined);
  size_t bad_rank = 99;
  views[2].digest += 1.0;
  assert_int_equal(
    water_ranks_join_views(views, 3, 0, &joined, &bad_rank), WATER_RANKS_DIFFERENT_LOOKS);
  assert_int_equal(bad_rank, 2);
  views[1].sheet_count = 2.0;
  assert_int_equal(
    water_ranks_join_views(views, 3, 2, &joined, &bad_rank), WATER_RANKS_DIFFERENT_WATERS);
  assert_int_equal(bad_rank, 1);
  assert_int_equal(joined.prop_count, 0);
}

// A pond with land on four sides, of which each rank has a part.
static water_prop land(double x, double y, double top)
{
  const water_prop made = { { x - 1.0, x + 1.0, y - 1.0, y + 1.0, -1.0, top }, WATER_PROP_VISIBLE,
    0.0f };
  return made;
}

// Each rank plans the same, bit by bit, as one that has all of it, though the root alone knows the
// eye, and another rank sees the water hidden.
TEST(every_rank_makes_the_same_plan)
{
  const water_prop props[5] = { land(-3.0, 0.0, 4.0), land(3.0, 0.0, 9.0), land(0.0, 60.0, 2.0),
    land(0.0, 5.0, 3.0), land(2.0, 8.0, 1.0) };
  water_scene serial = lake();
  serial.props = props;
  serial.prop_count = 5;
  water_plan expected;
  water_cull_reason reasons[5];
  assert_int_equal(water_plan_make(&serial, &expected, reasons), WATER_OK);
  assert_int_equal(expected.decision, WATER_REFLECT);

  water_scene root = serial;
  root.props = NULL;
  root.prop_count = 2;
  root.is_hidden = true;
  root.has_scene_depth = true;
  root.is_software = true;
  root.max_texture_px = 5;
  root.max_samples = 1;
  memset(root.surface_bounds, 0, sizeof root.surface_bounds);
  water_rank_view views[3] = { view_of_left, view_of_nothing, view_of_right };
  for (int i = 0; i < 3; ++i)
  {
    views[i].is_software = serial.is_software;
    views[i].max_texture_px = serial.max_texture_px;
    views[i].max_samples = serial.max_samples;
    memcpy(views[i].surface_bounds, serial.surface_bounds, sizeof serial.surface_bounds);
    views[i].has_waves = serial.has_waves;
    views[i].slope_rms = serial.slope_rms;
    views[i].slope_max = serial.slope_max;
    views[i].wave_height_max = serial.wave_height_max;
  }
  for (size_t rank = 0; rank < 3; ++rank)
  {
    water_ranks_view joined;
    size_t bad_rank;
    assert_int_equal(water_ranks_join_views(views, 3, rank, &joined, &bad_rank), WATER_OK);
    const water_scene scene = water_ranks_scene(&root, &joined, props);
    water_plan plan;
    water_cull_reason own[5];
    assert_int_equal(water_plan_make(&scene, &plan, own), WATER_OK);
    assert_memory_equal(&plan, &expected, sizeof plan);
    assert_memory_equal(own, reasons, sizeof own);
  }
}

// Every number counts, and so does the order.
TEST(digest_tells_numbers_apart)
{
  const double numbers[3] = { 1.0, 2.0, 3.0 };
  const double others[3] = { 2.0, 1.0, 3.0 };
  const uint64_t none = WATER_RANKS_DIGEST_BEGIN;
  assert_true(water_ranks_digest(none, numbers, 0) == none);
  const uint64_t digest = water_ranks_digest(none, numbers, 3);
  assert_true(digest == water_ranks_digest(water_ranks_digest(none, numbers, 1), numbers + 1, 2));
  assert_true(digest != water_ranks_digest(none, others, 3));
  assert_true(digest != water_ranks_digest(none, numbers, 2));
  // the published value of the byte 0 eight times: 64 bits of 0.0
  const double zero = 0.0;
  uint64_t expected = none;
  for (int i = 0; i < 8; ++i)
  {
    expected *= UINT64_C(1099511628211);
  }
  assert_true(water_ranks_digest(none, &zero, 1) == expected);
  ASSERT_CLOSE(water_ranks_digest_number(UINT64_MAX), 9007199254740991.0, 0.0);
  ASSERT_CLOSE(water_ranks_digest_number(UINT64_C(1) << 11), 1.0, 0.0);
}

// So does every number of a wave, and how many there are.
TEST(digest_tells_waves_apart)
{
  const water_wave_term one[2] = { { .k = 1.0 }, { .k = 2.0 } };
  const uint64_t digest = water_ranks_digest_waves(WATER_RANKS_DIGEST_BEGIN, one, 2);
  for (int i = 0; i < 8; ++i)
  {
    water_wave_term other[2] = { one[0], one[1] };
    double* const numbers[8] = { &other[1].dir[0], &other[1].dir[1], &other[1].turns_per_m[0],
      &other[1].turns_per_m[1], &other[1].k, &other[1].amplitude, &other[1].steepness,
      &other[1].turns };
    *numbers[i] += 0.5;
    assert_true(digest != water_ranks_digest_waves(WATER_RANKS_DIGEST_BEGIN, other, 2));
  }
  assert_true(digest != water_ranks_digest_waves(WATER_RANKS_DIGEST_BEGIN, one, 1));
  assert_true(digest == water_ranks_digest_waves(WATER_RANKS_DIGEST_BEGIN, one, 2));
}

// So does every setting.
TEST(digest_tells_settings_apart)
{
  const water_settings one = { .texture_scale = 1.0 };
  const uint64_t digest = water_ranks_digest_settings(WATER_RANKS_DIGEST_BEGIN, &one);
  for (int i = 0; i < 11; ++i)
  {
    water_settings other = one;
    double* const numbers[7] = { &other.texture_scale, &other.guard_band, &other.clip_margin,
      &other.prop_px_min, &other.reflectance_error, &other.target_error_px, &other.time_budget_ms };
    if (i < 7)
    {
      *numbers[i] += 0.5;
    }
    other.skips += i == 7;
    other.multi_samples += i == 8;
    other.color_precision = i == 9 ? WATER_COLOR_HALF_FLOAT : other.color_precision;
    other.quality = i == 10 ? WATER_QUALITY_UPDATE_RATE : other.quality;
    assert_true(digest != water_ranks_digest_settings(WATER_RANKS_DIGEST_BEGIN, &other));
  }
  assert_true(digest == water_ranks_digest_settings(WATER_RANKS_DIGEST_BEGIN, &one));
}

// What one rank could not draw nobody shows; what one refused is left out by all in a second draw.
TEST(draws_are_joined)
{
  const water_rank_drawn none = { 0.0, 0.0, 0.0, 0.0, { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 } };
  water_rank_drawn drawn[3] = { none, none, none };
  double bounds[3][6];
  bool has_blended = true;
  size_t bad_rank = 99;
  assert_int_equal(
    water_ranks_join_drawn(drawn, 3, bounds, &has_blended, &bad_rank), WATER_RANKS_DRAWN);
  assert_false(has_blended);
  assert_true(bounds[1][0] > bounds[1][1]); // of those that blend nothing
  drawn[1].has_blended = 1.0;
  assert_int_equal(
    water_ranks_join_drawn(drawn, 3, bounds, &has_blended, &bad_rank), WATER_RANKS_DRAWN);
  assert_true(has_blended);
  assert_bounds(bounds[1], none.blended_bounds);
  assert_int_equal(bad_rank, 99);
  drawn[2].has_failed = 1.0;
  assert_int_equal(
    water_ranks_join_drawn(drawn, 3, bounds, &has_blended, &bad_rank), WATER_RANKS_FAILED);
  assert_int_equal(bad_rank, 2);
  drawn[1].has_failed = 1.0;
  assert_int_equal(
    water_ranks_join_drawn(drawn, 3, bounds, &has_blended, &bad_rank), WATER_RANKS_FAILED);
  assert_int_equal(bad_rank, 1);
  drawn[0].is_aborted = 1.0;
  assert_int_equal(
    water_ranks_join_drawn(drawn, 3, bounds, &has_blended, &bad_rank), WATER_RANKS_ABORTED);
  drawn[1].wants_again = 1.0;
  assert_int_equal(
    water_ranks_join_drawn(drawn, 3, bounds, &has_blended, &bad_rank), WATER_RANKS_DRAW_AGAIN);
}

// A box around all that a rank blends; none around nothing, nor around what has no place.
TEST(blended_props_are_boxed)
{
  static const double one[6] = { 1.0, 2.0, -3.0, 4.0, 0.0, 0.5 };
  static const double two[6] = { -1.0, 1.5, 0.0, 5.0, 0.25, 2.0 };
  static const double none[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  static const double endless[6] = { 0.0, INFINITY, 0.0, 1.0, 0.0, 1.0 };
  static const double both[6] = { -1.0, 2.0, -3.0, 5.0, 0.0, 2.0 };
  water_rank_drawn drawn = water_rank_drawn_begin();
  assert_bounds(drawn.blended_bounds, none);
  ASSERT_CLOSE(
    drawn.has_blended + drawn.has_failed + drawn.is_aborted + drawn.wants_again, 0.0, 0.0);
  water_rank_drawn_add(none, &drawn);
  water_rank_drawn_add(endless, &drawn);
  assert_bounds(drawn.blended_bounds, none);
  water_rank_drawn_add(one, &drawn);
  water_rank_drawn_add(two, &drawn);
  assert_bounds(drawn.blended_bounds, both);
}

// A view is of calm water, and not averaged, if it is so on all ranks.
TEST(calm_on_all_ranks_is_calm)
{
  water_rank_view views[2] = { view_of_left, view_of_right };
  for (int i = 0; i < 2; ++i)
  {
    views[i].has_waves = 0.0;
    views[i].is_averaged = 0.0;
    views[i].has_marched_rays = 0.0;
    views[i].wants_peel = 0.0;
  }
  water_ranks_view joined;
  size_t bad_rank;
  assert_int_equal(water_ranks_join_views(views, 2, 0, &joined, &bad_rank), WATER_OK);
  assert_false(joined.has_waves);
  assert_false(joined.is_averaged);
  assert_false(joined.has_marched_rays);
  assert_false(joined.wants_peel);
}

// Where the ranks' pictures are blended in an order, the farthest rank shows the water; the root
// says which that is.
TEST(water_is_shown_by_all_ranks_or_by_the_farthest)
{
  for (size_t rank = 0; rank < 3; ++rank)
  {
    assert_true(water_rank_shows_water(-1, rank));
    assert_int_equal(water_rank_shows_water(2, rank), rank == 2);
    assert_int_equal(water_rank_shows_water(0, rank), rank == 0);
  }
  static const double roots[] = { -1.0, 0.0, 2.0, -7.0 };
  static const int agreed[] = { -1, 0, 2, -1 };
  water_rank_view views[3] = { view_of_left, view_of_nothing, view_of_right };
  views[1].farthest_rank = 1.0; // counts for nothing
  water_ranks_view joined;
  size_t bad_rank;
  for (int i = 0; i < 4; ++i)
  {
    views[0].farthest_rank = roots[i];
    assert_int_equal(water_ranks_join_views(views, 3, 1, &joined, &bad_rank), WATER_OK);
    assert_int_equal(joined.farthest_rank, agreed[i]);
  }
}

TEST(farthest_rank_that_does_not_exist_is_refused)
{
  static const double wrong[] = { 3.0, 1e9, NAN };
  water_rank_view views[3] = { view_of_left, view_of_nothing, view_of_right };
  water_ranks_view joined;
  size_t bad_rank;
  for (int i = 0; i < 3; ++i)
  {
    views[0].farthest_rank = wrong[i];
    assert_int_equal(
      water_ranks_join_views(views, 3, 1, &joined, &bad_rank), WATER_RANKS_NO_SUCH_RANK);
  }
}

// A rank that has sent nothing is noticed, wherever it is; those of all are moved together.
TEST(numbers_of_a_lost_rank_are_refused)
{
  const double sent[9] = { 1.0, 2.0, WATER_RANKS_IS_HERE, 3.0, 4.0, WATER_RANKS_IS_HERE, 5.0, 6.0,
    WATER_RANKS_IS_HERE };
  double numbers[9];
  memcpy(numbers, sent, sizeof sent);
  assert_true(water_ranks_take_numbers(numbers, 2, 3));
  for (int i = 0; i < 6; ++i)
  {
    ASSERT_CLOSE(numbers[i], i + 1.0, 0.0);
  }
  for (size_t lost = 0; lost < 3; ++lost)
  {
    memcpy(numbers, sent, sizeof sent);
    memset(numbers + 3 * lost, 0, 3 * sizeof *numbers);
    assert_false(water_ranks_take_numbers(numbers, 2, 3));
  }
}

// The rectangle is around those of all ranks that show clear water, in any order; its samples are
// those of all, or none.
TEST(parts_with_clear_water_are_joined)
{
  const water_rank_part left = { { 10.0, 40.0, 20.0, 5.0 }, 4.0 };
  const water_rank_part right = { { 15.0, 30.0, 90.0, 12.0 }, 4.0 };
  const water_rank_part flat = { { 0.0, 0.0, 500.0, 0.0 }, 4.0 };
  const water_rank_part narrow = { { -90.0, -90.0, 0.0, 70.0 }, 8.0 };
  const water_rank_part orders[3][3] = { { left, right, flat }, { flat, right, left },
    { right, flat, left } };
  static const int all[4] = { 10, 30, 95, 15 };
  int rect[4];
  for (int i = 0; i < 3; ++i)
  {
    assert_int_equal(water_ranks_join_parts(orders[i], 3, rect), 4);
    assert_memory_equal(rect, all, sizeof all);
  }
  const water_rank_part unequal[3] = { left, narrow, right };
  assert_int_equal(water_ranks_join_parts(unequal, 3, rect), 0);
  assert_memory_equal(rect, all, sizeof all);
  const water_rank_part none[2] = { flat, flat };
  static const int empty[4] = { 0, 0, 0, 0 };
  assert_int_equal(water_ranks_join_parts(none, 2, rect), 4);
  assert_memory_equal(rect, empty, sizeof empty);
}

TESTS(numbers_of_a_lost_rank_are_refused, parts_with_clear_water_are_joined,
  calm_on_all_ranks_is_calm, water_is_shown_by_all_ranks_or_by_the_farthest,
  farthest_rank_that_does_not_exist_is_refused, bounds_of_all_ranks_are_joined,
  rank_that_differs_is_named, facts_of_a_view_are_joined, parts_of_a_mesh_are_joined,
  error_of_one_rank_is_named, all_waters_are_gone, waters_that_differ_are_refused,
  digest_tells_waves_apart, every_rank_makes_the_same_plan, digest_tells_numbers_apart,
  digest_tells_settings_apart, draws_are_joined, blended_props_are_boxed)
