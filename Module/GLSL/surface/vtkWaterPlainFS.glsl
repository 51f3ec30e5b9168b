// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPlainFS.glsl: in place of all slots: the plain colour, when the driver refuses the rest.

uniform vec3 waterDeepColor;
uniform float waterOpacity;

uniform float waterDataOpacity;
uniform float waterDataGain; // of ambient and diffuse light together
vec4 waterDataColor = vec4(0.0);

// Where the mapper shows scalars: their colour, and the opacity that the lookup table gives it.
void waterTakeData(vec3 color, float opacity)
{
  waterDataColor = vec4(color / max(waterDataGain, 1e-6), waterDataOpacity * opacity);
}

void waterShade(inout vec4 color)
{
  color = vec4(mix(waterDeepColor, waterDataColor.rgb, waterDataColor.a), color.a * waterOpacity);
}
