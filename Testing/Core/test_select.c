// SPDX-License-Identifier: BSD-3-Clause
// test_select.c: side of the eye, is the water seen, reason of each prop.
#include "test_scene.h"

#include "water_camera.h"
#include "water_math.h"
#include "water_plane.h"
#include "water_select.h"

static const double nearby[3] = { 1.0, 2.0, 3.0 };
enum
{
  visible = WATER_PROP_VISIBLE
};

// Moves the eye of a scene to (x, y, z), looking at (x, y + 1, z + slope).
static void stand_at(water_scene* scene, double x, double y, double z, double slope)
{
  const double eye[3] = { x, y, z };
  const double target[3] = { x, y + 1.0, z + slope };
  const double up[3] = { 0.0, 0.0, 1.0 };
  look_at(eye, target, up, scene->eye.world_to_view);
}

static void make_parallel(water_scene* scene)
{
  const double box[4] = { -10.0, 10.0, -10.0, 10.0 };
  ortho_matrix(box, 1.0, 1000.0, scene->eye.view_to_clip);
  scene->eye.parallel = true;
}

// An eye over the water is above, one under it below, also when the plane is given upside down
// (then the other way round).
TEST(perspective_side_is_where_the_eye_is)
{
  water_scene scene = lake();
  assert_int_equal(plan_of(&scene, NULL).side, WATER_ABOVE);
  stand_at(&scene, 0.0, -10.0, -5.0, 0.5);
  assert_int_equal(plan_of(&scene, NULL).side, WATER_BELOW);
  scene.plane.normal[2] = -2.0;
  assert_int_equal(plan_of(&scene, NULL).side, WATER_ABOVE);
}

// A parallel eye is on the side it looks from, wherever it stands: a camera under the plane that
// looks down shows the water from above.
TEST(parallel_side_is_where_the_view_comes_from)
{
  water_scene scene = lake();
  make_parallel(&scene);
  for (int height = -5; height <= 5; height += 5)
  {
    stand_at(&scene, 0.0, -10.0, height, -0.5);
    assert_int_equal(plan_of(&scene, NULL).side, WATER_ABOVE);
    stand_at(&scene, 0.0, -10.0, height, 0.5);
    assert_int_equal(plan_of(&scene, NULL).side, WATER_BELOW);
  }
}

// So it is however wide the view is against its depth, and however far it is shifted.
TEST(parallel_side_of_a_wide_and_shifted_view)
{
  dice from = dice_seeded(62);
  for (int round = 0; round < 1000; ++round)
  {
    water_scene scene = lake();
    const double eye[3] = { 0.0, 0.0, 1.0 };
    const double sine = round % 2 ? -1e-8 : 1e-8;
    const double target[3] = { dice_roll(&from, 0.5, 1.0), dice_roll(&from, 0.5, 1.0), 1.0 - sine };
    const double up[3] = { 0.0, 0.0, 1.0 };
    const double half = pow(10.0, dice_roll(&from, 0.0, 9.0));
    const double x = half * dice_roll(&from, -100.0, 100.0);
    const double y = half * dice_roll(&from, -100.0, 100.0);
    const double box[4] = { x - half, x + half, y - half, y + half };
    const double near_z = dice_roll(&from, 1.0, 1000.0);
    look_at(eye, target, up, scene.eye.world_to_view);
    ortho_matrix(box, near_z, near_z + dice_roll(&from, 0.1, 100.0), scene.eye.view_to_clip);
    scene.eye.parallel = true;
    const water_plan plan = plan_of(&scene, NULL);
    assert_int_equal(plan.side, round % 2 ? WATER_BELOW : WATER_ABOVE);
  }
}

