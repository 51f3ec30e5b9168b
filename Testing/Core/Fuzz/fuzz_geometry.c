// SPDX-License-Identifier: BSD-3-Clause
// fuzz_geometry.c: the steps of a plan one by one, with any numbers; grids and clusters of meshes.
#include "fuzz_scene.h"

#include "water_camera.h"
#include "water_clusters.h"
#include "water_frustum.h"
#include "water_grid.h"
#include "water_lookup.h"
#include "water_math.h"
#include "water_mirror.h"
#include "water_optics.h"
#include "water_plane.h"
#include "water_select.h"
#include "water_target.h"
#include "water_visibility.h"

enum
{
  POINTS = 64,
  TRIANGLES = 100,
  GRID = 16
};

static void fuzz_clusters(fuzz_input* from)
{
  float floats[3 * POINTS];
  double doubles[3 * POINTS];
  uint32_t indices[3 * TRIANGLES];
  uint32_t drawn[3 * TRIANGLES];
  double boxes[(TRIANGLES + WATER_CLUSTER_TRIANGLES - 1) / WATER_CLUSTER_TRIANGLES][6];
  const size_t triangle_count = fuzz_below(from, TRIANGLES + 1);
  for (int i = 0; i < 3 * POINTS; ++i)
  {
    doubles[i] = fuzz_double(from);
    floats[i] = (float)doubles[i];
  }
  for (size_t i = 0; i < 3 * triangle_count; ++i)
  {
    indices[i] = fuzz_byte(from) % (POINTS + 1); // one beyond
  }
  water_cluster_work work[sizeof boxes / sizeof boxes[0]];
  const water_mesh mesh = { { fuzz_bool(from) ? floats : NULL, doubles }, POINTS, indices,
    triangle_count, boxes };
  (void)water_clusters_count(triangle_count);
  if (!water_clusters_bound(&mesh))
  {
    return;
  }
  water_clusters_view view;
  water_trend trend;
  memset(&trend, 0, sizeof trend);
  fuzz_doubles(from, &view.frustum.planes[0][0], 24);
  view.frustum.reach = fuzz_double(from);
  water_frustum_prepare(&view.frustum);
  enum
  {
    DEPTHS = 16
  };
  float depths[DEPTHS * DEPTHS];
  water_triangle_cull_view* fine = &view.triangles;
  view.is_fine = fuzz_bool(from);
  fuzz_doubles(from, fine->origin, 3);
  fuzz_doubles(from, fine->to_clip, 16);
  fuzz_doubles(from, fine->kept, 4);
  fine->reach = fuzz_double(from);
  fine->grid_px = fuzz_bool(from) ? fuzz_double(from) : 1.0 / 256.0;
  for (int i = 0; i < 2; ++i)
  {
    fine->rect_px[i] = (int)fuzz_below(from, 64);
    fine->rect_px[2 + i] = 1 + (int)fuzz_below(from, DEPTHS);
    fine->texture_px[i] = fine->rect_px[i] + fine->rect_px[2 + i] + (int)fuzz_below(from, 64);
  }
  fine->has_samples = fuzz_bool(from);
  fine->is_solid = fuzz_bool(from);
  fine->seen = NULL;
  fine->depths = fuzz_bool(from) ? depths : NULL;
  water_triangle_cull_begin(fine->rect_px, NULL, depths);
  fine->columns[0] = (int)fuzz_below(from, (size_t)fine->rect_px[2]);
  fine->columns[1] = fine->rect_px[2];
  const bool is_reversed = fuzz_bool(from);
  water_clusters_mark(&view, &mesh, is_reversed, &trend, work);
  PROMISED(water_clusters_copy(&mesh, is_reversed, work, 1, drawn) <= 3 * triangle_count);
}

