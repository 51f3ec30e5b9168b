// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterWhitecapsFS.glsl: slot whitecaps: how much of a pixel of a wind sea is white; water_whitecap.h for the
// shader.

uniform vec2 waterWhitecaps; // the Jacobian to first order under which the sea is white; variance over which it turns so

const float WATER_LEAST_WHITE = 1e-4; // of a pixel: what is less is not seen

// Share of a normal distribution below a number.
// Source: Page 1977, "Approximations to the Cumulative Normal Function and its Inverse".
float waterShareBelow(float number)
{
  float x = clamp(number, -6.0, 6.0);
  return 1.0 / (1.0 + exp(-x * (1.5976 + 0.07056 * x * x)));
}

// What a pixel does not resolve of the slopes it does not resolve of the Jacobian either: they have the
// same variance.
float waterWhitecap(WaterPoint point)
{
  float unseen = dot(point.variance, vec4(1.0));
  float share = waterShareBelow((waterWhitecaps.x - waterFirstOrder) * inversesqrt(unseen + waterWhitecaps.y));
  return share > WATER_LEAST_WHITE ? share : 0.0;
}