// A parallel view along the water sees nothing of it, which is no error; a tilt of a millionth of a
// degree does.
TEST(parallel_view_along_the_water_is_edge_on)
{
  water_scene scene = lake();
  make_parallel(&scene);
  stand_at(&scene, 0.0, -100.0, 0.0, 0.0);
  water_plan plan;
  assert_int_equal(water_plan_make(&scene, &plan, NULL), WATER_OK);
  assert_int_equal(plan.decision, WATER_NO_REFLECT_EDGE_ON);
  stand_at(&scene, 0.0, -100.0, 0.0, -2e-8);
  assert_int_equal(plan_of(&scene, NULL).decision, WATER_REFLECT);

  dice from = dice_seeded(27); // along any water, where rounding leaves no exact zero
  for (int round = 0; round < 300; ++round)
  {
    random_scene random = scene_rolled(&from, 3 * round + 2, nearby);
    double normal[3];
    dice_dir(&from, normal);
    cross(random.view_dir, normal, random.scene.plane.normal);
    assert_int_equal(water_plan_make(&random.scene, &plan, NULL), WATER_OK);
    assert_int_equal(plan.decision, WATER_NO_REFLECT_EDGE_ON);
  }
}

// An eye whose height is only rounding is on the plane, on any plane and 5000 km out; a hair off
// it, a thousand roundings, it is not, and is on the right side.
TEST(eye_on_the_plane_is_told_from_rounding)
{
  dice from = dice_seeded(19);
  const double far_away[3] = { 5e6, -4e6, 300.0 };
  for (int round = 0; round < 600; ++round)
  {
    const random_scene random = scene_rolled(&from, 3 * round, round % 2 ? far_away : nearby);
    const double hair = round % 2 ? 1e-5 : 1e-11;
    water_scene scene = random.scene;
    water_plan plan;
    const double* given = scene.plane.normal;
    const double length = sqrt(dot(given, given));
    const double to_eye = dot(given, random.normal) > 0.0 ? 1.0 : -1.0;
    scene.plane.offset = -dot(given, random.eye);
    water_eye eye;
    water_plane unit;
    water_side side = WATER_EDGE_ON;
    assert_int_equal(water_camera_decompose(&scene.eye, &eye), WATER_OK);
    assert_int_equal(water_plane_normalise(&scene.plane, &unit), WATER_OK);
    const bool is_told = water_select_side(&eye, &unit, &side) == WATER_CAMERA_ON_PLANE;
    assert_int_equal(is_told, !random.is_parallel);
    water_plane level;
    water_select_level(&eye, &unit, &level, &side);
    // the near plane is at 1
    ASSERT_CLOSE(level.offset - unit.offset, is_told ? 1e-4 : 0.0, round % 2 ? 1e-4 : 1e-9);
    assert_int_equal(side, is_told || to_eye > 0.0 ? WATER_ABOVE : WATER_BELOW);
    assert_int_equal(water_plan_make(&scene, &plan, NULL), WATER_OK);
    assert_int_equal(plan.side, side);
    scene.plane.offset += length * hair * to_eye;
    water_status status = water_plan_make(&scene, &plan, NULL);
    assert_int_equal(status, WATER_OK);
    assert_int_equal(plan.side, to_eye > 0.0 ? WATER_ABOVE : WATER_BELOW);
  }
}

// A sine of exactly 1e-9 is still edge-on, from either side, and the next double is not.
TEST(parallel_view_is_edge_on_up_to_the_stated_sine)
{
  const water_plane plane = { { 0.0, 0.0, 1.0 }, 0.0 };
  const double sines[4] = { -1e-9, 1e-9, nextafter(-1e-9, -1.0), nextafter(1e-9, 1.0) };
  const water_side expected[4] = { WATER_EDGE_ON, WATER_EDGE_ON, WATER_ABOVE, WATER_BELOW };
  for (int i = 0; i < 4; ++i)
  {
    water_eye eye = { { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 } };
    eye.ndc_to_dir[2] = 1.0;
    eye.ndc_to_dir[8] = sines[i];
    water_side side = WATER_EDGE_ON;
    assert_int_equal(water_select_side(&eye, &plane, &side), WATER_OK);
    assert_int_equal(side, expected[i]);
  }
}