// Cells of a reflection texture of any size, and boxes anywhere.
static void fuzz_seen(fuzz_input* from)
{
  enum
  {
    SIDE = 64
  };
  uint8_t cells[SIDE * SIDE / 4];
  uint32_t counts[(SIDE / 2 + 1) * (SIDE / 2 + 1)];
  float boxes[SIDE * SIDE / 8 + SIDE][4];
  water_visibility seen;
  water_visibility_walk walk;
  water_prop prop = { { 0.0 }, WATER_PROP_VISIBLE, 0.0f };
  water_cull_reason reason = WATER_CULL_NONE;
  water_camera camera;
  int texture_px[2];
  int rect_px[4];
  int viewport_px[2];
  for (int i = 0; i < 2; ++i)
  {
    texture_px[i] = 1 + (int)fuzz_below(from, SIDE);
    viewport_px[i] = 1 + (int)fuzz_below(from, 4 * SIDE);
    rect_px[i] = (int)fuzz_below(from, (size_t)texture_px[i]);
    rect_px[2 + i] = 1 + (int)fuzz_below(from, (size_t)(texture_px[i] - rect_px[i]));
  }
  water_visibility_begin(texture_px, rect_px, &seen);
  seen.counts = counts;
  for (size_t i = 0; i < sizeof cells; ++i)
  {
    cells[i] = fuzz_byte(from);
  }
  water_visibility_sum(&seen, cells);
  const size_t room = (size_t)(seen.size[1] * (seen.size[0] + 1) / 2);
  PROMISED(water_visibility_closed(&seen, boxes) <= room);
  water_visibility_walk_of(
    texture_px, rect_px, viewport_px, 1 + (int)fuzz_below(from, SIDE), &walk);
  PROMISED(walk.size[0] > 0 && walk.size[1] > 0);
  fuzz_camera(from, &camera);
  fuzz_doubles(from, prop.bounds, 6);
  prop.width_px = (float)fuzz_double(from);
  water_visibility_cull(&seen, &camera, &prop, 1, WATER_MAY_SKIP_ALL, &reason);
}

static void fuzz_grid(fuzz_input* from)
{
  water_camera camera;
  water_plane plane;
  double origin[3];
  double sheet[4];
  water_grid_view view;
  fuzz_camera(from, &camera);
  for (int i = 0; i < 3; ++i)
  {
    plane.normal[i] = fuzz_near(from, i == 2 ? 1.0 : 0.0);
    origin[i] = fuzz_near(from, 0.0);
  }
  plane.offset = fuzz_near(from, 0.0);
  for (int i = 0; i < 4; ++i)
  {
    sheet[i] = fuzz_near(from, i % 2 ? 10.0 : -10.0);
  }
  if (water_grid_view_make(&camera, &plane, origin, &view) == WATER_OK)
  {
    double points[3 * (GRID + 1) * (GRID + 1)];
    float cells[2 * (GRID + 1) * (GRID + 1)];
    double row_dir[2];
    if (water_grid_lay(
          &view, sheet, fuzz_near(from, 0.1), fuzz_near(from, 0.1), GRID, points, cells, row_dir))
    {
      fuzz_use(points, sizeof points);
    }
  }
}

