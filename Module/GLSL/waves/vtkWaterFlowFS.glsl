// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFlowFS.glsl: slot flow: a current carries the waves; water_flow.c for the shader.

in vec2 waterFlowVSOutput;      // way in a period, along the plane's axes
uniform vec3 waterFlowLayers;   // shares of the period that the layers have gone; weight of the first
uniform float waterFlowLikeness; // distance over which slopes become unlike
uniform vec4 waterFlowBands[3];  // longest and shortest waves of a wind sea's tiles, rad/unit
uniform float waterFootprint; // share of the pixel's sides that slopes are means over; 0: those of the pixel's middle

const float WATER_FLOW_SEEN = 2.0; // rad/pixel, of the shortest waves that are seen

vec2 waterAllSlopes(vec2 place, vec2 across, vec2 down, vec3 ray, inout vec4 variance, out float jacobian);

// The slopes of a layer that has gone so much of a period. Where the current changes from place to place it stretches
// the waves, and turns them.
vec2 waterCarriedSlopes(
  WaterPoint point, float gone, vec2 flowAcross, vec2 flowDown, vec3 ray, inout vec4 variance, out float jacobian)
{
  vec2 slope = waterAllSlopes(point.place - gone * waterFlowVSOutput, waterFootprint * (point.across - gone * flowAcross),
    waterFootprint * (point.down - gone * flowDown), ray, variance, jacobian);
  // from slopes where the layer was at rest to slopes where it is now
  float area = point.across.x * point.down.y - point.across.y * point.down.x;
  float perArea = abs(area) > 1e-30 ? gone / area : 0.0;
  vec2 alongX = perArea * (flowAcross * point.down.y - flowDown * point.across.y); // change of the way along x, and y
  vec2 alongY = perArea * (flowDown * point.across.x - flowAcross * point.down.x);
  return slope - vec2(dot(alongX, slope), dot(alongY, slope));
}

// Each tile of a wind sea keeps the variance of its own waves; over is the gain that all waves get besides.
void waterFlowSeaGains(WaterPoint point, float weight, float apart, float over)
{
  float pixel = max(length(point.across), length(point.down));
  for (int i = 0; i < 3; ++i)
  {
    vec2 band = waterFlowBands[i].xy;
    float last = max(min(band.y, WATER_FLOW_SEEN / pixel), 1.01 * band.x);
    waterSeaGains[i] = waterFlowBandGain(weight, apart, band.x, last) / over;
  }
}

// As waterAllSlopes at the pixel's own place.
vec2 waterFlowingSlopes(WaterPoint point, vec3 ray, inout vec4 variance, out float jacobian)
{
  vec2 flowAcross = dFdx(waterFlowVSOutput);
  vec2 flowDown = dFdy(waterFlowVSOutput);
  float weight = waterFlowLayers.z;
  float apart = 0.5 * length(waterFlowVSOutput); // half a period
  float gain = waterFlowGain(weight, apart, waterFlowLikeness);
  waterFlowSeaGains(point, weight, apart, gain);
  vec4 otherVariance = variance;
  float otherJacobian;
  vec2 other =
    waterCarriedSlopes(point, waterFlowLayers.y, flowAcross, flowDown, ray, otherVariance, otherJacobian);
  vec2 slope = waterCarriedSlopes(point, waterFlowLayers.x, flowAcross, flowDown, ray, variance, jacobian);
  // in this form two layers of the same slopes give just these
  variance = otherVariance + weight * (variance - otherVariance);
  jacobian = otherJacobian + weight * (jacobian - otherJacobian);
  return gain * (other + weight * (slope - other));
}
