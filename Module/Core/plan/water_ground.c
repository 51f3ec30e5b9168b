// SPDX-License-Identifier: BSD-3-Clause
// water_ground.c: has a scene ground under all of its water?
#include "water_ground.h"

#include "water_math.h"

static const double wide = 0.75;  // share of the scene's area that a bed covers
static const double near = 0.04;  // of the scene's diagonal
static const double steep = 0.15; // of the same: so far apart the points of one surface may lie
static const double world_origin[3] = { 0.0, 0.0, 0.0 };
static const int enough = 13;    // places that have a surface
static const double tall = 0.5;  // of its shorter side: so high a block with a flat top is a column
static const double flat = 0.05; // of its height: by so little a flat top differs
static const double even = 0.1;  // of the depth: by so little a flat bed differs
static const double mostly = 0.75; // share of a flat bed that does not differ
static const int few = 16;         // cells tell nothing
static const int gap = 6; // so many lines of cells may lie between the points of one surface

_Static_assert(
  (int)WATER_BLOCKS_CELLS == (int)WATER_GROUND_CELLS, "blocks are of the cells of the ground");

water_status water_ground_begin(
  const water_plane* plane, const double bounds[6], water_ground* ground)
{
  memset(ground, 0, sizeof *ground);
  for (int i = 0; i < WATER_GROUND_PLACES; ++i)
  {
    ground->spread[i] = (double)INFINITY;
  }
  for (int i = 0; i < WATER_GROUND_CELLS * WATER_GROUND_CELLS; ++i)
  {
    ground->cell_low[i / WATER_GROUND_CELLS][i % WATER_GROUND_CELLS] = (double)INFINITY;
  }
  for (int i = 0; i < WATER_RELIEF_CORNERS * WATER_RELIEF_CORNERS; ++i)
  {
    ground->corner_low[i / WATER_RELIEF_CORNERS][i % WATER_RELIEF_CORNERS] = (double)INFINITY;
  }
  ground->block_from = (double)INFINITY;
  ground->bed_top = (double)INFINITY;
  water_plane unit;
  water_status status = water_plane_normalise(plane, &unit);
  if (status == WATER_OK)
  {
    memcpy(ground->up, unit.normal, sizeof ground->up);
    water_plane_axes(unit.normal, ground->x_dir, ground->y_dir);
    status = water_sheet_bounds(world_origin, ground->x_dir, ground->y_dir, bounds, ground->bounds);
  }
  const double* scene = ground->bounds;
  ground->near = near * hypot(scene[1] - scene[0], scene[3] - scene[2]);
  return status;
}

static void to_axes(const water_ground* ground, const double point[3], double place[3])
{
  place[0] = water_vec3_dot(point, ground->x_dir);
  place[1] = water_vec3_dot(point, ground->y_dir);
  place[2] = water_vec3_dot(point, ground->up);
}

void water_ground_add_bounds(const double bounds[6], water_ground* ground)
{
  double box[4]; // along the plane's axes
  if (water_sheet_bounds(world_origin, ground->x_dir, ground->y_dir, bounds, box) != WATER_OK)
  {
    return;
  }
  double top[3]; // the highest corner
  double place[3];
  for (int i = 0; i < 3; ++i)
  {
    top[i] = bounds[2 * i + (ground->up[i] > 0.0)];
  }
  to_axes(ground, top, place);
  const double* scene = ground->bounds;
  const double area = (scene[1] - scene[0]) * (scene[3] - scene[2]);
  const double covered = fmax(fmin(box[1], scene[1]) - fmax(box[0], scene[0]), 0.0) *
    fmax(fmin(box[3], scene[3]) - fmax(box[2], scene[2]), 0.0);
  if (area > 0.0 && covered >= wide * area)
  {
    ground->bed_top = fmin(ground->bed_top, place[2]);
  }
}

// Place i of the border: four along each side, each beginning with a corner.
static void place_of(const water_ground* ground, int i, double place[2])
{
  const double* scene = ground->bounds;
  const double along = 0.25 * (i % 4);
  const int side = i / 4;
  const int axis = side % 2;
  const bool is_back = side >= 2;
  const double share[2] = { axis == 0 ? along : 1.0, axis == 0 ? 0.0 : along };
  for (int j = 0; j < 2; ++j)
  {
    const double part = is_back ? 1.0 - share[j] : share[j];
    place[j] = scene[2 * j] + part * (scene[2 * j + 1] - scene[2 * j]);
  }
}

