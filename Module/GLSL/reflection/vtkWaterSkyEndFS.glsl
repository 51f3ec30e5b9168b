// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSkyEndFS.glsl: slot end of rays in a reflection texture where a mesh may be the sky, which has a view of its own
// (vtkWaterSkyViewFS.glsl): a ray that meets nothing else meets that mesh.

uniform float waterRestDepth; // the reflection texture shows nothing else beyond this depth

bool waterIsSky(float depth)
{
  return depth > waterRestDepth;
}

bool waterIsSkyByRay()
{
  return true;
}

// Where the reflection texture shows what the ray meets of the sky, it is finer than the view of the sky.
void waterFindSky(vec3 start, float startW, vec3 dir, inout WaterRayHit hit)
{
  vec4 halfWay = waterHalfEnd(waterSkyWay * dir);
  vec3 window = ((start - 0.5) * startW + halfWay.xyz) / max(0.5 * startW + halfWay.w, 1e-20) * 0.5 + 0.5;
  hit.skyPlace = window.xy;
  hit.isSkyThere = all(lessThan(abs(window.xy - 0.5), vec2(0.5))) && waterIsSky(waterDepthAt(window.xy));
}

void waterTakeSky(inout WaterRayHit hit)
{
  bool isTaken = hit.isSkyThere && !hit.isPlace;
  hit.uv = isTaken ? hit.skyPlace : hit.uv;
  hit.isPlace = hit.isPlace || isTaken;
}
