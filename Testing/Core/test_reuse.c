// SPDX-License-Identifier: BSD-3-Clause
// test_reuse.c: when a reflection texture serves again, when
// the next one waits, and when it is found out what of it is seen.
#include "test_scene.h"

#include "water_plan.h"
#include "water_visibility.h"

// Revises a plan by the last one alone: nothing is known of what is seen.
static void revise(const water_plan* last, bool is_unchanged, unsigned skips, water_plan* plan)
{
  water_scene scene = lake();
  scene.settings.skips = skips;
  water_plan_revise(&scene, last, is_unchanged, NULL, plan, NULL);
}

// A reflection texture serves again for the same view of an unchanged scene, and for no other.
TEST(map_is_used_again_only_for_the_same)
{
  const water_prop tree = { { -1.0, 1.0, 2.0, 4.0, 0.0, 3.0 }, WATER_PROP_VISIBLE };
  water_cull_reason reason;
  water_scene scene = lake();
  scene.props = &tree;
  scene.prop_count = 1;
  const water_plan last = plan_of(&scene, &reason);
  water_plan plan = last;
  revise(&last, true, WATER_MAY_SKIP_ALL, &plan);
  assert_int_equal(plan.decision, WATER_REUSE);
  assert_true(water_plan_has_reflection(&plan));
  const water_plan again = plan;
  plan = last;
  revise(&again, true, WATER_MAY_SKIP_ALL, &plan); // and again
  assert_int_equal(plan.decision, WATER_REUSE);
  plan = last;
  revise(&last, false, WATER_MAY_SKIP_ALL, &plan);
  assert_int_equal(plan.decision, WATER_REFLECT);
  revise(&last, true, WATER_MAY_SKIP_ALL & ~(unsigned)WATER_MAY_SKIP_UNCHANGED, &plan);
  assert_int_equal(plan.decision, WATER_REFLECT);

  // a smaller surface needs less of the reflection texture, a larger one may need more
  water_scene other = scene;
  other.surface_bounds[1] = 1.0;
  plan = plan_of(&other, &reason);
  revise(&last, true, WATER_MAY_SKIP_ALL, &plan);
  assert_int_equal(plan.decision, WATER_REUSE);
  const water_plan smaller = plan_of(&other, &reason);
  plan = plan_of(&scene, &reason);
  revise(&smaller, true, WATER_MAY_SKIP_ALL, &plan);
  assert_int_equal(plan.decision, WATER_REFLECT);

  for (int i = 0; i < 7; ++i)
  {
    other = scene;
    other.eye.world_to_view[3] += i == 0 ? 1e-9 : 0.0;
    other.eye.view_to_clip[0] *= i == 1 ? 1.0001 : 1.0;
    other.plane.offset += i == 2 ? 1e-6 : 0.0;
    other.settings.texture_scale = i == 3 ? 0.5 : 1.0;
    other.settings.clip_margin = i == 4 ? 0.1 : 0.0;
    other.viewport_px[0] += i == 5;
    other.has_waves = i == 6;
    other.slope_rms = 0.05;
    plan = plan_of(&other, &reason);
    revise(&last, true, WATER_MAY_SKIP_ALL, &plan);
    assert_int_equal(plan.decision, WATER_REFLECT);
  }

  // what did not reflect left no reflection texture
  other = scene;
  other.is_hidden = true;
  const water_plan none = plan_of(&other, &reason);
  plan = plan_of(&scene, &reason);
  revise(&none, true, WATER_MAY_SKIP_ALL, &plan);
  assert_int_equal(plan.decision, WATER_REFLECT);
  plan = none;
  revise(&last, true, WATER_MAY_SKIP_ALL, &plan);
  assert_int_equal(plan.decision, WATER_NO_REFLECT_HIDDEN);
}

// A reflection texture is used again only if it covers what is wanted, on each side.
TEST(map_that_lacks_a_column_is_not_used_again)
{
  const water_scene scene = lake();
  const water_plan plan = plan_of(&scene, NULL);
  for (int side = 0; side < 5; ++side)
  {
    water_plan last = plan;
    water_plan next = plan;
    last.texture_rect_px[0] = last.texture_rect_px[1] = 10;
    last.texture_rect_px[2] = last.texture_rect_px[3] = 20;
    memcpy(next.texture_rect_px, last.texture_rect_px, sizeof next.texture_rect_px);
    if (side < 2)
    {
      last.texture_rect_px[side] += 1; // the same end, a later begin
      last.texture_rect_px[2 + side] -= 1;
    }
    else if (side < 4)
    {
      last.texture_rect_px[side] -= 1; // an earlier end
    }
    revise(&last, true, scene.settings.skips, &next);
    assert_int_equal(next.decision, side == 4 ? WATER_REUSE : WATER_REFLECT);
  }
}

// A hundred boxes over a pool.
static void crowd(water_prop props[100])
{
  for (int i = 0; i < 100; ++i)
  {
    const water_prop box = { { -1, 1, -1, 1, 1, 2 }, WATER_PROP_VISIBLE, 0.0f };
    props[i] = box;
  }
}

