// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSlopePasses: the slopes of a wind sea at a time, made by the GPU alone in full-screen
// draws: the spectrum (vtkWaterSlopeSpectrumFS.glsl), then its FFT along x and y
// (vtkWaterFftFS.glsl). What they read is uploaded once for a sea.
#ifndef vtkWaterSlopePasses_h
#define vtkWaterSlopePasses_h

#include "vtkSmartPointer.h"
#include "vtkWaterQuad.h"
#include "vtkWeakPointer.h"
#include "water_fft.h"
#include "water_tile.h"

#include <cstdint>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWaterSlopeTexture;
class vtkWindow;

class vtkWaterSlopePasses
{
public:
  struct Inputs
  {
    const water_tile& Tile;
    const std::vector<double>& Amplitudes;
    const std::vector<double>& Frequencies; // of a quadrant
    double Time;
  };

  vtkWaterSlopePasses();
  ~vtkWaterSlopePasses();

  // Draws the slopes and their squares into the texture, and makes its mip levels. GL's state is as
  // before.
  //
  // Returns nullptr, or why it cannot; then the texture has no use. What the driver refused is
  // not tried again in the window.
  const char* Draw(vtkOpenGLRenderWindow* window, const Inputs& sea, vtkWaterSlopeTexture& slopes);

  // The next sea is another one.
  void Forget() { this->HasSea = false; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Target
  {
    vtkSmartPointer<vtkTextureObject> Texture;
    vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  };

  bool Prepare(vtkOpenGLRenderWindow* window, const Inputs& sea, vtkWaterSlopeTexture& slopes);
  bool MakeTargets(vtkOpenGLRenderWindow* window, vtkWaterSlopeTexture& slopes);
  void UploadTable(vtkOpenGLRenderWindow* window);
  void UploadSea(vtkOpenGLRenderWindow* window, const Inputs& sea);
  bool DrawSpectrum(vtkOpenGLRenderWindow* window, const uint32_t units[2], double time);
  bool Transform(vtkOpenGLRenderWindow* window);
  void DrawInto(int target, vtkWaterQuad& quad);

  vtkWaterQuad Spectrum;
  vtkWaterQuad Fft;
  water_fft Plan = water_fft();
  int Exponent = 0;    // of the unit of time
  bool HasSea = false; // its waves and frequencies are uploaded
  vtkWeakPointer<vtkOpenGLRenderWindow> RefusedBy;
  vtkSmartPointer<vtkTextureObject> Waves;       // a texel for each wave vector
  vtkSmartPointer<vtkTextureObject> Frequencies; // a texel for each in a quadrant
  vtkSmartPointer<vtkTextureObject> Table;       // of the FFT, a row for each pass
  Target Targets[3];                             // two in turns, and the slopes
};

#endif
