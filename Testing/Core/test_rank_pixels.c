// SPDX-License-Identifier: BSD-3-Clause
// test_rank_pixels.c: what ranks send of their pixels comes back as it was, and the nearest of it;
// layers are blended in the order of their depth.
#include "test_scene.h"

#include "water_rank_pixels.h"

#include <stdlib.h>
#include <string.h>

enum
{
  PIXELS = 500,
  WORDS = 4
};

typedef struct part
{
  uint32_t colors[PIXELS * WORDS];
  uint32_t depths[PIXELS];
} part;

static unsigned char bytes[16 + PIXELS * (4 * WORDS + 6)];

static water_rank_picture picture_of(part* from, size_t words, bool has_depths)
{
  const water_rank_picture picture = { from->colors, has_depths ? from->depths : NULL, words,
    PIXELS, 0 };
  return picture;
}

static uint32_t next_random(uint64_t* state)
{
  *state = *state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return (uint32_t)(*state >> 32);
}

// Runs of all kinds and lengths: nothing, colours that repeat and that do not, smooth and wild
// depths.
static void fill(part* to, size_t words, uint64_t seed)
{
  uint64_t state = seed;
  size_t i = 0;
  while (i < PIXELS)
  {
    const size_t length = 1 + next_random(&state) % (next_random(&state) % 2 ? 4 : 90);
    const uint32_t kind = next_random(&state) % 4;
    const uint32_t color = next_random(&state);
    const uint32_t slope = next_random(&state) >> 12;
    const uint32_t depth = next_random(&state) >> 1;
    for (size_t j = i; j < PIXELS && j < i + length; ++j)
    {
      to->depths[j] = kind == 0 ? WATER_RANK_NOTHING
        : kind == 1             ? next_random(&state)
                                : depth + (uint32_t)(j - i) * slope;
      for (size_t k = 0; k < words; ++k)
      {
        to->colors[words * j + k] = kind == 2 ? color : next_random(&state);
      }
    }
    i += length;
  }
}

TEST(pixels_come_back)
{
  static part sent, got;
  for (uint64_t seed = 1; seed < 200; ++seed)
  {
    const size_t words = seed % 3 == 0 ? 4 : seed % 3;
    fill(&sent, words, seed);
    memset(&got, 0x5a, sizeof got);
    water_rank_picture from = picture_of(&sent, words, true);
    water_rank_picture to = picture_of(&got, words, true);
    const size_t size = water_rank_pixels_encode(&from, true, bytes);
    assert_true(size <= water_rank_pixels_limit(&from));
    assert_true(water_rank_pixels_merge(bytes, size, WATER_RANK_REPLACE, &to));
    assert_memory_equal(got.colors, sent.colors, 4 * words * PIXELS);
    assert_memory_equal(got.depths, sent.depths, sizeof sent.depths);
  }
}

// Of equal depths what was there stays; where nothing is drawn, too.
TEST(nearest_pixel_wins)
{
  static part lower, higher, expected;
  for (uint64_t seed = 1; seed < 100; ++seed)
  {
    fill(&lower, 1, seed);
    fill(&higher, 1, seed + 1000);
    for (size_t i = 0; i < 40; ++i)
    {
      higher.depths[i] = lower.depths[i];
    }
    expected = lower;
    for (size_t i = 0; i < PIXELS; ++i)
    {
      if (higher.depths[i] < lower.depths[i])
      {
        expected.depths[i] = higher.depths[i];
        expected.colors[i] = higher.colors[i];
      }
    }
    const water_rank_picture from = picture_of(&higher, 1, true);
    water_rank_picture to = picture_of(&lower, 1, true);
    const size_t size = water_rank_pixels_encode(&from, false, bytes);
    assert_true(water_rank_pixels_merge(bytes, size, WATER_RANK_NEAREST, &to));
    assert_memory_equal(lower.colors, expected.colors, 4 * PIXELS);
    assert_memory_equal(lower.depths, expected.depths, sizeof expected.depths);
  }
}

