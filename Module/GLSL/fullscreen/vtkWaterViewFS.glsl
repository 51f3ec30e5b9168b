//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterViewFS.glsl: debug: shows the mirrored view, flipped back in x.
//VTK::Output::Dec

in vec2 texCoord;
uniform sampler2D waterReflection;

void main()
{
  gl_FragData[0] = vec4(texture(waterReflection, vec2(1.0 - texCoord.x, texCoord.y)).rgb, 1.0);
}
