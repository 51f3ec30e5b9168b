// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterOpenFS.glsl: slot ground of open water: what meets nothing is deep water.

uniform int waterSceneIsOwnView;     // 1: what is seen is the own view of what lies below
uniform sampler2D waterPictureDepth; // window depth of the picture, also if that is not what is seen

const float WATER_MEDIUM_SLIVER_PX = 3.0; // at most so wide

// Does something over the water stand where the picture has a place of the own view?
bool waterMediumIsBehindLand(vec2 uv)
{
  vec2 place = 0.5 + (uv - 0.5) / waterSceneScale;
  float depth = textureLod(waterPictureDepth, place, 0.0).r;
  return place == clamp(place, 0.0, 1.0) && depth < 1.0 && waterMediumHeight(uv, depth) > 0.0;
}

// What something over the water hides is deep water, too, unless a bed is seen straight. The far side of an object is seen
// at most in slivers, between the background and what is over the water: rays from beyond that meet them would be specks.
//
// The own view is cut at the plane. Through the opening that this leaves in an island the eye sees the slope beyond from
// inside, in a few dark rows, and the background below. A ray that ends there has met that slope: what is seen straight is
// the same, further down.
void waterMediumGuess(WaterPoint point, vec3 dir, WaterMediumRay ray, float most, inout WaterMediumMet met)
{
  bool isPicture = waterSide > 0.0 && waterSceneIsOwnView == 0;
  vec2 pixel = ray.way.xy / max(length(ray.way.xy * waterMediumSize()), 1e-6);
  vec2 end = ray.start.xy + most / max(ray.w + most * ray.rate, 1e-6) * ray.way.xy;
  vec2 after = met.view.isHidden ? end : met.view.from + WATER_MEDIUM_SLIVER_PX * pixel;
  float depth = waterMediumDepth(after);
  vec2 straight = waterMediumMiddle(waterMediumPlace(point.ndc));
  float straightDepth = waterMediumDepth(straight);
  float height = waterMediumHeight(straight, straightDepth);
  bool isBed = straightDepth < 1.0 && height < 0.0;
  bool isOver = depth < 1.0 && waterMediumHeight(after, depth) > 0.0;
  bool isSliver = !met.view.isHidden && isOver && straightDepth >= 1.0;
  bool isHidden = met.view.isHidden ? isOver : !met.view.isMet && met.depth >= 1.0;
  met.isNothing = met.isNothing || (isPicture && !isBed && (isHidden || isSliver));

  bool isLost = met.depth >= 1.0 || !(met.view.isMet || met.view.isHidden);
  if (waterSide > 0.0 && !isPicture && isLost && isBed && waterMediumIsBehindLand(met.view.from))
  {
    met.view = WaterMediumView(true, met.view.s, straight, straight, 0.0, false, false, false);
    met.depth = straightDepth;
    met.way = height / dir.z;
    met.isNothing = false;
  }
}
