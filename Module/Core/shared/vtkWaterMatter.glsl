// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMatter.glsl: water that carries matter, of one channel; for shaders and, by water_shared.c, for C.

// A coefficient of the water with its matter, 1/m: absorption, scattering, or both together.
//
// clear          of the water alone, 1/m, >= 0
// perUnit        of the matter, 1/m per unit of its concentration, >= 0
// concentration  >= 0
// Source: Beer 1852 (the coefficient grows with the concentration).
float waterWithMatter(float clear, float perUnit, float concentration)
{
  return clear + perUnit * concentration;
}

// Share of the irradiance that infinitely deep water scatters back up, in [0, 0.33].
//
// scattering  1/m
// extinction  absorption + scattering, 1/m
// Source: see water_medium_reflectance.
float waterSentBack(float scattering, float extinction)
{
  return extinction > 0.0 ? 0.33 * (scattering / extinction) : 0.0;
}

// A linear value in [0, 1] as the display's; values outside are clamped.
// Source: IEC 61966-2-1:1999 (sRGB), section 5.2.
float waterEncoded(float linear)
{
  float value = min(max(linear, 0.0), 1.0);
  return value <= 0.0031308 ? 12.92 * value : 1.055 * pow(value, 1.0 / 2.4) - 0.055;
}
