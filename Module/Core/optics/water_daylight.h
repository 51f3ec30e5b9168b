// SPDX-License-Identifier: BSD-3-Clause
// water_daylight.h: the light that a scene's sky and lights bring to level water, and the colour
// that the water sends back of it.
//
// Daylight is irradiance on the plane over pi, linear, red, green and blue: what a white card in
// the plane would show. A background is a colour of the display (sRGB) and is decoded before it is
// added; a light's intensity is linear. What comes back from the water is encoded.
// Source of the encoding: IEC 61966-2-1:1999 (sRGB), section 5.2.
#ifndef water_daylight_h
#define water_daylight_h

#include "water_medium.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

// A linear value in [0, 1] as the display's, and back; values outside are clamped.
double water_display_encode(double linear);
double water_display_decode(double shown);

// Adds what a sky sends down: the mean of its colours.
void water_daylight_add_sky(const water_sky* sky, double daylight[3]);

// Adds a distant light's part: intensity times colour times the cosine to the normal, from the
// normal's side alone (Lambert's cosine law). A light without a direction adds nothing.
//
// normal     of the plane, any length but 0
// dir        towards the light, any length
// color      as VTK shades with it: a white card that faces the light shows intensity * color
// intensity  >= 0
void water_daylight_add_light(const double normal[3], const double dir[3], const double color[3],
  double intensity, double daylight[3]);

// Colour of water without an end under a daylight, as the display shows it, in [0, 1]: the share
// of the light that comes back up (water_medium_reflectance), encoded. How light enters the water
// and leaves it is not counted, as it is not for what is seen through the surface.
void water_daylight_deep_color(
  const water_medium* medium, const double daylight[3], double color[3]);

#ifdef __cplusplus
}
#endif
#endif
