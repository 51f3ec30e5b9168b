// SPDX-License-Identifier: BSD-3-Clause
// water_rank_pixels.c: pixels of ranks as few bytes, the nearest of them.
#include "water_rank_pixels.h"

#include <string.h>

// What a run of pixels holds: its length is sent with it, as a number of 7 bits a byte.
enum
{
  RUN_NOTHING,    // nothing is sent
  RUN_ONE_DRAWN,  // one colour, depths
  RUN_MANY_DRAWN, // colours, depths
  RUN_ONE,        // one colour
  RUN_MANY,       // colours
  RUN_COUNT,
  RUN_BITS = 3
};

enum
{
  REPEATS_MIN = 3 // pixels of one colour that are worth a run
};

// What the next depth is guessed from.
typedef struct guess
{
  int32_t last;       // upper 24 bits
  int32_t before;     // of the one before
  unsigned char rest; // lower 8 bits
} guess;

typedef struct reader
{
  const unsigned char* next;
  const unsigned char* end;
} reader;

static const double depth_scale = 4294967296.0; // 2^32: the numbers' steps in a depth of 1

void water_rank_pixels_from_depths(const float* depths, size_t count, uint32_t* numbers)
{
  for (size_t i = 0; i < count; ++i)
  {
    const double depth = depths[i] > 0.0f ? (double)depths[i] : 0.0;
    numbers[i] = depth < 1.0 ? (uint32_t)(depth * depth_scale) : WATER_RANK_NOTHING;
  }
}

void water_rank_pixels_to_depths(const uint32_t* numbers, size_t count, float* depths)
{
  for (size_t i = 0; i < count; ++i)
  {
    depths[i] = numbers[i] == WATER_RANK_NOTHING ? 1.0f : (float)((double)numbers[i] / depth_scale);
  }
}

size_t water_rank_pixels_limit(const water_rank_picture* picture)
{
  // a run each: its length, its colour, and a depth of 4 + 1 bytes
  return 16 + picture->pixel_count * (4 * picture->words + 6);
}

static inline unsigned char* put_number(size_t number, unsigned char* next)
{
  for (; number > 127; number >>= 7)
  {
    *next++ = (unsigned char)(number & 127) | 128;
  }
  *next++ = (unsigned char)number;
  return next;
}

static inline bool take_number(reader* from, size_t* number)
{
  if (from->next < from->end && *from->next < 128) // as a rule
  {
    *number = *from->next++;
    return true;
  }
  uint64_t read = 0; // a size_t may have 32 bits
  for (int shift = 0; shift < 63 && from->next < from->end; shift += 7)
  {
    const unsigned char byte = *from->next++;
    read |= (uint64_t)(byte & 127) << shift;
    if (byte < 128)
    {
      *number = (size_t)read;
      return read <= SIZE_MAX;
    }
  }
  return false;
}

// What a pixel's depth is guessed from: those of the same sample of other pixels, as the places of
// samples in a pixel are in no order.
static guess* guess_of(const water_rank_picture* picture, guess* known, size_t i)
{
  return known + (picture->samples > 1 ? i % picture->samples : 0);
}

static int32_t next_guess(const guess* known)
{
  const int32_t next = 2 * known->last - known->before;
  return next < 0 ? 0 : next > 0xffffff ? 0xffffff : next;
}

static void learn(guess* known, uint32_t depth)
{
  known->before = known->last;
  known->last = (int32_t)(depth >> 8);
  known->rest = (unsigned char)(depth & 255);
}

static inline unsigned char* put_depth(uint32_t depth, guess* known, unsigned char* next)
{
  const int32_t off = (int32_t)(depth >> 8) - next_guess(known);
  const size_t size = off < 0 ? 2 * (size_t)-off - 1 : 2 * (size_t)off;
  const bool has_rest = (depth & 255) != known->rest;
  next = put_number(2 * size + (has_rest ? 1 : 0), next);
  if (has_rest)
  {
    *next++ = (unsigned char)(depth & 255);
  }
  learn(known, depth);
  return next;
}

static inline bool take_depth(reader* from, guess* known, uint32_t* depth)
{
  size_t size;
  if (!take_number(from, &size) || size > (size_t)1 << 27 ||
    ((size & 1) && from->next == from->end))
  {
    return false;
  }
  const uint32_t rest = size & 1 ? *from->next++ : known->rest;
  size >>= 1;
  const int32_t off = size & 1 ? -(int32_t)(size / 2 + 1) : (int32_t)(size / 2);
  *depth = ((uint32_t)(next_guess(known) + off) & 0xffffff) << 8 | rest;
  learn(known, *depth);
  return true;
}

static bool is_one_color(const water_rank_picture* picture, size_t i, size_t j)
{
  const size_t words = picture->words;
  const uint32_t* first = picture->colors + i * words;
  const uint32_t* second = picture->colors + j * words;
  // each pixel asks: a call with a number of bytes that the compiler does not know takes longer
  return words == 1 ? *first == *second
    : words == 2    ? first[0] == second[0] && first[1] == second[1]
                    : memcmp(first, second, words * 4) == 0;
}

// Is something there: drawn, or in a layer?
static bool is_there(const water_rank_picture* picture, size_t i)
{
  if (picture->depths)
  {
    return picture->depths[i] != WATER_RANK_NOTHING;
  }
  for (size_t j = 0; j < picture->words; ++j)
  {
    if (picture->colors[i * picture->words + j] != 0)
    {
      return true;
    }
  }
  return false;
}