// An eye as high as the rounding may be is on the plane, and one a rounding higher is not: the
// lengths 1/4 of the offset, 1/2 to the origin of the view and 1/4 to the eye from there are 1
// together, of which 24 roundings are allowed.
TEST(eye_is_on_the_plane_up_to_the_stated_rounding)
{
  const double bound = 24.0 * DBL_EPSILON;
  for (int side = -1; side <= 1; side += 2)
  {
    for (int i = 0; i < 2; ++i)
    {
      const double height = i == 0 ? bound : bound + DBL_EPSILON;
      const water_plane plane = { { 0.0, 0.0, 1.0 }, -0.25 * side };
      water_eye eye = { { 1, 0, 0, 0.5 - bound, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 } };
      eye.has_center = true;
      eye.center_view[2] = side * (0.25 + height);
      water_side found = WATER_EDGE_ON;
      assert_int_equal(
        water_select_side(&eye, &plane, &found), i == 0 ? WATER_CAMERA_ON_PLANE : WATER_OK);
      assert_int_equal(found, i == 0 ? WATER_EDGE_ON : side > 0 ? WATER_ABOVE : WATER_BELOW);
    }
  }
}

// Each flag has its reason, and of several flags the first of the list counts.
TEST(flags_decide_in_their_order)
{
  const water_scene scene = lake();
  enum
  {
    water = WATER_PROP_IS_WATER,
    marked = WATER_PROP_NOT_REFLECTED,
    overlay = WATER_PROP_OVERLAY,
    label = WATER_PROP_LABEL,
    refused = WATER_PROP_REFUSED,
    endless = WATER_PROP_NO_BOUNDS
  };
  const uint32_t flags[] = { visible, 0, visible | water, visible | marked, visible | overlay,
    visible | label, visible | endless, water | marked, visible | water | marked | endless,
    visible | marked | overlay, visible | overlay | label, visible | label | endless,
    visible | refused, visible | label | refused, visible | refused | endless };
  const water_cull_reason expected[] = { WATER_CULL_NONE, WATER_CULL_INVISIBLE, WATER_CULL_WATER,
    WATER_CULL_NOT_REFLECTED, WATER_CULL_OVERLAY, WATER_CULL_LABEL, WATER_CULL_NONE,
    WATER_CULL_INVISIBLE, WATER_CULL_WATER, WATER_CULL_NOT_REFLECTED, WATER_CULL_OVERLAY,
    WATER_CULL_LABEL, WATER_CULL_REFUSED, WATER_CULL_LABEL, WATER_CULL_REFUSED };
  for (size_t i = 0; i < sizeof flags / sizeof flags[0]; ++i)
  {
    const water_prop prop = { { -1, 1, -1, 1, 1, 2 }, flags[i] };
    water_scene with = scene;
    water_cull_reason reason = WATER_CULL_REASON_COUNT;
    with.props = &prop;
    with.prop_count = 1;
    (void)plan_of(&with, &reason);
    assert_string_equal(water_cull_reason_text(reason), water_cull_reason_text(expected[i]));
  }
}

// Boxes over the lake of lake(): where they are decides; one without bounds is drawn wherever it
// is.
TEST(boxes_decide_in_their_order)
{
  water_scene scene = lake();
  scene.settings.clip_margin = 0.5;
  scene.surface_bounds[3] = 1e6; // to the horizon
  const water_prop props[] = {
    { { -1, 1, -1, 1, -1, 2 }, visible },            // across the water
    { { -1, 1, -1, 1, -3, -0.4 }, visible },         // under it, within the margin
    { { -1, 1, -1, 1, -3, -0.6 }, visible },         // under the margin
    { { -1, 1, -1, 1, -3, -0.5 }, visible },         // touches the margin
    { { 1, -1, 1, -1, 1, -1 }, visible },            // empty
    { { 0, 1, 0, 1, -3, -4 }, visible },             // empty comes before behind
    { { -1, 1, -40, -30, 1, 2 }, visible },          // behind the back of the mirrored camera
    { { 900, 910, 0, 1, 1, 2 }, visible },           // far to the right
    { { -1, 1, 5000, 5001, 0, 2 }, visible },        // beyond the far plane, which gives way
    { { -1, 1, -10.1, -9.9, -0.4, -0.3 }, visible }, // close over the mirrored camera: not in view
    { { 900, 910, 0, 1, 1, 2 }, visible | WATER_PROP_NO_BOUNDS },
    { { (double)NAN, 1, 0, 1, -9, -8 }, visible | WATER_PROP_NO_BOUNDS },
  };
  const water_cull_reason expected[] = { WATER_CULL_NONE, WATER_CULL_NONE, WATER_CULL_BEHIND_PLANE,
    WATER_CULL_NONE, WATER_CULL_EMPTY, WATER_CULL_EMPTY, WATER_CULL_OUT_OF_VIEW,
    WATER_CULL_OUT_OF_VIEW, WATER_CULL_NONE, WATER_CULL_OUT_OF_VIEW, WATER_CULL_NONE,
    WATER_CULL_NONE };
  water_cull_reason reasons[12];
  scene.props = props;
  scene.prop_count = 12;
  (void)plan_of(&scene, reasons);
  for (int i = 0; i < 12; ++i)
  {
    assert_string_equal(water_cull_reason_text(reasons[i]), water_cull_reason_text(expected[i]));
  }
  // between the mirrored camera, 0.2 under the water, and its near plane, 1 ahead: not in view, and
  // before that beside what the water reflects
  const water_prop near_by = { { -0.1, 0.1, -9.6, -9.5, 0.0, 0.1 }, visible };
  water_scene low = scene;
  low.settings.clip_margin = 0.0;
  low.props = &near_by;
  low.prop_count = 1;
  stand_at(&low, 0.0, -10.0, 0.2, 0.0);
  (void)plan_of(&low, reasons);
  assert_int_equal(reasons[0], WATER_CULL_OUT_OF_WATER);
  // seen from below it is the other side that is kept
  stand_at(&scene, 0.0, -10.0, -5.0, 0.5);
  const water_prop above = { { -1, 1, -1, 1, 0.6, 3 }, visible };
  scene.props = &above;
  scene.prop_count = 1;
  (void)plan_of(&scene, reasons);
  assert_int_equal(reasons[0], WATER_CULL_BEHIND_PLANE);
}

