// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterAttenuation.glsl: what a way through the water leaves of the light; for shaders and, by
// water_shared.c, for C.

// The part of the light that is left, of one channel.
//
// extinction  absorption + scattering, 1/m
// way         m
// Source: Bouguer 1729; Lambert 1760; Beer 1852.
float waterTransmittance(float extinction, float way)
{
  return exp(-extinction * way);
}

// Where along a way through the water that part of its light has been scattered into it, of one channel, m: single
// scattering of a light that is the same everywhere.
//
// part  in [0, 1]
// way   m; may be as good as infinite
// Source: Chandrasekhar 1950, "Radiative Transfer", section 7 (the formal solution, for a constant source).
float waterScatteredAt(float extinction, float way, float part)
{
  return min(-log(max(1.0 - part * (1.0 - exp(-extinction * way)), 1e-12)) / extinction, way);
}

// Light that is scattered into a way between two of its places and arrives, over that of water without an end; the same
// source.
float waterScattered(float extinction, float from, float to)
{
  return exp(-extinction * from) - exp(-extinction * to);
}
