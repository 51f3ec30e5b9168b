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
const float WATER_MEDIUM_CLOSE_PX = 0.2; // two places are as good as one
const float WATER_MEDIUM_LONG_PX = 8.0;  // ways that need eight looks, and not four

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

// Where a ray comes behind what the picture shows, between low and high. These are close, or else what lies between is
// hidden.
struct WaterMediumHit
{
  float low;
  float high;
  float depthLow; // of the picture
  float depthHigh;
  float share; // of the way from low to high, where the ray meets what is seen at high if that goes on
  bool isHit;  // or else low is the last place where the ray is known to be in front
};

vec2 waterMediumSize(); // of the picture, pixels; of the slot refraction

// Depths of the picture at the steps from one on.
vec4 waterMediumReadSteps(vec3 start, vec3 way, vec4 at)
{
  return vec4(waterMediumDepth(start.xy + at.x * way.xy), waterMediumDepth(start.xy + at.y * way.xy),
    waterMediumDepth(start.xy + at.z * way.xy), waterMediumDepth(start.xy + at.w * way.xy));
}

void waterMediumTest(float at, float rayDepth, float depth, inout WaterMediumHit found)
{
  bool isBehind = rayDepth > depth;
  found.high = isBehind ? at : found.high;
  found.depthHigh = isBehind ? depth : found.depthHigh;
  found.low = isBehind ? found.low : at;
  found.depthLow = isBehind ? found.depthLow : depth;
  found.isHit = found.isHit || isBehind;
}

// Is nothing before a place of the ray? So many looks on the way to it do not tell all, but see what the march does
// within some pixels.
bool waterMediumIsFree(vec3 start, vec3 way, float s, float lengthPx)
{
  vec4 parts = s * vec4(0.2, 0.4, 0.6, 0.8);
  bool areMore = lengthPx > WATER_MEDIUM_LONG_PX;
  vec4 more = parts - 0.1 * s;
  vec4 depths = waterMediumReadSteps(start, way, parts);
  vec4 depthsMore = vec4(1.0);
  if (areMore)
  {
    depthsMore = waterMediumReadSteps(start, way, more);
  }
  return all(lessThanEqual(start.z + parts * way.z, depths)) &&
    (!areMore || all(lessThanEqual(start.z + more * way.z, depthsMore)));
}

// Goes to where the line through two misses of a ray is none, up to three times, and from there to where the ray has
// the depth that is found: on one texel that is the place.
//
// pixels  of all of the way
//
// Returns whether the place is found.
bool waterMediumConverge(vec3 start, vec3 way, float pixels, inout WaterMediumHit found)
{
  float perDepth = 1.0 / max(way.z, 1e-20);
  for (int i = 0; i < 3; ++i)
  {
    float missLow = start.z + found.low * way.z - found.depthLow;
    float missHigh = start.z + found.high * way.z - found.depthHigh;
    float at = found.low - missLow * (found.high - found.low) / max(missHigh - missLow, 1e-20);
    float depth = waterMediumDepth(start.xy + at * way.xy);
    float there = (depth - start.z) * perDepth;
    waterMediumTest(at, start.z + at * way.z, depth, found);
    if (there > found.low && there < found.high || abs(there - at) * pixels < WATER_MEDIUM_CLOSE_PX)
    {
      float depthThere = waterMediumDepth(start.xy + there * way.xy);
      if (depthThere == depth)
      {
        found = WaterMediumHit(there, there, depth, depth, 0.0, true);
        return true;
      }
      waterMediumTest(there, start.z + there * way.z, depthThere, found);
    }
    if ((found.high - found.low) * pixels < WATER_MEDIUM_CLOSE_PX)
    {
      return true;
    }
  }
  return false;
}

// What the picture shows of what a ray meets.
struct WaterMediumView
{
  bool isMet; // or else it is guessed
  float s;    // the ray is start + s way
  vec2 from;  // u, v: the color is a mixture of two places
  vec2 to;
  float share; // of the second
};

// Where a ray leaves the picture.
float waterMediumLeaves(vec3 start, vec3 way)
{
  vec2 border =
    (step(0.0, way.xy) - start.xy) / mix(way.xy, vec2(1e-9), equal(way.xy, vec2(0.0)));
  return max(min(border.x, border.y), 0.0);
}

// Where a ray into the scene meets what the picture shows; of the slot refraction.
//
// start  of the ray in the picture's window: u, v, depth
// way    the ray is start + s way
WaterMediumView waterMediumMeets(vec3 start, vec3 way);

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
  WaterMediumView view = waterMediumMeets(start, way);
  float length = view.s * w0 / max(1.0 - view.s * end.w, 1e-6);
  float depth = waterMediumDepth(view.from);
  vec3 from = textureLod(waterSceneColor, view.from, 0.0).rgb;
  vec3 to = from;
  vec3 ways = vec3(length); // of what is seen at the first place, at the second, and of both
  float depthTo = depth;
  if (!view.isMet) // over level beds
  {
    depthTo = waterMediumDepth(view.to);
    to = textureLod(waterSceneColor, view.to, 0.0).rgb;
    ways.xy = max(vec2(waterMediumHeight(view.from, depth), waterMediumHeight(view.to, depthTo)) / dir.z, vec2(0.0));
    ways.z = mix(ways.x, ways.y, view.share);
  }
  if (waterSide < 0.0)
  {
    vec3 color = mix(from, to, view.share);
    return depth >= 1.0 && waterSkyBottom.a > 0.5 ? waterSky(dir) : color;
  }
  float caustic = waterCaustic(point.place + ways.z * dir.xy, -ways.z * dir.z);
  from = depth >= 1.0 ? waterDeepColor : waterAfter(caustic * from, ways.x);
  if (!view.isMet)
  {
    to = depthTo >= 1.0 ? waterDeepColor : waterAfter(caustic * to, ways.y);
    from = mix(from, to, view.share);
  }
  return from;
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
