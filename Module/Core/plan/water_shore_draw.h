// SPDX-License-Identifier: BSD-3-Clause
// water_shore_draw.h: in addition to water_shore.h: whether the shore of a solver's mesh is cut
// while the mesh is drawn, and by what number at each vertex.
//
// The graphics card cuts triangles where a number that is linear in each of them is below 0. The
// depth is such a number, so the line is the same that water_shore_cut finds in triangles. The mesh
// then stays whole, and its cells need not be sent again in the next step.
#ifndef water_shore_draw_h
#define water_shore_draw_h

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C"
{
#endif

// Who cuts. X(name), in the order of vtkWaterLakes' ShoreCut.
#define WATER_SHORE_CUT_LIST(X)                                                                    \
  X(AUTOMATIC)                                                                                     \
  X(IN_FILTER)                                                                                     \
  X(WHILE_DRAWN)

typedef enum water_shore_cut_setting
{
#define WATER_SHORE_CUT_VALUE(name) WATER_SHORE_CUT_##name,
  WATER_SHORE_CUT_LIST(WATER_SHORE_CUT_VALUE)
#undef WATER_SHORE_CUT_VALUE
    WATER_SHORE_CUT_COUNT
} water_shore_cut_setting;

// What is known before a step is read.
typedef struct water_shore_renderer
{
  water_shore_cut_setting setting;
  bool is_software;    // the CPU executes GL
  bool clips_well;     // its clip distances are right
  bool is_plain_draw;  // triangles, by VTK's own shaders of polygons
  bool is_of_the_mesh; // what is drawn comes from the filter that knows the mesh
} water_shore_renderer;

// Is it worth trying? In software the vertices of dry land cost more than the cut.
bool water_shore_draw_is_wanted(const water_shore_renderer* renderer);

// What a step has that a number at each vertex cannot tell, all counted.
typedef struct water_shore_facts
{
  bool has_depths; // false: the data do not say where the water ends
  size_t dykes;    // cells that are dry as a whole, with wet corners
  size_t crossed;  // polygons of five corners or more that the water crosses twice
  size_t shared;   // cells with water of two lakes, or dry corners between them
  size_t unplaced; // wet cells with a coordinate that is not a number
  size_t unknown;  // values at dry corners beside the water that are not numbers
} water_shore_facts;

// Does the mesh as it is drawn show the same as the cut mesh?
bool water_shore_draw_is_exact(const water_shore_facts* facts);

// Is the whole mesh drawn for the largest of several waters? Each other water is drawn from a copy
// of its own cells. So is the largest one, unless it has more than half of the wet cells.
//
// own_cells, wet_cells  with water of the largest, and of all
bool water_shore_draw_is_whole(size_t own_cells, size_t wet_cells);

// Computes the places of a mesh's vertices. Wet vertices lie at the water's level. All vertices on
// land lie at one place, so that code that reads only the points, such as a computation of bounds,
// finds only the water.
//
// points  of the mesh: rows of 3
// levels  in their unit
// depths  above 0 in water
// scale   of levels: heights are scale * level
// still   the place of land
// places  rows of 3
// bounds  xmin, xmax, ymin, ymax, zmin, zmax: the places are added to them
void water_shore_places(const double* points, const double* levels, const double* depths,
  size_t count, double scale, const double still[3], double* places, double bounds[6]);

// The numbers of vertices: above 0 in water, below 0 on land, linear in the depth. A depth of 0 is
// land: a triangle with all three corners at 0 would be drawn as a whole.
void water_shore_distances(const double* depths, size_t count, float* distances);

#ifdef __cplusplus
}
#endif
#endif
