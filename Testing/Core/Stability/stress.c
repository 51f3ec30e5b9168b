// SPDX-License-Identifier: BSD-3-Clause
// stress.c: generated cases against what must hold in all of them.
//
//   water_core_stress [--cases COUNT] [--seed SEED] [--first NUMBER] [--table FILE]
//
// COUNT cases (100000) from case NUMBER (0) of the seed (1) on; the same seed and number make the
// same case everywhere. FILE gets the errors by condition. Exit status 1: something did not hold.
#include "properties.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

static void run_case(stress_record* record)
{
  static stress_case of;
  case_make(record->seed, record->number, &of);
  stress_plane(&of, record);
  stress_optics(&of, record);

  water_plan plan;
  water_plan again;
  water_cull_reason reasons[CASE_PROPS];
  water_cull_reason fates_again[CASE_PROPS];
  memset(&plan, 0x55, sizeof plan);
  memset(&again, 0xaa, sizeof again);
  memset(reasons, 0, sizeof reasons);
  memset(fates_again, 0, sizeof fates_again);
  const water_status status = water_plan_make(&of.scene, &plan, reasons);
  const water_scene copy = of.scene;
  const water_status status_again = water_plan_make(&copy, &again, fates_again);
  const bool is_same = status == status_again && memcmp(&plan, &again, sizeof plan) == 0 &&
    memcmp(reasons, fates_again, sizeof reasons) == 0;
  stress_keep(record, SAME_PLAN, 1.0, is_same ? 0.0 : 1.0, 0.0);

  stress_decision(&of, &plan, status, record);
  if (status == WATER_OK && plan.decision == WATER_REFLECT && !stress_is_on_plane(&of))
  {
    stress_picture(&of, &plan, record);
    stress_clip(&of, &plan, record);
    stress_props(&of, &plan, reasons, record);
  }
}

int main(int argc, char** argv)
{
  static stress_record record;
  uint64_t count = 100000;
  const char* table = NULL;
  record.seed = 1;
  for (int i = 1; i + 1 < argc; i += 2)
  {
    if (strcmp(argv[i], "--cases") == 0)
    {
      count = strtoull(argv[i + 1], NULL, 10);
    }
    else if (strcmp(argv[i], "--seed") == 0)
    {
      record.seed = strtoull(argv[i + 1], NULL, 10);
    }
    else if (strcmp(argv[i], "--first") == 0)
    {
      record.number = strtoull(argv[i + 1], NULL, 10);
    }
    else if (strcmp(argv[i], "--table") == 0)
    {
      table = argv[i + 1];
    }
    else
    {
      fprintf(stderr, "%s: unknown\n", argv[i]);
      return 2;
    }
  }
  printf("seed %" PRIu64 ", cases %" PRIu64 " to %" PRIu64 "\n", record.seed, record.number,
    record.number + count - 1);
  for (uint64_t done = 0; done < count; ++done)
  {
    run_case(&record);
    ++record.number;
  }
  stress_print(&record);
  printf("%" PRIu64 " failures\n", record.failure_count);
  if (table != NULL)
  {
    FILE* file = fopen(table, "w");
    if (file == NULL)
    {
      perror(table);
      return 2;
    }
    stress_write(&record, file);
    fclose(file);
  }
  return record.failure_count == 0 ? 0 : 1;
}
