// SPDX-License-Identifier: BSD-3-Clause
// test_grid.c: grids over what an eye sees of a sheet: covered, ordered, in the plane, never
// broken.
#include "test_scene.h"

#include "water_grid.h"
#include "water_plane.h"

enum
{
  GRID = 24,
  SIDE = GRID + 1
};

typedef struct laid
{
  double points[SIDE * SIDE][3];
  float cells[SIDE * SIDE][2];
  double row_dir[2];
} laid;

static water_grid_view view_of(const random_scene* random)
{
  water_grid_view view;
  assert_int_equal(
    water_grid_view_make(&random->scene.eye, &random->scene.plane, random->target, &view),
    WATER_OK);
  return view;
}

// In the plane's own axes, from the target on.
static void place_of(const water_grid_view* view, const double point[3], double place[2])
{
  const double arm[3] = { point[0] - view->axes.origin[0], point[1] - view->axes.origin[1],
    point[2] - view->axes.origin[2] };
  place[0] = dot(arm, view->axes.x_dir);
  place[1] = dot(arm, view->axes.y_dir);
}

static void along_row(const laid* grid, const double place[2], double along[2])
{
  along[0] = grid->row_dir[0] * place[0] + grid->row_dir[1] * place[1];
  along[1] = grid->row_dir[0] * place[1] - grid->row_dir[1] * place[0];
}

// A point of the grid: x from row to row, y along its row.
static void grid_point(
  const water_grid_view* view, const laid* grid, int row, int column, double along[2])
{
  double place[2];
  place_of(view, grid->points[row * SIDE + column], place);
  along_row(grid, place, along);
}

static int is_covered(const water_grid_view* view, const laid* grid, const double place[2])
{
  double along[2];
  along_row(grid, place, along);
  for (int row = 0; row < GRID; ++row)
  {
    double corners[4][2];
    grid_point(view, grid, row, 0, corners[0]);
    grid_point(view, grid, row, GRID, corners[1]);
    grid_point(view, grid, row + 1, 0, corners[2]);
    grid_point(view, grid, row + 1, GRID, corners[3]);
    const double depth = corners[2][0] - corners[0][0];
    if (along[0] < corners[0][0] - 1e-9 || along[0] > corners[2][0] + 1e-9)
    {
      continue;
    }
    const double part = depth > 1e-12 ? (along[0] - corners[0][0]) / depth : 0.0;
    const double low = corners[0][1] + part * (corners[2][1] - corners[0][1]);
    const double high = corners[1][1] + part * (corners[3][1] - corners[1][1]);
    if (along[1] > low - 1e-6 && along[1] < high + 1e-6)
    {
      return 1;
    }
  }
  return 0;
}

static const double nearby[3] = { 1.0, 2.0, 3.0 };
static const double far_off[3] = { 4e5, -3e6, 2e5 };

// Whatever waves can bring into view lies on the grid when it is at rest.
TEST(grid_covers_what_can_come_into_view)
{
  dice from = dice_seeded(171);
  static laid grid;
  int seen = 0;
  for (int round = 0; round < 600; ++round)
  {
    const random_scene random = scene_rolled(&from, round, nearby);
    const water_grid_view view = view_of(&random);
    const double sheet[4] = { dice_roll(&from, -40.0, -1.0), dice_roll(&from, 1.0, 40.0),
      dice_roll(&from, -40.0, -1.0), dice_roll(&from, 1.0, 40.0) };
    const double height = dice_roll(&from, 0.0, 1.0);
    const double reach = dice_roll(&from, 0.0, 1.0);
    assert_true(water_grid_lay(
      &view, sheet, height, reach, GRID, grid.points[0], grid.cells[0], grid.row_dir));
    for (int i = 0; i < 200; ++i)
    {
      const double place[2] = { dice_roll(&from, sheet[0], sheet[1]),
        dice_roll(&from, sheet[2], sheet[3]) };
      const double up = dice_roll(&from, -height, height);
      const double turn = dice_roll(&from, 0.0, 6.3);
      const double across = dice_roll(&from, 0.0, reach);
      double point[3];
      for (int k = 0; k < 3; ++k)
      {
        point[k] = random.target[k] + (place[0] + across * cos(turn)) * view.axes.x_dir[k] +
          (place[1] + across * sin(turn)) * view.axes.y_dir[k] + up * view.axes.normal[k];
      }
      double clip[4];
      project(&random.scene.eye, point, 1.0, clip);
      if (is_inside(clip))
      {
        ++seen;
        assert_true(is_covered(&view, &grid, place));
      }
    }
  }
  assert_true(seen > 10000);
}

