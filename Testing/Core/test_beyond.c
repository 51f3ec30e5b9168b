// SPDX-License-Identifier: BSD-3-Clause
// test_beyond.c: the own view of clear water: its pixels, its props, its clip, and the part of it
// that refracted rays come to.
#include "test_scene.h"

#include "water_beyond.h"

static const uint32_t visible = WATER_PROP_VISIBLE;

// A lake's own view.
static water_scene lake_beyond(void)
{
  water_scene scene = lake();
  scene.is_beyond = true;
  scene.is_flat = true;
  return scene;
}

// The picture's pixels are pixels of the own view, a whole number of them further in.
TEST(the_pictures_pixels_are_pixels_of_the_own_view)
{
  dice from = dice_seeded(41);
  const double center[3] = { 0.0, 0.0, 0.0 };
  for (int number = 0; number < 60; ++number)
  {
    random_scene random = scene_rolled(&from, number, center);
    random.scene.is_beyond = true;
    const water_plan plan = plan_of(&random.scene, NULL);
    ASSERT_CLOSE(plan.headlight_dir[2], -1.0, 0.0); // the eye's own, straight ahead
    ASSERT_CLOSE(plan.headlight_dir[0], 0.0, 0.0);
    assert_int_equal(plan.decision, WATER_REFLECT);
    assert_int_equal(plan.texture_px[0], 1600);
    assert_int_equal(plan.texture_px[1], 1200);
    for (int i = 0; i < 20; ++i)
    {
      double point[3];
      double seen[4];
      double shown[4];
      point_near(&from, &random, 2.0, point);
      project(&random.scene.eye, point, 1.0, seen);
      project(&plan.mirrored, point, 1.0, shown);
      for (int axis = 0; axis < 2; ++axis)
      {
        const double size = random.scene.viewport_px[axis];
        const double px = 0.5 * (1.0 + seen[axis] / seen[3]) * size;
        const double own_px = 0.5 * (1.0 + shown[axis] / shown[3]) * plan.texture_px[axis];
        assert_true(fabs(own_px - px - 0.5 * size) < 1e-6 * size);
      }
      assert_true(fabs(shown[2] / shown[3] - seen[2] / seen[3]) < 1e-12); // one depth
    }
  }
}

// No side is longer than the GPU allows; the band gives way, the picture does not.
TEST(the_gpus_limit_narrows_the_band)
{
  const int viewport_px[2] = { 800, 600 };
  const int no_tile[2] = { 0, 1 };
  int texture_px[2];
  double scale[2];
  assert_int_equal(water_beyond_size(viewport_px, no_tile, 901, texture_px, scale), WATER_OK);
  assert_int_equal(texture_px[0], 900); // 50 on each side
  assert_int_equal(texture_px[1], 900);
  assert_true(scale[0] == 800.0 / 900.0 && scale[1] == 600.0 / 900.0);
  assert_int_equal(water_beyond_size(viewport_px, no_tile, 800, texture_px, scale), WATER_OK);
  assert_true(texture_px[0] == 800 && scale[0] == 1.0);
  assert_int_equal(
    water_beyond_size(viewport_px, no_tile, 799, texture_px, scale), WATER_TEXTURE_TOO_LARGE);
}

// A picture that no texture holds is said.
TEST(a_picture_larger_than_textures_has_none)
{
  const double box[4] = { -1.0, -1.0, 1.0, 1.0 };
  water_scene scene = lake_beyond();
  water_plan plan = plan_of(&scene, NULL);
  size_t bad_index = 0;
  scene.max_texture_px = 799;
  assert_int_equal(
    water_beyond_plan(&scene, box, &plan, NULL, &bad_index), WATER_TEXTURE_TOO_LARGE);
}

