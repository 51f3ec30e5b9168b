// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPeelFS.glsl: leaves out of a second draw of the mirrored view what the first one shows, so that it shows what is
// behind that (depth peeling). In all other draws the uniform makes it a no-op.

uniform sampler2D waterPeelDepth; // of the reflection texture
uniform vec3 waterPeel; // x: how much farther a thing must be, as waterReflectionTolerance; y: depth at infinity; z: 1 in that draw

void waterPeelOff()
{
  if (waterPeel.z > 0.5)
  {
    float first = texelFetch(waterPeelDepth, ivec2(gl_FragCoord.xy), 0).r;
    if (gl_FragCoord.z <= first + waterPeel.x * (waterPeel.y - first))
    {
      discard;
    }
  }
}