// Bounds that are not finite are an error of the first prop that has them, but only if it would be
// drawn; it is drawn all the same, as it may be anywhere, and so are the others.
TEST(bounds_that_are_not_finite_name_their_prop)
{
  water_scene scene = lake();
  const double bad = (double)NAN;
  const double huge = (double)INFINITY;
  water_prop props[4] = { { { 0, 1, 0, 1, -2, -1 }, visible }, { { bad, 1, 0, 1, 0, 1 }, 0 },
    { { 0, 1, 0, huge, 0, 1 }, visible }, { { 0, 1, 0, 1, bad, 1 }, visible } };
  water_cull_reason reasons[4] = { WATER_CULL_REASON_COUNT, WATER_CULL_REASON_COUNT,
    WATER_CULL_REASON_COUNT, WATER_CULL_REASON_COUNT };
  water_plan plan;
  scene.props = props;
  scene.prop_count = 4;
  assert_int_equal(water_plan_make(&scene, &plan, reasons), WATER_BAD_PROP_BOUNDS);
  assert_int_equal(plan.bad_index, 2);
  assert_int_equal(plan.decision, WATER_REFLECT);
  assert_true(isinf(plan.reflection_top));
  assert_true(plan.depth_scale == 1.0);
  assert_int_equal(reasons[0], WATER_CULL_BEHIND_PLANE);
  assert_int_equal(reasons[1], WATER_CULL_INVISIBLE);
  assert_int_equal(reasons[2], WATER_CULL_NONE);
  assert_int_equal(reasons[3], WATER_CULL_NONE);
  props[2].flags |= WATER_PROP_NOT_REFLECTED;
  assert_int_equal(water_plan_make(&scene, &plan, reasons), WATER_BAD_PROP_BOUNDS);
  assert_int_equal(plan.bad_index, 3);
  props[3].flags = WATER_PROP_VISIBLE | WATER_PROP_IS_WATER;
  assert_int_equal(water_plan_make(&scene, &plan, reasons), WATER_OK);
}

