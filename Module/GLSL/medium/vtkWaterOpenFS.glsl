// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterOpenFS.glsl: slot ground of open water: what meets nothing is deep water.

const float WATER_MEDIUM_SLIVER_PX = 3.0; // at most so wide

// Is the background seen within a few pixels before a place?
//
// pixel  of the ray's way
bool waterMediumIsAfterBackground(vec2 uv, vec2 pixel)
{
  vec3 depths = vec3(waterMediumDepth(uv - pixel), waterMediumDepth(uv - 2.0 * pixel),
    waterMediumDepth(uv - WATER_MEDIUM_SLIVER_PX * pixel));
  return max(depths.x, max(depths.y, depths.z)) >= 1.0;
}

// What something over the water hides is deep water, too. The far side of an object is seen at most in slivers, between
// the background and what is over the water: rays that meet them would be specks.
void waterMediumGuess(WaterPoint point, vec3 dir, WaterMediumRay ray, float most, inout WaterMediumMet met)
{
  bool isPicture = waterSide > 0.0 && waterSceneScale.x >= 1.0; // and not the own view
  vec2 pixel = ray.way.xy / max(length(ray.way.xy * waterMediumSize()), 1e-6);
  vec2 end = ray.start.xy + most / max(ray.w + most * ray.rate, 1e-6) * ray.way.xy;
  vec2 after = met.view.isHidden ? end : met.view.from + WATER_MEDIUM_SLIVER_PX * pixel;
  float depth = waterMediumDepth(after);
  bool isOver = depth < 1.0 && waterMediumHeight(after, depth) > 0.0;
  bool isSliver = !met.view.isHidden && isOver && waterMediumIsAfterBackground(met.view.from, pixel);
  bool isHidden = met.view.isHidden ? isOver : !met.view.isMet && met.depth >= 1.0;
  met.isNothing = met.isNothing || (isPicture && (isHidden || isSliver));
}
