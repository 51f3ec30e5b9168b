// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPlainFS.glsl: in place of all slots: the plain colour, when the driver refuses the rest.

uniform vec3 waterDeepColor;
uniform float waterOpacity;

#include "vtkWaterDataColor.glsl"

void waterShade(inout vec4 color)
{
  color = vec4(mix(waterDeepColor, waterDataColor.rgb, waterDataColor.a), waterOpacityOf(color) * waterOpacity);
}
