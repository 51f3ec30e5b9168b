// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPointFS.glsl: what all slots of a surface's shader know about their pixel.
//
// The slots, each one file of several: sky (waterSky), floor (waterOverFloor), place (waterPlaceOf,
// waterTilt), under (waterIsUnder), height (waterHeightOf), pixel (waterPerW, waterChangeAcross), hulls (waterLeaveHulls),
// region (waterKeepToRegion), waves
// (waterRipple), reflection (waterReflected), layer (waterCross), edges (waterRayAt), caustics (waterCaustic), body (waterTransmitted), facets
// (waterFacets), rays (waterMirrored), shadows (waterShadowed), glitter (waterGlint), foam
// (waterFoamShare, waterFoamLit), sun (waterSunlit), port (waterThroughPort), output (waterShow); vtkWaterSurfaceFS.glsl puts them together. They
// are files and not branches because software renderers execute both sides of a branch.
//
// NDC come from gl_FragCoord and the viewport of the draw itself (read from the GL state), which is
// exact for a sheet of any size.

uniform vec4 waterViewport;        // x, y, 1 / width, 1 / height of the draw, in pixels
uniform mat3 waterNdcToRay;        // (NDC x, NDC y, 1) -> view ray in the plane's axes
uniform mat4 waterDirToEye;        // direction in the plane's axes -> clip of the eye
uniform vec4 waterNormalClip;      // plane normal (towards the eye) in clip space, w included
uniform vec2 waterReflectionScale; // part of the reflection texture that is the picture itself, without its band
uniform vec2 waterDepthScale;      // of the surface: its depth in the picture times x, plus y, in the reflection texture
uniform int waterIsEndless;        // 1: gl_FragCoord's depth is held at the near and the far plane
uniform vec4 waterPixelDepth;      // (NDC, 1, 1 / w) -> NDC depth
uniform float waterSide;           // 1: seen from above, -1: from below
uniform float waterEta;            // index beyond the surface / index on the eye's side
uniform int waterIsReflecting;     // 0: there is no mirrored view
uniform float waterReflectance;    // 0 to 1, or below 0: Fresnel
uniform vec3 waterSunDir;          // towards it, in the plane's axes
uniform vec3 waterSlopeVariance;   // xx, yy, xy of the slopes too small for waves
uniform vec4 waterSkyBottom;       // of the background; a: 1 when the sky is known in all directions

uniform int waterSceneHasSamples; // 1: the picture is multisampled, and its samples are told apart
uniform sampler2D waterSceneSeen; // then from the pixel's middle to where the surface is seen, pixels

#include "vtkWaterDataColor.glsl"

float waterSmooth = 2e-5; // slope variance up to which a pixel has one facet: its reflection blurs by half a degree

struct WaterPoint
{
  vec2 moved;   // from the pixel's middle, pixels
  vec2 ndc;     // of the picture
  vec3 ray;     // view ray of unit length; directions are in the plane's axes, the third to the eye
  vec2 place;   // at rest on the plane, from the point under the eye
  float height; // over the plane, towards the eye
  vec2 across;  // change of the place from pixel to pixel
  vec2 down;
  vec3 normal;    // of the surface, of unit length
  vec2 tilt;      // slope of the surface without its waves, along the two axes
  vec4 variance;  // of the slopes along the two axes: within the pixel; taken by filters, not seen
  float both;     // covariance of the slopes along the two axes, of all of these
  vec2 even;      // of that within the pixel, what changes evenly over it: several rays see it
  float jacobian; // distance of the surface's points relative to that at rest: 0 on a breaking crest
  vec3 start;     // where the reflection texture shows its calm reflection: u, v, depth
  float startW;   // w of that in clip space of the reflection texture
};

const float WATER_UNMET = 2.0; // depth of what a ray cannot meet: beyond the background's
const float WATER_FACET_BLUR = 0.25; // what a facet sees is blurred by so much of the distance to its neighbours'

// What one of a pixel's facets sees, as far as its neighbour needs it.
struct WaterFacet
{
  float slope;  // of the facet, in spreads of the slopes
  float light;  // its reflectance
  vec3 line;    // of its ray: u, v, 1 / what it gains in depth
  float depth;  // of what it meets; from 1 on: nothing
  vec2 uv;      // where the reflection texture shows that
  bool isPlace; // or else
  vec3 color;   // this is what it sees
  float weight; // its share of all slopes times their reflectance
  float apart;  // texels to what its neighbours see
  vec4 layer;   // two places where it sees the translucent layer
  bool hasLayer;
};

WaterFacet waterNoFacet()
{
  return WaterFacet(0.0, 0.0, vec3(1.0), WATER_UNMET, vec2(0.0), false, vec3(0.0), 0.0, 0.0, vec4(0.0), false);
}

// From the pixel's middle to that of those samples which are not of something over the water: what is looked up in
// the middle may be the inside of that.
vec2 waterSeenShift()
{
  vec2 shift = vec2(0.0);
  for (int i = 0; i < waterSceneHasSamples; ++i)
  {
    shift = texelFetch(waterSceneSeen, ivec2(gl_FragCoord.xy - waterViewport.xy), 0).rg;
  }
  return shift;
}

