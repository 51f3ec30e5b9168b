// SPDX-License-Identifier: BSD-3-Clause
// test_rank_layers.c: layers of boxes are blended in the order in which rays meet the boxes.
#include "test_scene.h"

#include "water_rank_pixels.h"

enum
{
  BOXES = 12,
  EDGE = 8 // of the space that is parted
};

static int rolled(dice* from, int low, int high)
{
  return (int)floor(dice_roll(from, low, high + 1));
}

// Parts a cube at whole numbers, one box after the other, as a k-d tree does.
static void part_space(dice* from, double boxes[BOXES][6])
{
  const double all[6] = { 0.0, EDGE, 0.0, EDGE, 0.0, EDGE };
  memcpy(boxes[0], all, sizeof all);
  for (int count = 1; count < BOXES;)
  {
    double* box = boxes[rolled(from, 0, count - 1)];
    const int axis = rolled(from, 0, 2);
    const int low = (int)box[2 * axis];
    const int high = (int)box[2 * axis + 1];
    if (high - low < 2)
    {
      continue;
    }
    memcpy(boxes[count], box, sizeof all);
    box[2 * axis + 1] = rolled(from, low + 1, high - 1);
    boxes[count++][2 * axis] = box[2 * axis + 1];
  }
}

// The part of a ray in a box, from the eye on unless the view is parallel. Returns false where it
// only touches it.
static bool ray_meets(
  const double box[6], const double eye[3], const double dir[3], bool is_parallel, double range[2])
{
  range[0] = is_parallel ? -(double)INFINITY : 0.0;
  range[1] = (double)INFINITY;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = box[2 * axis] - eye[axis];
    const double high = box[2 * axis + 1] - eye[axis];
    if (dir[axis] == 0.0)
    {
      if (low >= 0.0 || high <= 0.0)
      {
        return false;
      }
      continue;
    }
    range[0] = fmax(range[0], fmin(low / dir[axis], high / dir[axis]));
    range[1] = fmin(range[1], fmax(low / dir[axis], high / dir[axis]));
  }
  return range[1] - range[0] > 1e-9;
}

static void order_of(const double (*boxes)[6], size_t count, const double eye[3],
  const double dir[3], bool is_parallel, size_t* order)
{
  size_t blockers[BOXES];
  const double focal_point[3] = { eye[0] + dir[0], eye[1] + dir[1], eye[2] + dir[2] };
  water_rank_pixels_order(boxes, count, eye, focal_point, is_parallel, order, blockers);
}

// Through random points of random k-d trees, from eyes in them, before them and in the planes
// between their boxes.
TEST(rays_meet_boxes_in_their_order)
{
  dice from = dice_seeded(24);
  int pairs = 0;
  for (int round = 0; round < 600; ++round)
  {
    double boxes[BOXES][6];
    double eye[3];
    double view[3];
    const bool is_parallel = round % 2 == 1;
    part_space(&from, boxes);
    for (int axis = 0; axis < 3; ++axis)
    {
      eye[axis] = rolled(&from, -4, EDGE + 4);
      view[axis] = rolled(&from, -2, 2);
    }
    view[0] += view[0] == 0.0 && view[1] == 0.0 && view[2] == 0.0 ? 1.0 : 0.0;
    size_t order[BOXES];
    size_t place[BOXES]; // of a box in the order
    order_of((const double(*)[6])boxes, BOXES, eye, view, is_parallel, order);
    unsigned int seen = 0;
    for (size_t i = 0; i < BOXES; ++i)
    {
      assert_in_range(order[i], 0, BOXES - 1);
      seen |= 1u << order[i];
      place[order[i]] = i;
    }
    assert_int_equal(seen, (1u << BOXES) - 1u);
    for (int ray = 0; ray < 40; ++ray)
    {
      double start[3];
      double dir[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        const double point = dice_roll(&from, 0.0, EDGE);
        start[axis] = is_parallel ? point : eye[axis];
        dir[axis] = is_parallel ? view[axis] : point - eye[axis];
      }
      double ranges[BOXES][2];
      bool is_met[BOXES];
      for (int i = 0; i < BOXES; ++i)
      {
        is_met[i] = ray_meets(boxes[i], start, dir, is_parallel, ranges[i]);
      }
      for (int i = 0; i < BOXES * BOXES; ++i)
      {
        const int first = i % BOXES;
        const int second = i / BOXES;
        if (first != second && is_met[first] && is_met[second] &&
          ranges[first][1] <= ranges[second][0] + 1e-9)
        {
          assert_true(place[first] < place[second]);
          ++pairs;
        }
      }
    }
  }
  assert_in_range(pairs, 20000, 10000000);
}

static void assert_order(const double (*boxes)[6], size_t count, const double eye[3],
  const double dir[3], bool is_parallel, const size_t* expected)
{
  size_t order[BOXES];
  order_of(boxes, count, eye, dir, is_parallel, order);
  assert_memory_equal(order, expected, count * sizeof *order);
}