// Colours that differ in one of their words alone come back, and one colour takes few bytes, of any
// number of words.
TEST(each_word_of_a_color_counts)
{
  static part sent, got;
  for (size_t words = 1; words <= WORDS; ++words)
  {
    for (size_t word = 0; word <= words; ++word) // at last all are the same
    {
      memset(&sent, 0, sizeof sent);
      memset(&got, 0x5a, sizeof got);
      for (size_t i = 0; word < words && i < PIXELS; ++i)
      {
        sent.colors[words * i + word] = (uint32_t)i + 1;
      }
      water_rank_picture from = picture_of(&sent, words, true);
      water_rank_picture to = picture_of(&got, words, true);
      const size_t size = water_rank_pixels_encode(&from, true, bytes);
      assert_true(water_rank_pixels_merge(bytes, size, WATER_RANK_REPLACE, &to));
      assert_memory_equal(got.colors, sent.colors, 4 * words * PIXELS);
      assert_true((size < 2 * PIXELS) == (word == words));
    }
  }
}

// The samples of a pixel show one colour and lie on one facet, each at a place of its own in the
// pixel: as many bytes as their depths, and no more for their colours than those of a pixel.
TEST(samples_of_a_pixel_take_few_bytes)
{
  static const uint32_t places[4] = { 700, 100, 1100, 400 };
  static part sent, got;
  memset(&got, 0, sizeof got);
  for (uint32_t i = 0; i < PIXELS; ++i)
  {
    sent.colors[i] = i / 4;
    sent.depths[i] = (UINT32_C(9000000) + 1234 * (i / 4) + places[i % 4]) << 8 | 255;
  }
  water_rank_picture from = picture_of(&sent, 1, true);
  from.samples = 4;
  water_rank_picture to = picture_of(&got, 1, true);
  to.samples = 4;
  const size_t size = water_rank_pixels_encode(&from, false, bytes);
  assert_true(size <= PIXELS + (4 + 2) * (PIXELS / 4) + 4 * 12);
  memset(got.depths, 0xff, sizeof got.depths);
  assert_true(water_rank_pixels_merge(bytes, size, WATER_RANK_NEAREST, &to));
  assert_memory_equal(got.colors, sent.colors, 4 * PIXELS);
  assert_memory_equal(got.depths, sent.depths, sizeof sent.depths);
}

// Every float of the far half, and some of the near one; what is nothing stays nothing.
TEST(depths_come_back)
{
  float depths[PIXELS], got[PIXELS];
  uint32_t numbers[PIXELS];
  for (int i = 0; i < PIXELS; ++i)
  {
    depths[i] = i < 300 ? 1.0f - (float)i * 5.9604645e-8f : 1.0f / (float)(i - 298);
  }
  depths[0] = 1.0f;
  depths[499] = 0.0f;
  depths[498] = -0.25f;
  water_rank_pixels_from_depths(depths, PIXELS, numbers);
  water_rank_pixels_to_depths(numbers, PIXELS, got);
  assert_true(numbers[0] == WATER_RANK_NOTHING);
  assert_true(numbers[1] == UINT32_C(0xffffff00));
  assert_true(numbers[300] == UINT32_C(0x80000000));
  assert_true(numbers[499] == 0 && numbers[498] == 0);
  for (int i = 0; i < 498; ++i)
  {
    assert_true(got[i] == depths[i]);
  }
  const float farthest[1] = { 1.0f };
  const uint32_t last[1] = { WATER_RANK_NOTHING - 1 };
  water_rank_pixels_to_depths(last, 1, got);
  water_rank_pixels_from_depths(farthest, 1, numbers);
  assert_true(got[0] <= 1.0f && numbers[0] == WATER_RANK_NOTHING);
}

