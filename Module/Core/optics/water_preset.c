// SPDX-License-Identifier: BSD-3-Clause
// water_preset.c: waters a user would look for, as the numbers of the other headers.
#include "water_preset.h"

#include <math.h>
#include <string.h>

#define DEEP ((double)INFINITY)
#define OCEAN                                                                                      \
  "Jerlov 1976 (IA), backward scattering of particles by Morel and Maritorena 2001 (0.1 mg/m^3 "   \
  "of chlorophyll); "
#define FRESNEL                                                                                    \
  {                                                                                                \
    1.333, 1.0, false                                                                              \
  }
// a growing sea of a short fetch, and a fully developed one (Pierson and Moskowitz 1964)
#define GROWING(wind, fetch, depth)                                                                \
  {                                                                                                \
    WATER_SEA_JONSWAP, WATER_SPREAD_DONELAN_BANNER, wind, 0.0, fetch, depth, 3.3, 10.0             \
  }
#define DEVELOPED(wind)                                                                            \
  {                                                                                                \
    WATER_SEA_JONSWAP, WATER_SPREAD_DONELAN_BANNER, wind, 0.0, DEEP, DEEP, 1.0, 10.0               \
  }
#define NO_SEA GROWING(1.0, 1000.0, DEEP) // a good value, in case it is switched on
#define NO_WAVES                                                                                   \
  {                                                                                                \
    {                                                                                              \
      0.0, 1.0, 0.0, 0.0, 0.0                                                                      \
    }                                                                                              \
  }
// of rms slope 0.0113 each; in all directions, as the walls of a pool send them back
#define RIPPLES                                                                                    \
  {                                                                                                \
    { 0.00217, 0.85, 0.30, 4.66, 0.0 }, { 0.00178, 0.70, 2.30, 5.92, 0.0 },                        \
      { 0.00149, 0.58, -1.98, 5.79, 0.0 }, { 0.00133, 0.52, 0.02, 2.92, 0.0 },                     \
      { 0.00102, 0.40, 2.02, 4.08, 0.0 }, { 0.00084, 0.33, -2.27, 0.71, 0.0 },                     \
    {                                                                                              \
      0.00074, 0.29, -0.27, 1.55, 0.0                                                              \
    }                                                                                              \
  }

typedef struct recipe
{
  water_type type;  // WATER_TYPE_COUNT: the medium is given in full
  double particles; // 1/m scattered backward by them: moved from the type's absorption
  water_preset preset;
} recipe;

static const recipe recipes[] = {
  { WATER_TYPE_COUNT, 0.0,
    { "pool",
      "Pope and Fry 1997 (absorption of pure water), Morel 1974 (scattering); seven chosen ripples "
      "of rms slope 0.030",
      FRESNEL, { { 0.340, 0.0565, 0.00922 }, { 0.00047, 0.00096, 0.00228 } }, false, NO_SEA,
      RIPPLES, 7, { 8.0, 40.0, 0.0 } } },
  { WATER_TYPE_1C, 0.012,
    { "lake",
      "Jerlov 1976 (1C stands in for a lake), chosen backward scattering of 1.2 g/m^3 of particles "
      "at 0.01 m^2/g; JONSWAP, wind 3 m/s over 2 km, 20 m deep",
      FRESNEL, { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } }, true, GROWING(3.0, 2000.0, 20.0), NO_WAVES,
      0, { 200.0, 2000.0, 0.0 } } },
  { WATER_TYPE_IB, 0.004,
    { "clear tropical",
      "Jerlov 1976 (IB), chosen backward scattering of 0.4 g/m^3 of coral sand at 0.01 m^2/g; "
      "JONSWAP, wind 4 m/s over 10 km, 5 m deep",
      FRESNEL, { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } }, true, GROWING(4.0, 10000.0, 5.0), NO_WAVES,
      0, { 120.0, 1000.0, 0.0 } } },
  { WATER_TYPE_IA, 0.0007,
    { "ocean wind 5", OCEAN "JONSWAP with gamma 1, fully developed (Pierson-Moskowitz)", FRESNEL,
      { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } }, true, DEVELOPED(5.0), NO_WAVES, 0,
      { 100.0, 1000.0, 0.0 } } },
  { WATER_TYPE_IA, 0.0007,
    { "ocean wind 10", OCEAN "JONSWAP with gamma 1, fully developed (Pierson-Moskowitz)", FRESNEL,
      { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } }, true, DEVELOPED(10.0), NO_WAVES, 0,
      { 200.0, 2000.0, 0.0 } } },
  { WATER_TYPE_IA, 0.0007,
    { "ocean wind 15", OCEAN "JONSWAP with gamma 1, fully developed (Pierson-Moskowitz)", FRESNEL,
      { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } }, true, DEVELOPED(15.0), NO_WAVES, 0,
      { 400.0, 4000.0, 0.0 } } },
  { WATER_TYPE_9C, 0.3,
    { "turbid river",
      "Jerlov 1976 (9C), chosen backward scattering of 30 g/m^3 of particles at 0.01 m^2/g; "
      "JONSWAP, "
      "wind 2 m/s over 300 m, 3 m deep",
      FRESNEL, { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } }, true, GROWING(2.0, 300.0, 3.0), NO_WAVES,
      0, { 50.0, 500.0, 0.0 } } },
  { WATER_TYPE_COUNT, 0.0,
    { "mirror floor", "chosen: a perfect mirror, no waves, nothing below", { 1.333, 1.0, true },
      { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } }, false, NO_SEA, NO_WAVES, 0,
      { 10.0, 1000.0, 0.0 } } }
};

static void add_particles(double backward, water_medium* medium)
{
  for (int channel = 0; channel < 3; ++channel)
  {
    medium->absorption[channel] -= backward; // Kd stays
    medium->scattering[channel] += backward;
  }
}

void water_preset_default(water_medium* medium, double natural_m[3])
{
  natural_m[0] = 400.0;
  natural_m[1] = 2000.0;
  natural_m[2] = 30.0;
  water_type_medium(WATER_TYPE_IB, medium);
  add_particles(0.010, medium);
  for (int channel = 0; channel < 3; ++channel)
  {
    medium->scattering[channel] += 0.020; // more of them than in the sea: Kd grows
  }
}

size_t water_preset_count(void)
{
  return sizeof recipes / sizeof recipes[0];
}

const char* water_preset_name(size_t number)
{
  return number < water_preset_count() ? recipes[number].preset.name : NULL;
}

water_status water_preset_find(const char* name, water_preset* preset)
{
  for (size_t i = 0; name != NULL && i < water_preset_count(); ++i)
  {
    const recipe* from = &recipes[i];
    if (strcmp(name, from->preset.name) != 0)
    {
      continue;
    }
    *preset = from->preset;
    if (water_type_medium(from->type, &preset->medium) == WATER_OK)
    {
      add_particles(from->particles, &preset->medium);
    }
    return WATER_OK;
  }
  return WATER_BAD_PRESET;
}
