// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPlainFS.glsl: in place of all slots: the plain colour, when the driver refuses the rest.

uniform vec3 waterDeepColor;
uniform float waterOpacity;

void waterShade(inout vec4 color)
{
  color = vec4(waterDeepColor, color.a * waterOpacity);
}