// The run that begins at a pixel.
static size_t find_run(
  const water_rank_picture* picture, bool has_background, size_t begin, int* kind)
{
  const bool there = is_there(picture, begin);
  const bool has_colors = there || (has_background && picture->depths);
  const bool has_depths = there && picture->depths;
  size_t repeats = 1; // at the end of what was looked at
  size_t i = begin + 1;
  for (; i < picture->pixel_count && is_there(picture, i) == there; ++i)
  {
    if (!has_colors)
    {
      continue;
    }
    const bool is_same = is_one_color(picture, i - 1, i);
    if (!is_same && repeats >= REPEATS_MIN)
    {
      break; // these begin the run, and are all of it
    }
    repeats = is_same ? repeats + 1 : 1;
    if (repeats == REPEATS_MIN && i + 1 - repeats > begin)
    {
      i -= repeats - 1; // those before are the run
      repeats = 1;
      break;
    }
  }
  const bool is_one = repeats == i - begin;
  *kind = !has_colors ? RUN_NOTHING
    : has_depths      ? (is_one ? RUN_ONE_DRAWN : RUN_MANY_DRAWN)
                      : (is_one ? RUN_ONE : RUN_MANY);
  return i - begin;
}

static unsigned char* put_depths(
  const water_rank_picture* picture, size_t begin, size_t length, guess* known, unsigned char* next)
{
  const uint32_t* depths = picture->depths;
  if (picture->samples > 1)
  {
    for (size_t i = begin; i < begin + length; ++i)
    {
      next = put_depth(depths[i], guess_of(picture, known, i), next);
    }
    return next;
  }
  guess own = *known; // which no byte that is written can change: it stays in registers
  for (size_t i = begin; i < begin + length; ++i)
  {
    next = put_depth(depths[i], &own, next);
  }
  *known = own;
  return next;
}

size_t water_rank_pixels_encode(
  const water_rank_picture* picture, bool has_background, unsigned char* bytes)
{
  unsigned char* next = bytes;
  guess known[WATER_RANK_SAMPLES_MAX] = { { 0, 0, 0 } };
  for (size_t i = 0; i < picture->pixel_count;)
  {
    int kind;
    const size_t length = find_run(picture, has_background, i, &kind);
    next = put_number(length << RUN_BITS | (size_t)kind, next);
    if (kind != RUN_NOTHING)
    {
      const size_t colors = kind == RUN_ONE || kind == RUN_ONE_DRAWN ? 1 : length;
      const size_t size = 4 * picture->words * colors;
      memcpy(next, picture->colors + i * picture->words, size);
      next += size;
    }
    if (kind == RUN_ONE_DRAWN || kind == RUN_MANY_DRAWN)
    {
      next = put_depths(picture, i, length, known, next);
    }
    i += length;
  }
  return (size_t)(next - bytes);
}

// The same as memcpy, of a size that the compiler knows.
static inline void copy_color(const unsigned char* from, size_t words, uint32_t* color)
{
  if (words == 1)
  {
    memcpy(color, from, 4);
  }
  else if (words == 2)
  {
    memcpy(color, from, 8);
  }
  else
  {
    memcpy(color, from, 4 * words);
  }
}

// Reads one run into a picture.
static bool merge_run(reader* from, int kind, size_t begin, size_t length, water_rank_merge merge,
  guess* known, water_rank_picture* picture)
{
  const bool is_one = kind == RUN_ONE || kind == RUN_ONE_DRAWN;
  const bool has_depths = kind == RUN_ONE_DRAWN || kind == RUN_MANY_DRAWN;
  const size_t words = picture->words;
  const unsigned char* colors = from->next;
  const size_t size = 4 * words * (is_one ? 1 : length);
  if (size > (size_t)(from->end - from->next) || (has_depths && !picture->depths))
  {
    return false;
  }
  from->next += size;
  for (size_t i = begin; i < begin + length; ++i, colors += is_one ? 0 : 4 * words)
  {
    uint32_t depth = WATER_RANK_NOTHING;
    if (has_depths && !take_depth(from, guess_of(picture, known, i), &depth))
    {
      return false;
    }
    if (picture->depths)
    {
      if (merge == WATER_RANK_NEAREST && picture->depths[i] <= depth)
      {
        continue;
      }
      picture->depths[i] = depth;
    }
    copy_color(colors, words, picture->colors + i * words);
  }
  return true;
}

bool water_rank_pixels_merge(const unsigned char* bytes, size_t byte_count, water_rank_merge merge,
  water_rank_picture* picture)
{
  reader from = { bytes, bytes + byte_count };
  guess known[WATER_RANK_SAMPLES_MAX] = { { 0, 0, 0 } };
  size_t done = 0;
  while (done < picture->pixel_count)
  {
    size_t head;
    if (!take_number(&from, &head))
    {
      return false;
    }
    const int kind = (int)(head & ((1 << RUN_BITS) - 1));
    const size_t length = head >> RUN_BITS;
    if (kind >= RUN_COUNT || length == 0 || length > picture->pixel_count - done ||
      (kind != RUN_NOTHING && !merge_run(&from, kind, done, length, merge, known, picture)))
    {
      return false;
    }
    done += length;
  }
  return from.next == from.end;
}
