// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSkyDomeFS.glsl: slot dome of a reflection texture in which a mesh may be the sky, which has a view of its own,
// too (vtkWaterSkyViewFS.glsl).

const float WATER_DRAWN = 0.02; // as in vtkWaterDomeFS.glsl

vec4 waterCalm = vec4(0.0); // what the reflection texture has for calm water

void waterLookCalm(vec3 start)
{
  waterCalm = textureLod(waterReflection, start.xy, 0.0);
}

// As in vtkWaterDomeFS.glsl; but what a ray sees where nothing was drawn is not what was cleared there.
vec3 waterDrawn(vec4 texel, vec3 background)
{
  vec3 drawn = max(texel.rgb - (1.0 - texel.a) * waterSkyBottom.rgb, vec3(0.0)) / max(texel.a, WATER_DRAWN);
  vec3 without = waterCalm.a > 0.5 ? waterCalm.rgb : background;
  return texel.a < WATER_DRAWN ? without : drawn;
}
