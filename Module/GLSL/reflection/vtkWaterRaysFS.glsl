// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterRaysFS.glsl: slot rays: a pixel has several rays where its neighbour within two by two pixels shows another
// reflection: most of what one ray gets wrong is at edges.

uniform int waterRays;          // of such a pixel
uniform float waterRayContrast; // how much another

const int WATER_FEW_RAYS = 4; // more than these look for edges within each pixel, too
const float WATER_NEARLY_SMOOTH = 2e-4; // waterSmooth of several rays, which are marched; facets are not
const float WATER_BLURRED = 1e-3; // slope variance from which a pixel's facets are blurred so far that it has no edges

// Place of one of so many rays in its pixel, from the middle: the first is there, of the others no two are in one row or
// column, and the first two of them are far apart.
vec2 waterRayPlace(int ray, int rays)
{
  int other = ray == rays ? 2 : ray;
  float number = float(ray == 2 ? rays : other) - 0.5;
  return ray == 0 ? vec2(0.0) : vec2(number / float(rays), fract(0.618034 * number)) - 0.5;
}

// What a pixel reflects, as waterFacets, which it is where neighbours are alike. Reason and place are the middle's.
//
// One loop for the first ray and the others: software renderers execute all that stands beside it. Derivatives are
// taken of the first, while all pixels are in it.
vec3 waterMirrored(WaterPoint point, out float reflectance, inout int reason, inout vec2 uv)
{
  waterReadOnce();
  waterLookCalm(point.start);
  WaterPointChange across = waterChangeAcross(point);
  WaterPointChange down = waterChangeDown(point);
  vec4 sum = vec4(0.0); // and the reflectance
  vec3 low = vec3(1e30); // of what the rays of this pixel have seen
  vec3 high = vec3(-1e30);
  bool areSeveral = waterRays > 1; // which see what changes evenly
  point.variance.xy = max(point.variance.xy - (areSeveral ? point.even : vec2(0.0)), vec2(0.0));
  waterSmooth = areSeveral ? WATER_NEARLY_SMOOTH : waterSmooth;
  bool isRough = point.variance.x + point.variance.y > WATER_BLURRED;
  bool areMany = waterRays > WATER_FEW_RAYS;
  bool mayBeEdge = areSeveral && !isRough;
  int sure = areMany && !isRough ? 2 : 0; // rays beside the first that look for an edge in the pixel
  int last = sure;
  int ray = 0;
  do
  {
    WaterPoint at = waterMovedPoint(point, waterRayPlace(ray, waterRays), across, down);
    vec4 seen;
    int why = reason;
    vec2 where = uv;
    seen.rgb = waterFacets(at, seen.a, why, where);
    low = min(low, seen.rgb);
    high = max(high, seen.rgb);
    bool isFirst = ray == 0;
    vec3 change = max(isFirst ? max(abs(dFdx(seen.rgb)), abs(dFdy(seen.rgb))) : vec3(0.0), high - low);
    bool isEdge = mayBeEdge && max(change.r, max(change.g, change.b)) > waterRayContrast;
    last = isEdge && ray <= sure ? waterRays : last;
    reason = isFirst ? why : reason;
    uv = isFirst ? where : uv;
    sum += isFirst && last > 0 ? vec4(0.0) : seen;
    ++ray;
  } while (ray <= last);
  sum /= float(max(last, 1));
  reflectance = sum.a;
  return sum.rgb;
}
