// SPDX-License-Identifier: BSD-3-Clause
// water_daylight.h: the light of a scene's sky and lights on level water, and the colour that the
// water scatters back.
//
// Daylight is the irradiance on the plane divided by pi, linear, red, green and blue: the colour of
// a white card in the plane. A background is a display colour (sRGB) and is decoded before it is
// added; a light's intensity is linear. The colour of the water is encoded. Source of the encoding:
// IEC 61966-2-1:1999 (sRGB), section 5.2.
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

// Adds the light of a sky: the mean of its colours.
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

// Display colour of infinitely deep water under a daylight, in [0, 1]: the share of the light that
// is scattered back (water_medium_reflectance), encoded. Losses where light enters and leaves the
// water are neglected, as they are for everything that is visible through the surface.
void water_daylight_deep_color(
  const water_medium* medium, const double daylight[3], double color[3]);

// Light on foam, besides the sun's direct light, as a share of its colour in [0, 1]. Under a sun it
// is that of the sky, WATER_FOAM_SKY. Without one it is what a white card in the plane shows under
// the daylight, and at least as much. Below WATER_FOAM_SUN it is a mixture.
//
// sun_color  light of the sun over pi, without its cosine to the plane; >= 0
// sun_dir    unit, towards the sun, in the plane's axes; NULL: no sun
#define WATER_FOAM_SKY 0.35
#define WATER_FOAM_SUN 0.25
void water_daylight_foam(
  const double daylight[3], const double sun_color[3], const double* sun_dir, double light[3]);

#ifdef __cplusplus
}
#endif
#endif