static void fuzz_plane(fuzz_input* from)
{
  water_plane plane;
  water_plane unit;
  double point[3];
  double bounds[6];
  double sheet[4];
  double corners[12];
  double x_dir[3];
  double y_dir[3];
  double matrix[16];
  fuzz_doubles(from, plane.normal, 3);
  plane.offset = fuzz_double(from);
  fuzz_doubles(from, point, 3);
  fuzz_doubles(from, bounds, 6);
  if (water_plane_normalise(&plane, &unit) != WATER_OK)
  {
    return;
  }
  const double length = hypot(hypot(unit.normal[0], unit.normal[1]), unit.normal[2]);
  PROMISED(fabs(length - 1.0) < 1e-14 && isfinite(unit.offset));
  (void)water_plane_height(&unit, point);
  water_plane_project(&unit, point, point);
  water_plane_mirror_matrix(&unit, matrix);
  water_plane_axes(unit.normal, x_dir, y_dir);
  PROMISED(
    fabs(water_vec3_dot(x_dir, y_dir)) < 1e-14 && fabs(water_vec3_dot(x_dir, x_dir) - 1.0) < 1e-14);
  if (water_sheet_bounds(point, x_dir, y_dir, bounds, sheet) == WATER_OK)
  {
    PROMISED(sheet[0] <= sheet[1] && sheet[2] <= sheet[3]);
    water_sheet_corners(point, x_dir, y_dir, sheet, corners);
  }
  double displaced[6];
  water_plane_displaced_bounds(&unit, bounds, fuzz_double(from), fuzz_double(from), displaced);
  water_axes axes;
  memcpy(axes.x_dir, x_dir, sizeof x_dir);
  memcpy(axes.y_dir, y_dir, sizeof y_dir);
  memcpy(axes.normal, unit.normal, sizeof axes.normal);
  memcpy(axes.origin, point, sizeof axes.origin);
  double dirs[2][3];
  double local[9];
  fuzz_doubles(from, &dirs[0][0], 6);
  (void)water_lookup_local(&axes, dirs[0], local);
  water_lookup_environment(&axes, dirs[0], dirs[1], local);
}

static void fuzz_steps(fuzz_input* from)
{
  water_camera camera;
  double matrix[16];
  double inverse[16];
  double four[4];
  double scale[2];
  int px[2] = { (int)fuzz_below(from, 5000) + 1, (int)fuzz_below(from, 5000) + 1 };
  int rect[4];
  fuzz_camera(from, &camera);
  fuzz_doubles(from, matrix, 16);
  (void)water_mat4_invert(matrix, inverse);
  (void)water_mat4_invert_affine(matrix, inverse);
  fuzz_doubles(from, four, 4);
  water_mirror_clip_window(four, px, matrix);
  water_target_reach(&camera, fuzz_double(from), four);
  scale[0] = fuzz_double(from);
  scale[1] = fuzz_double(from);
  water_target_rect(four, scale, px, rect);
  for (int i = 0; i < 2; ++i)
  {
    PROMISED(rect[i] >= 0 && rect[2 + i] >= 1 && rect[i] + rect[2 + i] <= px[i]);
  }
  water_rect_to_ndc(rect, px, four);
  const double band = water_target_guard_band(&camera, fuzz_double(from));
  const double bands[2] = { fmax(band, fuzz_double(from)), band };
  water_target_widen(bands, 16384, px, scale);
  PROMISED(px[0] <= 16384 && px[1] <= 16384);
  const double eta = fuzz_double(from);
  const double cosine = fuzz_double(from);
  if (eta >= 1e-3 && eta <= 1e3) // of any two media
  {
    const double reflectance = water_optics_fresnel(cosine, eta);
    PROMISED(reflectance >= 0.0 && reflectance <= 1.0);
    const double schlick = water_optics_schlick(cosine, eta);
    PROMISED(schlick >= 0.0 && schlick <= 1.0);
    const double critical = water_optics_critical_rad(eta);
    PROMISED(critical >= 0.0 && critical < 1.6);
  }
  water_look look = { fuzz_double(from), fuzz_double(from), fuzz_bool(from) };
  water_look all = { fuzz_double(from), fuzz_double(from), fuzz_bool(from) };
  if (water_optics_check(&look) == WATER_OK && water_optics_check(&all) == WATER_OK)
  {
    water_optics_join(&look, &all);
    PROMISED(water_optics_check(&all) == WATER_OK);
  }
}

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
  fuzz_input from = { bytes, size };
  static void (*const parts[])(
    fuzz_input*) = { fuzz_clusters, fuzz_grid, fuzz_plane, fuzz_steps, fuzz_seen };
  parts[fuzz_byte(&from) % 5](&from);
  return 0;
}