// Rows follow each other, and points their row; all lie on the sheet, near the origin and far away.
TEST(grid_is_ordered_and_on_the_sheet)
{
  dice from = dice_seeded(172);
  static laid grid;
  for (int round = 0; round < 600; ++round)
  {
    const random_scene random = scene_rolled(&from, round, round % 2 ? far_off : nearby);
    const double rounding = round % 2 ? 1e-7 : 1e-11; // of world coordinates, and of 300 m of grid
    const water_grid_view view = view_of(&random);
    const double sheet[4] = { -30.0, 20.0, -10.0, 40.0 };
    assert_true(
      water_grid_lay(&view, sheet, 0.3, 0.2, GRID, grid.points[0], grid.cells[0], grid.row_dir));
    for (int row = 0; row < SIDE; ++row)
    {
      for (int column = 0; column < SIDE; ++column)
      {
        double place[2];
        double here[2];
        const double* point = grid.points[row * SIDE + column];
        ASSERT_CLOSE(height_of(&random, point), 0.0, 30.0 * rounding);
        place_of(&view, point, place);
        assert_true(place[0] > sheet[0] - 1e-6 && place[0] < sheet[1] + 1e-6);
        assert_true(place[1] > sheet[2] - 1e-6 && place[1] < sheet[3] + 1e-6);
        grid_point(&view, &grid, row, column, here);
        if (row > 0)
        {
          double before[2];
          grid_point(&view, &grid, row - 1, column, before);
          assert_true(here[0] >= before[0] - 100.0 * rounding);
        }
        if (column > 0)
        {
          double before[2];
          grid_point(&view, &grid, row, column - 1, before);
          assert_true(here[1] >= before[1] - 100.0 * rounding);
          ASSERT_CLOSE(here[0], before[0], 100.0 * rounding);
          ASSERT_CLOSE(
            here[1] - before[1], (double)grid.cells[row * SIDE + column][1], 1e-5 + rounding);
        }
      }
    }
  }
}

// No two rows lie further apart than the cells say, but for how that changes from row to row.
TEST(cells_are_as_large_as_they_say)
{
  dice from = dice_seeded(173);
  static laid grid;
  for (int round = 0; round < 300; ++round)
  {
    const random_scene random = scene_rolled(&from, round, nearby);
    const water_grid_view view = view_of(&random);
    const double sheet[4] = { -300.0, 200.0, -100.0, 400.0 };
    assert_true(
      water_grid_lay(&view, sheet, 0.3, 0.2, GRID, grid.points[0], grid.cells[0], grid.row_dir));
    for (int row = 1; row < SIDE; ++row)
    {
      double here[2];
      double before[2];
      grid_point(&view, &grid, row, 0, here);
      grid_point(&view, &grid, row - 1, 0, before);
      const double said =
        fmax((double)grid.cells[row * SIDE][0], (double)grid.cells[(row - 1) * SIDE][0]);
      assert_true(here[0] - before[0] <= 1.001 * said);
    }
  }
}

// Rows follow each other away from the eye: as its view goes, along the sheet.
TEST(rows_lead_where_the_view_goes)
{
  dice from = dice_seeded(175);
  static laid grid;
  for (int round = 0; round < 300; ++round)
  {
    const random_scene random = scene_rolled(&from, 3 * (round / 2) + round % 2, nearby);
    const water_grid_view view = view_of(&random);
    const double sheet[4] = { -30.0, 20.0, -10.0, 40.0 };
    assert_true(
      water_grid_lay(&view, sheet, 0.3, 0.2, GRID, grid.points[0], grid.cells[0], grid.row_dir));
    const double x = dot(random.view_dir, view.axes.x_dir);
    const double y = dot(random.view_dir, view.axes.y_dir);
    ASSERT_CLOSE(grid.row_dir[0] * hypot(x, y), x, 1e-12);
    ASSERT_CLOSE(grid.row_dir[1] * hypot(x, y), y, 1e-12);
  }
}