TEST(layers_come_back)
{
  static part sent, got;
  for (uint64_t seed = 1; seed < 100; ++seed)
  {
    fill(&sent, 1, seed);
    for (size_t i = 0; i < PIXELS; ++i)
    {
      sent.colors[i] = sent.depths[i] == WATER_RANK_NOTHING ? 0 : sent.colors[i];
    }
    memset(&got, 0, sizeof got);
    const water_rank_picture from = picture_of(&sent, 1, false);
    water_rank_picture to = picture_of(&got, 1, false);
    const size_t size = water_rank_pixels_encode(&from, false, bytes);
    assert_true(water_rank_pixels_merge(bytes, size, WATER_RANK_REPLACE, &to));
    assert_memory_equal(got.colors, sent.colors, 4 * PIXELS);
  }
}

// Nothing takes a few bytes, a flat facet of one colour little more than one byte a pixel.
TEST(pixels_take_few_bytes)
{
  static part sent;
  const water_rank_picture picture = picture_of(&sent, 1, true);
  memset(&sent, 0xff, sizeof sent);
  assert_true(water_rank_pixels_encode(&picture, false, bytes) <= 2);
  assert_true(water_rank_pixels_encode(&picture, true, bytes) <= 2 + 4);
  for (uint32_t i = 0; i < PIXELS; ++i)
  {
    sent.depths[i] = (UINT32_C(9000000) + 1234 * i) << 8 | 255;
  }
  assert_true(water_rank_pixels_encode(&picture, false, bytes) <= PIXELS + 2 + 4 + 12);
}

// Whatever arrives, nothing but the picture is written, and an error is told.
TEST(wrong_bytes_are_refused)
{
  static part sent, got;
  fill(&sent, 1, 7);
  water_rank_picture from = picture_of(&sent, 1, true);
  water_rank_picture to = picture_of(&got, 1, true);
  const size_t size = water_rank_pixels_encode(&from, true, bytes);
  for (size_t i = 0; i < size; ++i)
  {
    unsigned char* given = malloc(i + 1); // sanitizers see who reads on
    assert_non_null(given);
    memcpy(given + 1, bytes, i);
    assert_false(water_rank_pixels_merge(given + 1, i, WATER_RANK_REPLACE, &to));
    free(given);
  }
  assert_false(water_rank_pixels_merge(bytes, size + 1, WATER_RANK_REPLACE, &to));
  uint64_t state = 3;
  for (int i = 0; i < 20000; ++i)
  {
    const size_t place = next_random(&state) % size;
    const unsigned char kept = bytes[place];
    bytes[place] = (unsigned char)next_random(&state);
    water_rank_pixels_merge(bytes, size, WATER_RANK_NEAREST, &to);
    bytes[place] = kept;
  }
  water_rank_picture layer = picture_of(&got, 1, false);
  assert_false(water_rank_pixels_merge(bytes, size, WATER_RANK_REPLACE, &layer));
}

TEST(layers_are_blended)
{
  const unsigned char front[12] = { 100, 50, 0, 128, 0, 0, 0, 0, 10, 20, 30, 255 };
  unsigned char back[12] = { 200, 100, 40, 255, 1, 2, 3, 4, 200, 200, 200, 200 };
  const unsigned char expected[12] = { 200, 100, 20, 255, 1, 2, 3, 4, 10, 20, 30, 255 };
  uint32_t words[3], result[3];
  memcpy(words, front, sizeof words);
  memcpy(result, back, sizeof result);
  water_rank_pixels_over(words, 1, 3, result);
  memcpy(back, result, sizeof back);
  assert_memory_equal(back, expected, sizeof back);
  const float source[4] = { 0.25f, 0.0f, 2.0f, 0.5f };
  float under[4] = { 1.0f, 3.0f, 0.0f, 0.5f };
  uint32_t source_words[4], under_words[4];
  memcpy(source_words, source, sizeof source);
  memcpy(under_words, under, sizeof under);
  water_rank_pixels_over(source_words, 4, 1, under_words);
  memcpy(under, under_words, sizeof under);
  static const float blended[4] = { 0.75f, 1.5f, 2.0f, 0.75f };
  for (int i = 0; i < 4; ++i)
  {
    ASSERT_CLOSE((double)under[i], (double)blended[i], 1e-6);
  }
}

