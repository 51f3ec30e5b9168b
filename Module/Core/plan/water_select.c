// SPDX-License-Identifier: BSD-3-Clause
// water_select.c: side of the eye, is the water seen, reason of each prop.
#include "water_select.h"

#include "water_frustum.h"
#include "water_math.h"
#include "water_plane.h"

// Below this sine of the view direction against the plane, water as wide as 1e8 pixels is thinner
// than a tenth of a pixel: there is nothing to see.
static const double edge_on_sine = 1e-9;

// Over the distance of the near plane: how high over the plane an eye is taken to be that is on it.
static const double on_plane_height = 1e-4;

static const double whole_picture[4] = { -1.0, -1.0, 1.0, 1.0 };

// Rounding of a box against a plane: an offset and the products of a corner are sums of at most 8
// products, each off by half an epsilon for every sum and factor. 32 epsilons are more than all of
// that.
static const double box_rounding = 32.0 * DBL_EPSILON;

// The reason as far as the flags decide it; WATER_CULL_NONE: they do not mind.
static water_cull_reason reason_of_flags(uint32_t flags)
{
  if (flags == WATER_PROP_VISIBLE)
  {
    return WATER_CULL_NONE; // most of them
  }
  if (!(flags & WATER_PROP_VISIBLE))
  {
    return WATER_CULL_INVISIBLE;
  }
  if (flags & WATER_PROP_IS_WATER)
  {
    return WATER_CULL_WATER;
  }
  if (flags & WATER_PROP_NOT_REFLECTED)
  {
    return WATER_CULL_NOT_REFLECTED;
  }
  if (flags & WATER_PROP_OVERLAY)
  {
    return WATER_CULL_OVERLAY;
  }
  if (flags & WATER_PROP_LABEL)
  {
    return WATER_CULL_LABEL;
  }
  return flags & WATER_PROP_REFUSED ? WATER_CULL_REFUSED : WATER_CULL_NONE;
}

// How far an eye's height may be off.
//
// Rounding: the origin of the view went through two rotations (into the matrix and back), each
// component off by 3 roundings of its length at most, so by sqrt(3) * 3 together, twice; the unit
// normal and its rotation add 3 and 3 of the same, the sum of the height 4: less than 24
// roundings of all lengths.
static double height_rounding(const water_eye* eye, const water_plane* plane)
{
  const double* world = eye->view_to_world;
  const double origin[3] = { world[3], world[7], world[11] };
  return 24.0 * DBL_EPSILON *
    (fabs(plane->offset) + water_vec3_length(origin) + water_vec3_length(eye->center_view));
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
  const double height = water_vec3_dot(plane_view, eye->center_view) + plane_view[3];
  if (!(fabs(height) > height_rounding(eye, plane)))
  {
    return WATER_CAMERA_ON_PLANE;
  }
  *side = height > 0.0 ? WATER_ABOVE : WATER_BELOW;
  return WATER_OK;
}

void water_select_level(
  const water_eye* eye, const water_plane* plane, water_plane* level, water_side* side)
{
  *level = *plane;
  if (water_select_side(eye, plane, side) == WATER_OK)
  {
    return;
  }
  static const double middle[4] = { 0.0, 0.0, -1.0, 1.0 }; // of the near plane's picture
  double near_view[4];
  water_mat4_apply(eye->clip_to_view, middle, near_view);
  double arm[3];
  for (int i = 0; i < 3; ++i)
  {
    arm[i] = near_view[i] / near_view[3] - eye->center_view[i];
  }
  double plane_view[4];
  water_camera_plane_view(eye, plane, plane_view);
  const double height = water_vec3_dot(plane_view, eye->center_view) + plane_view[3];
  const double least = 1000.0 * height_rounding(eye, plane);
  const double raised = fmax(on_plane_height * water_vec3_length(arm), least);
  // the middle of the near plane may be farther away than numbers reach
  level->offset += (raised <= water_largest ? raised : least) - height;
  *side = WATER_ABOVE;
}

bool water_select_is_in_view(const water_camera* camera, const double bounds[6])
{
  water_frustum view;
  water_frustum_make(camera, whole_picture, &view);
  return water_frustum_meets(&view, 6, bounds, box_rounding);
}

