// SPDX-License-Identifier: BSD-3-Clause
// consumer.c: plans the reflection of a box, in C, without VTK.
#include <water_plan.h>

#include <stdio.h>

int main(void)
{
  // An eye 2 above the water z = 0, looking straight down with an opening angle of 90 degrees.
  const water_prop box = { { -1.0, 1.0, -1.0, 1.0, 0.5, 1.0 }, WATER_PROP_VISIBLE };
  const water_scene scene = {
    .eye = { .world_to_view = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -2, 0, 0, 0, 1 },
      .view_to_clip = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.2, -2.2, 0, 0, -1, 0 } },
    .viewport_px = { 400, 300 },
    .plane = { .normal = { 0.0, 0.0, 1.0 }, .offset = 0.0 },
    .surface_bounds = { -5.0, 5.0, -5.0, 5.0, 0.0, 0.0 },
    .props = &box,
    .prop_count = 1,
    .look = { .index_of_refraction = 1.333 },
    .settings = { .texture_scale = 1.0 },
    .max_texture_px = 4096,
  };
  water_plan plan;
  water_cull_reason fate = WATER_CULL_REASON_COUNT;
  const water_status status = water_plan_make(&scene, &plan, &fate);
  if (status != WATER_OK)
  {
    printf("plan failed: %s\n", water_status_text(status));
    return 1;
  }
  printf("plan: %s, box %s, texture %d x %d\n", water_decision_text(plan.decision),
    water_cull_reason_text(fate), plan.texture_px[0], plan.texture_px[1]);
  return 0;
}
