// SPDX-License-Identifier: BSD-3-Clause
// water_medium.h: light in the water: refraction, attenuation along a path, backscattering.
//
// eta and cosines are those of water_optics.h. Colours are three channels at 650, 550 and 450 nm
// (red, green, blue), linear. Seen from below, the sky lies in a window of half-angle
// water_optics_critical_rad(1 / index): 48.6 degrees.
//
// Scattering is the light lost from a beam. Real water scatters most light forward, by a degree or
// two, and this light still reaches the eye. Therefore give only the part that is scattered
// backward; the three closed forms below are then quasi-single scattering. Source: Gordon 1973,
// "Simple Calculation of the Diffuse Reflectance of the Ocean".
#ifndef water_medium_h
#define water_medium_h

#include "water_status.h"

#ifdef __cplusplus
extern "C"
{
#endif

#define WATER_COEFFICIENT_MAX 1e9 // 1/m: the shaders have floats

typedef struct water_medium
{
  double absorption[3]; // 1/m, in [0, WATER_COEFFICIENT_MAX]
  double scattering[3]; // 1/m, likewise
} water_medium;

// Jerlov's optical water types: I to III of the ocean, 1C to 9C of the coast, clear to turbid.
#define WATER_TYPE_LIST(X)                                                                         \
  X(WATER_TYPE_I, "I")                                                                             \
  X(WATER_TYPE_IA, "IA")                                                                           \
  X(WATER_TYPE_IB, "IB")                                                                           \
  X(WATER_TYPE_II, "II")                                                                           \
  X(WATER_TYPE_III, "III")                                                                         \
  X(WATER_TYPE_1C, "1C")                                                                           \
  X(WATER_TYPE_3C, "3C")                                                                           \
  X(WATER_TYPE_5C, "5C")                                                                           \
  X(WATER_TYPE_7C, "7C")                                                                           \
  X(WATER_TYPE_9C, "9C")

typedef enum water_type
{
#define WATER_TYPE_VALUE(name, text) name,
  WATER_TYPE_LIST(WATER_TYPE_VALUE)
#undef WATER_TYPE_VALUE
    WATER_TYPE_COUNT
} water_type;

// Jerlov's own name of a type, never NULL; static storage.
const char* water_type_text(water_type type);

// Returns WATER_OK, WATER_BAD_ABSORPTION or WATER_BAD_SCATTERING.
water_status water_medium_check(const water_medium* medium);

// Refracts a ray by Snell's law, from either side.
//
// dir        of the ray towards the surface, unit length
// normal     of the surface, unit length, to either side
// eta        index beyond the surface over the one on the ray's side, > 0
// refracted  unit length; in the plane of dir and normal
//
// Returns WATER_OK, WATER_BAD_DIRECTION (off unit length by more than 1e-6), WATER_BAD_INDEX_RATIO
// or WATER_TOTAL_REFLECTION. On an error, refracted is unchanged.
// Used only by tests, as a reference.
water_status water_medium_refract(
  const double dir[3], const double normal[3], double eta, double refracted[3]);

// Cosine of the refracted ray with the normal; 0 under total internal reflection.
double water_medium_cosine(double cosine, double eta);

// Length of a refracted ray down to a level bed, m.
//
// depth   m, >= 0
// cosine  of the ray in the air; clamped to [0, 1]
// eta     > 1
// Used only by tests, as a reference.
double water_medium_path(double depth, double cosine, double eta);

// Apparent depth of a bed, m, vertically above its true place. For a vertical view it is depth /
// eta. Used only by tests, as a reference.
double water_medium_apparent_depth(double depth, double cosine, double eta);

// Attenuation of a beam, 1/m: absorption + scattering.
void water_medium_extinction(const water_medium* medium, double extinction[3]);

// Share of the irradiance that infinitely deep water scatters back up, 0.33 b / (a + b) per
// channel, or 0 if both are 0. Linear, in [0, 0.33]; for the display colour see water_daylight.h.
// Source: Morel and Prieur 1977, "Analysis of Variations in Ocean Color" (R = 0.33 b_b / a), with
// the loss of the light that is scattered: a + b_b (Gordon 1973).
void water_medium_reflectance(const water_medium* medium, double reflectance[3]);

// The fraction of the light that remains after a path through the water, exp(-(a + b) path), per
// channel. Source: Bouguer 1729; Lambert 1760; Beer 1852. Used only by tests, as a reference.
void water_medium_transmittance(const water_medium* medium, double path, double transmittance[3]);

// Radiance scattered once towards an eye above, per unit of irradiance that the sun brings through
// a level surface, just below it (1/sr), per channel:
// b phase / (c (mu_s + mu_v)) (1 - exp(-c depth (1 / mu_s + 1 / mu_v))), c = a + b.
//
// depth       m, >= 0; infinity: no bed
// cosine_sun  mu_s of the refracted sunlight with the vertical, (0, 1]
// cosine_eye  mu_v of the refracted line of sight, (0, 1]
// phase       1/sr at the angle between them; 1 / (4 pi) when all directions are alike
// Source: Chandrasekhar 1950, "Radiative Transfer", section 47 (single scattering, finite slab).
// Used only by tests, as a reference.
void water_medium_inscatter(const water_medium* medium, double depth, double cosine_sun,
  double cosine_eye, double phase, double inscatter[3]);

// Diffuse attenuation of daylight in a Jerlov type, Kd in 1/m at 650, 550 and 450 nm, just below
// the surface under a high sun. The table has these wavelengths: nothing is interpolated.
//
// Returns WATER_OK or WATER_BAD_WATER_TYPE. On an error, kd is unchanged.
// Source: Jerlov 1976, "Marine Optics", table XXVII. (Austin and Petzold 1986 revised types I to 1C
// by up to 20 %; theirs are not used, so that all ten types have one source.)
water_status water_type_attenuation(water_type type, double kd[3]);

// A medium for a Jerlov type: scattering is the backward half of pure sea water's molecular
// scattering, 4.72e-4 * 16.06 (400 nm / wavelength)^4.32 (Morel 1974, "Optical Properties of Pure
// Water and Pure Sea Water"); absorption is what is left of Kd / 1.0395. The scattering of
// particles is unknown from Kd alone: add it for the colour of coastal waters.
//
// Returns as water_type_attenuation.
// Source: Gordon 1989, "Can the Lambert-Beer Law Be Applied to the Diffuse Attenuation Coefficient
// of Ocean Water?" (Kd = 1.0395 (a + b_b), the sun at the zenith).
water_status water_type_medium(water_type type, water_medium* medium);

#ifdef __cplusplus
}
#endif
#endif
