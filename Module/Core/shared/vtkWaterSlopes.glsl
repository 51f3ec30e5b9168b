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

// Area of the facets of Gaussian slopes that face a direction, seen from there, over their area on the plane. It exceeds
// the plane's own, which is the cosine, by what facets hide of each other.
//
// cosine  of the direction with the plane's normal; with another mean slope, the mean over the facets: z - slope . xy
// spread  standard deviation of that, > 0: of the slopes along the direction's azimuth, times the direction's sine
// Source: Smith 1967, "Geometrical Shadowing of a Random Rough Surface"; the cumulative normal distribution by Page 1977,
// "Approximations to the Cumulative Normal Function and its Inverse for Use on a Pocket Calculator".
float waterFacingArea(float cosine, float spread)
{
  float x = min(max(cosine / spread, -9.0), 9.0);
  float share = 1.0 / (1.0 + exp(-x * (1.5957691 + 0.0713548 * x * x)));
  return cosine * share + spread * 0.3989422804 * exp(-0.5 * x * x);
}

// What the radiance of glitter towards the eye is less by than the irradiance that it is made of: light
// on a plane facing it, times reflectance and density of the slopes.
//
// seen    area of what the eye and the sun see, over the area on the plane, > 0: without waves that hide each other the
//         cosine of the eye's direction with the plane's normal
// facet4  fourth power of the facet's cosine with the plane's normal, > 0
// Source: Cox and Munk 1954, "Measurement of the Roughness of the Sea Surface from Photographs of the
// Sun's Glitter".
float waterGlitterSpread(float seen, float facet4)
{
  return 4.0 * seen * facet4;
}