// What the shader has leads from clip back to the place and the height, and on to a moved point.
TEST(view_leads_from_clip_to_places_and_back)
{
  dice from = dice_seeded(174);
  for (int round = 0; round < 2000; ++round)
  {
    const random_scene random = scene_rolled(&from, round, nearby);
    const water_grid_view view = view_of(&random);
    double rest[3];
    double moved[3];
    double clip[4];
    double clip_moved[4];
    const double place[2] = { dice_roll(&from, -9.0, 9.0), dice_roll(&from, -9.0, 9.0) };
    const double by[3] = { dice_roll(&from, -1.0, 1.0), dice_roll(&from, -1.0, 1.0),
      dice_roll(&from, -1.0, 1.0) };
    for (int k = 0; k < 3; ++k)
    {
      rest[k] = random.target[k] + place[0] * view.axes.x_dir[k] + place[1] * view.axes.y_dir[k];
      moved[k] = rest[k] + by[0] * view.axes.x_dir[k] + by[1] * view.axes.y_dir[k] +
        by[2] * view.axes.normal[k];
    }
    project(&random.scene.eye, rest, 1.0, clip);
    project(&random.scene.eye, moved, 1.0, clip_moved);
    const double picture[3] = { clip[0], clip[1], clip[3] };
    const double w = dot(view.clip_to_place + 6, picture);
    ASSERT_CLOSE(view.origin_xy[0] + dot(view.clip_to_place, picture) / w, place[0], 1e-8);
    ASSERT_CLOSE(view.origin_xy[1] + dot(view.clip_to_place + 3, picture) / w, place[1], 1e-8);
    double height = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      ASSERT_CLOSE(clip[i] + dot(view.dir_to_clip + 3 * i, by), clip_moved[i], 1e-9);
      height += view.height_clip[i] * clip_moved[i];
    }
    ASSERT_CLOSE(height, by[2], 1e-8);
  }
}

// An eye whose projection moves it stands over the plane where it is, not where its view begins.
TEST(grid_knows_the_height_of_a_moved_eye)
{
  water_scene scene = pool(10.0);
  const double origin[3] = { 0.0, 0.0, 0.0 };
  water_grid_view view;
  assert_int_equal(water_grid_view_make(&scene.eye, &scene.plane, origin, &view), WATER_OK);
  ASSERT_CLOSE(view.eye_height, 10.0, 1e-12);
  for (int i = 0; i < 4; ++i) // view_to_clip * translate(0, 0, -3): the eye 3 higher
  {
    scene.eye.view_to_clip[4 * i + 3] -= 3.0 * scene.eye.view_to_clip[4 * i + 2];
  }
  assert_int_equal(water_grid_view_make(&scene.eye, &scene.plane, origin, &view), WATER_OK);
  ASSERT_CLOSE(view.eye_height, 13.0, 1e-12);
}

