// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterOpenFS.glsl: slot ground of open water: what meets nothing is deep water.

uniform int waterSceneIsOwnView; // 1: what is seen is the own view of what lies below

const float WATER_MEDIUM_SLIVER_PX = 3.0; // at most so wide

// What something over the water hides is deep water, too. The far side of an object is seen at most in slivers, between
// the background and what is over the water: rays from beyond that meet them would be specks.
void waterMediumGuess(WaterPoint point, vec3 dir, WaterMediumRay ray, float most, inout WaterMediumMet met)
{
  bool isPicture = waterSide > 0.0 && waterSceneIsOwnView == 0;
  vec2 pixel = ray.way.xy / max(length(ray.way.xy * waterMediumSize()), 1e-6);
  vec2 end = ray.start.xy + most / max(ray.w + most * ray.rate, 1e-6) * ray.way.xy;
  vec2 after = met.view.isHidden ? end : met.view.from + WATER_MEDIUM_SLIVER_PX * pixel;
  float depth = waterMediumDepth(after);
  bool isOver = depth < 1.0 && waterMediumHeight(after, depth) > 0.0;
  bool isSliver = !met.view.isHidden && isOver && waterMediumDepth(waterMediumPlace(point.ndc)) >= 1.0;
  bool isHidden = met.view.isHidden ? isOver : !met.view.isMet && met.depth >= 1.0;
  met.isNothing = met.isNothing || (isPicture && (isHidden || isSliver));
}
