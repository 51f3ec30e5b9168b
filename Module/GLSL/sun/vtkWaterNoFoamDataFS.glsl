// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoFoamDataFS.glsl: slot foam_data of water without such data.

float waterWithFoamData(float cover)
{
  return cover;
}
