// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHazeFS.glsl: slot haze: what the water between an eye in it and what it sees adds; water_haze.h for the shader.
// Also of the fog (vtkWaterFogFS.glsl).

uniform float waterHazeShare;       // of it; the rest is the deep colour, in all directions
uniform float waterHazeDepth;       // of the eye, 0 over the water
uniform vec3 waterHazeDiffuse;      // as of water_haze
uniform vec3 waterHazeSun;          // in the plane's axes: the third points to the eye's side
uniform vec3 waterHazeOfParticles;
uniform vec3 waterHazeOfMolecules;
uniform vec4 waterHazeSky[3];

const float WATER_HAZE_FALL_MIN = -0.7; // water_haze.h

// The colour of mix(it, color, what is left) after a way.
//
// ray   unit length, in the plane's axes
// fall  what it gains in depth, per m
// way   m
vec3 waterHaze(vec3 ray, float fall, float way)
{
  float cosine = dot(ray, waterHazeSun);
  float x = max(fall, WATER_HAZE_FALL_MIN);
  vec4 powers = vec4(1.0, x, x * x, x * x * x);
  vec3 source = vec3(dot(waterHazeSky[0], powers), dot(waterHazeSky[1], powers), dot(waterHazeSky[2], powers)) +
    waterHazeOfParticles * waterHazeParticles(cosine) + waterHazeOfMolecules * waterHazeMolecules(cosine);
  source *= vec3(waterHazeOver(waterExtinction.r, waterHazeDiffuse.r, fall, waterHazeDepth, way),
    waterHazeOver(waterExtinction.g, waterHazeDiffuse.g, fall, waterHazeDepth, way),
    waterHazeOver(waterExtinction.b, waterHazeDiffuse.b, fall, waterHazeDepth, way));
  vec3 shown = vec3(waterEncoded(source.r), waterEncoded(source.g), waterEncoded(source.b));
  return waterHazeShare > 0.0 ? mix(waterDeepColor, shown, waterHazeShare) : waterDeepColor;
}