// Is the picture of a box smaller than that many pixels, both ways?
static bool is_smaller(
  const double world_to_clip[16], const int texture_px[2], const double bounds[6], double px)
{
  double picture[4];
  return water_bounds_picture(world_to_clip, bounds, picture) &&
    0.5 * texture_px[0] * (picture[2] - picture[0]) < px &&
    0.5 * texture_px[1] * (picture[3] - picture[1]) < px;
}

// Points and lines have a width in pixels whatever their distance: half of it may reach into the
// pyramid. What is 2 pixels wide stays within the texels that are added for filtering.
static const float width_px_thin = 2.0f;

static water_cull_reason reason_of_wide_box(
  const water_camera* mirrored, const water_selection* selection, const water_prop* prop)
{
  const double* box = selection->box;
  const double reach_px = 0.5 * (double)prop->width_px + 1.0; // and what antialiasing adds
  const double x = 2.0 * reach_px / selection->texture_px[0];
  const double y = 2.0 * reach_px / selection->texture_px[1];
  const double widened[4] = { box[0] - x, box[1] - y, box[2] + x, box[3] + y };
  water_frustum pyramid;
  water_frustum_make(mirrored, widened, &pyramid);
  return water_frustum_meets(&pyramid, 5, prop->bounds, box_rounding) ? WATER_CULL_NONE
                                                                      : WATER_CULL_OUT_OF_WATER;
}

// The mirrored view and the part of it that the water looks up.
typedef struct frusta
{
  water_frustum view;
  water_frustum pyramid;
  bool is_side_of_view[5]; // of the pyramid's sides
} frusta;

static void make_frusta(const water_camera* mirrored, const double box[4], frusta* made)
{
  water_frustum_make(mirrored, whole_picture, &made->view);
  water_frustum_make(mirrored, box, &made->pyramid);
  for (int i = 0; i < 5; ++i)
  {
    made->is_side_of_view[i] =
      memcmp(made->view.planes[i], made->pyramid.planes[i], sizeof made->view.planes[i]) == 0;
  }
}

static water_cull_reason reason_of_box(const frusta* both, const double bounds[6])
{
  const int side = water_frustum_divides(&both->pyramid, 5, bounds, box_rounding);
  if (side < 0)
  {
    return WATER_CULL_NONE;
  }
  // the pyramid is a part of the view: what is behind the same side of both is out of both
  return both->is_side_of_view[side] ||
      water_frustum_is_behind(both->view.planes[side], bounds, both->view.reach, box_rounding)
    ? WATER_CULL_OUT_OF_VIEW
    : WATER_CULL_OUT_OF_WATER;
}

size_t water_select_props(const water_camera* mirrored, const water_plane* plane,
  const water_selection* selection, const water_prop* props, size_t prop_count,
  water_cull_reason* reasons)
{
  frusta both;
  make_frusta(mirrored, selection->box, &both);
  double world_to_clip[16];
  water_mat4_multiply(mirrored->view_to_clip, mirrored->world_to_view, world_to_clip);
  const double kept[4] = { plane->normal[0], plane->normal[1], plane->normal[2],
    plane->offset + selection->margin };
  const uint32_t ignored = selection->is_direct ? WATER_PROP_NOT_REFLECTED : 0;
  size_t bad_index = prop_count;
  for (size_t i = 0; i < prop_count; ++i)
  {
    const double* bounds = props[i].bounds;
    water_cull_reason reason = reason_of_flags(props[i].flags & ~ignored);
    if (reason != WATER_CULL_NONE || (props[i].flags & WATER_PROP_NO_BOUNDS))
    {
      reasons[i] = reason;
      continue;
    }
    if (!water_bounds_are_finite(bounds))
    {
      bad_index = bad_index < i ? bad_index : i;
    }
    else
    {
      if (water_bounds_is_empty(bounds))
      {
        reason = WATER_CULL_EMPTY;
      }
      else if (selection->is_off)
      {
        reason = WATER_CULL_NONE;
      }
      else if (water_frustum_is_behind(kept, bounds, 0.0, box_rounding))
      {
        reason = WATER_CULL_BEHIND_PLANE;
      }
      else
      {
        reason = props[i].width_px > width_px_thin
          ? reason_of_wide_box(mirrored, selection, props + i)
          : reason_of_box(&both, bounds);
        if (reason == WATER_CULL_NONE && selection->prop_px_min > 0.0 &&
          is_smaller(world_to_clip, selection->texture_px, bounds, selection->prop_px_min))
        {
          reason = WATER_CULL_TOO_SMALL;
        }
      }
    }
    reasons[i] = reason;
  }
  return bad_index;
}