// A tile's refracted rays leave it: it has a view of its own, asked for or not.
TEST(tiles_have_a_view_of_their_own)
{
  const int tiles[4][2] = { { 0, 0 }, { 1, 1 }, { 1, 2 }, { 16, 16 } };
  for (int i = 0; i < 4; ++i)
  {
    assert_true(water_beyond_is_wanted(WATER_FROM_OWN_VIEW, false, false, tiles[i]));
    assert_int_equal(water_beyond_is_wanted(WATER_FROM_PICTURE, true, true, tiles[i]), i >= 2);
    assert_int_equal(water_beyond_is_wanted(WATER_FROM_AUTOMATIC, false, true, tiles[i]), i >= 2);
    assert_int_equal(water_beyond_is_wanted(WATER_FROM_AUTOMATIC, true, false, tiles[i]), i >= 2);
    assert_true(water_beyond_is_wanted(WATER_FROM_AUTOMATIC, true, true, tiles[i]));
  }
}

// Low: above the plane, and looking down by less than 30 degrees, or up. On a tilted plane, of any
// scale.
TEST(a_low_eye_looks_down_by_less_than_thirty_degrees)
{
  const water_plane plane = { { 0.0, 6.0, 8.0 }, -10.0 }; // through (0, 0.6, 0.8)
  for (int degrees = -90; degrees <= 90; ++degrees)
  {
    const double down = ((double)degrees + 0.25) * acos(-1.0) / 180.0;
    // from the plane's axis x and its normal
    const double ahead[3] = { cos(down), -0.6 * sin(down), -0.8 * sin(down) };
    const double above[3] = { 5.0, 1.2, 1.6 };
    const double below[3] = { 5.0, 0.3, 0.4 };
    assert_int_equal(water_beyond_is_low(&plane, above, ahead), degrees < 30);
    assert_false(water_beyond_is_low(&plane, below, ahead));
  }
  const water_plane none = { { 0.0, 0.0, 0.0 }, 1.0 };
  const double eye[3] = { 0.0, 0.0, 1.0 };
  const double ahead[3] = { 1.0, 0.0, 0.0 };
  assert_false(water_beyond_is_low(&none, eye, ahead));
  // an eye on the plane is not above it, and exactly 30 degrees are not less
  const water_plane level = { { 0.0, 0.0, 1.0 }, 0.0 };
  const double on_it[3] = { 3.0, 4.0, 0.0 };
  const double thirty[3] = { sqrt(0.75), 0.0, -0.5 };
  assert_true(water_beyond_is_low(&level, eye, ahead));
  assert_false(water_beyond_is_low(&level, on_it, ahead));
  assert_false(water_beyond_is_low(&level, eye, thirty));
}

// Beside a tile as much is drawn as beside the picture that it is a tile of.
TEST(band_of_a_tile_is_that_of_the_picture)
{
  const int whole_px[2] = { 800, 600 };
  const int tile_px[2] = { 200, 300 };
  const int no_tile[2] = { 1, 1 };
  const int tile_scale[2] = { 4, 2 };
  int texture_px[2];
  double scale[2];
  assert_int_equal(water_beyond_size(whole_px, no_tile, 16384, texture_px, scale), WATER_OK);
  assert_true(texture_px[0] == 800 + 2 * 400 && texture_px[1] == 600 + 2 * 300);
  assert_int_equal(water_beyond_size(tile_px, tile_scale, 16384, texture_px, scale), WATER_OK);
  assert_true(texture_px[0] == 200 + 2 * 400 && texture_px[1] == 300 + 2 * 300);
  assert_true(scale[0] == 0.2 && scale[1] == 300.0 / 900.0);
}