// The border between cells of an axis.
static double border_of(const water_ground* ground, int axis, int i)
{
  const double* scene = ground->bounds + 2 * axis;
  return scene[0] + (scene[1] - scene[0]) * i / WATER_GROUND_CELLS;
}

// The cell along an axis that has a place; places out of the scene are in its outermost.
static int cell_of(const water_ground* ground, int axis, double place)
{
  const double* scene = ground->bounds + 2 * axis;
  const double share = (place - scene[0]) / (scene[1] - scene[0]);
  return (int)fmin(fmax(share * WATER_GROUND_CELLS, 0.0), WATER_GROUND_CELLS - 1.0);
}

void water_ground_see_point(
  const water_ground* ground, const double point[3], water_footprint* footprint)
{
  double at[3];
  to_axes(ground, point, at);
  if (isfinite(at[0] + at[1] + at[2]))
  {
    water_footprint_add(cell_of(ground, 0, at[0]), cell_of(ground, 1, at[1]), at[2], footprint);
  }
}

// The same, in cells from the grid's border.
static void to_cells(const water_ground* ground, const double point[3], double place[3])
{
  double at[3];
  to_axes(ground, point, at);
  const double* scene = ground->bounds;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double wide_of = scene[2 * axis + 1] - scene[2 * axis];
    place[axis] = WATER_GROUND_CELLS * (at[axis] - scene[2 * axis]) / wide_of;
  }
  place[2] = at[2];
}

void water_ground_see_face(const water_ground* ground, double corners[3][3], water_relief* relief)
{
  double places[3][3];
  for (int i = 0; i < 3; ++i)
  {
    to_cells(ground, corners[i], places[i]);
  }
  water_relief_add_triangle(places, relief);
}

void water_ground_see_relief(
  const water_ground* ground, const double point[3], water_relief* relief)
{
  double place[3];
  to_cells(ground, point, place);
  water_relief_add_point(place, relief);
}

// A cell counts for the places of the border that are near. spread: of the heights in it.
static void add_to_border(int x, int y, double spread, bool is_block, water_ground* ground)
{
  const double at[2] = { 0.5 * (border_of(ground, 0, x) + border_of(ground, 0, x + 1)),
    0.5 * (border_of(ground, 1, y) + border_of(ground, 1, y + 1)) };
  const double* scene = ground->bounds;
  const double inside =
    fmin(fmin(at[0] - scene[0], scene[1] - at[0]), fmin(at[1] - scene[2], scene[3] - at[1]));
  if (inside > ground->near) // most cells are far from the border
  {
    return;
  }
  for (int i = 0; i < WATER_GROUND_PLACES; ++i)
  {
    double place[2];
    place_of(ground, i, place);
    if (fabs(at[0] - place[0]) <= ground->near && fabs(at[1] - place[1]) <= ground->near)
    {
      ground->has_block[i] = ground->has_block[i] || is_block;
      ground->spread[i] = is_block ? ground->spread[i] : fmin(ground->spread[i], spread);
    }
  }
}

// Is a block a column: high, with a flat top? Even wholly under water it is no bed.
static bool is_column(const water_footprint* footprint, const water_ground* ground)
{
  double side = (double)INFINITY;
  double low = (double)INFINITY;
  double high[2] = { (double)INFINITY, -(double)INFINITY }; // of the top
  for (int axis = 0; axis < 2; ++axis)
  {
    side = fmin(side,
      border_of(ground, axis, footprint->last[axis] + 1) -
        border_of(ground, axis, footprint->first[axis]));
  }
  for (int y = footprint->first[1]; y <= footprint->last[1]; ++y)
  {
    for (int x = footprint->first[0]; x <= footprint->last[0]; ++x)
    {
      if (water_footprint_has(footprint, x, y))
      {
        low = fmin(low, footprint->low[y][x]);
        high[0] = fmin(high[0], footprint->high[y][x]);
        high[1] = fmax(high[1], footprint->high[y][x]);
      }
    }
  }
  return high[1] - low > tall * side && high[1] - high[0] < flat * (high[1] - low);
}

