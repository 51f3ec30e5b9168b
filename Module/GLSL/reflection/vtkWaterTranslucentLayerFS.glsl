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

// Where a ray sees the layer.
vec2 waterLayerPlace(WaterPoint point, vec3 normal)
{
  WaterRayHit crossed = waterEstimateHit(point, normal);
  waterRefineHit(point.start, false, false, crossed);
  return crossed.uv;
}

// The same of one of several facets, along two rays: edges of the layer are not searched.
void waterCrossFacet(WaterPoint point, vec3 lower, vec3 upper, inout WaterFacet facet)
{
  waterMeetsLayer = true;
  facet.layer = vec4(waterLayerPlace(point, lower), waterLayerPlace(point, upper));
  waterMeetsLayer = false;
  facet.hasLayer = true;
}

// What a facet sees, blurred as in vtkWaterBlurFS.glsl.
vec3 waterFacetColor(WaterFacet facet)
{
  vec2 apart = vec2(facet.apart, length(waterReflectionPx() * (facet.layer.zw - facet.layer.xy)));
  vec2 level = log2(max(WATER_FACET_BLUR * apart, vec2(1.0)));
  vec3 behind = facet.isPlace ? textureLod(waterOpaque, facet.uv, level.x).rgb : facet.color;
  vec4 layer = 0.5 * (textureLod(waterLayer, facet.layer.xy, level.y) + textureLod(waterLayer, facet.layer.zw, level.y));
  return facet.hasLayer ? layer.rgb + (1.0 - layer.a) * behind : behind;
}
