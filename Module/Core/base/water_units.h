// SPDX-License-Identifier: BSD-3-Clause
// water_units.h: the length of a metre in a scene. Wavelengths, depths and paths through water are
// in metres; a scene has its own unit.
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
// Returns WATER_OK or WATER_BAD_UNITS (NULL as well). On an error, metres is unchanged.
water_status water_units_find(const char* name, double* metres);

// Name of unit i; NULL from the number of units on.
const char* water_units_name(size_t i);

// Metres per unit for a scene of unknown unit, so that its water looks natural. Sizes are rounded
// up to a power of two, so that the unit does not change while an object moves. A scene whose
// rounded size is a natural one is in metres. A smaller scene, such as a model, gets half to all of
// the least natural size, and a larger one, such as a map, half to all of the largest.
//
// diagonal   of the scene, units; the result is 1 if it is not finite or not positive
// natural_m  the least and the largest natural size, m, > 0
double water_units_fit(double diagonal, const double natural_m[2]);

// What lies under a water.
typedef enum water_units_bed
{
  WATER_UNITS_BED_UNEVEN, // or of unknown shape
  WATER_UNITS_BED_FLAT,
  WATER_UNITS_BED_NONE // objects stand or float in open water
} water_units_bed;

// Attenuation in a scene of unknown unit: 1/64 to 16 times that of the medium, so that the deepest
// bed is treated as naturally deep, or as four times as deep in a map. In a map the water then
// hides the deep parts and shows the shore; elsewhere, objects that reach into the water stay
// visible. A map is a scene at least ten times as wide as deep. A scene that is at most five times
// as wide is not a map; between the two, the depth changes linearly. A flat bed is treated as the
// visible floor of a tank or a pool: a sixth of the natural depth, however wide the scene is. Open
// water around objects has no bed: the deepest part of them is treated as a third as deep. If it
// were deeper, the water would show a blurred glow of their colour at the waterline, and not their
// shape.
//
// extinction     of the medium, per unit
// bed_depth      of the deepest bed under the water, units; nothing changes unless it is > 0
// diagonal       of the scene, units
// natural_depth  units; 0: beds are as deep as they are
// bed            what lies under the water
// dimmed         extinction to use; may be extinction
void water_units_dim(const double extinction[3], double bed_depth, double diagonal,
  double natural_depth, water_units_bed bed, double dimmed[3]);

// Depth of foam at the shore, units, that a picture of the whole scene shows: at least 1/400 of its
// diagonal.
double water_units_show_foam(double depth, double diagonal);

// Depth over which a reflection fades in at a shore, units, unless it is given: at most a tenth of
// the depth of the deepest bed, so that small objects in shallow water have a reflection, too.
double water_units_soften(double depth, double bed_depth);

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