// What a thing tells of the corners around a cell that it has.
static void add_corners(int x, int y, const water_relief* relief, water_ground* ground)
{
  for (int i = 0; i < 4; ++i)
  {
    double* corner = &ground->corner_low[y + i / 2][x + i % 2];
    const double height =
      relief ? water_relief_at(relief, x + i % 2, y + i / 2) : -(double)INFINITY;
    *corner = fmin(*corner, height);
  }
}

bool water_ground_add_thing(
  const water_footprint* footprint, const water_relief* relief, water_ground* ground)
{
  const water_footprint_shape shape = water_footprint_shape_of(footprint);
  const bool is_block = shape == WATER_FOOTPRINT_BLOCK;
  if (shape == WATER_FOOTPRINT_OBJECT || (is_block && is_column(footprint, ground)))
  {
    return false;
  }
  for (int y = footprint->first[1]; y <= footprint->last[1]; ++y)
  {
    for (int x = footprint->first[0]; x <= footprint->last[0]; ++x)
    {
      if (water_footprint_has(footprint, x, y))
      {
        const double high = footprint->high[y][x];
        const double low = is_block ? high : footprint->low[y][x];
        ground->cell_low[y][x] = fmin(ground->cell_low[y][x], low);
        ground->cell_has_block[y][x] = ground->cell_has_block[y][x] || is_block;
        add_to_border(x, y, high - low, is_block, ground);
        add_corners(x, y, is_block ? NULL : relief, ground);
      }
    }
  }
  if (is_block)
  {
    ground->block_from = fmin(ground->block_from, water_footprint_wet_from(footprint));
  }
  return true;
}

void water_ground_write(
  const water_ground* ground, const water_relief* relief, double numbers[WATER_GROUND_NUMBERS])
{
  double* next = numbers;
  for (int i = 0; i < WATER_GROUND_PLACES; ++i)
  {
    *next++ = ground->spread[i];
    *next++ = ground->has_block[i] ? 1.0 : 0.0;
  }
  *next++ = ground->block_from;
  *next++ = ground->bed_top;
  for (int i = 0; i < WATER_GROUND_CELLS * WATER_GROUND_CELLS; ++i)
  {
    *next++ = ground->cell_low[i / WATER_GROUND_CELLS][i % WATER_GROUND_CELLS];
    *next++ = ground->cell_has_block[i / WATER_GROUND_CELLS][i % WATER_GROUND_CELLS] ? 1.0 : 0.0;
  }
  memcpy(next, relief->height, sizeof relief->height);
}

void water_ground_join(
  const double numbers[WATER_GROUND_NUMBERS], water_ground* ground, water_relief* relief)
{
  const double* next = numbers;
  for (int i = 0; i < WATER_GROUND_PLACES; ++i)
  {
    ground->spread[i] = fmin(ground->spread[i], *next++);
    ground->has_block[i] = *next++ > 0.0 || ground->has_block[i];
  }
  ground->block_from = fmin(ground->block_from, *next++);
  ground->bed_top = fmin(ground->bed_top, *next++);
  for (int i = 0; i < WATER_GROUND_CELLS * WATER_GROUND_CELLS; ++i)
  {
    double* low = &ground->cell_low[i / WATER_GROUND_CELLS][i % WATER_GROUND_CELLS];
    bool* has_block = &ground->cell_has_block[i / WATER_GROUND_CELLS][i % WATER_GROUND_CELLS];
    *low = fmin(*low, *next++);
    *has_block = *next++ > 0.0 || *has_block;
  }
  water_relief_join_heights(next, relief);
}

void water_ground_take_relief(const water_relief* relief, water_ground* ground)
{
  for (int y = 0; y < WATER_GROUND_CELLS; ++y)
  {
    for (int x = 0; x < WATER_GROUND_CELLS; ++x)
    {
      if (isfinite(ground->cell_low[y][x]))
      {
        add_corners(x, y, ground->cell_has_block[y][x] ? NULL : relief, ground);
      }
    }
  }
}

int water_ground_across(const water_ground* ground, double corners[3][3])
{
  double at[3][3];
  double across = 1.0;
  for (int i = 0; i < 3; ++i)
  {
    to_axes(ground, corners[i], at[i]);
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    const double cell = border_of(ground, axis, 1) - border_of(ground, axis, 0);
    const double sides = fabs(at[1][axis] - at[0][axis]) + fabs(at[2][axis] - at[0][axis]);
    across = fmax(across, cell > 0.0 ? ceil(sides / cell) : 1.0);
  }
  return (int)fmin(across, 2.0 * WATER_GROUND_CELLS); // two sides of the whole scene
}