float waterPerW();       // 1 / w of the surface at the pixel; of the slot pixel
float waterDepthHere();  // its window depth
vec2 waterDepthSlope();  // of that, from pixel to pixel
void waterPlaceSlope(vec2 middle, out vec2 across, out vec2 down); // of the place at the pixel's middle

vec3 waterFrom = vec3(0.0);       // the pixel's point in the plane's axes, from the one under the eye
float waterSpread = 0.0;          // radians about a direction that the sky's mean is taken over
vec2 waterDepthChange = vec2(0.0); // of the window depth, from pixel to pixel

// Window depth of the surface at a place of the pixel, as in WaterPoint; of an endless surface before the near plane and
// beyond the far plane, too.
float waterWindowDepth(vec2 ndc, vec2 moved)
{
  float endless = 0.5 + 0.5 * dot(waterPixelDepth, vec4(ndc, 1.0, waterPerW()));
  return waterIsEndless != 0 ? endless : waterDepthHere() + dot(moved, waterDepthChange);
}

// Where the reflection texture shows the calm reflection of a point.
//
// clip    NDC of the point, 1
// height  over the plane, over w
// perW    1 / w
void waterStart(inout WaterPoint point, vec4 clip, float height, float perW)
{
  vec4 mirrored = clip - 2.0 * height * waterNormalClip;
  point.startW = mirrored.w / perW;
  vec3 window = 0.5 / mirrored.w * mirrored.xyz;
  point.start = vec3(0.5 + waterReflectionScale * vec2(-window.x, window.y),
    waterDepthScale.x * (0.5 + window.z) + waterDepthScale.y);
}

WaterPoint waterPoint()
{
  WaterPoint point;
  vec2 middle = waterPlaceOf(2.0 * (gl_FragCoord.xy - waterViewport.xy) * waterViewport.zw - 1.0);
  point.moved = waterSeenShift();
  waterDepthChange = waterDepthSlope();
  point.ndc = 2.0 * (gl_FragCoord.xy + point.moved - waterViewport.xy) * waterViewport.zw - 1.0;
  point.ray = normalize(waterNdcToRay * vec3(point.ndc, 1.0));
  waterPlaceSlope(middle, point.across, point.down);
  point.place = middle + point.moved.x * point.across + point.moved.y * point.down;
  point.variance = vec4(waterSlopeVariance.xy, 0.0, 0.0);
  point.both = waterSlopeVariance.z;
  point.even = vec2(0.0);
  point.jacobian = 1.0;
  vec4 clip = vec4(point.ndc, 2.0 * waterWindowDepth(point.ndc, point.moved) - 1.0, 1.0); // w cancels below
  float height = waterHeightOf(clip);
  point.height = height / waterPerW();
  point.tilt = waterTilt(point.across, point.down, vec2(dFdx(point.height), dFdy(point.height)));
  point.normal = normalize(vec3(-point.tilt, 1.0));
  waterFrom = vec3(point.place, point.height);
  waterStart(point, clip, height, waterPerW());
  return point;
}

// The place on the plane of a pixel's surface point, from the point under the eye: waves move it
// from its place at rest, along the view ray.
vec2 waterOverPlane(WaterPoint point)
{
  vec3 seen = waterNdcToPlane * vec3(point.ndc, 1.0);
  float rise = abs(point.ray.z) > 1e-6 ? point.height / point.ray.z : 0.0;
  return seen.xy / seen.z + rise * point.ray.xy;
}

// What changes of a point from pixel to pixel.
struct WaterPointChange
{
  vec3 start;
  float startW;
  vec3 ray;
  vec3 normal;
};

WaterPointChange waterChangeAcross(WaterPoint point); // of the slot pixel
WaterPointChange waterChangeDown(WaterPoint point);

// A point elsewhere in its pixel, as far as it changes evenly: waves that are short against one are not in the slope.
//
// place  pixels from the middle
WaterPoint waterMovedPoint(WaterPoint point, vec2 place, WaterPointChange across, WaterPointChange down)
{
  WaterPoint moved = point;
  moved.start += place.x * across.start + place.y * down.start;
  moved.startW += place.x * across.startW + place.y * down.startW;
  moved.moved += place;
  moved.ndc += 2.0 * place * waterViewport.zw;
  moved.place += place.x * point.across + place.y * point.down;
  bool isMiddle = place == vec2(0.0); // not normalized again: that would be another rounding
  moved.ray = isMiddle ? point.ray : normalize(point.ray + place.x * across.ray + place.y * down.ray);
  moved.normal =
    isMiddle ? point.normal : normalize(point.normal + place.x * across.normal + place.y * down.normal);
  return moved;
}

// Cosine of the angle at which the eye sees a surface. Slopes that face away are hidden behind others, which face it: seen
// at the same angle they reflect as those do, and not all light.
float waterFacing(vec3 ray, vec3 normal)
{
  return min(abs(dot(ray, normal)), 1.0);
}
