// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMirroredVS.glsl: cuts opaque geometry away behind the water in the mirrored view, where
// GL_CLIP_DISTANCE0 is on. Unlike a discard it leaves early depth tests alone, in both views.

uniform vec4 waterClipPosition; // water plane in clip space, kept side >= 0; and what is added
uniform float waterClipConstant;

void waterClipVertex(vec4 position)
{
  gl_ClipDistance[0] = dot(waterClipPosition, position) + waterClipConstant;
}
