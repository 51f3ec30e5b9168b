// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterTarget: the textures and framebuffers a mirrored view is drawn into.
#ifndef vtkWaterTarget_h
#define vtkWaterTarget_h

#include "vtkSmartPointer.h"

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

class vtkWaterTarget
{
public:
  // Makes or changes the textures to this size (pixels) and number of samples (0: none; at
  // most what the GPU has). Colours are half floats, or bytes.
  //
  // Returns false, and leaves nothing half made, when the GPU refuses.
  bool Ensure(vtkOpenGLRenderWindow* window, int width, int height, int samples, bool isFloat);

  // The same as another target, which has been made; with its samples, or without.
  bool EnsureAs(vtkOpenGLRenderWindow* window, const vtkWaterTarget& other, bool isSampled)
  {
    return this->Ensure(
      window, other.Width, other.Height, isSampled ? other.Samples : 0, other.IsFloat);
  }

  // Takes what is drawn in another target of the same size, which has no samples or as many; or its
  // colours without samples. The scissor cuts, and both framebuffers' bindings are lost.
  //
  // buffers     GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT
  // isResolved  what is in its textures, not what is drawn
  void CopyFrom(vtkWaterTarget& other, unsigned int buffers, bool isResolved = false);

  // Binds the framebuffer to draw into; Resolve() brings its samples into the textures. The caller
  // has pushed the framebuffer bindings and pops them.
  bool Bind();
  void Resolve();

  // Fills the colour's mip levels.
  void MakeLevels();

  // What VTK's passes take as the framebuffer they draw into.
  vtkOpenGLFramebufferObject* GetFramebuffer();
  // Its textures, without samples.
  vtkOpenGLFramebufferObject* GetResolved();
  bool HasHalfFloats() const { return this->IsFloat; }

  vtkTextureObject* GetColor() { return this->Color; }
  vtkTextureObject* GetDepth() { return this->Depth; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool MakeTextures(vtkOpenGLRenderWindow* window, int width, int height, bool isFloat);
  bool MakeFramebuffers(
    vtkOpenGLRenderWindow* window, int width, int height, int samples, bool isFloat);

  vtkSmartPointer<vtkTextureObject> Color;
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;        // holds the two textures
  vtkSmartPointer<vtkOpenGLFramebufferObject> SampledFramebuffer; // only with samples
  int Width = 0;
  int Height = 0;
  int Samples = 0;
  bool IsFloat = false;
};

#endif
