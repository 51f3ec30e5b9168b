// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBackdrop: colour and depth of the picture as it is before a water is drawn: what is seen
// through the surface.
#ifndef vtkWaterBackdrop_h
#define vtkWaterBackdrop_h

#include "vtkOpenGLFramebufferObject.h" // for members
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h" // for members
#include "vtkWaterRankSamples.h"
#include "vtkWaterSampleSpread.h"

class vtkOpenGLRenderWindow;
class vtkWaterRankPixels;
class vtkWaterRanks;
class vtkWindow;

class vtkWaterBackdrop
{
public:
  // Copies what the bound framebuffer has in a rectangle (x, y, width, height in pixels). The
  // samples of a pixel are spread over several, or else averaged, as far as the GPU can.
  //
  // Returns false when the GPU refuses; there is then no backdrop.
  //
  // rect        of the picture
  // part        of that, from its corner, that is looked at; the rest is what it was
  // heightClip  as in vtkWaterSampleSpread.h; nullptr: samples are averaged
  bool Copy(
    vtkOpenGLRenderWindow* window, const int rect[4], const int part[4], const double* heightClip);

  // How many samples a pixel of the bound framebuffer has that ranks can send; 0: none.
  static int CountSamples();

  // Copies what is nearest of what all ranks have. All of them call it, or none, with the same part
  // and number of samples. Of several samples each is the nearest.
  //
  // samples  that all have, or 0: ranks send a pixel's mean
  //
  // Returns false when one of them has no backdrop; none is used then.
  bool CopyOfAll(vtkWaterRanks& ranks, vtkOpenGLRenderWindow* window, const int rect[4],
    const int part[4], int samples, const double* heightClip);

  // What was copied is of another frame.
  void Forget() { this->IsSpread = this->IsMixed = false; }

  // Did the GPU give no memory for it, when last asked?
  bool GetHasFailed() const { return this->HasFailed; }

  // Are its colours means of several samples?
  bool GetIsMixed() const { return this->IsMixed; }

  // Its samples; nullptr: there is one a pixel.
  vtkWaterSampleSpread* GetSpread() { return this->IsSpread ? &this->Samples : nullptr; }

  // So many of its pixels lie along each side of one of the picture's.
  int GetSide() const { return this->IsSpread ? this->Side : 1; }

  vtkTextureObject* GetColor() { return this->Color; }
  vtkTextureObject* GetDepth() { return this->Depth; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  // Spreads the samples. false: nothing is done, as there is one a pixel, or the GPU cannot.
  bool Spread(
    vtkOpenGLRenderWindow* window, const int rect[4], const int part[4], const double* heightClip);
  bool Ensure(vtkOpenGLRenderWindow* window, int width, int height);
  void ReleaseCopies(vtkWindow* window); // not the samples that are copied from
  bool Join(vtkWaterRanks& ranks, vtkOpenGLRenderWindow* window, const int part[4], bool isCopied);
  bool EnsureSamples(vtkOpenGLRenderWindow* window, int width, int height, int samples);
  void Read(vtkOpenGLRenderWindow* window, const int part[4], vtkWaterRankPixels& pixels);

  vtkSmartPointer<vtkTextureObject> Color;
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer; // only when samples are averaged
  int Width = 0;
  int Height = 0;
  int ColorType = 0; // VTK's, as the picture's
  int DepthFormat = 0;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Joined; // of all ranks, when they have several
  int JoinedSize[4] = {};                             // width, height, number, type
  vtkWaterRankSamples RankSamples;
  vtkWaterSampleSpread Samples;
  int Side = 1;
  bool IsSpread = false;
  bool IsMixed = false;
  bool HasFailed = false;
};

#endif