// A prop with any point that the mirrored camera sees on the kept side, where the water looks
// anything up, is drawn: checked against 64 points of each box. And culling is of use: most boxes
// that it could drop are dropped.
TEST(culling_never_drops_what_is_seen)
{
  dice from = dice_seeded(20);
  int seen = 0;
  int dropped = 0;
  for (int round = 0; round < 20000; ++round)
  {
    random_scene random = scene_rolled(&from, round, nearby);
    water_prop prop = { { 0.0 }, visible };
    water_cull_reason reason;
    double center[3];
    random.scene.settings.clip_margin = round % 2 ? 0.1 : 0.0;
    point_near(&from, &random, 30.0, center);
    for (int i = 0; i < 3; ++i)
    {
      const double half = dice_roll(&from, 0.0, round % 5 ? 2.0 : 20.0);
      prop.bounds[2 * i] = center[i] - half;
      prop.bounds[2 * i + 1] = center[i] + half;
    }
    random.scene.props = &prop;
    random.scene.prop_count = 1;
    const water_plan plan = plan_of(&random.scene, &reason);
    for (int corner = 0; corner < 8 && reason == WATER_CULL_NONE; ++corner)
    {
      // before the far plane, and by more than single precision rounds: the reflection texture is
      // cleared with it
      double point[3];
      double clip[4];
      water_bounds_corner(prop.bounds, corner, point);
      project(&plan.mirrored, point, 1.0, clip);
      assert_true(!(clip[3] > 0.0) || clip[2] <= (1.0 - 8.0 * (double)FLT_EPSILON) * clip[3]);
    }
    int is_seen = 0;
    for (int number = 0; number < 64 && !is_seen; ++number)
    {
      double point[3];
      double clip[4];
      double px[2];
      const int* rect = plan.texture_rect_px;
      box_point(prop.bounds, number, point);
      map_place(&plan, point, clip, px);
      is_seen = is_inside(clip) && px[0] >= 0.0 && px[0] <= rect[2] && px[1] >= 0.0 &&
        px[1] <= rect[3] && height_of(&random, point) >= -random.scene.settings.clip_margin;
    }
    assert_true(!is_seen || reason == WATER_CULL_NONE);
    seen += is_seen;
    dropped += reason != WATER_CULL_NONE;
  }
  assert_int_in_range(seen, 1000, 20000);
  assert_int_in_range(dropped, 8 * (20000 - seen) / 10, 20000);
}

// Water with any point in the eye's frustum is in view: checked against 64 points of each box; and
// water behind the eye's back, beside its picture or beyond its far plane is not.
TEST(water_in_view_is_never_out_of_view)
{
  dice from = dice_seeded(21);
  int seen = 0;
  int out = 0;
  for (int round = 0; round < 20000; ++round)
  {
    random_scene random = scene_rolled(&from, round, nearby);
    double* bounds = random.scene.surface_bounds;
    double center[3];
    point_near(&from, &random, 30.0, center);
    for (int i = 0; i < 3; ++i)
    {
      const double half = dice_roll(&from, 0.0, 3.0);
      bounds[2 * i] = center[i] - half;
      bounds[2 * i + 1] = center[i] + half;
    }
    const water_plan plan = plan_of(&random.scene, NULL);
    int is_seen = 0;
    for (int number = 0; number < 64 && !is_seen; ++number)
    {
      double point[3];
      double clip[4];
      for (int i = 0; i < 3; ++i)
      {
        const double part = ((number >> (2 * i)) & 3) / 3.0;
        point[i] = (1.0 - part) * bounds[2 * i] + part * bounds[2 * i + 1];
      }
      project(&random.scene.eye, point, 1.0, clip);
      is_seen = is_inside(clip);
    }
    assert_true(!is_seen || plan.decision == WATER_REFLECT);
    seen += is_seen;
    out += plan.decision == WATER_NO_REFLECT_OUT_OF_VIEW;
  }
  assert_int_in_range(seen, 1000, 20000);
  assert_int_in_range(out, 8 * (20000 - seen) / 10, 20000);
}

