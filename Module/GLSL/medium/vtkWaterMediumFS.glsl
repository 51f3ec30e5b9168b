// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMediumFS.glsl: slot body: what is seen through the surface, refracted, and what the way
// through the water leaves of it; water_medium.c for the shader.
//
// Seen from above the refracted ray runs through the water, from below the view ray does.

uniform sampler2D waterSceneColor; // the picture without this water; linear
uniform sampler2D waterSceneDepth; // its window depth, 1: background; nearest
uniform vec3 waterExtinction;      // absorption + scattering, 1/m
uniform int waterIsSubmerged;      // 1: the eye is in the water
uniform vec4 waterHeightClip;      // point in clip space of the eye -> height over the plane, times w
uniform vec4 waterClipW;           // the same -> w of the point in view space

const int WATER_MEDIUM_STEPS = 16;
const float WATER_MEDIUM_JUMP = 8.0; // a silhouette's, in depths that the ray goes meanwhile

float waterMediumDepth(vec2 uv)
{
  return textureLod(waterSceneDepth, uv, 0.0).r;
}

// Height over the plane of what the picture shows.
float waterMediumHeight(vec2 uv, float depth)
{
  vec4 clip = vec4(2.0 * vec3(uv, depth) - 1.0, 1.0);
  return dot(waterHeightClip, clip) / dot(waterClipW, clip);
}

// What is left of a color after a way of so many metres through the water.
vec3 waterAfter(vec3 color, float way)
{
  vec3 left = vec3(waterTransmittance(waterExtinction.r, way),
    waterTransmittance(waterExtinction.g, way), waterTransmittance(waterExtinction.b, way));
  return mix(waterDeepColor, color, left);
}

// The first place of a ray that is behind what the picture shows, between low and high, which are close.
struct WaterMediumHit
{
  float low;
  float high;
  float depthLow; // of the picture
  float depthHigh;
  bool isHit; // or else there is none up to high
};

// How far a ray can come: to the depth straight behind the surface, and on while still in front; and the first place.
// Of the slot refraction.
//
// depth  of the picture at the ray's start
// reach  how far the ray is followed
vec2 waterMediumSize(); // of the picture, pixels
float waterMediumReach(vec3 start, vec3 way, float depth);
WaterMediumHit waterMediumWalk(vec3 start, vec3 way, float depth, float reach);

// Where a ray into the scene meets what the picture shows.
//
// start  of the ray in the picture's window: u, v, depth
// way    the ray is start + s way
// s      of the hit
// uv     where in the picture its color is; within it
//
// Returns false when the picture does not show it: uv is then beside it and s of no use.
bool waterMediumMeets(vec3 start, vec3 way, out float s, out vec2 uv)
{
  float depth = waterMediumDepth(start.xy);
  float reach = waterMediumReach(start, way, depth);
  vec2 border =
    (step(0.0, way.xy) - start.xy) / mix(way.xy, vec2(1e-9), equal(way.xy, vec2(0.0)));
  float leaves = max(min(border.x, border.y), 0.0);
  bool isInside = reach <= leaves;
  reach = min(reach, leaves);

  WaterMediumHit found = waterMediumWalk(start, way, depth, reach);
  vec2 size = waterMediumSize();
  float texel = 1.0 / max(length(way.xy * size), 1e-6);
  if (found.isHit && found.depthLow - found.depthHigh > WATER_MEDIUM_JUMP * way.z * max(found.high - found.low, texel))
  {
    // behind something: what is beside it, not filtered
    uv = (floor((start.xy + found.low * way.xy) * size) + 0.5) / size;
    return false;
  }
  // the false position between the two, which are close
  float missLow = start.z + found.low * way.z - found.depthLow;
  float missHigh = start.z + found.high * way.z - found.depthHigh;
  s = found.isHit ? found.low - missLow * (found.high - found.low) / max(missHigh - missLow, 1e-20) : reach;
  uv = start.xy + s * way.xy;
  return found.isHit || isInside;
}

// Color of what lies beyond a point of the surface, and the light that the water adds.
vec3 waterTransmitted(WaterPoint point)
{
  vec3 dir = refract(point.ray, point.normal, 1.0 / waterEta);
  if (dir.z >= 0.0)
  {
    return waterDeepColor; // total reflection: it has no weight
  }
  float w0 = 1.0 / gl_FragCoord.w;
  vec3 start = vec3(0.5 + 0.5 * point.ndc, gl_FragCoord.z);
  vec4 end = waterDirToEye * vec4(dir, 0.0);
  vec3 way = 0.5 * (end.xyz - (2.0 * start - 1.0) * end.w);
  float s;
  vec2 uv;
  bool isMet = waterMediumMeets(start, way, s, uv);
  float depth = waterMediumDepth(uv);
  float length = s * w0 / max(1.0 - s * end.w, 1e-6);
  if (!isMet)
  {
    length = max(waterMediumHeight(uv, depth) / dir.z, 0.0); // over a level bed
  }
  vec3 color = textureLod(waterSceneColor, uv, 0.0).rgb;
  if (waterSide < 0.0)
  {
    return depth >= 1.0 && waterSkyBottom.a > 0.5 ? waterSky(dir) : color;
  }
  color *= waterCaustic(point.place + length * dir.xy, -length * dir.z);
  return depth >= 1.0 ? waterDeepColor : waterAfter(color, length);
}

// Depth of the water where the pixel looks straight, m.
//
// What is found over the water shares the pixel's samples and stands before it: at the waterline
// that is the shore, and far over it as good as none, or silhouettes had a shore.
float waterTransmittedDepth(WaterPoint point)
{
  vec2 uv = 0.5 + 0.5 * point.ndc;
  float depth = waterMediumDepth(uv);
  return depth >= 1.0 || waterSide < 0.0 ? 1e9 : abs(waterMediumHeight(uv, depth));
}

// The surface as the eye sees it, which may be under water.
vec3 waterSeenFrom(WaterPoint point, vec3 color)
{
  if (waterIsSubmerged == 0)
  {
    return color;
  }
  float along = (waterDirToEye * vec4(point.ray, 0.0)).w;
  return waterAfter(color, 1.0 / (gl_FragCoord.w * along));
}
