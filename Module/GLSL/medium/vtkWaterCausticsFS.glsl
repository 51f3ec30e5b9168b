// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterCausticsFS.glsl: slot caustics: the light that waves gather on what lies under them, from a texture over
// the picture (vtkWaterCaustics).
//
// A place under water is known by the place of the surface that would light it in calm water, whatever its depth. The
// texture has the light for the depth of the bed. What stands on the bed is lit alike, less gathered the nearer it is to
// the surface.

uniform float waterCaustics;          // strength, 0 to 1
uniform sampler2D waterCausticLight;  // over that of calm water
uniform sampler2D waterBed;           // its depth under water, over the picture
uniform vec4 waterCausticTexel;       // NDC at the middle depth -> a place in it, texels
uniform float waterCausticMiddle;     // that depth
uniform vec3 waterCausticNear;        // (NDC, 1) -> 1: the pixel is too wide for caustics, 2: it is not
uniform vec2 waterCalmWay;            // horizontal displacement of light in calm water, per depth

const float WATER_CAUSTIC_BEYOND = 0.03; // of the texture's size: so far beyond its border light is that of calm water
const float WATER_CAUSTIC_BED = 0.8; // what is that share as deep as the bed is of it: the bed is known roughly

// Light on a place under water, over that of calm water.
//
// ndc    where it is, for the eye; may lie beyond the picture's border
// w      of that in view space
// depth  under water
// pixel  that sees it, NDC
float waterCaustic(vec2 ndc, float w, float depth, vec2 pixel)
{
  float bed = textureLod(waterBed, 0.5 + 0.5 * ndc, 0.0).r;
  vec4 down = (waterCausticMiddle - depth) * (waterDirToEye * vec4(waterCalmWay, -1.0, 0.0));
  vec2 texel = (ndc * w + down.xy) / max(w + down.w, 1e-6) * waterCausticTexel.xy + waterCausticTexel.zw;
  float gathered = clamp(depth / max(WATER_CAUSTIC_BED * bed, 1e-6), 0.0, 1.0);
  float share = waterCaustics * gathered * smoothstep(1.0, 2.0, dot(waterCausticNear, vec3(pixel, 1.0)));
  vec2 uv = texel / vec2(textureSize(waterCausticLight, 0));
  vec2 beyond = max(abs(uv - 0.5) - 0.5, vec2(0.0));
  share *= 1.0 - smoothstep(0.0, WATER_CAUSTIC_BEYOND, max(beyond.x, beyond.y));
  return 1.0 + share * (textureLod(waterCausticLight, uv, 0.0).r - 1.0);
}

bool waterHasCaustics()
{
  return true;
}
