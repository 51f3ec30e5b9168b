// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterDomeFS.glsl: slot dome of a reflection texture in which a mesh may be the sky: its alpha is 0 where nothing was
// drawn.

const float WATER_DRAWN = 0.02; // share of a filtered texel below which its colour is rounding

vec4 waterCalm = vec4(0.0); // what the reflection texture has for calm water

void waterLookCalm(vec3 start)
{
  waterCalm = textureLod(waterReflection, start.xy, 0.0);
}

// The colour of what was drawn at a place of the reflection texture. A filtered texel at a dome's rim has a share of the
// background, which no ray sees: it is taken out. Where nothing was drawn, the place is under the rim, and calm water
// shows the dome; or the sky is open, and calm water shows nothing either.
vec3 waterDrawn(vec4 texel, vec3 background)
{
  vec3 drawn = max(texel.rgb - (1.0 - texel.a) * background, vec3(0.0)) / max(texel.a, WATER_DRAWN);
  vec3 without = waterCalm.a > 0.5 ? waterCalm.rgb : background;
  return texel.a < WATER_DRAWN ? without : drawn;
}
