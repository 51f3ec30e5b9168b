// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBelowLayerFS.glsl: slot below of an own view with translucent props or volumes, which are kept apart from the
// rest (vtkWaterTranslucentLayer). A ray goes to what is opaque, as without them, and once more to the first thing of all:
// so each is refracted, and dimmed, at its own place.

uniform sampler2D waterBelowColor; // over nothing: colours times alpha, alpha; linear
uniform sampler2D waterBelowDepth; // of all, what is translucent like the rest; nearest

bool waterMeetsBelowLayer = false;

float waterMediumDepth(vec2 uv)
{
  float depth = 0.0;
  if (waterMeetsBelowLayer)
  {
    depth = textureLod(waterBelowDepth, uv, 0.0).r;
  }
  else
  {
    depth = textureLod(waterSceneDepth, uv, 0.0).r;
  }
  return depth;
}

// What a refracted ray sees through the first translucent thing that it meets. The water in front of that adds its light
// once: to the share that it covers, since what is behind has its own already.
//
// behind  the rest, with all of the water in front of it
vec3 waterThroughBelowLayer(WaterPoint point, vec3 dir, vec3 behind)
{
  waterMeetsBelowLayer = true;
  WaterMediumMet met = waterMediumMeet(point, dir);
  vec2 uv = waterMediumUnmixed(met.view.from, met.depth);
  waterMeetsBelowLayer = false;
  bool isThere = met.view.isMet && !met.isUnderBorder;
  vec4 layer = isThere ? textureLod(waterBelowColor, uv, 0.0) : vec4(0.0);
  vec3 left = waterSide > 0.0 ? waterLeft(met.way) : vec3(1.0);
  return (1.0 - layer.a) * behind + left * layer.rgb + layer.a * (1.0 - left) * waterDeepColor;
}
