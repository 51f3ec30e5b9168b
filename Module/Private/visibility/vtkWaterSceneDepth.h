// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSceneDepth: the depth texture of the bound framebuffer, read where it is, without a copy,
// while another framebuffer is drawn into.
#ifndef vtkWaterSceneDepth_h
#define vtkWaterSceneDepth_h

class vtkOpenGLRenderWindow;
class vtkOpenGLState;

class vtkWaterSceneDepth
{
public:
  // Looks at what is bound for drawing now; the viewport is the picture's place in it.
  void Find(vtkOpenGLState* state);

  // Is there a texture with one sample a pixel?
  bool IsThere() const { return this->Texture != 0; }

  // Binds the texture to a unit of its own, and gives both back.
  //
  // Returns the unit.
  int Activate(vtkOpenGLRenderWindow* window);
  void Deactivate();

  // Of the picture in it, in pixels.
  const int* GetOrigin() const { return this->Viewport; }
  const int* GetSize() const { return this->Viewport + 2; }

private:
  unsigned int Texture = 0;
  int Viewport[4] = { 0, 0, 0, 0 };
  int Unit = -1;
  vtkOpenGLRenderWindow* Window = nullptr;
};

#endif
