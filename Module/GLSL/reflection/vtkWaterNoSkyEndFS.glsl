// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoSkyEndFS.glsl: slot end of rays in a reflection texture where the sky is what nothing was drawn over.

bool waterIsSky(float depth)
{
  return depth >= 1.0;
}

bool waterIsSkyByRay()
{
  return false;
}

void waterFindSky(vec3 start, float startW, vec3 dir, inout WaterRayHit hit) {}

void waterTakeSky(inout WaterRayHit hit) {}
