// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterShaftsFS.glsl: slot shafts: the light that waves gather, in the water before an eye in it and on what lies
// there; water_shafts.h for the shader. Also of the fog (vtkWaterFogFS.glsl).
//
// No step is random: each scatters the same light in calm water, and sees the mean of the texture over its length.

uniform float waterShafts;         // share of the light, 0 to 1
uniform int waterShaftSteps;       // 0: there are none
uniform sampler2D waterShaftLight; // over that of calm water, around the eye
uniform vec3 waterShaftPlace;      // factor and offsets: place on the plane -> that texture
uniform vec2 waterShaftFade;       // squared distances from its middle
uniform vec2 waterShaftWay;        // horizontal displacement of light in calm water, per depth
uniform float waterShaftDepth;     // of the eye

// Light on a place before the eye, over that of calm water.
//
// ray   unit length, in the plane's axes: the third points down
// way   m
// wide  m along the ray: the mean over it
float waterShaftAt(vec3 ray, float way, float wide)
{
  float depth = waterShaftDepth + way * ray.z;
  vec2 uv = waterShaftPlace.x * (way * ray.xy - depth * waterShaftWay) + waterShaftPlace.yz;
  float across = waterShaftPlace.x * wide * length(ray.xy - ray.z * waterShaftWay) * float(textureSize(waterShaftLight, 0).x);
  float light = textureLod(waterShaftLight, uv, log2(max(across, 1.0))).r;
  vec2 off = uv - 0.5;
  float kept = 1.0 - smoothstep(waterShaftFade.x, waterShaftFade.y, dot(off, off));
  return 1.0 + waterShafts * kept * clamp(depth / waterShaftDepth, 0.0, 1.0) * (light - 1.0);
}

// Light on what lies at the end of a way.
float waterShaftEnd(vec3 ray, float way)
{
  return waterShaftSteps > 0 ? waterShaftAt(ray, way, 0.0) : 1.0;
}

// Light that is scattered into a way, over that of calm water: its steps are weighted by what each scatters.
vec3 waterShaftsAlong(vec3 ray, float way)
{
  float least = max(min(min(waterExtinction.r, waterExtinction.g), waterExtinction.b), 1e-3 / min(way, 1e6));
  vec3 sum = vec3(0.0);
  vec3 all = vec3(0.0);
  float from = 0.0;
  for (int i = 0; i < waterShaftSteps; ++i)
  {
    float middle = waterScatteredAt(least, way, (float(i) + 0.5) / float(waterShaftSteps));
    float to = waterScatteredAt(least, way, (float(i) + 1.0) / float(waterShaftSteps));
    vec3 scattered = vec3(waterScattered(waterExtinction.r, from, to), waterScattered(waterExtinction.g, from, to),
      waterScattered(waterExtinction.b, from, to));
    sum += scattered * waterShaftAt(ray, middle, to - from);
    all += scattered;
    from = to;
  }
  return mix(vec3(1.0), sum / max(all, vec3(1e-12)), greaterThan(all, vec3(1e-12)));
}