// Of boxes in each other, that with the nearest centre comes first, whichever number it has. All
// centres are before the eye, and their distances from (0, 0, 0) have another order.
TEST(nested_boxes_are_sorted_from_the_eye)
{
  static const double boxes[3][6] = { { -1.0, 5.0, -3.0, 3.0, -3.0, 3.0 },
    { -1.0, 3.0, -3.0, 3.0, -3.0, 3.0 }, { -1.0, 1.0, -3.0, 3.0, -3.0, 3.0 } };
  static const double turned[3][6] = { { -1.0, 1.0, -3.0, 3.0, -3.0, 3.0 },
    { -1.0, 3.0, -3.0, 3.0, -3.0, 3.0 }, { -1.0, 5.0, -3.0, 3.0, -3.0, 3.0 } };
  static const size_t rising[3] = { 0, 1, 2 };
  static const size_t falling[3] = { 2, 1, 0 };
  for (int i = 0; i < 4; ++i)
  {
    const bool is_parallel = i % 2 == 1;
    const double eye[3] = { i < 2 ? 4.5 : -4.5, 0.0, 0.0 };
    const double dir[3] = { i < 2 ? -1.0 : 1.0, 0.0, 0.0 };
    assert_order(boxes, 3, eye, dir, is_parallel, i < 2 ? rising : falling);
    assert_order(turned, 3, eye, dir, is_parallel, i < 2 ? falling : rising);
  }
}

// An eye in the plane between two boxes sees none through the other, and neither does a view along
// that plane: their centres decide.
TEST(boxes_beside_the_eye_are_sorted_by_their_centres)
{
  const double dir[3] = { 1.0, 0.0, 0.0 };
  const double eye[3] = { -1.0, 2.0, 2.0 };
  static const size_t expected[2][2] = { { 0, 1 }, { 1, 0 } };
  for (int axis = 1; axis < 3; ++axis)
  {
    for (int low = 0; low < 2; ++low) // the first is under the plane, or over it
    {
      for (int nearest = 0; nearest < 2; ++nearest)
      {
        double boxes[2][6] = { { 0.0, 4.0, 0.0, 4.0, 0.0, 4.0 }, { 0.0, 4.0, 0.0, 4.0, 0.0, 4.0 } };
        boxes[low][2 * axis + 1] = 2.0;
        boxes[1 - low][2 * axis] = 2.0;
        boxes[1 - nearest][1] = 9.0; // the other's centre is 2.5 farther away
        const double(*given)[6] = (const double(*)[6])boxes;
        assert_order(given, 2, eye, dir, false, expected[nearest]);
        assert_order(given, 2, eye, dir, true, expected[nearest]);
      }
    }
  }
}

// All ranks blend equal boxes in the same order: their own.
TEST(equal_boxes_keep_their_order)
{
  static const double boxes[4][6] = { { 1.0, 2.0, 0.0, 1.0, 0.0, 1.0 },
    { 1.0, -1.0, 0.0, 1.0, 0.0, 1.0 }, { 1.0, 2.0, 0.0, 1.0, 0.0, 1.0 },
    { 1.0, -1.0, 0.0, 1.0, 0.0, 1.0 } };
  static const size_t expected[4] = { 0, 2, 1, 3 };
  const double eye[3] = { -3.0, 1.0, 2.0 };
  const double dir[3] = { 1.0, 0.0, 0.0 };
  assert_order(boxes, 4, eye, dir, false, expected);
  assert_order(boxes, 4, eye, dir, true, expected);
}

// Each pixel of floats is blended with the one at its own place, and what is behind the last stays.
TEST(each_pixel_is_blended_with_its_own)
{
  const float front[2][4] = { { 0.5f, 0.0f, 0.25f, 0.5f }, { 1.0f, 0.5f, 0.0f, 1.0f } };
  const float behind[3][4] = { { 1.0f, 0.5f, 0.5f, 1.0f }, { 0.25f, 0.25f, 0.25f, 0.25f },
    { 8.0f, 8.0f, 8.0f, 8.0f } };
  const float expected[3][4] = { { 1.0f, 0.25f, 0.5f, 1.0f }, { 1.0f, 0.5f, 0.0f, 1.0f },
    { 8.0f, 8.0f, 8.0f, 8.0f } };
  uint32_t words[3][4] = { { 0 } };
  uint32_t result[3][4];
  float blended[3][4];
  memcpy(words, front, sizeof front);
  memcpy(result, behind, sizeof result);
  water_rank_pixels_over(words[0], 4, 2, result[0]);
  memcpy(blended, result, sizeof blended);
  for (int i = 0; i < 12; ++i)
  {
    ASSERT_CLOSE((double)blended[i / 4][i % 4], (double)expected[i / 4][i % 4], 0.0);
  }
}

TESTS(rays_meet_boxes_in_their_order, nested_boxes_are_sorted_from_the_eye,
  boxes_beside_the_eye_are_sorted_by_their_centres, equal_boxes_keep_their_order,
  each_pixel_is_blended_with_its_own)
