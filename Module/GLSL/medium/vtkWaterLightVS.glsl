//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterLightVS.glsl: a photon's ellipse, drawn as a point of its size over the texture of light.

uniform sampler2D waterPhotonPlace; // place in texels, weight in the middle, size in texels
uniform sampler2D waterPhotonShape; // of the ellipse
uniform vec2 waterCausticTexels;
flat out vec3 waterPhotonVSOutput;
flat out vec3 waterShapeVSOutput;

void main()
{
  int columns = textureSize(waterPhotonPlace, 0).x;
  ivec2 which = ivec2(gl_VertexID % columns, gl_VertexID / columns);
  vec4 photon = texelFetch(waterPhotonPlace, which, 0);
  waterPhotonVSOutput = photon.xyz;
  waterShapeVSOutput = texelFetch(waterPhotonShape, which, 0).xyz;
  gl_Position = vec4(2.0 * photon.xy / waterCausticTexels - 1.0, 0.0, 1.0);
  gl_PointSize = photon.w;
}
