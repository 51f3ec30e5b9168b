// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterEnvironmentFS.glsl: slot reflection: the sky alone, and no scene.

vec3 waterAround(WaterPoint point, vec3 normal, out vec2 uv)
{
  vec3 dir = reflect(point.ray, normal);
  dir.z = abs(dir.z); // met the water again: bounced off it once more
  uv = waterSkyPlace(dir);
  return waterSky(dir);
}

vec3 waterReflected(WaterPoint point, out int reason, out vec2 uv)
{
  reason = 2;
  return waterAround(point, point.normal, uv);
}

// What a facet sees: a place of the reflection texture, or a colour.
struct WaterRayHit
{
  vec2 uv;
  bool isPlace;
  vec3 color;
};

WaterRayHit waterEstimateHit(WaterPoint point, vec3 normal)
{
  WaterRayHit hit;
  hit.color = waterAround(point, normal, hit.uv);
  hit.isPlace = false;
  return hit;
}

void waterReadOnce() {}

void waterRefineHit(vec3 start, bool isFollowed, bool isScanned, inout WaterRayHit hit) {}

void waterMarchRay(vec3 start, bool isWanted, inout WaterRayHit hit) {}

vec2 waterPlaceOver(vec3 start, WaterRayHit hit)
{
  return hit.uv;
}

int waterReason(WaterRayHit hit)
{
  return 2;
}

vec2 waterReflectionPx()
{
  return vec2(1.0);
}
