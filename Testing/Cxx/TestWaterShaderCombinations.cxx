// SPDX-License-Identifier: BSD-3-Clause
// The driver takes the surface's shader in every eleventh of the combinations of files that a look
// can ask for, and all other shaders, but for the lines of vtkWaterVolumeFS.glsl, which only a
// volume's own shader completes. glslang compiles all of them (check_glsl.sh --all), and the tests
// of volumes draw with those lines.
#include "../Core/shader_combinations.h"

#include "WaterShaderRun.h"
#include "WaterTestScene.h"

#include "vtkWaterGLSL.h"

namespace
{
// Odd: a step of a power of two would never meet some features.
constexpr size_t kStep = 11;

struct File
{
  const char* Name;
  water_feature_set AnyOf;
  water_feature_set NoneOf;
  const char* Source;
};
#define WATER_TEST_FILE(slot, file, any_of, none_of, what) { #file, any_of, none_of, file },
const File surfaceFiles[] = { WATER_SURFACE_FILE_LIST(WATER_TEST_FILE) };
const File photonFiles[] = { WATER_PHOTON_FILE_LIST(WATER_TEST_FILE) };
const File bufferFiles[] = { WATER_BUFFER_FILE_LIST(WATER_TEST_FILE) };
const File vertexFiles[] = { WATER_VERTEX_FILE_LIST(WATER_TEST_FILE) };

const char* const fragmentHead =
  "#version 150\nout vec4 fragOutput0, fragOutput1, fragOutput2, fragOutput3, fragOutput4;\n";

template <size_t Count>
std::string Join(const File (&files)[Count], water_feature_set features)
{
  std::string source;
  for (const File& file : files)
  {
    if (water_features_want(features, file.AnyOf, file.NoneOf))
    {
      source += std::string(file.Source) + "\n";
    }
  }
  return source;
}

bool Compiles(const std::string& name, GLenum stage, const std::string& source)
{
  const GLuint shader = WaterShaderRun::Compile(stage, source);
  if (!shader)
  {
    std::cout << name << ": FAILED" << std::endl;
  }
  glDeleteShader(shader);
  return shader != 0;
}

// A shader that VTK's shader cache would complete.
bool CompilesAlone(const std::string& name, GLenum stage, std::string source)
{
  for (const char* number : { "0", "1", "2", "3", "4" })
  {
    const std::string output = std::string("gl_FragData[") + number + "]";
    for (size_t at = source.find(output); at != std::string::npos; at = source.find(output))
    {
      source.replace(at, output.size(), std::string("fragOutput") + number);
    }
  }
  const bool hasMain = source.find("void main()") != std::string::npos;
  return Compiles(name, stage,
    (stage == GL_VERTEX_SHADER ? "#version 150\n" : fragmentHead) + source +
      (hasMain ? "" : "void main() {}\n"));
}
}

int TestWaterShaderCombinations(int, char*[])
{
  WaterShaderRun run;
  static water_feature_set sets[SHADER_SET_COUNT];
  const size_t count = shader_combinations(sets);
  size_t compiled = 0;
  size_t tried = 0; // until five are refused: that says enough
  for (size_t i = 0; i < count && tried < compiled + 5; i += kStep, ++tried)
  {
    compiled += Compiles("features " + std::to_string(sets[i]), GL_FRAGMENT_SHADER,
      fragmentHead + Join(surfaceFiles, sets[i]) +
        "void main()\n{\n  vec4 color = vec4(0.0);\n  waterShade(color);\n"
        "  fragOutput0 = color;\n}\n");
  }
  bool ok = WaterCheck("combinations", compiled, (count + kStep - 1) / kStep);
  for (int i = 0; i < 4; ++i)
  {
    const water_feature_set features =
      (i & 1 ? WATER_FEATURE_SEA : 0) | (i & 2 ? WATER_FEATURE_NORMAL_MAPS : 0);
    ok &= CompilesAlone("photons, features " + std::to_string(features), GL_FRAGMENT_SHADER,
      Join(photonFiles, features));
  }
  for (const water_feature_set sloped : { water_feature_set(0), WATER_FEATURE_SLOPED })
  {
    ok &= CompilesAlone("into a buffer, features " + std::to_string(sloped), GL_FRAGMENT_SHADER,
      Join(bufferFiles, sloped | WATER_FEATURE_BUFFERED) +
        "void main()\n{\n  vec4 color = vec4(0.0);\n  waterShade(color);\n"
        "  gl_FragData[0] = color;\n}\n");
  }
  ok &= CompilesAlone("buffer, one sample", GL_FRAGMENT_SHADER,
    std::string(vtkWaterBufferSortFS) + vtkWaterBufferOneFS);
  ok &= CompilesAlone("buffer, several samples", GL_FRAGMENT_SHADER,
    std::string(vtkWaterBufferSortFS) + vtkWaterBufferSampleFS);
  ok &= CompilesAlone("light, vertices", GL_VERTEX_SHADER, vtkWaterLightVS);
  ok &= CompilesAlone("displacement", GL_VERTEX_SHADER,
    Join(vertexFiles, WATER_FEATURE_DISPLACED) +
      "void main()\n{\n  vec4 position = vec4(1.0);\n  waterDisplace(position);\n"
      "  gl_Position = position;\n}\n");
  ok &= CompilesAlone("heights", GL_VERTEX_SHADER,
    Join(vertexFiles, WATER_FEATURE_MESH) +
      "void main()\n{\n  vec4 position = vec4(1.0);\n  waterMeasure(position);\n"
      "  gl_Position = position;\n}\n");
  ok &= CompilesAlone("mirrored, vertices", GL_VERTEX_SHADER, vtkWaterMirroredVS);
  ok &= CompilesAlone("cover, vertices", GL_VERTEX_SHADER, vtkWaterCoverVS);
  const std::pair<const char*, const char*> alone[] = { { "mirrored", vtkWaterMirroredFS },
    { "plain", vtkWaterPlainFS }, { "cover", vtkWaterCoverFS }, { "fog", vtkWaterFogFS },
    { "bed", vtkWaterBedFS }, { "light", vtkWaterLightFS }, { "sky", vtkWaterSkyFS },
    { "view", vtkWaterViewFS }, { "volume's depth", vtkWaterVolumeDepthFS },
    { "buffer into the picture", vtkWaterBufferPutFS } };
  for (const auto& [name, source] : alone)
  {
    ok &= CompilesAlone(name, GL_FRAGMENT_SHADER, source);
  }
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