static void assert_order(const double (*boxes)[6], size_t count, const double eye[3],
  const double direction[3], bool is_parallel, const size_t* expected)
{
  size_t order[8], blockers[8];
  const double focal_point[3] = { eye[0] + direction[0], eye[1] + direction[1],
    eye[2] + direction[2] };
  water_rank_pixels_order(boxes, count, eye, focal_point, is_parallel, order, blockers);
  assert_memory_equal(order, expected, count * sizeof *order);
}

// The parts of a k-d tree, the long one of them with its centre nearer than what is before it.
TEST(boxes_are_sorted)
{
  static const double boxes[4][6] = { { 1.0, -1.0, 0.0, 1.0, 0.0, 1.0 },
    { -100.0, 100.0, 2.0, 3.0, 0.0, 1.0 }, { 40.0, 41.0, 1.0, 2.0, 0.0, 1.0 },
    { 40.0, 41.0, 3.0, 4.0, 0.0, 1.0 } };
  static const double eye[3] = { 0.0, 0.0, 0.5 };
  static const double behind[3] = { 0.0, 9.0, 0.5 };
  static const double along[3] = { 0.0, 1.0, 0.0 };
  static const double against[3] = { 0.0, -1.0, 0.0 };
  static const size_t there[4] = { 2, 1, 3, 0 };
  static const size_t back[4] = { 3, 1, 2, 0 };
  assert_order(boxes, 4, eye, along, false, there);
  assert_order(boxes, 4, behind, against, false, back);
  assert_order(boxes, 4, behind, along, true, there);
  assert_order(boxes, 4, eye, against, true, back);
}

// Boxes that overlap: the one whose centre is nearer; boxes that hide each other in turn: all are
// there, once.
TEST(boxes_that_overlap_are_sorted_by_their_centres)
{
  static const double boxes[3][6] = { { -2.0, 2.0, 1.0, 9.0, -2.0, 2.0 },
    { -1.0, 1.0, 2.0, 3.0, -1.0, 1.0 }, { -1.0, 1.0, 0.5, 3.0, -1.0, 1.0 } };
  static const double eye[3] = { 0.0, 0.0, 0.0 };
  static const double along[3] = { 0.0, 1.0, 0.0 };
  static const size_t expected[3] = { 2, 1, 0 };
  assert_order(boxes, 3, eye, along, false, expected);
  static const double cycle[3][6] = { { 0.0, 3.0, 0.0, 1.0, 1.0, 2.0 },
    { 2.0, 3.0, 0.0, 3.0, 0.0, 1.0 }, { 1.0, 2.0, 1.0, 2.0, 0.0, 3.0 } };
  static const double corner[3] = { 9.0, 9.0, 9.0 };
  static const double before[3] = { 8.0, 8.0, 8.0 };
  size_t order[3], blockers[3], seen[3] = { 0, 0, 0 };
  water_rank_pixels_order(cycle, 3, corner, before, false, order, blockers);
  for (int i = 0; i < 3; ++i)
  {
    assert_true(order[i] < 3);
    ++seen[order[i]];
  }
  assert_true(seen[0] == 1 && seen[1] == 1 && seen[2] == 1);
}

// A pixel of a layer is sent if any of its words is not 0, and the most bytes are few a pixel.
TEST(any_word_of_a_layer_is_sent)
{
  static part sent, got;
  memset(&sent, 0, sizeof sent);
  memset(&got, 0, sizeof got);
  sent.colors[2 * 3 + 1] = 5;
  sent.colors[2 * 7] = 6;
  water_rank_picture from = picture_of(&sent, 2, false);
  water_rank_picture to = picture_of(&got, 2, false);
  const size_t size = water_rank_pixels_encode(&from, false, bytes);
  assert_true(water_rank_pixels_merge(bytes, size, WATER_RANK_REPLACE, &to));
  assert_memory_equal(got.colors, sent.colors, sizeof sent.colors);
  const water_rank_picture widest = picture_of(&sent, WORDS, true);
  assert_int_equal(water_rank_pixels_limit(&widest), sizeof bytes);
}

