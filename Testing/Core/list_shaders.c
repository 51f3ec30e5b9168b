// SPDX-License-Identifier: BSD-3-Clause
// list_shaders.c: what the lists of water_features.h amount to, for scripts.
//
//   list_shaders files  a line for each shader of a surface: its stage, its features in
//   hexadecimal,
//                       its files in order
//   list_shaders triples  of these lines, enough to have every three files that any shader brings
//                       together: a file does not compile for itself, for what another one lacks,
//                       or, rarely, for what two others lack
//   list_shaders table  features, slots and files as Markdown, for Documentation/architecture.md
#include "shader_combinations.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

typedef struct shader_file
{
  const char* slot;
  const char* name;
  water_feature_set any_of;
  water_feature_set none_of;
  const char* what;
} shader_file;

#define SHADER_FILE(slot, file, any_of, none_of, what) { #slot, #file, any_of, none_of, what },
static const shader_file surface_files[] = { WATER_SURFACE_FILE_LIST(SHADER_FILE) };
static const shader_file photon_files[] = { WATER_PHOTON_FILE_LIST(SHADER_FILE) };
static const shader_file buffer_files[] = { WATER_BUFFER_FILE_LIST(SHADER_FILE) };
static const shader_file vertex_files[] = { WATER_VERTEX_FILE_LIST(SHADER_FILE) };

enum
{
  SURFACE_FILE_COUNT = sizeof surface_files / sizeof surface_files[0],
  PHOTON_FILE_COUNT = sizeof photon_files / sizeof photon_files[0],
  BUFFER_FILE_COUNT = sizeof buffer_files / sizeof buffer_files[0],
  VERTEX_FILE_COUNT = sizeof vertex_files / sizeof vertex_files[0]
};

#define FEATURE_NAME(name, what) #name,
#define FEATURE_WHAT(name, what) what,
static const char* const names[] = { WATER_FEATURE_LIST(FEATURE_NAME) };
static const char* const meanings[] = { WATER_FEATURE_LIST(FEATURE_WHAT) };

static void print_files(
  const char* stage, water_feature_set features, const shader_file* files, size_t file_count)
{
  printf("%s %04" PRIx64, stage, features);
  for (size_t i = 0; i < file_count; ++i)
  {
    if (water_features_want(features, files[i].any_of, files[i].none_of))
    {
      printf(" %s", files[i].name);
    }
  }
  printf("\n");
}

// Does a shader bring three files together that none before it did? Remembers that they are.
static bool is_news(water_feature_set features)
{
  static bool seen[SURFACE_FILE_COUNT][SURFACE_FILE_COUNT][SURFACE_FILE_COUNT];
  size_t files[SURFACE_FILE_COUNT];
  size_t count = 0;
  for (size_t i = 0; i < SURFACE_FILE_COUNT; ++i)
  {
    if (water_features_want(features, surface_files[i].any_of, surface_files[i].none_of))
    {
      files[count++] = i;
    }
  }
  bool is_new = false;
  for (size_t i = 0; i < count; ++i)
  {
    for (size_t j = i + 1; j < count; ++j)
    {
      for (size_t k = j + 1; k < count; ++k)
      {
        bool* place = &seen[files[i]][files[j]][files[k]];
        is_new |= !*place;
        *place = true;
      }
    }
  }
  return is_new;
}

// In any order: each shader then differs in much from those before it, and fewer are enough.
static void shuffle(water_feature_set* sets, size_t count)
{
  uint32_t state = 1;
  for (size_t i = count; i > 1; --i)
  {
    state = 1664525u * state + 1013904223u; // Numerical Recipes, 2nd edition, section 7.1
    const size_t other = (size_t)((uint64_t)state * i >> 32);
    const water_feature_set set = sets[i - 1];
    sets[i - 1] = sets[other];
    sets[other] = set;
  }
}

