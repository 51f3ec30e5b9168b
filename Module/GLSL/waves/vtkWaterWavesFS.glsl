// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterWavesFS.glsl: slot waves: sine and Gerstner waves; water_waves.c for the shader.

uniform sampler2D waterWaves; // a row per wave: (kx, ky, amplitude, phase), (steepness, 0, 0, 0)
uniform int waterWaveCount;
uniform int waterRestSteps; // steps to the point at rest; 0 for sines in the plane: not moved

// How far a wave turns over a pixel, squared: it changes evenly over the pixel up to the first, in rad2, and
// not at all evenly from the second on. Source: measured, Documentation/decisions/006-lookup.md.
const vec2 WATER_EVEN = vec2(1.0, 6.0);

// Of the last place: of the slope variances within the pixel, those of such waves; the slope by the point at
// rest, and d place / d rest (xx, xy, yy).
vec2 waterEven = vec2(0.0);
float waterBoth = 0.0; // covariance xy of the slopes of which the variances are not seen, or within the pixel
vec2 waterGradient = vec2(0.0);
vec3 waterBent = vec3(1.0, 0.0, 1.0);

// The part of a wave's variance within the pixel that is even.
float waterEvenPart(vec2 turn)
{
  return 1.0 - smoothstep(WATER_EVEN.x, WATER_EVEN.y, dot(turn, turn));
}

// The slope of waterSlope where all waves are sines in the plane.
vec2 waterSineSlope(vec2 place, vec2 across, vec2 down, inout vec4 variance)
{
  vec2 gradient = vec2(0.0);
  vec2 unseen = vec2(0.0);
  waterEven = vec2(0.0);
  waterBoth = 0.0;
  for (int i = 0; i < waterWaveCount; ++i)
  {
    vec4 wave = texelFetch(waterWaves, ivec2(0, i), 0);
    vec2 turn = vec2(dot(wave.xy, across), dot(wave.xy, down));
    float part = exp(-dot(turn, turn) / 24.0);
    vec2 steep = wave.z * wave.xy;
    float left = 0.5 * (1.0 - part * part);
    vec2 within = left * steep * steep;
    unseen += within;
    waterBoth += left * steep.x * steep.y;
    waterEven += waterEvenPart(turn) * within;
    gradient += part * cos(dot(wave.xy, place) + wave.w) * steep;
  }
  variance.xy += unseen;
  return gradient;
}

// dz/dx and dz/dy over a place in the plane's axes.
//
// across, down  change of the place from pixel to pixel: of a wave that is short against them the
//               pixel sees the mean slope. A Gaussian that falls as the mean over a box does.
// variance      the rest of the wave's variance is added to the first two, as in WaterPoint
// jacobian       area over that at rest
// ray           the view ray, the third along the plane's own normal; 0: not a place of the pixel
//
// Long because all of its sums change in one loop: software renderers go through a loop once at least.
vec2 waterSlope(
  vec2 place, vec2 across, vec2 down, vec3 ray, inout vec4 variance, out float jacobian)
{
  if (waterRestSteps == 0)
  {
    jacobian = 1.0;
    waterBent = vec3(1.0, 0.0, 1.0);
    waterGradient = waterSineSlope(place, across, down, variance);
    return waterGradient;
  }
  vec2 rest = place;
  float height = 0.0;
  vec2 gradient = vec2(0.0);
  vec2 unseen = vec2(0.0);
  vec3 bent = vec3(1.0, 0.0, 1.0); // d place / d rest: xx, xy, yy
  for (int step = 0; step <= waterRestSteps; ++step)
  {
    vec2 moved = vec2(0.0);
    height = 0.0;
    gradient = vec2(0.0);
    unseen = vec2(0.0);
    waterEven = vec2(0.0);
    waterBoth = 0.0;
    bent = vec3(1.0, 0.0, 1.0);
    for (int i = 0; i < waterWaveCount; ++i)
    {
      vec4 wave = texelFetch(waterWaves, ivec2(0, i), 0);
      float steepness = texelFetch(waterWaves, ivec2(1, i), 0).x;
      vec2 k = wave.xy;
      vec2 turn = vec2(dot(k, across), dot(k, down));
      float part = exp(-dot(turn, turn) / 24.0);
      float seen = wave.z * part;
      float left = 0.5 * (1.0 - part * part) * wave.z * wave.z;
      vec2 within = left * k * k;
      unseen += within;
      waterBoth += left * k.x * k.y;
      waterEven += waterEvenPart(turn) * within;
      float angle = dot(k, rest) + wave.w;
      float moving = waterMoving(wave.z, seen, k);
      vec2 bend = seen * vec2(sin(angle), cos(angle));
      float perK = steepness * inversesqrt(dot(k, k));
      gradient += bend.y * k;
      moved += perK * moving * cos(angle) * k;
      height += moving * sin(angle);
      bent -= perK * bend.x * vec3(k.x * k.x, k.x * k.y, k.y * k.y);
    }
    if (step < waterRestSteps)
    {
      float area = max(bent.x * bent.z - bent.y * bent.y, 1e-3);
      vec3 normal = vec3(bent.y * gradient.y - bent.z * gradient.x,
        bent.y * gradient.x - bent.x * gradient.y, area);
      vec3 off = vec3(rest + moved - place, height);
      vec2 miss = dot(ray, ray) > 0.0 ? waterMiss(off, normal, ray, waterSide) : off.xy;
      rest -= vec2(bent.z * miss.x - bent.y * miss.y,
                bent.x * miss.y - bent.y * miss.x) / area;
    }
  }
  variance.xy += unseen;
  waterGradient = gradient;
  waterBent = bent;
  // from slopes per point at rest to slopes per place
  jacobian = max(bent.x * bent.z - bent.y * bent.y, 1e-6);
  return vec2(bent.z * gradient.x - bent.y * gradient.y,
           bent.x * gradient.y - bent.y * gradient.x) / jacobian;
}