// Seen straight down a sheet within the picture, or that just fills it, has two rows through its
// two corners at either end, and even ones between: of a length that grows with sqrt(h + |y|), h
// the height of the eye or of waves that are higher. A sheet without a width has all of them in a
// line.
TEST(rows_seen_straight_down_are_where_they_should_be)
{
  enum
  {
    EVEN = SIDE - 4
  };
  static laid grid;
  const double halves[4] = { 10.0, 5.0, 5.0, 0.0 };
  const double heights[4] = { 0.0, 0.0, 40.0, 0.0 };
  random_scene random;
  memset(&random, 0, sizeof random);
  random.scene = pool(10.0); // from 10 above, 45 degrees to each side
  const water_grid_view view = view_of(&random);
  for (int i = 0; i < 4; ++i)
  {
    const double half = halves[i];
    const double middle = i == 3 ? 3.0 : 0.0;
    const double h = fmax(10.0, heights[i]);
    const double sheet[4] = { -5.0, 5.0, middle - half, middle + half };
    assert_true(water_grid_lay(
      &view, sheet, heights[i], 0.0, GRID, grid.points[0], grid.cells[0], grid.row_dir));
    const double most = 2.0 * (sqrt(h + half) - sqrt(h)); // of the integral of 1 / sqrt(h + |y|)
    for (int row = 0; row < SIDE; ++row)
    {
      const int even = row < 2 ? 0 : row > EVEN + 1 ? EVEN + 1 : row - 1;
      const double measure = most * (2.0 * even / (EVEN + 1) - 1.0);
      const double root = sqrt(h) + 0.5 * fabs(measure);
      const double y = middle + copysign(root * root - h, measure);
      for (int end = 0; end < 2; ++end)
      {
        const double* point = grid.points[row * SIDE + end * GRID];
        ASSERT_CLOSE(point[0], end == 0 ? 5.0 : -5.0, 1e-12);
        ASSERT_CLOSE(point[1], y, 1e-12);
      }
      const double apart = half > 0.0 ? 2.0 * most / (EVEN + 1) * root : 0.0;
      ASSERT_CLOSE((double)grid.cells[row * SIDE][0], apart, 1e-6);
    }
  }
}

// Seen straight down a sheet without an end is laid as one that just fills the picture.
TEST(endless_rows_seen_straight_down_fill_the_picture)
{
  static laid grid;
  static laid endless;
  const double sheet[4] = { -10.0, 10.0, -10.0, 10.0 };
  random_scene random;
  memset(&random, 0, sizeof random);
  random.scene = pool(10.0); // from 10 above, 45 degrees to each side
  const water_grid_view view = view_of(&random);
  assert_true(
    water_grid_lay(&view, sheet, 0.0, 0.0, GRID, grid.points[0], grid.cells[0], grid.row_dir));
  assert_true(water_grid_lay(
    &view, NULL, 0.0, 0.0, GRID, endless.points[0], endless.cells[0], endless.row_dir));
  for (int i = 0; i < SIDE * SIDE; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_CLOSE(endless.points[i][k], grid.points[i][k], 1e-6);
    }
    ASSERT_CLOSE((double)endless.cells[i][0], (double)grid.cells[i][0], 1e-6);
  }
}

// Straight down, a sheet out of view, an eye in the plane, a plane that is none.
TEST(odd_views_are_safe)
{
  static laid grid;
  random_scene random;
  memset(&random, 0, sizeof random);
  random.scene = lake();
  const double above[3] = { 0.0, 0.0, 9.0 };
  const double up[3] = { 0.0, 1.0, 0.0 };
  look_at(above, random.target, up, random.scene.eye.world_to_view);
  water_grid_view view = view_of(&random);
  ASSERT_CLOSE(view.eye_height, 9.0, 1e-12);
  const double sheet[4] = { -100.0, 100.0, -100.0, 100.0 };
  assert_true(
    water_grid_lay(&view, sheet, 0.0, 0.0, GRID, grid.points[0], grid.cells[0], grid.row_dir));
  ASSERT_CLOSE(grid.points[0][1], -9.0, 1e-9); // 90 degrees high, 4 : 3
  ASSERT_CLOSE(fabs(grid.points[0][0]), 12.0, 1e-9);
  ASSERT_CLOSE(grid.points[SIDE * SIDE - 1][1], 9.0, 1e-9);

  const double elsewhere[4] = { 20.0, 30.0, 20.0, 30.0 };
  grid.points[0][0] = 77.0;
  assert_false(
    water_grid_lay(&view, elsewhere, 0.1, 0.1, GRID, grid.points[0], grid.cells[0], grid.row_dir));
  assert_true(grid.points[0][0] == 77.0);

  view.eye_height = 5.0;
  const double inside[3] = { 0.0, -10.0, 0.0 };
  const double high[3] = { 0.0, 0.0, 1.0 };
  look_at(inside, random.target, high, random.scene.eye.world_to_view);
  assert_int_equal(
    water_grid_view_make(&random.scene.eye, &random.scene.plane, random.target, &view), WATER_OK);
  ASSERT_CLOSE(view.eye_height, 1e-4, 1e-12); // on the plane: over it, for a near plane at 1
  view.eye_height = 5.0;
  random.scene.plane.normal[2] = 0.0;
  assert_int_equal(
    water_grid_view_make(&random.scene.eye, &random.scene.plane, random.target, &view),
    WATER_BAD_PLANE);
  assert_true(view.eye_height == 5.0);
}

