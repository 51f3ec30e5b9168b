// SPDX-License-Identifier: BSD-3-Clause
// water_target.c: size of the reflection texture, and the part of it the water can look up.
#include "water_target.h"

#include "water_math.h"
#include "water_plane.h"

// Filtering reads one texel beside the point looked up; the other covers the rounding of the GPU.
static const double pad_px = 2.0;

static const double right_angle = 1.57079632679489662;

water_status water_target_size(
  const int viewport_px[2], double texture_scale, int max_texture_px, int texture_px[2])
{
  if (viewport_px[0] < 1 || viewport_px[1] < 1)
  {
    return WATER_BAD_VIEWPORT;
  }
  if (!isfinite(texture_scale) || texture_scale <= 0.0)
  {
    return WATER_BAD_TEXTURE_SCALE;
  }
  // compared as doubles: a large scale does not fit an int
  const double width = fmax(1.0, round(viewport_px[0] * texture_scale));
  const double height = fmax(1.0, round(viewport_px[1] * texture_scale));
  if (fmax(width, height) > max_texture_px)
  {
    return WATER_TEXTURE_TOO_LARGE;
  }
  texture_px[0] = (int)width;
  texture_px[1] = (int)height;
  return WATER_OK;
}

double water_target_fine_scale(const int viewport_px[2], double texture_scale, int max_texture_px)
{
  const double fine = 2.0 * texture_scale;
  int texture_px[2];
  return water_target_size(viewport_px, fine, max_texture_px, texture_px) == WATER_OK
    ? fine
    : texture_scale;
}

typedef struct rectangle // in NDC of the eye
{
  double low[2];
  double high[2];
  bool has_picture; // false once a point had no place in the picture
} rectangle;

static void rectangle_add(rectangle* covered, const double clip[4])
{
  for (int i = 0; i < 2; ++i)
  {
    const double ndc = clip[i] / clip[3];
    if (!(clip[3] > 0.0) || !isfinite(ndc))
    {
      covered->has_picture = false;
      return;
    }
    covered->low[i] = fmin(covered->low[i], ndc);
    covered->high[i] = fmax(covered->high[i], ndc);
  }
}

typedef struct surface_point
{
  double clip[4];     // in clip space of the eye
  double mirrored[4]; // of its mirror image
} surface_point;

static void surface_point_add(const surface_point* point, rectangle* covered)
{
  rectangle_add(covered, point->clip);
  rectangle_add(covered, point->mirrored);
}

void water_target_box(
  const water_camera* eye, const water_plane* plane, const double surface_bounds[6], double box[4])
{
  surface_point points[8];
  double in_front[8]; // distance from the near plane, in clip space: z + w
  rectangle covered = { { DBL_MAX, DBL_MAX }, { -DBL_MAX, -DBL_MAX }, true };
  for (int number = 0; number < 8; ++number)
  {
    double corner[3];
    double view[4];
    water_bounds_corner(surface_bounds, number, corner);
    water_mat4_apply_point(eye->world_to_view, corner, view);
    water_mat4_apply(eye->view_to_clip, view, points[number].clip);
    const double twice = 2.0 * water_plane_height(plane, corner);
    for (int i = 0; i < 3; ++i)
    {
      corner[i] -= twice * plane->normal[i];
    }
    water_mat4_apply_point(eye->world_to_view, corner, view);
    water_mat4_apply(eye->view_to_clip, view, points[number].mirrored);
    in_front[number] = points[number].clip[2] + points[number].clip[3];
    if (!(in_front[number] < 0.0))
    {
      surface_point_add(&points[number], &covered);
    }
  }
  // The eye sees only what lies in front of its near plane: cut the box there. The mirror image of
  // the cut box is the box of the mirrored corners, as mirroring is linear.
  for (int number = 0; number < 8; ++number)
  {
    for (int bit = 1; bit < 8; bit *= 2)
    {
      const int other = number | bit;
      if (other == number || (in_front[number] < 0.0) == (in_front[other] < 0.0))
      {
        continue;
      }
      const double part = in_front[number] / (in_front[number] - in_front[other]);
      surface_point cut;
      for (int i = 0; i < 4; ++i)
      {
        cut.clip[i] = (1.0 - part) * points[number].clip[i] + part * points[other].clip[i];
        cut.mirrored[i] =
          (1.0 - part) * points[number].mirrored[i] + part * points[other].mirrored[i];
      }
      surface_point_add(&cut, &covered);
    }
  }
  for (int i = 0; i < 2; ++i)
  {
    box[i] = covered.has_picture ? fmin(fmax(covered.low[i], -1.0), 1.0) : -1.0;
    box[2 + i] = covered.has_picture ? fmin(fmax(covered.high[i], -1.0), 1.0) : 1.0;
  }
}

