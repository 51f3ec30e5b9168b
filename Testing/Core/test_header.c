// SPDX-License-Identifier: BSD-3-Clause
// test_header.c: the core's headers compile as plain C, on their own, in any order, twice.
#include "water_medium.h"

#include "water_glitter.h"

#include "water_flatness.h"
#include "water_grid.h"
#include "water_placement.h"

#include "water_volume_planes.h"

#include "water_lookup.h"

#include "water_normals.h"

#include "water_phase.h"

#include "water_clusters.h"

#include "water_preset.h"

#include "water_features.h"
#include "water_quality.h"
#include "water_share.h"

#include "water_random.h"

#include "water_spectrum.h"

#include "water_fft.h"
#include "water_tile.h"
#include "water_tile_time.h"
#include "water_triangle_cull.h"
#include "water_turns.h"

#include "water_waves.h"

#include "water_frustum.h"

#include "water_target.h"

#include "water_secondary.h"

#include "water_select.h"

#include "water_optics.h"

#include "water_mirror.h"

#include "water_camera.h"
#include "water_cascade.h"

#include "water_math.h"

#include "water_plan_draw.h"
#include "water_plane.h"

#include "water_plan.h"

#include "water_status.h"
#include "water_types.h"

#include "water_old_foam.h"
#include "water_plan.h"
#include "water_whitecap.h"

_Static_assert(WATER_OK == 0, "success is 0 in every language");
_Static_assert(WATER_NOT_PLANNED == 0, "a zeroed plan says that nothing was planned");

// A scene of zeros has no plane: the header's promise, reached from C.
int main(void)
{
  const water_scene scene = { 0 };
  water_plan plan;
  return water_plan_make(&scene, &plan, NULL) == WATER_BAD_PLANE ? 0 : 1;
}
