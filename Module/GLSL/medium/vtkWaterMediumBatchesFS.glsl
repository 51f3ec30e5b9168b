// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMediumBatchesFS.glsl: slot refraction for hardware: as vtkWaterMediumWalkFS.glsl, with eight looks at the
// picture at once, since hardware waits hundreds of cycles for each; they are tested in their order.

// Depths of the picture at the steps from one on.
vec4 waterMediumReadSteps(vec3 start, vec3 way, vec4 at)
{
  return vec4(waterMediumDepth(start.xy + at.x * way.xy), waterMediumDepth(start.xy + at.y * way.xy),
    waterMediumDepth(start.xy + at.z * way.xy), waterMediumDepth(start.xy + at.w * way.xy));
}

void waterMediumTest(float at, float rayDepth, float depth, inout WaterMediumHit found)
{
  bool isBehind = rayDepth > depth;
  found.high = isBehind ? at : found.high;
  found.depthHigh = isBehind ? depth : found.depthHigh;
  found.low = isBehind ? found.low : at;
  found.depthLow = isBehind ? found.depthLow : depth;
  found.isHit = found.isHit || isBehind;
}

void waterMediumTestSteps(vec3 start, vec3 way, vec4 at, vec4 depths, inout WaterMediumHit found)
{
  for (int i = 0; i < 4; ++i)
  {
    if (!found.isHit)
    {
      waterMediumTest(at[i], start.z + at[i] * way.z, depths[i], found);
    }
  }
}

// Halves the step of a hit four times, each time with both of the next middles.
void waterMediumHalve(vec3 start, vec3 way, inout WaterMediumHit found)
{
  for (int i = 0; i < 2; ++i)
  {
    float middle = 0.5 * (found.low + found.high);
    float lower = 0.5 * (found.low + middle);
    float upper = 0.5 * (middle + found.high);
    float depth = waterMediumDepth(start.xy + middle * way.xy);
    float depthLower = waterMediumDepth(start.xy + lower * way.xy);
    float depthUpper = waterMediumDepth(start.xy + upper * way.xy);
    float rayDepth = start.z + middle * way.z;
    bool isLower = rayDepth > depth;
    waterMediumTest(middle, rayDepth, depth, found);
    float next = isLower ? lower : upper;
    waterMediumTest(next, start.z + next * way.z, isLower ? depthLower : depthUpper, found);
  }
}

WaterMediumHit waterMediumWalk(vec3 start, vec3 way, float depth, float reach)
{
  WaterMediumHit found = WaterMediumHit(0.0, reach, depth, depth, false);
  for (int first = 1; first <= WATER_MEDIUM_STEPS && !found.isHit; first += 8)
  {
    vec4 steps = vec4(float(first)) + vec4(0.0, 1.0, 2.0, 3.0);
    vec4 near = reach * steps / float(WATER_MEDIUM_STEPS);
    vec4 far = reach * (steps + 4.0) / float(WATER_MEDIUM_STEPS);
    vec4 depthsNear = waterMediumReadSteps(start, way, near);
    vec4 depthsFar = waterMediumReadSteps(start, way, far);
    waterMediumTestSteps(start, way, near, depthsNear, found);
    waterMediumTestSteps(start, way, far, depthsFar, found);
  }
  if (found.isHit)
  {
    waterMediumHalve(start, way, found);
  }
  return found;
}
