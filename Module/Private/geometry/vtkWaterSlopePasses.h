// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSlopePasses: the fields of a wind sea's tiles at a time, made by the GPU alone in
// full-screen draws: the spectra (vtkWaterSeaSpectrumFS.glsl), then their FFT along x and y
// (vtkWaterFftFS.glsl). All tiles lie one above the other in one texture, since a draw takes longer
// than its work. What they read is uploaded once for a sea.
#ifndef vtkWaterSlopePasses_h
#define vtkWaterSlopePasses_h

#include "vtkSmartPointer.h"
#include "vtkWaterQuad.h"
#include "vtkWeakPointer.h"
#include "water_cascade.h"
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
  struct Tile
  {
    const water_tile* Shape;
    const std::vector<double>* Amplitudes;
    const std::vector<double>* Frequencies; // of a quadrant
  };
  struct Inputs
  {
    std::vector<Tile> Tiles; // of one size
    double Time;
  };

  // What a layer of the texture has.
  enum Fields
  {
    SLOPES, // and their squares
    BENDS,  // derivatives of the chop: xx, yy, xy, 0
    MOVES,  // chop x and y, height, 0
    FIELDS
  };

  vtkWaterSlopePasses();
  ~vtkWaterSlopePasses();

  // Draws fields into the texture's layers: the first of all tiles, then the second, and so on.
  // GL's state is as before.
  //
  // fields  how many, in the order above
  //
  // Returns nullptr, or why it cannot; then the texture has no use. What the driver refused is
  // not tried again in the window.
  const char* Draw(
    vtkOpenGLRenderWindow* window, const Inputs& sea, int fields, vtkWaterSlopeTexture& texture);

  // The next sea is another one.
  void Forget() { this->HasFields = 0; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Target
  {
    vtkSmartPointer<vtkTextureObject> Texture;
    vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  };

  bool Prepare(vtkOpenGLRenderWindow* window, const Inputs& sea, int fields);
  bool MakeTarget(vtkOpenGLRenderWindow* window, int components, Target& target);
  bool MakeTargetsOf(vtkOpenGLRenderWindow* window, int fields);
  void UploadTable(vtkOpenGLRenderWindow* window);
  void UploadFrequencies(vtkOpenGLRenderWindow* window, const Inputs& sea);
  void UploadWaves(vtkOpenGLRenderWindow* window, const Inputs& sea, int fields);
  const char* FindUnits(const Inputs& sea);
  bool DrawSpectrum(vtkOpenGLRenderWindow* window, double time, int fields);
  bool Transform(vtkOpenGLRenderWindow* window, int fields);

  vtkWaterQuad Spectrum;
  vtkWaterQuad Fft;
  water_fft Plan = water_fft();
  size_t Count = 0;                       // of tiles
  int Exponents[WATER_CASCADES_MAX] = {}; // of a tile's unit of time
  int Units[2 * WATER_CASCADES_MAX] = {}; // the bits of each tile's time
  int HasFields = 0;                      // their waves, and the frequencies, are uploaded
  vtkWeakPointer<vtkOpenGLRenderWindow> RefusedBy;
  vtkSmartPointer<vtkTextureObject> Waves[FIELDS][2]; // a texel for each wave vector
  vtkSmartPointer<vtkTextureObject> Frequencies;      // a texel for each in a quadrant
  vtkSmartPointer<vtkTextureObject> Table;            // of the FFT, a row for each pass
  Target Targets[2][2]; // of the slopes, and of other fields: two numbers and four; in turns
  Target Whole;         // the slopes and their squares
};

#endif
