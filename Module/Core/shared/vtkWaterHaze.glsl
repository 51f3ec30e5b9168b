// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHaze.glsl: light that the water scatters towards an eye in it, of one channel; for shaders and, by
// water_shared.c, for C. See water_haze.h.

// Scattering by particles at an angle, over that of as much backward scattering that is the same in all backward
// directions: its integral over the backward directions is 2 pi. Light that is scattered by less than
// 41.4 degrees, the complement of the critical angle, counts as not scattered: the first term stays at that angle.
//
// cosine  of the angle
// Source: Fournier and Forand 1994, "Analytic Phase Function for Ocean Water", as in Mobley, Sundman and Boss 2002, "Phase
// Function Effects on Oceanic Light Fields": n = 1.10, mu = 3.5835, a backward share of 0.0183, as Petzold measured.
float waterHazeParticles(float cosine)
{
  float from = 1.0 - min(cosine, 0.75);
  float delta = 66.6666667 * from;
  float power = pow(delta, -0.29175);
  float rest = 1.0 - delta;
  float wide = -0.29175 * rest - (1.0 - power) + 2.0 * (delta * (1.0 - power) + 0.29175 * rest) / from;
  float all = wide / (12.5663706 * rest * rest * power) + 4.763e-4 * (3.0 * cosine * cosine - 1.0);
  return 343.2 * all;
}

// The same of molecules.
//
// Source: Rayleigh 1871, without the depolarization.
float waterHazeMolecules(float cosine)
{
  return 0.75 + 0.75 * cosine * cosine;
}

// (1 - exp(-rate way)) / rate: the integral of exp(-rate s) from 0 to way. It keeps its digits for a small rate.
float waterHazeIntegral(float rate, float way)
{
  float x = rate * way;
  return abs(x) < 0.03 ? way * (1.0 - x * (0.5 - x * (0.16666667 - x * 0.041666667)))
                       : (1.0 - exp(-x)) / rate;
}

// Light that is scattered into a way and arrives at its start, over the same if daylight was everywhere as just under the
// surface: the integral of exp(-diffuse depth(s) - extinction s), over that of exp(-extinction s).
//
// extinction  of a beam, absorption + backward scattering, 1/m
// diffuse     attenuation of daylight with depth, 1/m
// fall        what the way gains in depth, per m, in [-1, 1]
// depth       of its start, m, >= 0
// way         m; ends at the surface; may be as good as infinite
// Source: Preisendorfer 1976, "Hydrologic Optics", volume 5, section 10.8, and Duntley 1963, "Light in the Sea": the
// path radiance of horizontal and inclined paths.
float waterHazeOver(float extinction, float diffuse, float fall, float depth, float way)
{
  float far = max(fall < 0.0 ? min(way, depth / max(-fall, 1e-9)) : way, 1e-9);
  float rate = extinction + diffuse * fall;
  float begun = exp(-diffuse * depth);
  float ended = exp(-diffuse * max(depth + fall * far, 0.0) - extinction * far); // begun times exp(-rate far)
  float along = abs(rate * far) < 0.03 ? begun * waterHazeIntegral(rate, far) : (begun - ended) / rate;
  return along / waterHazeIntegral(extinction, far);
}
