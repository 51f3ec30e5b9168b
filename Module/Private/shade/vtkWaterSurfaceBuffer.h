// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSurfaceBuffer: the surface of a user's mesh at each pixel, and what it looks like
// (water_buffer.h).
//
//   keep   the mesh is drawn with a short shader, against the depth of the picture, which gets its
//          own: height, slope and distance of each sample
//   sort   a pixel's samples become one texel, or two where two parts of the surface lie behind
//   each
//          other
//   shade  the water's shader runs for each of these texels
//   put    each sample of the picture gets the colour of its texel
#ifndef vtkWaterSurfaceBuffer_h
#define vtkWaterSurfaceBuffer_h

#include "vtkOpenGLFramebufferObject.h" // for members
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkWaterQuad.h"

#include <functional>
#include <string>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkShaderProgram;
class vtkWindow;

class vtkWaterSurfaceBuffer
{
public:
  vtkWaterSurfaceBuffer() = default;
  ~vtkWaterSurfaceBuffer() = default;

  // Can what is bound for drawing have a buffer: one colour, and a depth that is a texture?
  static bool CanServe(vtkOpenGLRenderWindow* window);

  // Has the GPU no memory for it, or does it refuse the shaders? Until the resources are released.
  bool GetHasFailed() const { return this->HasFailed; }

  // A mesh that is drawn while an object of this class lives is kept.
  class Keeping
  {
  public:
    // viewport  of the picture: x, y, width, height in pixels
    // hasData   its mapper shows scalars
    Keeping(vtkWaterSurfaceBuffer& buffer, vtkOpenGLRenderWindow* window, const int viewport[4],
      bool hasData);
    ~Keeping();
    Keeping(const Keeping&) = delete;
    void operator=(const Keeping&) = delete;

    bool GetIsReady() const { return this->IsReady; } // false: nothing is bound

  private:
    vtkWaterSurfaceBuffer& Buffer;
    vtkOpenGLState* State;
    bool IsBlending;
    bool IsReady;
  };

  // Shades what was kept and puts it into the picture.
  //
  // shader  of the water, with what reads the buffer
  // setUp   sets the uniforms of this shader, and of others that have some of them
  //
  // Returns false if the driver refuses a shader; then nothing is drawn.
  bool Shade(const std::string& shader, const std::function<void(vtkShaderProgram*)>& setUp);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkWaterSurfaceBuffer(const vtkWaterSurfaceBuffer&) = delete;
  void operator=(const vtkWaterSurfaceBuffer&) = delete;

  bool Ensure(const int viewport[4], bool hasData);
  vtkSmartPointer<vtkTextureObject> MakeTexture(int components, int type, int samples);
  bool Sort(const std::function<void(vtkShaderProgram*)>& setUp);
  bool ShadeTexels(const std::string& shader, const std::function<void(vtkShaderProgram*)>& setUp);
  bool Put(const std::function<void(vtkShaderProgram*)>& setUp);

  vtkOpenGLRenderWindow* Window = nullptr; // of the textures
  int Viewport[4] = {};
  int Size[2] = {}; // of the textures, from the framebuffer's origin
  int Samples = 0;  // per pixel; 0: not multisampled
  int ColorType = 0;
  bool HasData = false;
  bool HasFailed = false;
  std::string Shader;
  vtkSmartPointer<vtkTextureObject> Kept; // of all samples
  vtkSmartPointer<vtkTextureObject> KeptData;
  vtkSmartPointer<vtkTextureObject> Texels[2];
  vtkSmartPointer<vtkTextureObject> Data[2];
  vtkSmartPointer<vtkTextureObject> Masks;
  vtkSmartPointer<vtkTextureObject> Depth; // how many texels a pixel has
  vtkSmartPointer<vtkTextureObject> Shaded[2];
  vtkSmartPointer<vtkOpenGLFramebufferObject> KeptFramebuffer;
  vtkSmartPointer<vtkOpenGLFramebufferObject> SortedFramebuffer;
  vtkSmartPointer<vtkOpenGLFramebufferObject> ShadedFramebuffer;
  vtkWaterQuad SortQuad;
  vtkWaterQuad ShadeQuad;
  vtkWaterQuad PutQuad;
};

#endif
