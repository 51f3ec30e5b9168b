// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPhotonFS.glsl: the last slot of the photons' shader: a point of the surface, where its light comes to the
// bed under what the eye's picture shows, and how it spreads there; water_caustics_plan.h.
//
// A fragment is a point of the grid; its derivatives are the differences to its neighbours.

in vec2 texCoord;
uniform sampler2D waterBed;        // vtkWaterBedFS.glsl
uniform vec2 waterPhotonSearch;    // depths: the bed is searched from; the bed under a source is read at
uniform vec2 waterPhotonStep;      // of the grid, 1 / points
uniform mat3 waterGridToSource;    // water_caustics
uniform mat3 waterPlaceToClip;
uniform vec3 waterRiseClip;
uniform vec2 waterCalmWay;
uniform vec3 waterTurn;
uniform vec3 waterSunSpread;
uniform mat3 waterPlaceToLight;    // (place on the plane, 1) -> texels of the texture of light
const float WATER_PHOTON_CELL = 0.28;   // variance of a cell's own image: neighbours' ellipses add up to an even light
const float WATER_PHOTON_TEXEL = 0.12; // of a texel: a box has 1/12
const int WATER_PHOTON_STEPS = 3; // to where light meets the bed
const float WATER_PHOTON_LARGEST = 24.0; // radius of an ellipse, texels

vec2 waterSource(vec2 grid)
{
  vec3 source = waterGridToSource * vec3(grid, 1.0);
  return source.xy / source.z;
}

// Horizontal displacement of light per depth.
vec2 waterWay(vec2 slope)
{
  vec3 dir = refract(-waterSunDir, normalize(vec3(-slope, 1.0)), 1.0 / waterEta);
  return dir.xy / max(-dir.z, 0.1);
}

vec3 waterBedClip(vec2 place, float depth)
{
  return waterPlaceToClip * vec3(place, 1.0) - depth * waterRiseClip;
}

vec2 waterBedSeen(vec3 clip)
{
  return 0.5 + 0.5 * clip.xy / max(clip.z, 1e-6);
}

float waterBedDepthAt(vec2 uv)
{
  return textureLod(waterBed, uv, 0.0).r;
}

// Depth of the bed where light comes to a depth; what lies beyond the picture is as deep as the bed under the source.
float waterBedWhere(vec3 clip, float own)
{
  vec2 uv = waterBedSeen(clip);
  bool isSeen = clip.z > 0.0 && all(lessThan(abs(uv - 0.5), vec2(0.5)));
  return isSeen ? waterBedDepthAt(uv) : own;
}

void main()
{
  vec2 source = waterSource(texCoord);
  vec2 across = 0.5 * (waterSource(texCoord + vec2(waterPhotonStep.x, 0.0)) - waterSource(texCoord - vec2(waterPhotonStep.x, 0.0)));
  vec2 down = 0.5 * (waterSource(texCoord + vec2(0.0, waterPhotonStep.y)) - waterSource(texCoord - vec2(0.0, waterPhotonStep.y)));
  vec4 variance = vec4(0.0);
  float jacobian;
  vec2 slope = waterAllSlopes(source, across, down, vec3(0.0), variance, jacobian);
  vec2 way = waterWay(slope);
  mat2 turned = mat2(dFdx(way), dFdy(way));
  vec2 within = max(variance.xy - waterEven, vec2(0.0));

  // the bed is smooth: where it is to a step is near enough, as only the way aside of the waves depends on it
  float depth = waterPhotonSearch.x; // from there: a wall towards the sun is before the bed that its water lights
  float own = waterBedDepthAt(waterBedSeen(waterBedClip(source + waterPhotonSearch.y * waterCalmWay, waterPhotonSearch.y)));
  for (int i = 0; i < WATER_PHOTON_STEPS; ++i)
  {
    depth = waterBedWhere(waterBedClip(source + depth * way, depth), own);
  }
  vec2 lit = source + depth * (way - waterCalmWay); // in calm water that place would light it
  vec3 light3 = waterPlaceToLight * vec3(lit, 1.0);
  vec2 at = light3.xy / light3.z;
  mat2 lands = mat2(waterPlaceToLight[0].xy - at * waterPlaceToLight[0].z,
    waterPlaceToLight[1].xy - at * waterPlaceToLight[1].z) / light3.z;
  mat2 cell = mat2(across, down);
  mat2 image = lands * (cell + depth * turned);
  float light = abs(determinant(lands * cell)); // texels that it would light in calm water
  mat2 turn = mat2(waterTurn.xy, waterTurn.yz);
  mat2 spread = mat2(waterSunSpread.xy, waterSunSpread.yz) + turn * mat2(within.x, 0.0, 0.0, within.y) * transpose(turn);
  mat2 sum = WATER_PHOTON_CELL * image * transpose(image) + depth * depth * lands * spread * transpose(lands) + mat2(WATER_PHOTON_TEXEL);
  float middle = 0.5 * (sum[0][0] + sum[1][1]);
  float widest = middle + length(vec2(0.5 * (sum[0][0] - sum[1][1]), sum[0][1]));
  sum *= min(1.0, WATER_PHOTON_LARGEST * WATER_PHOTON_LARGEST / (10.0 * widest));
  float radius = min(sqrt(10.0 * widest), WATER_PHOTON_LARGEST);
  float area = sqrt(max(determinant(sum), 1e-6));
  vec3 source3 = waterGridToSource * vec3(texCoord, 1.0);
  bool isSeen = source3.z > 0.0 && light3.z > 0.0 && light < 1e4 && all(lessThan(abs(at), vec2(1e5)));
  // weight of a texel: peak (1 - d . shape d)^3, with the variance of the sum
  gl_FragData[0] = isSeen ? vec4(at, 0.4 * 0.318309886 * light / area, 2.0 * radius) : vec4(-1e6, -1e6, 0.0, 1.0);
  gl_FragData[1] = vec4(vec3(sum[1][1], -sum[0][1], sum[0][0]) / (10.0 * area * area), 0.0);
}