// A box that just touches the picture's edge from outside, 5000 km from the origin, is kept: its
// distance from the edge is smaller than the rounding of its own coordinates.
TEST(rounding_never_drops)
{
  dice from = dice_seeded(22);
  const double far_away[3] = { 5e6, -4e6, 300.0 };
  for (int round = 0; round < 3000; ++round)
  {
    random_scene random = scene_rolled(&from, 3 * round, far_away); // symmetric, perspective
    const double* view = random.scene.eye.world_to_view;
    const double edge[3] = { 0.8, dice_roll(&from, -0.5, 0.5), -1.0 }; // left = right = 0.8
    const double distance = dice_roll(&from, 1.5, 40.0);
    for (int i = 0; i < 3; ++i)
    {
      const double at = random.eye[i] +
        distance * (view[i] * edge[0] + view[4 + i] * edge[1] + view[8 + i] * edge[2]);
      random.scene.surface_bounds[2 * i] = at;
      random.scene.surface_bounds[2 * i + 1] = at;
    }
    assert_int_equal(plan_of(&random.scene, NULL).decision, WATER_REFLECT);

    // the same for a box at the origin, seen on the edge from as far out
    double* moved = random.scene.eye.world_to_view;
    const double box[4] = { -0.8, 0.8, -0.6, 0.6 };
    frustum_matrix(box, 1.0, 1e8, random.scene.eye.view_to_clip);
    memset(random.scene.surface_bounds, 0, sizeof random.scene.surface_bounds);
    for (int i = 0; i < 3; ++i)
    {
      random.eye[i] = -5e6 * (moved[i] * edge[0] + moved[4 + i] * edge[1] + moved[8 + i] * edge[2]);
    }
    for (int i = 0; i < 3; ++i)
    {
      moved[4 * i + 3] = -dot(moved + 4 * i, random.eye);
    }
    random.scene.plane.offset = 1e9; // away from the eye, wherever that is
    assert_int_equal(plan_of(&random.scene, NULL).decision, WATER_REFLECT);
  }
}

// Far out, where rounding is more than a near plane's distance, an eye that is on the plane but for
// rounding is lifted to the same height as one exactly on it: 1000 roundings.
TEST(eyes_on_the_plane_are_lifted_to_one_height)
{
  const double box[4] = { -1e-9, 1e-9, -1e-9, 1e-9 };
  water_scene scene = lake();
  stand_at(&scene, 1e6, 2e6, 0.0, 0.0);
  frustum_matrix(box, 1e-9, 1.0, scene.eye.view_to_clip);
  water_eye eye;
  assert_int_equal(water_camera_decompose(&scene.eye, &eye), WATER_OK);
  water_plane under = { { 0.0, 0.0, 1.0 }, 1.0 }; // the eye is as high as the offset
  water_plane level;
  water_side side;
  while (water_select_side(&eye, &under, &side) == WATER_OK)
  {
    under.offset *= 0.5;
  }
  water_select_level(&eye, &under, &level, &side);
  const double lifted = level.offset;
  const double most = under.offset; // at least a half of what counts as rounding
  under.offset = 0.0;
  water_select_level(&eye, &under, &level, &side);
  assert_true(most > 1e-12 && lifted > 900.0 * most && lifted < 2100.0 * most);
  ASSERT_CLOSE(lifted, level.offset, 0.2 * most);
}

// A projection whose near plane is farther away than numbers reach lifts an eye on the plane by no
// more than rounding. Found by the fuzzer of plans.
TEST(eye_on_the_plane_with_a_near_plane_out_of_reach)
{
  const double far = -1.993854408381186e81;
  const water_camera camera = { { 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, -10.0,
                                  0.0, 0.0, 0.0, 1.0 },
    { 1.0, 0.0, far, 0.0, 0.0, 1.3, far, 0.0, 0.0, 0.0, -1.01, far, 0.0, 0.0, -1.0, 0.0 }, false };
  const water_plane upright = { { -1.0, 0.0, 0.0 }, 0.0 };
  water_eye eye;
  water_plane level;
  water_side side = WATER_BELOW;
  assert_int_equal(water_camera_decompose(&camera, &eye), WATER_OK);
  water_select_level(&eye, &upright, &level, &side);
  assert_int_equal(side, WATER_ABOVE);
  assert_true(level.offset > 0.0 && level.offset < 1e-6);
}

TESTS(eye_on_the_plane_with_a_near_plane_out_of_reach, eyes_on_the_plane_are_lifted_to_one_height,
  perspective_side_is_where_the_eye_is, parallel_side_is_where_the_view_comes_from,
  parallel_side_of_a_wide_and_shifted_view, parallel_view_along_the_water_is_edge_on,
  eye_on_the_plane_is_told_from_rounding, parallel_view_is_edge_on_up_to_the_stated_sine,
  eye_is_on_the_plane_up_to_the_stated_rounding, flags_decide_in_their_order,
  boxes_decide_in_their_order, bounds_that_are_not_finite_name_their_prop,
  culling_never_drops_what_is_seen, water_in_view_is_never_out_of_view, rounding_never_drops)
