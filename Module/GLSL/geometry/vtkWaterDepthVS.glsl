// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterDepthVS.glsl: keeps an endless surface from being cut at the near plane, and at the far plane: what is nearer or
// farther is drawn with their depths, or close to them (water_horizon_depths). The sheet has corners, and a grid has a row,
// where it meets these planes, so that it bends nowhere else.

uniform vec3 waterHorizonDepths; // y 0: the surface has an end, and is cut

void waterKeepDepth(inout vec4 position)
{
  if (waterHorizonDepths.y > 0.0)
  {
    float w = position.w;
    float z = position.z;
    float first = waterHorizonDepths.y * w;
    // also behind the eye, where w is negative
    float nearer = z < -w ? -w - waterHorizonDepths.x * w * w / z : max(z, (waterHorizonDepths.x - 1.0) * w);
    position.z = w > 0.0 && z > first ? first + waterHorizonDepths.z * (z - first) : nearer;
  }
}
