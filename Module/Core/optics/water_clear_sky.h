// SPDX-License-Identifier: BSD-3-Clause
// water_clear_sky.h: a clear daytime sky and the sun's light: the light from each direction.
//
// Directions are x east, y north, z up. Colours are luminances, kcd/m^2, of the linear primaries of
// sRGB: red = green = blue = Y is a white of the luminance Y. The sun's disc is not in the sky: its
// reflection is the glitter of a light (water_glitter.h).
//
// Sources: Preetham, Shirley and Smits 1999, "A Practical Analytic Model for Daylight", appendix:
// luminance and chromaticity at the zenith and over the sky (Perez, Seals and Michalsky 1993),
// transmittance of the air for the sun's light. Its chromaticities leave the locus of daylight
// towards purple near the horizon of very clear air; they are moved to the locus, at the same x
// (Judd, MacAdam and Wyszecki 1964). IEC 61966-2-1:1999: primaries of sRGB.
#ifndef water_clear_sky_h
#define water_clear_sky_h

#include <stdbool.h>

#ifdef __cplusplus
extern "C"
{
#endif

// What a sky is computed with; made by water_clear_sky_make.
typedef struct water_clear_sky
{
  double sun_dir[3];
  double zenith_angle_rad; // of the sun
  double turbidity;
  double perez[3][5]; // of Y, x and y
  double zenith[3];   // Y in kcd/m^2, x and y there, each over Perez's function there
  double mean[3];     // colour that level ground gets from the sky: irradiance over pi
} water_clear_sky;

// Limits of the model.
extern const double water_clear_sky_turbidity_min; // 2: very clear air
extern const double water_clear_sky_turbidity_max; // 10: hazy

// azimuth_deg    of the sun, from north over east, finite
// elevation_deg  over the horizon, in [0, 90]
// turbidity      of the air, in [2, 10]
//
// Returns false, and leaves the output unchanged, for other values.
bool water_clear_sky_make(
  double azimuth_deg, double elevation_deg, double turbidity, water_clear_sky* sky);

// Luminance from a direction of unit length; no colour is negative. Below the horizon, the haze
// fades within 10 degrees into grey ground, which reflects a tenth of the sky's mean.
void water_clear_sky_color(const water_clear_sky* sky, const double dir[3], double color[3]);

// Colour of a white card that faces the sun and is lit by the sun alone: 128 klx, reduced by
// scattering of the air's molecules and aerosols at 650, 570 and 475 nm. Ozone and water vapour,
// which absorb a few per cent, are left out.
void water_clear_sky_sun(const water_clear_sky* sky, double color[3]);

// Factor from a colour to the displayed colour: the sky's mean luminance becomes 0.3 of white.
double water_clear_sky_exposure(const water_clear_sky* sky);

// A place of a picture in longitude and latitude, u, v in [0, 1]: u from west over south, east and
// north to west again, v from the nadir to the zenith. As vtkSkybox has it with up z and right x.
void water_clear_sky_place(double u, double v, double dir[3]);

#ifdef __cplusplus
}
#endif
#endif
