// SPDX-License-Identifier: BSD-3-Clause
// WaterShaderRun.h: compiles and runs shaders of a test's own on the driver, beside VTK's
// rendering.
#ifndef WaterShaderRun_h
#define WaterShaderRun_h

#include "../../Module/Private/host/vtkWaterGL.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <functional>
#include <iostream>
#include <string>
#include <vector>

class WaterShaderRun
{
public:
  // A case is a pixel: so many of them, in rows of Width.
  static constexpr int Width = 128;
  static constexpr int Height = 128;
  static constexpr int CaseCount = Width * Height;
  static constexpr int TexelsPerCase = 3;

  WaterShaderRun()
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(16, 16);
    this->Window->AddRenderer(this->Renderer);
    this->Window->Render();
    this->Window->MakeCurrent();
  }

  // 0, and the driver's words on std::cout, when it does not compile.
  static GLuint Compile(GLenum stage, const std::string& source)
  {
    const GLuint shader = glCreateShader(stage);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint isCompiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &isCompiled);
    if (isCompiled)
    {
      return shader;
    }
    char log[2000] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    std::cout << log << std::endl;
    glDeleteShader(shader);
    return 0;
  }

  // What GLSL's testCase(i) gives for each case, i below TexelsPerCase, and where the vertex of a
  // case goes, testVertex().
  static std::string Declarations(const std::string& pixel)
  {
    return "#version 150\n"
           "uniform sampler2D testCases;\n"
           "vec4 testCase(int i)\n"
           "{\n"
           "  ivec2 pixel = ivec2(" +
      pixel +
      ");\n"
      "  return texelFetch(testCases, ivec2(pixel.x, 3 * pixel.y + i), 0);\n"
      "}\n";
  }
  static std::string VertexDeclarations()
  {
    return Declarations("gl_VertexID % 128, gl_VertexID / 128") +
      "vec4 testVertex()\n"
      "{\n"
      "  vec2 pixel = vec2(gl_VertexID % 128, gl_VertexID / 128);\n"
      "  return vec4((2.0 * pixel + 1.0) / 128.0 - 1.0, 0.0, 1.0);\n"
      "}\n";
  }
  static std::string FragmentDeclarations()
  {
    return Declarations("gl_FragCoord.xy") + "out vec4 testResult;\n";
  }

  // Four floats a case; empty when the driver refuses.
  //
  // cases        TexelsPerCase times four floats each
  // waves        a table as in vtkWaterWavesFS.glsl, two texels a row
  // setUniforms  called with the program in use
  std::vector<float> Run(const std::string& vertexSource, const std::string& fragmentSource,
    const std::vector<float>& cases, const std::vector<float>& waves,
    const std::function<void(GLuint)>& setUniforms)
  {
    const GLuint vertex = Compile(GL_VERTEX_SHADER, vertexSource);
    const GLuint fragment = Compile(GL_FRAGMENT_SHADER, fragmentSource);
    const GLuint program = glCreateProgram();
    GLint isLinked = 0;
    if (vertex && fragment)
    {
      glAttachShader(program, vertex);
      glAttachShader(program, fragment);
      glLinkProgram(program);
      glGetProgramiv(program, GL_LINK_STATUS, &isLinked);
    }
    if (!isLinked)
    {
      return {};
    }
    GLuint textures[3];
    glGenTextures(3, textures);
    Upload(GL_TEXTURE2, textures[2], Width, Height, nullptr);
    Upload(GL_TEXTURE1, textures[1], 2, static_cast<int>(waves.size() / 8), waves.data());
    Upload(GL_TEXTURE0, textures[0], Width, Height * TexelsPerCase, cases.data());
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures[2], 0);
    glDrawBuffer(GL_COLOR_ATTACHMENT0);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    GLuint vertices = 0;
    glGenVertexArrays(1, &vertices);
    glBindVertexArray(vertices);
    for (GLenum capability : { GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_CULL_FACE })
    {
      glDisable(capability);
    }
    glViewport(0, 0, Width, Height);
    glUseProgram(program);
    glUniform1i(glGetUniformLocation(program, "testCases"), 0);
    glUniform1i(glGetUniformLocation(program, "waterWaves"), 1);
    setUniforms(program);
    glDrawArrays(GL_POINTS, 0, CaseCount);
    std::vector<float> results(4 * CaseCount);
    glReadPixels(0, 0, Width, Height, GL_RGBA, GL_FLOAT, results.data());
    const bool isDone = glGetError() == GL_NO_ERROR;
    glUseProgram(0);
    glBindVertexArray(0);
    glDeleteVertexArrays(1, &vertices);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(3, textures);
    glDeleteProgram(program);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    return isDone ? results : std::vector<float>();
  }

private:
  static void Upload(GLenum unit, GLuint texture, int width, int height, const float* texels)
  {
    glActiveTexture(unit);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, texels);
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};

#endif