// What lies beyond the plane is drawn, also beside the picture, and if it is marked as not
// reflected; what lies on the eye's side is not.
TEST(what_lies_beyond_is_drawn)
{
  const water_prop props[] = {
    { { -1.0, 1.0, -1.0, 1.0, -3.0, -1.0 }, visible },
    { { -1.0, 1.0, -1.0, 1.0, 1.0, 3.0 }, visible },
    { { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 }, visible },
    { { -1.0, 1.0, -11.0, -10.0, -3.0, -2.0 }, visible }, // under the eye, out of the picture
    { { -1.0, 1.0, -90.0, -80.0, -3.0, -2.0 }, visible }, // behind it
    { { -1.0, 1.0, -1.0, 1.0, -3.0, -1.0 }, visible | WATER_PROP_NOT_REFLECTED },
    { { -1.0, 1.0, -1.0, 1.0, -3.0, -1.0 }, visible | WATER_PROP_IS_WATER },
    { { -1.0, 1.0, -1.0, 1.0, -3.0, -1.0 }, 0 },
  };
  const water_cull_reason expected[] = { WATER_CULL_NONE, WATER_CULL_BEHIND_PLANE, WATER_CULL_NONE,
    WATER_CULL_NONE, WATER_CULL_OUT_OF_VIEW, WATER_CULL_NONE, WATER_CULL_WATER,
    WATER_CULL_INVISIBLE };
  enum
  {
    count = sizeof props / sizeof *props
  };
  water_cull_reason reasons[count];
  water_scene scene = lake_beyond();
  scene.props = props;
  scene.prop_count = count;
  (void)plan_of(&scene, reasons);
  for (int i = 0; i < count; ++i)
  {
    assert_int_equal(reasons[i], expected[i]);
  }
  scene.settings.skips &= ~(unsigned)WATER_MAY_SKIP_PROPS;
  (void)plan_of(&scene, reasons);
  assert_int_equal(reasons[1], WATER_CULL_NONE);
  assert_int_equal(reasons[4], WATER_CULL_NONE);

  // an eye in the water looks up through it: what is over it is drawn
  scene = lake_beyond();
  scene.props = props;
  scene.prop_count = 2;
  scene.plane.normal[2] = -1.0;
  assert_int_equal(plan_of(&scene, reasons).side, WATER_BELOW);
  assert_int_equal(reasons[0], WATER_CULL_NONE);
  assert_int_equal(reasons[1], WATER_CULL_BEHIND_PLANE);
}

// The clip keeps what is less than the waves' height and two pixels over the plane, in all of its
// spaces.
TEST(the_clip_keeps_what_is_beyond_the_crests)
{
  dice from = dice_seeded(42);
  const double center[3] = { 0.0, 0.0, 0.0 };
  for (int number = 0; number < 60; ++number)
  {
    random_scene random = scene_rolled(&from, number, center);
    random.scene.is_beyond = true;
    random.scene.wave_height_max = number % 2 ? 0.3 : 0.0;
    const water_plan plan = plan_of(&random.scene, NULL);
    for (int i = 0; i < 20; ++i)
    {
      double point[3];
      double view[4];
      double clip[4];
      point_near(&from, &random, 1.0, point);
      apply(plan.mirrored.world_to_view, point, 1.0, view);
      project(&plan.mirrored, point, 1.0, clip);
      const double pixel = 2.0 * clip[3] / (random.scene.eye.view_to_clip[5] * 600.0);
      const double kept = random.scene.wave_height_max + 2.0 * pixel - height_of(&random, point);
      const double* in_view = plan.clip_plane_view;
      const double* in_clip = plan.clip_plane_clip;
      const double* in_world = plan.clip_plane_world;
      const double in_view_length = dot(in_view, view) + in_view[3];
      assert_true(fabs(in_view_length - kept) < 0.02 * fabs(kept) + 1e-9); // it is turned by them
      assert_true(fabs(dot(in_clip, clip) + in_clip[3] * clip[3] - in_view_length) < 1e-9);
      assert_true(fabs(dot(in_world, point) + in_world[3] - in_view_length) < 1e-9);
      assert_true(fabs(dot(in_view, in_view) - 1.0) < 1e-12);
      if (clip[3] > 0.0)
      {
        const double window[3] = { 0.5 * (1.0 + clip[0] / clip[3]) * plan.texture_px[0],
          0.5 * (1.0 + clip[1] / clip[3]) * plan.texture_px[1], 0.5 * (1.0 + clip[2] / clip[3]) };
        const double found = dot(plan.clip_plane_window, window) + plan.clip_plane_window[3];
        assert_true(fabs(kept) < 1e-6 || (found > 0.0) == (kept > 0.0));
      }
    }
  }
}

