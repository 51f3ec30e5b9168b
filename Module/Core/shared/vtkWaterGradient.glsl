// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterGradient.glsl: where a direction finds its colour in a background that is a gradient; for
// shaders and, by water_shared.c, for C.

// Share of the second colour in VTK's gradients.
//
// screen  water_screen; s, t: place on the screen, 0 to 1
// Source: the shader of vtkOpenGLRenderer::Clear (VTK 9.6.2).
float waterGradientShare(int screen, float s, float t)
{
  float x = s - 0.5;
  float y = t - 0.5;
  float away = sqrt(x * x + y * y);
  return screen == 2 ? s : (screen == 3 ? min(2.0 * away, 1.0) : (screen == 4 ? sqrt(2.0) * away : t));
}

// Height on the user's screen, 0 at its bottom and 1 at its top. The gradient is painted there, and
// beyond the screen's edge ends in its last colour.
//
// y, w  of the direction in clip space of the eye, both times any positive number
float waterGradientHeight(float y, float w)
{
  // behind the user's camera (w <= 0) the direction is above or below all of the screen
  float height = w > 0.0 ? 0.5 + 0.5 * y / w : (y >= 0.0 ? 1.0 : 0.0);
  return min(max(height, 0.0), 1.0);
}
