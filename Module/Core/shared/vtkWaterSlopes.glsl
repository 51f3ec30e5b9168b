// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSlopes.glsl: slopes as a distribution, and the sun's glitter from it; for shaders and, by
// water_shared.c, for C.

// Probability per unit of both slopes, Gaussian.
//
// xx, yy, xy  variances and covariance of the slopes along two axes
// area        xx yy - xy^2, > 0: with a bound where the caller's numbers need one
// x, y        the slope
float waterSlopeDensity(float xx, float yy, float xy, float area, float x, float y)
{
  return exp(-0.5 * (yy * x * x - 2.0 * xy * x * y + xx * y * y) / area) /
    (6.283185307179586 * sqrt(area));
}

// What the radiance of glitter towards the eye is less by than the irradiance that it is made of: light
// on a plane facing it, times reflectance and density of the slopes.
//
// eyeCosine  of the eye's direction with the plane's normal, > 0
// facet4     fourth power of the facet's cosine with the plane's normal, > 0
// Source: Cox and Munk 1954, "Measurement of the Roughness of the Sea Surface from Photographs of the
// Sun's Glitter".
float waterGlitterSpread(float eyeCosine, float facet4)
{
  return 4.0 * eyeCosine * facet4;
}
