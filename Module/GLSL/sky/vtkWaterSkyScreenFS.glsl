// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSkyScreenFS.glsl: slot sky of a background that is a picture, or any gradient. It is painted on the user's
// screen; beyond the screen's edges it goes on with what is there at the edge. Behind the camera left and right are as
// before it, so that nothing jumps there.

uniform vec4 waterSkyTop;
uniform sampler2D waterScreenPicture;
uniform int waterScreen;         // water_screen
uniform vec2 waterScreenBorder;  // half a pixel: filters would mix what is at the opposite edge

const int WATER_SCREEN_PICTURE = 5;

vec3 waterOverFloor(vec3 dir, vec3 color); // of the slot floor

mat3 waterHalfToScreen; // direction -> half of its x, y and w on the user's screen

void waterReadSky()
{
  mat4 rows = transpose(waterDirToEye);
  waterHalfToScreen = 0.5 * mat3(rows[0].xyz, rows[1].xyz, rows[3].xyz);
}

vec2 waterSkyPlace(vec3 dir)
{
  vec3 eye = dir * waterHalfToScreen;
  return vec2(waterGradientHeight(eye.x, abs(eye.z)), waterGradientHeight(eye.y, eye.z));
}

vec3 waterSky(vec3 dir)
{
  vec2 place = waterSkyPlace(dir);
  vec2 inside = clamp(place, waterScreenBorder, 1.0 - waterScreenBorder);
  float share = waterGradientShare(waterScreen, place.x, place.y);
  vec3 color = mix(waterSkyBottom.rgb, waterSkyTop.rgb, share);
  vec3 painted = textureLod(waterScreenPicture, inside, 0.0).rgb;
  return waterOverFloor(dir, waterScreen == WATER_SCREEN_PICTURE ? painted : color);
}

bool waterIsSkyKnown()
{
  return waterSkyBottom.a > 0.5;
}