// Refracted rays of calm water (by Snell's law) stay in the part that is drawn, wherever the eye
// is, and this part is smaller than the whole for an eye that sees the horizon.
TEST(refracted_rays_stay_in_the_drawn_part)
{
  dice from = dice_seeded(43);
  const double center[3] = { 0.0, 0.0, 0.0 };
  int looked_up = 0;
  int smaller = 0;
  for (int number = 0; number < 300; ++number)
  {
    random_scene random = scene_rolled(&from, number, center);
    random.scene.is_beyond = true;
    random.scene.is_flat = true;
    const water_plan plan = plan_of(&random.scene, NULL);
    const int* rect = plan.texture_rect_px;
    const int is_above = plan.side == WATER_ABOVE;
    smaller += rect[3] < plan.texture_px[1];
    assert_true(is_above || rect[3] == plan.texture_px[1]);
    assert_int_equal(rect[2], plan.texture_px[0]);
    for (int i = 0; i < 20; ++i)
    {
      double point[3];
      double seen[4];
      point_near(&from, &random, 8.0, point);
      const double height = height_of(&random, point);
      double ray[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        point[axis] -= height * random.normal[axis]; // on the water
        ray[axis] = random.is_parallel ? random.view_dir[axis] : point[axis] - random.eye[axis];
      }
      project(&random.scene.eye, point, 1.0, seen);
      int is_in_box = 1;
      for (int axis = 0; axis < 3; ++axis)
      {
        is_in_box = is_in_box && fabs(point[axis] - random.target[axis]) <= 8.0;
      }
      if (!is_inside(seen) || !is_in_box)
      {
        continue; // no water, or not in the picture
      }
      normalise(ray);
      const double cosine = -dot(ray, random.normal);
      const double n = 1.333;
      const double down = cosine / n - sqrt(1.0 - (1.0 - cosine * cosine) / (n * n));
      for (double way = 0.0; way < 40.0; way += 0.5 + 0.2 * way)
      {
        double place[3];
        double clip[4];
        for (int axis = 0; axis < 3; ++axis)
        {
          place[axis] = point[axis] + way * (ray[axis] / n + down * random.normal[axis]);
        }
        project(&plan.mirrored, place, 1.0, clip);
        if (!is_inside(clip))
        {
          break; // it leaves the own view
        }
        double px[2];
        map_place(&plan, place, clip, px);
        assert_true(px[1] >= 1.0 || rect[1] == 0);
        assert_true(px[1] <= rect[3] - 1.0 || rect[1] + rect[3] == plan.texture_px[1]);
        ++looked_up;
      }
    }
  }
  assert_true(looked_up > 2000);
  assert_true(smaller > 20);

  // waves bend them anywhere, and so do those of a surface that is not flat
  water_scene scene = lake_beyond();
  assert_true(plan_of(&scene, NULL).texture_rect_px[3] < 1200);
  scene.has_waves = true;
  assert_int_equal(plan_of(&scene, NULL).texture_rect_px[3], 1200);
  scene.has_waves = false;
  scene.is_flat = false;
  assert_int_equal(plan_of(&scene, NULL).texture_rect_px[3], 1200);
  scene.is_flat = true;
  scene.settings.skips = 0;
  assert_int_equal(plan_of(&scene, NULL).texture_rect_px[3], 1200);
}