static void print_shaders(bool all)
{
  static water_feature_set sets[SHADER_SET_COUNT];
  const size_t count = shader_combinations(sets);
  if (!all)
  {
    shuffle(sets, count);
  }
  for (size_t i = 0; i < count; ++i)
  {
    if (all || is_news(sets[i]))
    {
      print_files("frag", sets[i], surface_files, SURFACE_FILE_COUNT);
    }
  }
  for (unsigned i = 0; i < 4; ++i)
  {
    const water_feature_set features =
      (i & 1u ? WATER_FEATURE_SEA : 0) | (i & 2u ? WATER_FEATURE_NORMAL_MAPS : 0);
    print_files("frag", features | WATER_FEATURE_CAUSTICS, photon_files, PHOTON_FILE_COUNT);
  }
  print_files("frag", WATER_FEATURE_BUFFERED, buffer_files, BUFFER_FILE_COUNT);
  print_files(
    "frag", WATER_FEATURE_BUFFERED | WATER_FEATURE_SLOPED, buffer_files, BUFFER_FILE_COUNT);
  const water_feature_set vertex_sets[] = { WATER_FEATURE_DISPLACED,
    WATER_FEATURE_DISPLACED | WATER_FEATURE_SEA_MOVES, WATER_FEATURE_MESH,
    WATER_FEATURE_MESH | WATER_FEATURE_SLOPED, WATER_FEATURE_MESH | WATER_FEATURE_FLOW,
    WATER_FEATURE_MESH | WATER_FEATURE_MATTER, WATER_FEATURE_MESH | WATER_FEATURE_FOAM_DATA,
    WATER_FEATURE_MESH | WATER_FEATURE_SHORE };
  for (size_t i = 0; i < sizeof vertex_sets / sizeof vertex_sets[0]; ++i)
  {
    print_files("vert", vertex_sets[i], vertex_files, VERTEX_FILE_COUNT);
  }
}

static void print_names(water_feature_set features, const char* between)
{
  const char* before = "";
  for (size_t i = 0; i < WATER_FEATURE_COUNT; ++i)
  {
    if (features >> i & 1u)
    {
      printf("%s`%s`", before, names[i]);
      before = between;
    }
  }
}

static void print_condition(const shader_file* file)
{
  print_names(file->any_of, " or ");
  if (file->none_of)
  {
    printf(file->any_of ? ", not " : "not ");
    print_names(file->none_of, " nor ");
  }
  if (!file->any_of && !file->none_of)
  {
    printf("always");
  }
}

static void print_table(const shader_file* files, size_t file_count)
{
  printf("| slot | file | when | what |\n|---|---|---|---|\n");
  for (size_t i = 0; i < file_count; ++i)
  {
    const bool is_next = i > 0 && strcmp(files[i].slot, files[i - 1].slot) == 0;
    printf("| %s | `%s` | ", is_next ? "" : files[i].slot, files[i].name);
    print_condition(files + i);
    printf(" | %s |\n", files[i].what);
  }
}

int main(int argc, char** argv)
{
  const bool all = argc == 2 && strcmp(argv[1], "files") == 0;
  if (all || (argc == 2 && strcmp(argv[1], "triples") == 0))
  {
    print_shaders(all);
    return 0;
  }
  if (argc == 2 && strcmp(argv[1], "table") == 0)
  {
    printf("| feature | what |\n|---|---|\n");
    for (size_t i = 0; i < WATER_FEATURE_COUNT; ++i)
    {
      printf("| `%s` | %s |\n", names[i], meanings[i]);
    }
    printf("\nFragment shader:\n\n");
    print_table(surface_files, SURFACE_FILE_COUNT);
    printf("\nFragment shader that follows light from the surface to the bed, for caustics:\n\n");
    print_table(photon_files, PHOTON_FILE_COUNT);
    printf("\nFragment shader with which a user's mesh writes its surface into a buffer:\n\n");
    print_table(buffer_files, BUFFER_FILE_COUNT);
    printf("\nVertex shader of a surface that waves displace, or of a user's mesh:\n\n");
    print_table(vertex_files, VERTEX_FILE_COUNT);
    return 0;
  }
  fprintf(stderr, "usage: list_shaders files|triples|table\n");
  return 2;
}