static bool has_point_in_line(const water_ground* ground, int axis, int line)
{
  bool has_point = false;
  for (int i = 0; i < WATER_GROUND_CELLS; ++i)
  {
    has_point =
      has_point || isfinite(axis == 0 ? ground->cell_low[i][line] : ground->cell_low[line][i]);
  }
  return has_point;
}

// Things in a row, however many, leave gaps from one side of the scene to the other.
static bool has_gap_across(const water_ground* ground)
{
  int longest = 0;
  for (int axis = 0; axis < 2; ++axis)
  {
    int empty = 0;
    for (int line = 0; line < WATER_GROUND_CELLS; ++line)
    {
      empty = has_point_in_line(ground, axis, line) ? 0 : empty + 1;
      longest = empty > longest ? empty : longest;
    }
  }
  return longest > gap;
}

bool water_ground_is_under(const water_ground* ground, double level)
{
  const double most = steep / near * ground->near;
  const bool has_block = ground->block_from <= level; // with water over it
  int count = 0;
  for (int i = 0; i < WATER_GROUND_PLACES; ++i)
  {
    count += ground->spread[i] <= most || (has_block && ground->has_block[i]) ? 1 : 0;
  }
  return ground->bed_top <= level || (count >= enough && !has_gap_across(ground));
}

bool water_ground_is_flat(const water_ground* ground, double level)
{
  double deepest = 0.0;
  for (int i = 0; i < WATER_GROUND_CELLS * WATER_GROUND_CELLS; ++i)
  {
    const double low = ground->cell_low[i / WATER_GROUND_CELLS][i % WATER_GROUND_CELLS];
    deepest = fmax(deepest, level - low); // of infinity: no depth
  }
  int count = 0;
  int deep_count = 0;
  for (int i = 0; i < WATER_GROUND_CELLS * WATER_GROUND_CELLS; ++i)
  {
    const double depth = level - ground->cell_low[i / WATER_GROUND_CELLS][i % WATER_GROUND_CELLS];
    count += depth > 0.0 ? 1 : 0;
    deep_count += depth > 0.0 && depth >= (1.0 - even) * deepest ? 1 : 0;
  }
  return count >= few && deep_count >= mostly * count;
}

// How high the ground is known to be over a level at a corner of cells, at least; outside of the
// scene there is nothing.
static double height_at_corner(const water_ground* ground, double level, int x, int y)
{
  if (isfinite(ground->corner_low[y][x]))
  {
    return ground->corner_low[y][x] - level;
  }
  double lowest = (double)INFINITY;
  for (int i = y - 2; i < y + 2; ++i)
  {
    for (int j = x - 2; j < x + 2; ++j)
    {
      if (i >= 0 && i < WATER_GROUND_CELLS && j >= 0 && j < WATER_GROUND_CELLS)
      {
        const double low = ground->cell_low[i][j];
        lowest = fmin(lowest, isfinite(low) ? low - level : -(double)INFINITY);
      }
    }
  }
  return lowest;
}

// Where on the way from a corner to the next the ground reaches the level, in [0, 1]. The part
// between a dry corner and an unknown one is wet.
static double crossing(double from, double to)
{
  if (isinf(from) || isinf(to))
  {
    return isinf(from) ? 1.0 : 0.0;
  }
  return from / (from - to);
}

// A point on the way from corner k of a cell to the next, in world.
static void put_point(const water_ground* ground, double level, const double cell[4], int k,
  double way, double point[3])
{
  static const int at[5][2] = { { 0, 2 }, { 1, 2 }, { 1, 3 }, { 0, 3 }, { 0, 2 } };
  const double x = cell[at[k][0]] + way * (cell[at[k + 1][0]] - cell[at[k][0]]);
  const double y = cell[at[k][1]] + way * (cell[at[k + 1][1]] - cell[at[k][1]]);
  for (int i = 0; i < 3; ++i)
  {
    point[i] = x * ground->x_dir[i] + y * ground->y_dir[i] + level * ground->up[i];
  }
}

