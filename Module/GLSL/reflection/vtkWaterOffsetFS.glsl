// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterOffsetFS.glsl: slot reflection: the calm one, shifted by the normal: what most programs do
// for waves.

uniform sampler2D waterReflection; // mirrored view, flipped in x; linear
uniform int waterLookup;           // vtkWaterProperty::Lookups
uniform float waterOffsetScale;
uniform mat4 waterDirToReflection; // direction in the plane's axes -> clip of the reflection texture

vec2 waterOffsetPlace(WaterPoint point, vec3 normal)
{
  float scale = waterOffsetScale * (waterLookup == 2 ? waterPerW() : 1.0);
  vec2 offset = scale * waterReflectionScale * normal.xy;
  vec2 uv = point.start.xy + vec2(-offset.x, offset.y);
  if (waterLookup == 3) // the point itself is moved
  {
    vec4 moved = waterDirToReflection * vec4(waterOffsetScale * normal.xy, 0.0, 0.0);
    uv = 0.5 + 0.5 * ((2.0 * point.start.xy - 1.0) * point.startW + moved.xy) /
        (point.startW + moved.w);
  }
  return uv;
}

vec3 waterReflected(WaterPoint point, out int reason, out vec2 uv)
{
  uv = waterOffsetPlace(point, point.normal);
  reason = 1;
  return textureLod(waterReflection, uv, 0.0).rgb;
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
  return WaterRayHit(waterOffsetPlace(point, normal), true, vec3(0.0));
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
  return 1;
}

vec2 waterReflectionPx()
{
  return vec2(textureSize(waterReflection, 0));
}
