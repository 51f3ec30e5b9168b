// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterOffsetFS.glsl: stage reflection: the calm one, shifted by the normal: what most programs do
// for waves. Needs vtkWaterPointFS.glsl before it.

uniform sampler2D waterReflection; // mirrored view, flipped in x; linear
uniform int waterLookup;           // vtkWaterProperty::Lookups
uniform float waterOffsetScale;
uniform mat4 waterDirToMap; // direction in the plane's axes -> clip of the map

vec2 waterOffsetPlace(WaterPoint point)
{
  float scale = waterOffsetScale * (waterLookup == 2 ? gl_FragCoord.w : 1.0);
  vec2 offset = scale * waterMapScale * point.normal.xy;
  vec2 uv = point.start.xy + vec2(-offset.x, offset.y);
  if (waterLookup == 3) // the point itself is moved
  {
    vec4 moved = waterDirToMap * vec4(waterOffsetScale * point.normal.xy, 0.0, 0.0);
    uv = 0.5 + 0.5 * ((2.0 * point.start.xy - 1.0) * point.startW + moved.xy) /
        (point.startW + moved.w);
  }
  return uv;
}

vec3 waterReflected(WaterPoint point, out int reason, out vec2 uv)
{
  uv = waterOffsetPlace(point);
  reason = 1;
  return textureLod(waterReflection, uv, 0.0).rgb;
}

// How much of the light from a direction something keeps off, as far as the map shows it.
float waterShaded(WaterPoint point, vec3 dir)
{
  return 0.0;
}

// What one of several facets sees: a place of the map, or a colour.
//
// Returns whether it is a place.
bool waterFacetSees(WaterPoint point, out vec2 uv, out vec3 color)
{
  uv = waterOffsetPlace(point);
  color = vec3(0.0);
  return true;
}

// Places of the map with their shares, blurred over their distance: several sharp images would be
// seen as several.
vec3 waterBlurred(WaterPlaces places, int count)
{
  vec3 blurred = vec3(0.0);
  float level = 0.0;
  for (int i = 0; i < count; ++i)
  {
    if (i == 0)
    {
      vec2 apart = (waterPlaceOf(places, count - 2) - waterPlaceOf(places, count - 1)) /
        float(count - 1);
      level = log2(max(0.3 * length(apart * vec2(textureSize(waterReflection, 0))), 1.0));
    }
    float share = dot(places.shares, vec4(equal(vec4(i), vec4(0.0, 1.0, 2.0, 3.0))));
    blurred += share * textureLod(waterReflection, waterPlaceOf(places, i), level).rgb;
  }
  return blurred;
}
