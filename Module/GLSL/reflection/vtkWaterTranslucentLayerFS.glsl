// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterTranslucentLayerFS.glsl: slots layer and blur of a reflection texture
// with translucent things or volumes, which are kept apart from the rest. A ray goes to what is opaque, as without
// them, and once more to the first thing of all: so things are found at their own distance, and what is seen through
// them at its own.

uniform sampler2D waterReflectionDepth; // of the mirrored view without the layer, 1: nothing; nearest
uniform sampler2D waterOpaque;          // its colours; linear
uniform sampler2D waterLayer;           // over nothing: colours times alpha, alpha; linear
uniform sampler2D waterLayerDepth;      // of all, what is translucent like the rest; nearest

bool waterMeetsLayer = false;

float waterDepthAt(vec2 uv)
{
  float depth = 0.0;
  if (waterMeetsLayer)
  {
    depth = textureLod(waterLayerDepth, uv, 0.0).r;
  }
  else
  {
    depth = textureLod(waterReflectionDepth, uv, 0.0).r;
  }
  return depth;
}

// Where the facets see the layer; the shares are 1 where what is behind is a place of the reflection texture.
WaterPlaces waterLayers = WaterPlaces(vec4(0.0), vec4(0.0), vec4(0.0));
mat4x3 waterBehind = mat4x3(0.0); // or else its colours, one a column

// A ray that has gone to what is opaque, once more. Its colour is known then.
void waterCross(WaterPoint point, inout WaterRayHit hit)
{
  waterMeetsLayer = true;
  WaterRayHit crossed = waterEstimateHit(point, point.normal);
  waterFollowRay(point.start, crossed);
  waterMeetsLayer = false;
  vec4 layer = crossed.isPlace ? textureLod(waterLayer, crossed.uv, 0.0) : vec4(0.0);
  vec3 behind = hit.isPlace ? textureLod(waterOpaque, hit.uv, 0.0).rgb : hit.color;
  hit.color = layer.rgb + (1.0 - layer.a) * behind;
  hit.isPlace = false;
}

// The same of one of several facets. Its colour is waterBlurred's.
void waterCrossFacet(WaterPoint point, vec3 normal, int i, inout WaterRayHit hit)
{
  waterMeetsLayer = true;
  WaterRayHit crossed = waterEstimateHit(point, normal);
  waterRefineHit(point.start, false, crossed);
  waterMeetsLayer = false;
  bvec4 isIt = equal(ivec4(i), ivec4(0, 1, 2, 3));
  vec4 inner = waterLayers.inner;
  vec4 outer = waterLayers.outer;
  waterLayers.inner = vec4(isIt.x ? crossed.uv : inner.xy, isIt.y ? crossed.uv : inner.zw);
  waterLayers.outer = vec4(isIt.z ? crossed.uv : outer.xy, isIt.w ? crossed.uv : outer.zw);
  waterLayers.shares = mix(waterLayers.shares, vec4(hit.isPlace ? 1.0 : 0.0), isIt);
  waterBehind = mat4x3(isIt.x ? hit.color : waterBehind[0],
    isIt.y ? hit.color : waterBehind[1], isIt.z ? hit.color : waterBehind[2],
    isIt.w ? hit.color : waterBehind[3]);
  hit.isPlace = true;
}

// From one of so many places to the next, as a level of the reflection texture.
float waterLevel(WaterPlaces places, int count)
{
  vec2 apart =
    count == 4 ? (places.outer.zw - places.outer.xy) / 3.0 : places.inner.zw - places.inner.xy;
  apart = count == 1 ? vec2(0.0) : apart;
  return log2(max(0.3 * length(apart * vec2(textureSize(waterReflection, 0))), 1.0));
}

// What some facets see, blurred over their distance as in vtkWaterBlurFS.glsl.
//
// places  of what is opaque
vec3 waterBlurred(WaterPlaces places, int count)
{
  float level = waterLevel(places, count);
  float layerLevel = waterLevel(waterLayers, count);
  vec3 blurred = vec3(0.0);
  int i = 0;
  do
  {
    vec4 pair = i < 2 ? places.inner : places.outer;
    vec4 layerPair = i < 2 ? waterLayers.inner : waterLayers.outer;
    vec2 shares = i < 2 ? places.shares.xy : places.shares.zw;
    vec2 kept = i < 2 ? waterLayers.shares.xy : waterLayers.shares.zw;
    vec3 firstBehind = i < 2 ? waterBehind[0] : waterBehind[2];
    vec3 secondBehind = i < 2 ? waterBehind[1] : waterBehind[3];
    bool isFirst = (i & 1) == 0;
    vec4 layer = textureLod(waterLayer, isFirst ? layerPair.xy : layerPair.zw, layerLevel);
    vec3 place = textureLod(waterOpaque, isFirst ? pair.xy : pair.zw, level).rgb;
    vec3 behind = mix(isFirst ? firstBehind : secondBehind, place, isFirst ? kept.x : kept.y);
    blurred += (isFirst ? shares.x : shares.y) * (layer.rgb + (1.0 - layer.a) * behind);
    ++i;
  } while (i < count);
  return blurred;
}