// The next reflection texture waits when the water was hidden, or when it pays to know what of it
// is seen: when less is than nine tenths of its rectangle.
TEST(map_waits_when_it_pays)
{
  water_scene scene = pool(5.0); // 400 x 300 pixels of 800 x 600, 2 texels more on each side
  water_prop props[100];
  water_cull_reason reasons[100];
  crowd(props);
  scene.is_flat = true;
  scene.props = props;
  const double whole = 404.0 * 304.0;
  const struct
  {
    bool is_software;
    size_t prop_count;
    double texture_scale;
    bool can_wait;
  } cases[] = { { false, 0, 1.0, true }, { false, 100, 0.2, true }, { true, 0, 1.0, true },
    { true, 100, 0.5, true }, { true, 0, 0.2, false } };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
  {
    scene.is_software = cases[i].is_software;
    scene.prop_count = cases[i].prop_count;
    scene.settings.texture_scale = cases[i].texture_scale;
    const water_plan last = plan_of(&scene, reasons);
    const bool is_software = cases[i].is_software;
    assert_int_equal(water_plan_should_wait(&last, 0.85 * whole, is_software, WATER_MAY_SKIP_ALL),
      cases[i].can_wait);
    // a GPU draws the picture meanwhile, whatever it shows
    assert_int_equal(
      water_plan_should_wait(&last, 0.95 * whole, is_software, WATER_MAY_SKIP_ALL), !is_software);
    assert_int_equal(
      water_plan_should_wait(&last, -1.0, is_software, WATER_MAY_SKIP_ALL), !is_software);
    assert_false(is_software && cases[i].can_wait &&
      water_plan_should_wait(&last, last.visible_px_max, is_software, WATER_MAY_SKIP_ALL));
    assert_int_equal(water_plan_should_wait(&last, 0.85 * whole, is_software,
                       WATER_MAY_SKIP_ALL & ~(unsigned)WATER_MAY_SKIP_PIXELS),
      !is_software);
  }
  // hidden: whatever the reflection texture was, unless that may not be skipped
  water_plan none;
  memset(&none, 0, sizeof none);
  assert_true(water_plan_should_wait(&none, 0.0, true, WATER_MAY_SKIP_ALL));
  assert_false(water_plan_should_wait(&none, 1.0, true, WATER_MAY_SKIP_ALL));
  assert_false(water_plan_should_wait(
    &none, 0.0, true, WATER_MAY_SKIP_ALL & ~(unsigned)WATER_MAY_SKIP_HIDDEN));
  // waves look up other pixels than their own
  scene.has_waves = true;
  scene.is_software = true;
  scene.settings.texture_scale = 1.0;
  const water_plan waves = plan_of(&scene, reasons);
  assert_false(water_plan_should_wait(&waves, 1.0, true, WATER_MAY_SKIP_ALL));
}

// What is seen of the reflection texture is found out for flat, calm water whose picture is at
// hand, in a view that has changed: as a mask for a reflection texture with the picture's pixels on
// a GPU, as cells in software or for many draws.
TEST(what_is_seen_is_found_out_where_it_can_be)
{
  water_scene scene = pool(5.0);
  water_prop props[100];
  water_cull_reason reasons[100];
  crowd(props);
  scene.props = props;
  scene.is_flat = true;
  scene.has_scene_depth = true;
  const unsigned no_draws = WATER_MAY_SKIP_PROPS | WATER_MAY_SKIP_CLUSTERS;
  const struct
  {
    bool is_software;
    size_t prop_count;
    double texture_scale;
    unsigned off; // skips
    bool has_visibility;
  } cases[] = { { false, 64, 1.0, 0, false }, { false, 0, 0.5, 0, false },
    { true, 0, 1.0, 0, true }, { true, 0, 0.5, 0, true }, { true, 0, 0.25, 0, true },
    { true, 64, 0.2, 0, false }, { true, 64, 1.0, WATER_MAY_SKIP_PIXELS, false },
    { true, 64, 1.0, WATER_MAY_SKIP_PROPS, true }, { true, 64, 1.0, no_draws, false } };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
  {
    scene.is_software = cases[i].is_software;
    scene.prop_count = cases[i].prop_count;
    scene.settings.texture_scale = cases[i].texture_scale;
    scene.settings.skips = WATER_MAY_SKIP_ALL & ~cases[i].off;
    const water_plan plan = plan_of(&scene, reasons);
    assert_int_equal(plan.has_visibility, cases[i].has_visibility);
    // of the picture's pixels that the reflection texture's rectangle covers nine tenths may be
    // seen
    const bool is_asked = cases[i].has_visibility;
    const int* rect = plan.texture_rect_px;
    ASSERT_CLOSE(plan.visible_px_max,
      is_asked
        ? 0.9 * rect[2] * rect[3] * (800.0 / plan.texture_px[0]) * (600.0 / plan.texture_px[1])
        : 0.0,
      1e-6);
    for (int j = 0; j < 3; ++j)
    {
      water_scene other = scene;
      other.is_flat = j != 0;
      other.has_scene_depth = j != 1;
      other.has_waves = j == 2;
      const water_plan none = plan_of(&other, reasons);
      assert_false(none.has_visibility);
    }
    // such a reflection texture serves once; the next of the same view is whole, and can be used
    // again
    if (cases[i].has_visibility)
    {
      water_plan again = plan;
      revise(&plan, true, WATER_MAY_SKIP_ALL, &again);
      assert_int_equal(again.decision, WATER_REFLECT);
      assert_false(again.has_visibility);
      water_plan next = plan;
      revise(&again, true, WATER_MAY_SKIP_ALL, &next);
      assert_int_equal(next.decision, WATER_REUSE);
    }
  }
}

