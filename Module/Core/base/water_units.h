// SPDX-License-Identifier: BSD-3-Clause
// water_units.h: what a metre is in a scene. Lengths of waves, depths and ways through water are
// metres; a scene has a unit of its own.
#ifndef water_units_h
#define water_units_h

#include <stdbool.h>
#include <stddef.h>

#include "water_status.h"

#ifdef __cplusplus
extern "C"
{
#endif

// Units by name: X(name, metres). The foot is the international one (NIST SP 811, appendix B).
#define WATER_UNIT_LIST(X)                                                                         \
  X("um", 1e-6)                                                                                    \
  X("mm", 1e-3)                                                                                    \
  X("cm", 1e-2)                                                                                    \
  X("m", 1.0)                                                                                      \
  X("km", 1e3)                                                                                     \
  X("in", 0.0254)                                                                                  \
  X("ft", 0.3048)                                                                                  \
  X("mi", 1609.344)

// Metres of a unit of this name.
//
// Returns WATER_OK or WATER_BAD_UNITS (NULL as well); then metres is unchanged.
water_status water_units_find(const char* name, double* metres);

// Name of unit i; NULL from the number of units on.
const char* water_units_name(size_t i);

// Metres per unit of a scene of unknown unit, so that its water looks natural. A scene of a natural
// size for its water is in metres. A smaller or a larger one, such as a model or a map, counts as
// half of the nearest natural size or more. Sizes are rounded up to a power of two, so that nothing
// changes while an object moves.
//
// diagonal   of the scene, units; the result is 1 if it is not finite or not positive
// natural_m  the least and the largest natural size, m, > 0
double water_units_fit(double diagonal, const double natural_m[2]);

// Attenuation in a scene of unknown unit: 1/64 to 16 times that of the medium, so that the deepest
// bed counts as naturally deep, or as four times as deep in a map. In a map, water hides its deep
// parts and shows its shore; elsewhere, objects that reach into the water stay visible. A map is a
// scene at least ten times as wide as deep. A scene five times as wide is not a map; between the
// two the depth changes linearly. A flat bed is that of a tank or a pool, which is there to be
// seen: it counts as a sixth as deep, however wide the scene is.
//
// extinction     of the medium, per unit
// bed_depth      of the deepest bed under the water, units; nothing changes unless it is > 0
// diagonal       of the scene, units
// natural_depth  units; 0: beds are as deep as they are
// is_flat        the bed is flat
// dimmed         extinction to use; may be extinction
void water_units_dim(const double extinction[3], double bed_depth, double diagonal,
  double natural_depth, bool is_flat, double dimmed[3]);

// Depth of foam at the shore, units, that a picture of the whole scene shows: at least 1/400 of its
// diagonal.
double water_units_show_foam(double depth, double diagonal);

// Are waves of this length visible in a picture of the whole scene? Not if they are shorter
// than 1/400 of it, which is about two pixels of a picture.
//
// wavelength  of the longest, m
// diagonal    of the scene, m
bool water_units_show_waves(double wavelength, double diagonal);

#ifdef __cplusplus
}
#endif
#endif