// A pixel is sent for its own words, not for those of the next.
TEST(the_next_pixels_words_are_not_a_pixels_own)
{
  static part sent;
  memset(&sent, 0, sizeof sent);
  sent.colors[2 * 3] = 5;
  water_rank_picture from = picture_of(&sent, 2, false);
  const size_t one = water_rank_pixels_encode(&from, false, bytes);
  sent.colors[2 * 2] = 6;
  const size_t two = water_rank_pixels_encode(&from, false, bytes);
  sent.colors[2 * 4] = 7;
  const size_t three = water_rank_pixels_encode(&from, false, bytes);
  print_message("one, two and three pixels: %zu, %zu, %zu bytes\n", one, two, three);
  assert_int_equal(two - one, 8);
  assert_int_equal(three - two, 8);
}

// Runs without an end to their kinds, without a length, and depths of too many bits are refused,
// each by itself: of one pixel, whose bytes are otherwise right.
TEST(bytes_are_wrong_one_by_one)
{
  uint32_t color = 0;
  uint32_t depth = 0;
  water_rank_picture one = { &color, &depth, 1, 1, 0 };
  for (unsigned char kind = 0; kind < 8; ++kind)
  {
    const unsigned char given[6] = { (unsigned char)(1 << 3 | kind), 1, 2, 3, 4, 0 };
    const size_t size = kind == 0 ? 1 : (kind < 3 ? 6 : 5);
    assert_int_equal(water_rank_pixels_merge(given, size, WATER_RANK_REPLACE, &one), kind < 5);
  }
  const unsigned char empty[2] = { 0, 1 << 3 };
  assert_true(water_rank_pixels_merge(empty + 1, 1, WATER_RANK_REPLACE, &one));
  assert_false(water_rank_pixels_merge(empty, 2, WATER_RANK_REPLACE, &one));
  for (int i = 0; i < 4; ++i) // numbers of 2^27, and 1, 2 and 3 more; odd ones have another byte
  {
    const unsigned char deep[10] = { 1 << 3 | 1, 1, 2, 3, 4, (unsigned char)(128 + i), 128, 128, 64,
      9 };
    assert_int_equal(
      water_rank_pixels_merge(deep, i % 2 ? 10 : 9, WATER_RANK_REPLACE, &one), i == 0);
  }
}

// Three pixels of one colour are worth a run of their own, before others; numbers up to 127 take
// one byte.
TEST(bytes_are_as_few_as_they_can_be)
{
  uint32_t colors[6] = { 9, 9, 9, 1, 2, 3 };
  uint32_t depths[6] = { 100 << 8, 168 << 8 | 5, 0, 0, 0, 0 };
  const water_rank_picture layer = { colors, NULL, 1, 6, 0 };
  assert_int_equal(water_rank_pixels_encode(&layer, false, bytes), (1 + 4) + (1 + 3 * 4));
  // 200 of the first depth, two bytes; the second is 32 under where the first two lead: 63, and a
  // rest
  const water_rank_picture drawn = { colors, depths, 1, 2, 0 };
  assert_int_equal(water_rank_pixels_encode(&drawn, false, bytes), 1 + 4 + 2 + (1 + 1));
}

TESTS(bytes_are_wrong_one_by_one, bytes_are_as_few_as_they_can_be,
  the_next_pixels_words_are_not_a_pixels_own, each_word_of_a_color_counts,
  any_word_of_a_layer_is_sent, pixels_come_back, nearest_pixel_wins,
  samples_of_a_pixel_take_few_bytes, depths_come_back, layers_come_back, pixels_take_few_bytes,
  wrong_bytes_are_refused, layers_are_blended, boxes_are_sorted,
  boxes_that_overlap_are_sorted_by_their_centres)