int water_ground_wet(const water_ground* ground, double level, int x, int y, double parts[24])
{
  const double cell[4] = { border_of(ground, 0, x), border_of(ground, 0, x + 1),
    border_of(ground, 1, y), border_of(ground, 1, y + 1) };
  const double heights[5] = { height_at_corner(ground, level, x, y),
    height_at_corner(ground, level, x + 1, y), height_at_corner(ground, level, x + 1, y + 1),
    height_at_corner(ground, level, x, y + 1), height_at_corner(ground, level, x, y) };
  double outline[8][3]; // of what is wet; of two opposite corners together
  int count = 0;
  for (int k = 0; k < 4; ++k)
  {
    if (heights[k] <= 0.0)
    {
      put_point(ground, level, cell, k, 0.0, outline[count++]);
    }
    if ((heights[k] <= 0.0) != (heights[k + 1] <= 0.0))
    {
      put_point(ground, level, cell, k, crossing(heights[k], heights[k + 1]), outline[count++]);
    }
  }
  if (count < 3)
  {
    return 0;
  }
  const int part_count = count > 4 ? 2 : 1;
  for (int i = 0; i < 4 * part_count; ++i)
  {
    const int corner = i < 4 ? i : (i == 4 ? 0 : i - 2); // a fan
    memcpy(parts + 3 * i, outline[corner < count ? corner : count - 1], sizeof outline[0]);
  }
  return part_count;
}

bool water_ground_find_blocks(const water_ground* ground, double level, water_blocks* blocks)
{
  bool is_wet[WATER_GROUND_CELLS + 1][WATER_GROUND_CELLS + 1]; // corners
  for (int y = 0; y <= WATER_GROUND_CELLS; ++y)
  {
    for (int x = 0; x <= WATER_GROUND_CELLS; ++x)
    {
      is_wet[y][x] = height_at_corner(ground, level, x, y) <= 0.0;
    }
  }
  bool is_any_dry = false;
  for (int y = 0; y < WATER_GROUND_CELLS; ++y)
  {
    for (int x = 0; x < WATER_GROUND_CELLS; ++x)
    {
      const int count = is_wet[y][x] + is_wet[y][x + 1] + is_wet[y + 1][x] + is_wet[y + 1][x + 1];
      const water_cell partly = count == 0 ? WATER_CELL_NONE : WATER_CELL_PART;
      blocks->cell[y][x] = (unsigned char)(count == 4 ? WATER_CELL_WHOLE : partly);
      is_any_dry = is_any_dry || count == 0;
    }
  }
  water_blocks_merge(blocks);
  return is_any_dry;
}

int water_ground_block(const water_ground* ground, double level, const water_blocks* blocks, int x,
  int y, double parts[96])
{
  const int cells = 1 << blocks->size[y][x];
  const double block[4] = { border_of(ground, 0, x), border_of(ground, 0, x + cells),
    border_of(ground, 1, y), border_of(ground, 1, y + cells) };
  double corners[4][3];
  bool has_middle[4];
  bool is_one = true;
  for (int k = 0; k < 4; ++k)
  {
    put_point(ground, level, block, k, 0.0, corners[k]);
    has_middle[k] = water_blocks_has_middle(blocks, x, y, k);
    is_one = is_one && !has_middle[k];
  }
  if (is_one)
  {
    memcpy(parts, corners, sizeof corners);
    return 1;
  }
  // the borders between cells, as the neighbours have them
  const double x_middle = border_of(ground, 0, x + cells / 2);
  const double y_middle = border_of(ground, 1, y + cells / 2);
  const double middles[5][2] = { { x_middle, block[2] }, { block[1], y_middle },
    { x_middle, block[3] }, { block[0], y_middle }, { x_middle, y_middle } };
  double points[5][3];
  for (int k = 0; k < 5; ++k)
  {
    const double there[4] = { middles[k][0], middles[k][0], middles[k][1], middles[k][1] };
    put_point(ground, level, there, 0, 0.0, points[k]);
  }
  int count = 0;
  for (int k = 0; k < 8; ++k) // halves of sides
  {
    const double* from = k % 2 == 0 ? corners[k / 2] : points[k / 2];
    const double* to = k % 2 == 0 && has_middle[k / 2] ? points[k / 2] : corners[(k / 2 + 1) % 4];
    if (k % 2 == 0 || has_middle[k / 2])
    {
      const double* triangle[4] = { points[4], from, to, to };
      for (int i = 0; i < 4; ++i)
      {
        memcpy(parts + 12 * count + 3 * i, triangle[i], 3 * sizeof(double));
      }
      ++count;
    }
  }
  return count;
}
