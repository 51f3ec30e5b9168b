// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterWavesFS.glsl: stage waves: sine and Gerstner waves; water_waves.c for the shader.
// Needs vtkWaterFlatFS.glsl, vtkWaterPointFS.glsl before it.

uniform sampler2D waterWaves; // a row per wave: (kx, ky, amplitude, phase), (steepness, 0, 0, 0)
uniform int waterWaveCount;
uniform int waterRestSteps; // steps to the point at rest; 0 for sines in the plane: not moved

// dz/dx and dz/dy over a place in the plane's axes.
//
// across, down  change of the place from pixel to pixel: of a wave that is short against them the
//               pixel sees the mean slope. A Gaussian that falls as the mean over a box does.
// ray           the view ray, the third along the plane's own normal
vec2 waterSlope(vec2 place, vec2 across, vec2 down, vec3 ray)
{
  vec2 rest = place;
  float height = 0.0;
  vec2 gradient = vec2(0.0);
  vec3 stretch = vec3(1.0, 0.0, 1.0); // d place / d rest: xx, xy, yy
  for (int step = 0; step <= waterRestSteps; ++step)
  {
    vec2 moved = vec2(0.0);
    height = 0.0;
    gradient = vec2(0.0);
    stretch = vec3(1.0, 0.0, 1.0);
    for (int i = 0; i < waterWaveCount; ++i)
    {
      vec4 wave = texelFetch(waterWaves, ivec2(0, i), 0);
      float steepness = texelFetch(waterWaves, ivec2(1, i), 0).x;
      vec2 k = wave.xy;
      vec2 turn = vec2(dot(k, across), dot(k, down));
      float seen = wave.z * exp(-dot(turn, turn) / 24.0);
      float angle = dot(k, rest) + wave.w;
      float moving = waterMoving(wave.z, seen, k);
      vec2 bend = seen * vec2(sin(angle), cos(angle));
      float perK = steepness * inversesqrt(dot(k, k));
      gradient += bend.y * k;
      moved += perK * moving * cos(angle) * k;
      height += moving * sin(angle);
      stretch -= perK * bend.x * vec3(k.x * k.x, k.x * k.y, k.y * k.y);
    }
    if (step < waterRestSteps)
    {
      float area = max(stretch.x * stretch.z - stretch.y * stretch.y, 1e-3);
      vec3 normal = vec3(stretch.y * gradient.y - stretch.z * gradient.x,
        stretch.y * gradient.x - stretch.x * gradient.y, area);
      vec2 miss = waterMiss(vec3(rest + moved - place, height), normal, ray, waterSide);
      rest -= vec2(stretch.z * miss.x - stretch.y * miss.y,
                stretch.x * miss.y - stretch.y * miss.x) / area;
    }
  }
  // from slopes per point at rest to slopes per place
  float area = max(stretch.x * stretch.z - stretch.y * stretch.y, 1e-6);
  return vec2(stretch.z * gradient.x - stretch.y * gradient.y,
           stretch.x * gradient.y - stretch.y * gradient.x) / area;
}

void waterRipple(inout WaterPoint point)
{
  vec2 slope = waterSlope(point.place, point.across, point.down,
    vec3(point.ray.xy, waterSide * point.ray.z));
  point.normal = normalize(vec3(-waterSide * slope, 1.0));
}
