// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPlainFS.glsl: in place of all slots: the plain colour, when the driver refuses the rest.

uniform vec3 waterDeepColor;
uniform float waterOpacity;

uniform float waterDataOpacity;
uniform float waterDataGain; // of ambient and diffuse light together
vec4 waterDataColor = vec4(0.0);

float waterActorOpacity = -1.0; // where the mapper shows scalars

// Where the mapper shows scalars: their colour. The opacity that the lookup table gives it is not the water's.
//
// opacity  of both the table and the actor
void waterTakeData(vec3 color, float opacity, float opacityOfActor)
{
  float opacityOfTable = opacity / max(opacityOfActor, 1e-6);
  waterDataColor = vec4(color / max(waterDataGain, 1e-6), waterDataOpacity * opacityOfTable);
  waterActorOpacity = opacityOfActor;
}

// Opacity of the actor, of VTK's colour.
float waterOpacityOf(vec4 color)
{
  return waterActorOpacity < 0.0 ? color.a : waterActorOpacity;
}

void waterShade(inout vec4 color)
{
  color = vec4(mix(waterDeepColor, waterDataColor.rgb, waterDataColor.a), waterOpacityOf(color) * waterOpacity);
}
