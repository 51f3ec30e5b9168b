// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSceneDepth: where the bound framebuffer has the depths of the picture so far.
#ifndef vtkWaterSceneDepth_h
#define vtkWaterSceneDepth_h

class vtkOpenGLState;

class vtkWaterSceneDepth
{
public:
  // Looks at what is bound for drawing now; the viewport is the picture's place in it.
  void Find(vtkOpenGLState* state);

  // Are there depths, of one sample a pixel?
  bool IsThere() const { return this->HasDepths; }

  // Of the picture in it, in pixels.
  const int* GetOrigin() const { return this->Viewport; }
  const int* GetSize() const { return this->Viewport + 2; }

private:
  bool HasDepths = false;
  int Viewport[4] = { 0, 0, 0, 0 };
};

#endif