// To look for what is seen is worth it for a plan that reflects, can leave out what is not, and
// shows another view than the last one.
TEST(visibility_is_wanted_for_a_new_view)
{
  water_scene scene = pool(5.0);
  scene.is_flat = true;
  scene.has_scene_depth = true;
  scene.is_software = true;
  water_plan none;
  memset(&none, 0, sizeof none);
  const water_plan plan = plan_of(&scene, NULL);
  assert_true(plan.has_visibility);
  assert_true(water_plan_wants_visibility(&none, &plan));
  assert_false(water_plan_wants_visibility(&plan, &plan));

  water_scene moved = scene;
  moved.eye.world_to_view[3] += 1e-6;
  const water_plan next = plan_of(&moved, NULL);
  assert_true(water_plan_wants_visibility(&plan, &next));

  moved.has_scene_depth = false;
  const water_plan blind = plan_of(&moved, NULL);
  assert_false(water_plan_wants_visibility(&plan, &blind));
  moved.has_scene_depth = true;
  moved.is_hidden = true;
  water_plan hidden = plan_of(&moved, NULL);
  assert_false(water_plan_wants_visibility(&plan, &hidden));
  hidden.has_visibility = true; // whatever else it says
  assert_false(water_plan_wants_visibility(&plan, &hidden));
}

// Once it is known what is seen, props that only unseen pixels show are left out: of a plan that
// draws, where props may be skipped, and no prop that has another reason.
TEST(what_is_seen_decides_about_props)
{
  const water_prop props[2] = { { { -1.0, 1.0, -1.0, 1.0, 1.0, 2.0 }, WATER_PROP_VISIBLE },
    { { -1.0, 1.0, -1.0, 1.0, 1.0, 2.0 }, 0 } };
  water_scene scene = pool(5.0);
  scene.props = props;
  scene.prop_count = 2;
  scene.is_flat = true;
  scene.has_scene_depth = true;
  scene.is_software = true;
  water_plan last;
  memset(&last, 0, sizeof last);
  enum
  {
    OPEN,      // all cells are looked up
    CLOSED,    // none is
    NOT_ASKED, // nothing is known
    SAME,      // none is, and the last reflection texture serves again
    ALL_PROPS, // none is, and props may not be skipped
    HIDDEN,    // none is, and the plan does not draw
    CASES
  };
  for (int i = 0; i < CASES; ++i)
  {
    water_cull_reason reasons[2] = { WATER_CULL_NONE, WATER_CULL_NONE };
    scene.is_hidden = i == HIDDEN;
    scene.settings.skips = WATER_MAY_SKIP_ALL & ~(i == ALL_PROPS ? WATER_MAY_SKIP_PROPS : 0u);
    water_plan plan = plan_of(&scene, reasons);
    static uint8_t cells[WATER_VISIBILITY_CELLS_MAX];
    static uint32_t counts[2 * WATER_VISIBILITY_CELLS_MAX];
    water_visibility visible;
    const int whole[4] = { 0, 0, 800, 600 };
    const int size_px[2] = { 800, 600 };
    water_visibility_begin(size_px, whole, &visible);
    memset(cells, i == OPEN, sizeof cells);
    visible.counts = counts;
    water_visibility_sum(&visible, cells);
    water_plan before = plan;
    before.has_visibility = false; // it showed everything
    water_plan_revise(&scene, i == SAME ? &before : &last, i == SAME,
      i == NOT_ASKED ? NULL : &visible, &plan, reasons);
    assert_int_equal(plan.decision,
      i == SAME       ? WATER_REUSE
        : i == HIDDEN ? WATER_NO_REFLECT_HIDDEN
                      : WATER_REFLECT);
    if (i != HIDDEN)
    {
      assert_int_equal(reasons[0], i == CLOSED ? WATER_CULL_OUT_OF_WATER : WATER_CULL_NONE);
      assert_int_equal(reasons[1], WATER_CULL_INVISIBLE);
    }
    else
    {
      assert_int_equal(reasons[0], WATER_CULL_NONE);
    }
  }
}

TESTS(map_is_used_again_only_for_the_same, map_that_lacks_a_column_is_not_used_again,
  map_waits_when_it_pays, what_is_seen_is_found_out_where_it_can_be,
  visibility_is_wanted_for_a_new_view, what_is_seen_decides_about_props)
