//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBedFS.glsl: the bed under the picture, coarse and smooth: depths under water, in four draws. The first takes the
// deepest of what a block of the picture shows; the second and third together are a morphological closing, which takes
// away what stands on the bed and leaves slopes as they are (Serra 1982, "Image Analysis and Mathematical Morphology");
// the last makes it smooth. Light that is followed to the picture itself would break at every edge of it.
//VTK::Output::Dec

in vec2 texCoord;
uniform sampler2D waterBedSource; // window depths of the picture, or the draw before
uniform int waterBedStep;         // 0 to 3
uniform vec4 waterHeightClip;     // as in vtkWaterMediumPictureFS.glsl
uniform vec4 waterClipW;
uniform vec2 waterBedBlock;       // of the picture, a texel's sides as parts of it
uniform float waterCausticDepth;  // where nothing is known

const int WATER_BED_LOOKS = 4;  // along a block's sides
const int WATER_BED_RADIUS = 4; // blocks
const float WATER_BED_UNKNOWN = -1.0;

float waterBedOf(vec2 uv)
{
  float depth = textureLod(waterBedSource, uv, 0.0).r;
  vec4 clip = vec4(2.0 * vec3(uv, depth) - 1.0, 1.0);
  float height = dot(waterHeightClip, clip) / dot(waterClipW, clip);
  return depth < 1.0 && height < 0.0 ? min(-height, waterCausticDepth) : WATER_BED_UNKNOWN;
}

float waterBedOfBlock()
{
  float deepest = WATER_BED_UNKNOWN;
  for (int i = 0; i < WATER_BED_LOOKS * WATER_BED_LOOKS; ++i)
  {
    vec2 part = (vec2(float(i % WATER_BED_LOOKS), float(i / WATER_BED_LOOKS)) + 0.5) / float(WATER_BED_LOOKS) - 0.5;
    // a pixel's middle: depths are those of its middle
    vec2 size = vec2(textureSize(waterBedSource, 0));
    vec2 uv = clamp((floor((texCoord + part * waterBedBlock) * size) + 0.5) / size, 0.0, 1.0);
    deepest = max(deepest, waterBedOf(uv));
  }
  return deepest;
}

void main()
{
  vec2 found = vec2(WATER_BED_UNKNOWN, 1e30); // deepest, shallowest
  vec2 sum = vec2(0.0);
  int radius = waterBedStep == 0 ? -1 : WATER_BED_RADIUS;
  for (int j = -radius; j <= radius; ++j)
  {
    for (int i = -radius; i <= radius; ++i)
    {
      float there = textureLod(waterBedSource, texCoord + vec2(float(i), float(j)) * waterBedBlock, 0.0).r;
      bool isKnown = there >= 0.0;
      found = isKnown ? vec2(max(found.x, there), min(found.y, there)) : found;
      float weight = exp(-0.2 * float(i * i + j * j));
      sum += isKnown ? vec2(weight * there, weight) : vec2(0.0);
    }
  }
  bool isNone = found.x < 0.0;
  float bed = waterBedStep == 1 ? found.x : (waterBedStep == 2 ? found.y : sum.x / max(sum.y, 1e-9));
  bed = isNone ? (waterBedStep == 3 ? waterCausticDepth : WATER_BED_UNKNOWN) : bed;
  if (waterBedStep == 0)
  {
    bed = waterBedOfBlock();
  }
  gl_FragData[0] = vec4(bed);
}
