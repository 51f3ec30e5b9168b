// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterVolumeFS.glsl: cuts the rays of a ray-cast volume at the water plane in the mirrored view.
// Uses the globals of VTK's ray caster: g_rayOrigin, g_rayTermination, g_rayJitter (all in texture
// coordinates), g_dataPos, g_terminatePos, g_terminatePointMax, g_dirStep, in_texMin, in_texMax.

uniform vec4 waterClipView;         // water plane in view space, kept side >= 0; (0,0,0,1): keep all
uniform vec4 waterHeadlightPlaceVC; // xyz: the user's eye in view space; w: 1 in the mirror

// Position of the headlight in a volume's shading. VTK assumes that it is at the eye; in the
// mirrored view it is at the user's eye. given: the place of the eye, in a volume's own space.
vec4 waterHeadlightPlace(vec4 given, mat4 worldToVolume)
{
  vec4 world = in_inverseModelViewMatrix * vec4(waterHeadlightPlaceVC.xyz, 1.0);
  return waterHeadlightPlaceVC.w > 0.5 ? worldToVolume * world : given;
}

// For light that a volume scatters: the cosine of the angle by which the headlight's is turned to
// the eye at a sample, in texture coordinates as VTK has it for other lights. VTK uses -1, as if
// lamp and eye were in one place. light: given the place of the eye, set to that of the headlight.
float waterHeadlightTurn(inout vec3 light)
{
  if (waterHeadlightPlaceVC.w < 0.5)
  {
    return -1.0;
  }
  vec3 eye = light;
  light = (in_inverseTextureDatasetMatrix[0] *
           waterHeadlightPlace(vec4(eye, 1.0), in_inverseVolumeMatrix[0])).xyz;
  return dot(normalize(g_dataPos - light), normalize(eye - g_dataPos));
}

float waterRayHeight(vec3 texturePosition)
{
  // what VTK's vertex shader does to place samples in the middle of texels, undone: scale and offset
  mat4 toPoint = in_cellToPoint[0];
  vec3 cell = (texturePosition - toPoint[3].xyz) / vec3(toPoint[0][0], toPoint[1][1], toPoint[2][2]);
  vec4 view =
    in_modelViewMatrix * in_volumeMatrix[0] * in_textureDatasetMatrix[0] * vec4(cell, 1.0);
  return dot(waterClipView, view / view.w);
}

void waterClipRay()
{
  vec3 start = g_rayOrigin - g_rayJitter;
  float startHeight = waterRayHeight(start);
  float stopHeight = waterRayHeight(g_rayTermination);
  if (startHeight < 0.0 && stopHeight < 0.0)
  {
    discard;
  }
  if (startHeight < 0.0 || stopHeight < 0.0)
  {
    vec3 crossing = mix(start, g_rayTermination, startHeight / (startHeight - stopHeight));
    if (startHeight < 0.0)
    {
      g_rayOrigin = crossing + g_rayJitter;
      // VTK takes one sample before it asks where the ray is
      if (any(greaterThan(g_rayOrigin, in_texMax[0])) || any(lessThan(g_rayOrigin, in_texMin[0])))
      {
        discard;
      }
    }
    else
    {
      g_rayTermination = crossing;
    }
    g_dataPos = g_rayOrigin;
    g_terminatePos = g_rayTermination;
    g_terminatePointMax = length(g_terminatePos - g_dataPos) / length(g_dirStep);
  }
}
