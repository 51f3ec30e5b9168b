// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterDataColor.glsl: the colour that the mapper's scalars give the water; a part of the files that show it.

uniform float waterDataOpacity;
uniform float waterDataGain; // of ambient and diffuse light together
vec4 waterDataColor = vec4(0.0); // of the mesh's scalars, set where it has some; a: how much of what is seen in the water it is

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
