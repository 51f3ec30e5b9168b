// SPDX-License-Identifier: BSD-3-Clause
// water_select.c: step 3: side of the eye, is the water seen, fate of each prop.
#include "water_select.h"

#include "water_math.h"
#include "water_plane.h"

// Below this sine of the view direction against the plane, water as wide as 1e8 pixels is thinner
// than a tenth of a pixel: there is nothing to see.
static const double edge_on_sine = 1e-9;

// Half-spaces of a frustum in world, dot(plane, (x, 1)) >= 0 inside, and how far they may be off.
typedef struct frustum
{
  double planes[6][4];
  double reach; // the length of the numbers that were summed and cancelled to the planes' offsets
} frustum;

static void frustum_make(const water_camera* camera, frustum* made)
{
  double world_to_clip[16];
  water_mat4_multiply(camera->view_to_clip, camera->world_to_view, world_to_clip);
  // -w <= x, y, z <= w: rows of the matrix (Gribb and Hartmann 2001, "Fast Extraction of Viewing
  // Frustum Planes from the World-View-Projection Matrix")
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int j = 0; j < 4; ++j)
    {
      made->planes[2 * axis][j] = world_to_clip[12 + j] + world_to_clip[4 * axis + j];
      made->planes[2 * axis + 1][j] = world_to_clip[12 + j] - world_to_clip[4 * axis + j];
    }
  }
  const double* view = camera->world_to_view;
  const double origin[3] = { view[3], view[7], view[11] };
  made->reach = water_vec3_length(origin);
}

// Whether a box lies wholly on the negative side of a plane, and by more than rounding.
//
// Rounding: an offset and the products of a corner are sums of at most 8 products, each off by half
// an epsilon for every sum and factor, of numbers no larger than |normal| * (corner + reach). 32
// epsilons are more than all of that. A sum that overflows is not below anything: kept.
// The larger of two by a comparison and not by fmax, which is a call: NaN must do something else
// there. Bounds have none, and a plane that has any makes sums that are not below anything.
static bool is_behind(const double plane[4], const double bounds[6], double reach)
{
  double highest = plane[3];
  for (int i = 0; i < 3; ++i)
  {
    const double low = plane[i] * bounds[2 * i];
    const double high = plane[i] * bounds[2 * i + 1];
    highest += low > high ? low : high;
  }
  if (!(highest < 0.0))
  {
    return false; // most boxes: no need to know how far it may be off
  }
  double size = fabs(plane[3]);
  for (int i = 0; i < 3; ++i)
  {
    const double low = fabs(bounds[2 * i]);
    const double high = fabs(bounds[2 * i + 1]);
    size += fabs(plane[i]) * (low > high ? low : high) + fabs(plane[i]) * reach;
  }
  return highest < -32.0 * DBL_EPSILON * size;
}

// plane_count  6, or 5 without the far plane, which is the last
static bool is_in_frustum(const frustum* view, int plane_count, const double bounds[6])
{
  for (int i = 0; i < plane_count; ++i)
  {
    if (is_behind(view->planes[i], bounds, view->reach))
    {
      return false;
    }
  }
  return true;
}

// The fate as far as the flags decide it; WATER_DRAW: they do not mind.
static water_fate fate_of_flags(uint32_t flags)
{
  if (!(flags & WATER_PROP_VISIBLE))
  {
    return WATER_SKIP_INVISIBLE;
  }
  if (flags & WATER_PROP_IS_WATER)
  {
    return WATER_SKIP_WATER;
  }
  if (flags & WATER_PROP_NOT_REFLECTED)
  {
    return WATER_SKIP_NOT_REFLECTED;
  }
  if (flags & WATER_PROP_OVERLAY)
  {
    return WATER_SKIP_OVERLAY;
  }
  return flags & WATER_PROP_LABEL ? WATER_SKIP_LABEL : WATER_DRAW;
}

water_status water_select_side(const water_eye* eye, const water_plane* plane, water_side* side)
{
  double plane_view[4];
  water_camera_plane_view(eye, plane, plane_view);
  if (!eye->has_center)
  {
    const double dir[3] = { eye->ndc_to_dir[2], eye->ndc_to_dir[5], eye->ndc_to_dir[8] };
    const double sine = water_vec3_dot(plane_view, dir);
    *side = sine < -edge_on_sine ? WATER_ABOVE : sine > edge_on_sine ? WATER_BELOW : WATER_EDGE_ON;
    return WATER_OK;
  }
  const double* world = eye->view_to_world;
  const double origin[3] = { world[3], world[7], world[11] };
  const double height = water_vec3_dot(plane_view, eye->center_view) + plane_view[3];
  // Rounding: the origin of the view went through two rotations (into the matrix and back), each
  // component off by 3 roundings of its length at most, so by sqrt(3) * 3 together, twice; the unit
  // normal and its rotation add 3 and 3 of the same, the sum of the height 4: less than 24
  // roundings of all lengths.
  const double bound = 24.0 * DBL_EPSILON *
    (fabs(plane->offset) + water_vec3_length(origin) + water_vec3_length(eye->center_view));
  if (!(fabs(height) > bound))
  {
    return WATER_CAMERA_ON_PLANE;
  }
  *side = height > 0.0 ? WATER_ABOVE : WATER_BELOW;
  return WATER_OK;
}

bool water_select_is_in_view(const water_camera* camera, const double bounds[6])
{
  frustum view;
  frustum_make(camera, &view);
  return is_in_frustum(&view, 6, bounds);
}

water_status water_select_check(const water_prop* props, size_t prop_count, size_t* culprit)
{
  for (size_t i = 0; i < prop_count; ++i)
  {
    const uint32_t flags = props[i].flags;
    if (fate_of_flags(flags) == WATER_DRAW && !(flags & WATER_PROP_NO_BOUNDS) &&
      !water_all_finite(props[i].bounds, 6))
    {
      *culprit = i;
      return WATER_BAD_PROP_BOUNDS;
    }
  }
  return WATER_OK;
}

void water_select_props(const water_camera* mirrored, const water_plane* plane, double margin,
  const water_prop* props, size_t prop_count, water_fate* fates)
{
  frustum view;
  frustum_make(mirrored, &view);
  const double kept[4] = { plane->normal[0], plane->normal[1], plane->normal[2],
    plane->offset + margin };
  for (size_t i = 0; i < prop_count; ++i)
  {
    const double* bounds = props[i].bounds;
    water_fate fate = fate_of_flags(props[i].flags);
    if (fate == WATER_DRAW && !(props[i].flags & WATER_PROP_NO_BOUNDS))
    {
      if (water_bounds_is_empty(bounds))
      {
        fate = WATER_SKIP_EMPTY;
      }
      else if (is_behind(kept, bounds, 0.0))
      {
        fate = WATER_SKIP_BEHIND_PLANE;
      }
      else if (!is_in_frustum(&view, 5, bounds))
      {
        fate = WATER_SKIP_OUT_OF_VIEW;
      }
    }
    fates[i] = fate;
  }
}