// It does not matter what the water reflects; where the water is not seen there is no own view.
TEST(it_is_planned_where_the_water_is_seen)
{
  water_scene scene = lake_beyond();
  scene.has_environment = true;
  assert_int_equal(plan_of(&scene, NULL).decision, WATER_REFLECT);
  scene.look.constant_reflectance = true;
  assert_int_equal(plan_of(&scene, NULL).decision, WATER_REFLECT);
  scene = pool(1.0);
  scene.settings.reflectance_error = 0.03;
  assert_int_equal(plan_of(&scene, NULL).decision, WATER_NO_REFLECT_FAINT);
  scene.is_beyond = true;
  assert_int_equal(plan_of(&scene, NULL).decision, WATER_REFLECT);
  scene.is_hidden = true;
  assert_int_equal(plan_of(&scene, NULL).decision, WATER_NO_REFLECT_HIDDEN);
  scene.hides_above = true;
  assert_int_equal(plan_of(&scene, NULL).decision, WATER_NO_REFLECT_FACING_AWAY);
  scene = lake_beyond();
  const double eye[3] = { 0.0, -10.0, 5.0 };
  const double away[3] = { 0.0, -20.0, 10.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  look_at(eye, away, up, scene.eye.world_to_view);
  assert_int_equal(plan_of(&scene, NULL).decision, WATER_NO_REFLECT_OUT_OF_VIEW);
}

// Its size is that of the picture, whatever the scale of the reflection.
TEST(the_reflections_scale_does_not_matter)
{
  water_scene scene = lake_beyond();
  scene.settings.texture_scale = 0.25;
  assert_int_equal(plan_of(&scene, NULL).texture_px[0], 1600);
  assert_int_equal(plan_of(&scene, NULL).samples, 0);
}

// Rows and directions of the eye's clip space say the same in that of the own view.
TEST(rows_and_directions_follow_the_band)
{
  dice from = dice_seeded(44);
  const double scale[2] = { 0.5, 0.625 };
  const double none[2] = { 1.0, 1.0 };
  for (int number = 0; number < 100; ++number)
  {
    double row[4];
    double clip[4];
    double own_row[4];
    double dirs[12];
    double own_dirs[12];
    for (int i = 0; i < 4; ++i)
    {
      row[i] = dice_roll(&from, -1.0, 1.0);
      clip[i] = dice_roll(&from, -1.0, 1.0);
    }
    for (int i = 0; i < 12; ++i)
    {
      dirs[i] = dice_roll(&from, -1.0, 1.0);
    }
    water_beyond_row(row, scale, own_row);
    const double own_clip[4] = { scale[0] * clip[0], scale[1] * clip[1], clip[2], clip[3] };
    assert_true(fabs(dot(row, clip) + row[3] * clip[3] - dot(own_row, own_clip) -
                  own_row[3] * own_clip[3]) < 1e-14);
    water_beyond_dirs(dirs, scale, own_dirs);
    for (int i = 0; i < 12; ++i)
    {
      const double factor = i < 3 ? scale[0] : i < 6 ? scale[1] : 1.0;
      assert_true(own_dirs[i] == factor * dirs[i]);
    }
    water_beyond_row(row, none, own_row);
    water_beyond_dirs(dirs, none, own_dirs);
    assert_memory_equal(row, own_row, sizeof row);
    assert_memory_equal(dirs, own_dirs, sizeof dirs);
  }
}

// Flags and bounds as they were, unless something else is drawn.
TEST(the_own_view_has_what_stands_there_itself)
{
  const water_prop given = { { 1.0, 2.0, 3.0, 4.0, 5.0, 6.0 },
    WATER_PROP_VISIBLE | WATER_PROP_LABEL | WATER_PROP_RULER | WATER_PROP_OWN_VISIBLE, 2.0f };
  water_prop prop = given;
  water_prop made = water_beyond_prop(&prop);
  assert_int_equal(made.flags, (given.flags & ~(uint32_t)WATER_PROP_LABEL) | WATER_PROP_NO_BOUNDS);
  assert_memory_equal(made.bounds, given.bounds, sizeof given.bounds);
  assert_true(made.width_px == 2.0f);
  prop.flags = WATER_PROP_VISIBLE | WATER_PROP_LABEL | WATER_PROP_OWN_OTHER; // which is hidden
  made = water_beyond_prop(&prop);
  assert_int_equal(made.flags & WATER_PROP_VISIBLE, 0);
  assert_true((made.flags & WATER_PROP_NO_BOUNDS) && (made.flags & WATER_PROP_LABEL));
  prop.flags = WATER_PROP_OWN_OTHER | WATER_PROP_OWN_VISIBLE; // the stand-in is hidden
  made = water_beyond_prop(&prop);
  assert_true((made.flags & WATER_PROP_VISIBLE) && (made.flags & WATER_PROP_NO_BOUNDS));
}

// Plumb lines go down in the picture from where they vanish on, and up from there, if the eye looks
// down; if it looks up, they go away from there, and reach the whole picture.
TEST(plumb_lines_reach_to_where_they_vanish)
{
  static const double inf = (double)INFINITY;
  // y and w of the direction up in clip space; low and high y of the water; of what is reached
  static const double rows[9][6] = { { 0.0, 0.0, -0.5, 0.25, -0.5, 0.25 }, // points to the eye
    { 0.25, -0.5, -0.25, 0.5, -0.5, 0.5 },                                 // vanish under it
    { 0.25, -0.5, -0.75, -0.625, -0.75, -0.5 },                            // over it
    { 0.25, -0.5, -0.75, 0.5, -0.75, 0.5 },                                // in it
    { 0.5, 1.0, 0.25, 0.75, -inf, inf },                                   // from in it
    { 0.5, 1.0, -0.5, 0.25, -inf, 0.25 },                                  // from over it
    { 0.5, 1.0, 0.625, 0.75, 0.625, inf },                                 // from under it
    { 0.5, 1.0, 0.25, 0.5, -inf, 0.5 },                                    // from its upper end
    { 0.5, 0.0, -0.5, 0.25, -inf, 0.25 } };                                // nowhere: all go down
  for (int i = 0; i < 9; ++i)
  {
    double dir_to_eye[12] = { 0.0 };
    dir_to_eye[5] = rows[i][0];
    dir_to_eye[11] = rows[i][1];
    double box[4] = { -0.25, rows[i][2], 0.25, rows[i][3] };
    water_beyond_reach(dir_to_eye, box);
    assert_true(isinf(box[0]) && box[0] < 0.0 && isinf(box[2]) && box[2] > 0.0);
    assert_true(box[1] <= rows[i][4] && box[1] >= rows[i][4]);
    assert_true(box[3] <= rows[i][5] && box[3] >= rows[i][5]);
  }
}

TEST(layer_is_kept_unless_ranks_or_a_gpus_volumes_forbid_it)
{
  assert_true(water_beyond_keeps_layer(true, true, false));
  assert_true(water_beyond_keeps_layer(true, false, false));
  assert_true(water_beyond_keeps_layer(false, false, false));
  assert_false(water_beyond_keeps_layer(false, true, false));
  assert_false(water_beyond_keeps_layer(true, false, true));
  assert_false(water_beyond_keeps_layer(false, false, true));
}

// Without ground under it, or to the horizon unless the picture alone is refracted.
TEST(open_water_reaches_beyond_its_ground)
{
  assert_true(water_beyond_is_open(WATER_UNITS_BED_NONE, false, WATER_FROM_PICTURE));
  assert_true(water_beyond_is_open(WATER_UNITS_BED_UNEVEN, true, WATER_FROM_AUTOMATIC));
  assert_true(water_beyond_is_open(WATER_UNITS_BED_FLAT, true, WATER_FROM_OWN_VIEW));
  assert_false(water_beyond_is_open(WATER_UNITS_BED_UNEVEN, true, WATER_FROM_PICTURE));
  assert_false(water_beyond_is_open(WATER_UNITS_BED_UNEVEN, false, WATER_FROM_AUTOMATIC));
}

TESTS(open_water_reaches_beyond_its_ground, layer_is_kept_unless_ranks_or_a_gpus_volumes_forbid_it,
  plumb_lines_reach_to_where_they_vanish, a_picture_larger_than_textures_has_none,
  tiles_have_a_view_of_their_own, a_low_eye_looks_down_by_less_than_thirty_degrees,
  band_of_a_tile_is_that_of_the_picture, the_pictures_pixels_are_pixels_of_the_own_view,
  the_gpus_limit_narrows_the_band, what_lies_beyond_is_drawn,
  the_clip_keeps_what_is_beyond_the_crests, refracted_rays_stay_in_the_drawn_part,
  it_is_planned_where_the_water_is_seen, the_reflections_scale_does_not_matter,
  rows_and_directions_follow_the_band, the_own_view_has_what_stands_there_itself)
