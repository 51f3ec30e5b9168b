// SPDX-License-Identifier: BSD-3-Clause
// water_preset.h: waters a user would look for, as the numbers of the other headers.
//
// What is measured has its source in the preset; what is chosen for the look says so. Wind and
// waves travel along the first axis of the plane, or near it.
#ifndef water_preset_h
#define water_preset_h

#include "water_medium.h"
#include "water_spectrum.h"
#include "water_types.h"
#include "water_waves.h"

#ifdef __cplusplus
extern "C"
{
#endif

enum
{
  WATER_PRESET_WAVES = 7
};

typedef struct water_preset
{
  const char* name;
  const char* source; // of its numbers, in English; static storage
  water_look look;
  water_medium medium; // zeros: nothing under the surface matters
  bool has_sea;        // the wind sea is in use
  water_sea sea;
  water_wave waves[WATER_PRESET_WAVES];
  size_t wave_count;
  double natural_m[3]; // smallest and largest natural size of a scene with such water; natural
                       // depth of its deepest bed, 0: depths are used unchanged; water_units.h
} water_preset;

// Medium of a water for which the user sets none: a clear lake. It is Jerlov's IB, whose
// attenuation includes 0.010/m of backscattering by particles, with another 0.020/m of it: 3 g/m^3
// at 0.01 m^2/g, a chosen amount.
//
// natural_m  as of a preset
void water_preset_default(water_medium* medium, double natural_m[3]);

// Number of presets, and the name of each; NULL from the number on.
size_t water_preset_count(void);
const char* water_preset_name(size_t number);

// The preset of a name: "pool", "lake", "clear tropical", "ocean wind 5", "ocean wind 10",
// "ocean wind 15", "turbid river" or "mirror floor".
//
// Returns WATER_OK or WATER_BAD_PRESET (NULL as well). On an error, preset is unchanged.
water_status water_preset_find(const char* name, water_preset* preset);

#ifdef __cplusplus
}
#endif
#endif
