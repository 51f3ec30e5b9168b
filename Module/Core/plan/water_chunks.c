// SPDX-License-Identifier: BSD-3-Clause
#include "water_chunks.h"

#include "water_regions.h"

#include <stdbool.h>

// Of two cells: comparing the corners of larger ones, such as outlines of lakes, would take longer
// than what chunks save.
static const int64_t pairs_max = 1024;

// Has a cell a corner of another one? Unknown of large cells, which begin chunks of their own.
static bool shares_point(const int64_t* starts, const int64_t* corners, size_t cell, size_t other)
{
  const int64_t pairs = (starts[cell + 1] - starts[cell]) * (starts[other + 1] - starts[other]);
  for (int64_t i = pairs <= pairs_max ? starts[cell] : starts[cell + 1]; i < starts[cell + 1]; ++i)
  {
    for (int64_t j = starts[other]; j < starts[other + 1]; ++j)
    {
      if (corners[i] == corners[j])
      {
        return true;
      }
    }
  }
  return false;
}

size_t water_chunks_split(
  const int64_t* starts, const int64_t* corners, size_t cells, size_t most, int64_t* begins)
{
  size_t chunks = 0;
  size_t size = 0; // of the last one
  for (size_t cell = 0; cell < cells; ++cell)
  {
    if (size == 0 || size == most || !shares_point(starts, corners, cell, cell - 1))
    {
      if (begins)
      {
        begins[chunks] = (int64_t)cell;
      }
      ++chunks;
      size = 0;
    }
    ++size;
  }
  if (begins)
  {
    begins[chunks] = (int64_t)cells;
  }
  return chunks;
}

size_t water_chunks_link(const int64_t* starts, const int64_t* corners, const int64_t* begins,
  size_t chunks, int32_t* last, size_t points, int32_t* seen, water_chunk_link* links)
{
  size_t count = 0;
  for (size_t i = 0; i < points; ++i)
  {
    last[i] = -1;
  }
  for (size_t i = 0; i < chunks; ++i)
  {
    seen[i] = -1;
  }
  for (size_t chunk = 0; chunk < chunks; ++chunk)
  {
    const int32_t own = (int32_t)chunk;
    for (int64_t i = starts[begins[chunk]]; i < starts[begins[chunk + 1]]; ++i)
    {
      const int32_t other = last[corners[i]];
      last[corners[i]] = own;
      if (other < 0 || other == own || seen[other] == own)
      {
        continue;
      }
      seen[other] = own;
      if (links)
      {
        links[count].chunks[0] = other;
        links[count].chunks[1] = own;
      }
      ++count;
    }
  }
  return count;
}

size_t water_chunks_list(const int64_t* starts, const int64_t* corners, const int64_t* begins,
  size_t chunks, int32_t* last, size_t points, int32_t* ends, int32_t* listed)
{
  size_t count = 0;
  for (size_t i = 0; i < points; ++i)
  {
    last[i] = -1;
  }
  for (size_t chunk = 0; chunk < chunks; ++chunk)
  {
    ends[chunk] = (int32_t)count;
    for (int64_t i = starts[begins[chunk]]; i < starts[begins[chunk + 1]]; ++i)
    {
      const int64_t point = corners[i];
      if (last[point] == (int32_t)chunk)
      {
        continue;
      }
      last[point] = (int32_t)chunk;
      if (listed)
      {
        listed[count] = (int32_t)point;
      }
      ++count;
    }
  }
  ends[chunks] = (int32_t)count;
  return count;
}

int water_chunks_water(const double* depths, const int32_t* points, size_t count)
{
  size_t wet = 0;
  for (size_t i = 0; i < count; ++i)
  {
    wet += depths[points[i]] > 0.0 ? 1 : 0;
  }
  return wet == count ? 1 : (wet == 0 ? 0 : -1);
}

void water_chunks_judge(const int64_t* begins, size_t chunks, const water_chunk_link* links,
  size_t link_count, const char* cells, unsigned char* kinds)
{
  for (size_t i = 0; i < chunks; ++i)
  {
    int any = 0;
    int all = 0;
    for (int64_t cell = begins[i]; cell < begins[i + 1]; ++cell)
    {
      any |= cells[cell];
      all |= cells[cell] ^ 1;
    }
    kinds[i] = all == 0 ? WATER_CHUNK_INSIDE : (any ? WATER_CHUNK_PART : WATER_CHUNK_LAND);
  }
  for (size_t i = 0; i < link_count; ++i)
  {
    const int32_t* pair = links[i].chunks;
    for (int side = 0; side < 2; ++side)
    {
      if (kinds[pair[1 - side]] < WATER_CHUNK_RIM && kinds[pair[side]] == WATER_CHUNK_INSIDE)
      {
        kinds[pair[side]] = WATER_CHUNK_RIM;
      }
    }
  }
}

void water_chunks_join(const water_chunk_link* links, size_t link_count, const unsigned char* kinds,
  int64_t* parents, size_t points)
{
  for (size_t i = 0; i < link_count; ++i)
  {
    const int32_t* pair = links[i].chunks;
    if (kinds[pair[0]] == WATER_CHUNK_INSIDE || kinds[pair[1]] == WATER_CHUNK_INSIDE)
    {
      const int64_t nodes[2] = { (int64_t)points + pair[0], (int64_t)points + pair[1] };
      water_regions_join(parents, nodes, 2);
    }
  }
}
