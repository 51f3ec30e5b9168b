// SPDX-License-Identifier: BSD-3-Clause
// fuzz_plan.c: any scene: the plan, and what is done with one.
#include "fuzz_scene.h"

#include "water_clusters.h"
#include "water_math.h"
#include "water_mirror.h"
#include "water_quality.h"
#include "water_volume_planes.h"

static void check_plan(
  const water_scene* scene, const water_plan* plan, const water_cull_reason* reasons)
{
  PROMISED((unsigned)plan->decision < WATER_DECISION_COUNT);
  PROMISED(water_decision_text(plan->decision) != NULL);
  if (plan->decision != WATER_REFLECT)
  {
    return;
  }
  for (size_t i = 0; i < scene->prop_count; ++i)
  {
    PROMISED((unsigned)reasons[i] < WATER_CULL_REASON_COUNT);
  }
  for (int i = 0; i < 2; ++i)
  {
    PROMISED(plan->texture_px[i] >= 1 && plan->texture_px[i] <= scene->max_texture_px);
    PROMISED(plan->texture_rect_px[i] >= 0 && plan->texture_rect_px[2 + i] >= 1);
    PROMISED(plan->texture_rect_px[i] + plan->texture_rect_px[2 + i] <= plan->texture_px[i]);
    PROMISED(plan->reflection_scale[i] > 0.0 && plan->reflection_scale[i] <= 1.0);
  }
  PROMISED(plan->depth_scale > 0.0 && plan->depth_scale <= 1.0);
  PROMISED(water_all_finite(plan->mirrored.world_to_view, 16));
  PROMISED(water_all_finite(plan->mirrored.view_to_clip, 16));
  double world_to_texture[16];
  water_mirror_texture_matrix(&plan->mirrored, world_to_texture);
  PROMISED(water_all_finite(world_to_texture, 16));
  PROMISED(water_all_finite(plan->clip_plane_window, 4));
}

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
  fuzz_input from = { bytes, size };
  water_prop props[FUZZ_PROPS];
  water_scene scene;
  fuzz_scene(&from, props, &scene);
  water_plan plan;
  water_plan again;
  water_cull_reason reasons[FUZZ_PROPS];
  memset(&plan, 0x55, sizeof plan);
  memset(&again, 0xaa, sizeof again);
  const water_status status = water_plan_make(&scene, &plan, reasons);
  PROMISED(status == water_plan_make(&scene, &again, reasons));
  PROMISED(memcmp(&plan, &again, sizeof plan) == 0);
  PROMISED((unsigned)status <= WATER_BAD_PROP_BOUNDS);
  PROMISED(status == WATER_OK || status == WATER_BAD_PROP_BOUNDS ||
    plan.decision == WATER_NO_REFLECT_FAILED);
  check_plan(&scene, &plan, reasons);

  water_roughness roughness;
  water_quality_roughness(&scene, &plan, fuzz_double(&from), &roughness);
  int step = (int)fuzz_byte(&from) - 128;
  if (water_quality_for_error(fuzz_double(&from), &roughness, &step) == WATER_OK)
  {
    PROMISED(step >= 0 && step < WATER_QUALITY_STEPS);
  }
  (void)water_plan_should_wait(&plan, fuzz_double(&from), scene.is_software, scene.settings.skips);
  if (plan.decision == WATER_REFLECT)
  {
    double model[16];
    water_clusters_view view;
    fuzz_doubles(&from, model, 16);
    const water_clusters_target target = { NULL, NULL, fuzz_byte(&from), fuzz_byte(&from) };
    double origin[3];
    fuzz_doubles(&from, origin, 3);
    const int band = (int)fuzz_byte(&from) % 4;
    water_clusters_view_make(&plan, &target, band, 4, true, model, origin, &view);
    for (size_t i = 0; i < scene.prop_count; ++i)
    {
      (void)water_frustum_divides(&view.frustum, 6, props[i].bounds, 1e-6);
      const water_box_place place = water_clusters_place(&view, props[i].bounds);
      PROMISED(place <= WATER_BOX_INSIDE);
      (void)water_clusters_is_kept(&view, props[i].bounds);
      (void)water_plan_cuts(&plan, props[i].bounds);
    }
    double sides[WATER_VOLUME_PLANES_COUNT][4];
    for (size_t i = 0; i < scene.prop_count; ++i)
    {
      if (water_volume_planes_make(&plan, props[i].bounds, model, sides) == WATER_OK)
      {
        fuzz_use(sides, sizeof sides);
      }
    }
  }
  scene.settings.skips = fuzz_byte(&from);
  const water_status next_status = water_plan_make(&scene, &again, reasons);
  (void)water_plan_wants_visibility(&plan, &again);
  water_plan_revise(&scene, &plan, fuzz_bool(&from), NULL, &again, reasons);
  PROMISED((unsigned)next_status < WATER_STATUS_COUNT);
  PROMISED((unsigned)again.decision < WATER_DECISION_COUNT);
  return 0;
}