// A sheet without an end covers all that a parallel eye sees of the plane.
TEST(endless_grid_covers_parallel_views)
{
  dice from = dice_seeded(177);
  static laid grid;
  int seen = 0;
  for (int round = 2; round < 300; round += 3)
  {
    const random_scene random = scene_rolled(&from, round, nearby);
    assert_true(random.is_parallel);
    const water_grid_view view = view_of(&random);
    assert_true(
      water_grid_lay(&view, NULL, 0.2, 0.1, GRID, grid.points[0], grid.cells[0], grid.row_dir));
    for (int i = 0; i < 100; ++i)
    {
      const double place[2] = { dice_roll(&from, -20.0, 20.0), dice_roll(&from, -20.0, 20.0) };
      double point[3];
      for (int k = 0; k < 3; ++k)
      {
        point[k] = random.target[k] + place[0] * view.axes.x_dir[k] + place[1] * view.axes.y_dir[k];
      }
      double clip[4];
      project(&random.scene.eye, point, 1.0, clip);
      if (is_inside(clip))
      {
        ++seen;
        assert_true(is_covered(&view, &grid, place));
      }
    }
  }
  assert_true(seen > 500);
}

// Also without waves, whose heights add to how far the sheet reaches: straight down and aslant,
// about the point under the eye and far beside it, to each side.
TEST(endless_grid_covers_calm_parallel_views)
{
  static laid grid;
  for (int i = 0; i < 5 * 2; ++i)
  {
    const double far[5][2] = { { 0.0, 0.0 }, { 9e3, 0.0 }, { -9e3, 0.0 }, { 0.0, 9e3 },
      { 0.0, -9e3 } };
    const double* middle = far[i % 5];
    const double box[4] = { middle[0] - 1.0, middle[0] + 1.0, middle[1] - 1.0, middle[1] + 1.0 };
    const double eye[3] = { 0.0, 0.0, 2e4 };
    const double target[3] = { i / 5 ? 7e3 : 0.0, 0.0, 0.0 };
    const double up[3] = { 0.0, 1.0, 0.0 };
    water_scene scene = lake();
    look_at(eye, target, up, scene.eye.world_to_view);
    ortho_matrix(box, 1.0, 1e5, scene.eye.view_to_clip);
    scene.eye.parallel = true;
    water_grid_view view;
    assert_int_equal(water_grid_view_make(&scene.eye, &scene.plane, target, &view), WATER_OK);
    assert_true(
      water_grid_lay(&view, NULL, 0.0, 0.0, GRID, grid.points[0], grid.cells[0], grid.row_dir));
    double low[2] = { DBL_MAX, DBL_MAX }; // of the grid's picture
    double high[2] = { -DBL_MAX, -DBL_MAX };
    for (int j = 0; j < SIDE * SIDE; ++j)
    {
      double clip[4];
      project(&scene.eye, grid.points[j], 1.0, clip);
      for (int axis = 0; axis < 2; ++axis)
      {
        low[axis] = fmin(low[axis], clip[axis]);
        high[axis] = fmax(high[axis], clip[axis]);
      }
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      ASSERT_CLOSE(low[axis], -1.0, 1e-6);
      ASSERT_CLOSE(high[axis], 1.0, 1e-6);
    }
  }
}

TESTS(endless_rows_seen_straight_down_fill_the_picture, endless_grid_covers_calm_parallel_views,
  endless_grid_covers_parallel_views, grid_covers_what_can_come_into_view,
  grid_is_ordered_and_on_the_sheet, cells_are_as_large_as_they_say, rows_lead_where_the_view_goes,
  view_leads_from_clip_to_places_and_back, grid_knows_the_height_of_a_moved_eye,
  rows_seen_straight_down_are_where_they_should_be, odd_views_are_safe)
