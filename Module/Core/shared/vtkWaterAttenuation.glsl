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
