// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFoamFS.glsl: slot foam: at the shore and on crests.

uniform vec3 waterFoamColor;
uniform float waterFoamDepth;    // depth of water over which the shore's foam ends; 0: none
uniform float waterFoamJacobian; // crests are foam where their points stand closer than that; 0: none
uniform vec2 waterPatternOrigin; // of the foam's pattern, m, from the point under the eye
uniform float waterFoamUnit;     // m per unit of the scene

// A number in [0, 1] for a cell of a grid.
float waterHash(vec2 cell)
{
  vec2 p = fract(cell * vec2(0.1031, 0.1030));
  p += dot(p, p.yx + 33.33);
  return fract((p.x + p.y) * p.x * p.y * 8.0 + p.x);
}

float waterNoise(vec2 place)
{
  vec2 cell = floor(place);
  vec2 t = place - cell;
  t = t * t * (3.0 - 2.0 * t);
  cell = mod(cell, 256.0);
  vec2 next = mod(cell + 1.0, 256.0);
  return mix(mix(waterHash(cell), waterHash(vec2(next.x, cell.y)), t.x),
    mix(waterHash(vec2(cell.x, next.y)), waterHash(next), t.x), t.y);
}

// How much of a pixel is foam, in [0, 1].
float waterFoamShare(WaterPoint point)
{
  float share = 0.0;
  if (waterFoamDepth > 0.0)
  {
    float depth = waterTransmittedDepth(point);
    share = 1.0 - clamp(depth / waterFoamDepth, 0.0, 1.0);
  }
  if (waterFoamJacobian > 0.0)
  {
    share = max(share, clamp(2.0 - 2.0 * point.jacobian / waterFoamJacobian, 0.0, 1.0));
  }
  // bubbles: what is shorter than two pixels is their mean
  vec2 place = waterFoamUnit * point.place + waterPatternOrigin;
  float pixel = waterFoamUnit * max(length(point.across), length(point.down));
  float bubbles = 0.5;
  float weight = 0.5;
  for (float size = 1.0; size > 0.05; size *= 0.5, weight *= 0.6)
  {
    bubbles += weight * (waterNoise(place / size) - 0.5) * clamp(size / pixel - 1.0, 0.0, 1.0);
  }
  return clamp(smoothstep(0.0, 1.0, 2.0 * share - 1.0 + bubbles), 0.0, 1.0) * step(1e-4, share);
}

// Lays foam over the surface's color.
//
// sun  light of the sun that arrives
void waterFoam(WaterPoint point, vec3 sun, inout vec3 rgb)
{
  vec3 light = 0.35 + 0.65 * sun * clamp(dot(point.normal, waterSunDir) * waterSide, 0.0, 1.0);
  rgb = mix(rgb, waterFoamColor * light, waterFoamShare(point));
}
