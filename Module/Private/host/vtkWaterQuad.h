// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterQuad: a draw that covers the viewport, with a fragment shader of ours.
#ifndef vtkWaterQuad_h
#define vtkWaterQuad_h

#include <memory>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

class vtkWaterQuad
{
public:
  vtkWaterQuad();
  ~vtkWaterQuad();

  // Readies the draw, made at first.
  //
  // Returns the program, for its uniforms; nullptr: it does not compile.
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, const char* fragmentShader);

  // Draws what is ready.
  void Draw();

  void ReleaseGraphicsResources();

private:
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
};

#endif