void water_target_reach(const water_camera* eye, double slope_max, double box[4])
{
  const double* clip = eye->view_to_clip;
  double turned = (double)INFINITY;
  if (clip[14] != 0.0)
  {
    // the steepest view ray of the picture, as a slope against the view axis
    double steepest = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double x = (corner & 1 ? 1.0 : -1.0) + clip[2];
      const double y = (corner & 2 ? 1.0 : -1.0) + clip[6];
      steepest = fmax(steepest, hypot(x / clip[0], y / clip[5]));
    }
    // a normal turned by an angle turns the reflected ray by twice that
    const double angle = atan(steepest) + 2.0 * atan(slope_max);
    turned = angle < right_angle ? tan(angle) - steepest : (double)INFINITY;
  }
  for (int i = 0; i < 2; ++i)
  {
    const double widened = turned * fabs(clip[5 * i]);
    box[i] -= slope_max > 0.0 ? widened : 0.0;
    box[2 + i] += slope_max > 0.0 ? widened : 0.0;
  }
}

static int clamp_px(double value, int size)
{
  return (int)fmin(fmax(value, 0.0), (double)size);
}

void water_target_rect(
  const double box[4], const double reflection_scale[2], const int texture_px[2], int rect_px[4])
{
  const double flipped[4] = { -box[2], box[1], -box[0], box[3] };
  water_target_rect_of_eye(flipped, reflection_scale, texture_px, rect_px);
}

void water_target_rect_of_eye(
  const double box[4], const double reflection_scale[2], const int texture_px[2], int rect_px[4])
{
  for (int i = 0; i < 2; ++i)
  {
    const int size = texture_px[i];
    const double low = reflection_scale[i] * box[i];
    const double high = reflection_scale[i] * box[2 + i];
    int first = clamp_px(floor((0.5 + 0.5 * low) * size) - pad_px, size);
    int end = clamp_px(ceil((0.5 + 0.5 * high) * size) + pad_px, size);
    first = first < size ? first : size - 1;
    end = end > first ? end : first + 1;
    rect_px[i] = first;
    rect_px[2 + i] = end - first;
  }
}

double water_target_guard_band(const water_camera* camera, double slope_rms)
{
  const double* clip = camera->view_to_clip;
  if (clip[14] == 0.0)
  {
    return 1.0;
  }
  // a turn by an angle moves a pixel by it times the projection's scale
  const double turn = 2.0 * slope_rms * fmax(fabs(clip[0]), fabs(clip[5]));
  return fmin(fmax(1.0 + turn, 1.0), 1.25);
}

void water_target_tile_bands(double guard_band, const int tile_scale[2], double bands[2])
{
  for (int i = 0; i < 2; ++i)
  {
    bands[i] = 1.0 + fmax((double)tile_scale[i], 1.0) * (guard_band - 1.0);
  }
}

water_camera water_target_whole(const water_camera* tile, const int tile_scale[2])
{
  water_camera whole = *tile;
  for (int i = 0; i < 2; ++i)
  {
    whole.view_to_clip[5 * i] /= fmax((double)tile_scale[i], 1.0);
  }
  return whole;
}

void water_target_widen(
  const double guard_band[2], int max_texture_px, int texture_px[2], double reflection_scale[2])
{
  for (int i = 0; i < 2; ++i)
  {
    const int inner = texture_px[i];
    const double wanted = ceil(0.5 * fmax(guard_band[i] - 1.0, 0.0) * inner);
    const int most = (max_texture_px - inner) / 2;
    const int margin = wanted < (double)most ? (int)wanted : most;
    texture_px[i] = inner + 2 * margin;
    reflection_scale[i] = (double)inner / texture_px[i];
  }
}
