// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSea: a wind sea at one time: its tiles, heights and slopes at places, and a texture.
//
// What somebody asks for is computed then, once for a time. A GPU computes the texture by itself
// (vtkWaterSlopePasses); heights and slopes for the CPU, and the texture where GL is software
// or where the GPU cannot, by vtkWaterSeaTile. What has no memory throws std::bad_alloc, and is
// tried anew when it is asked for again. See Documentation/decisions/014-wind-sea.md.
#ifndef vtkWaterSea_h
#define vtkWaterSea_h

#include "vtkWaterOldFoam.h"
#include "vtkWaterSeaTile.h"
#include "vtkWaterSlopePasses.h"
#include "vtkWaterSlopeTexture.h"
#include "vtkWeakPointer.h"
#include "water_cascade.h"

#include <vector>

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

class vtkWaterSea
{
public:
  // Brings the sea to a time; does nothing when it is there. All three have been checked.
  void Update(const water_cascades& cascades, const water_sea& sea, double time);

  // Bilinear on the tiles, x and y in the plane's own axes; NaN when the place is not finite.
  double GetHeight(double x, double y);
  void GetSlope(double x, double y, double slope[2]);

  // The sea as it moves a surface, as of the last update; its pointers hold until the next.
  water_cascade_surface GetSurface(double choppiness, double unitsPerMetre);

  const water_cascades& GetCascades() const { return this->Cascades; }

  // The texture with mip levels, as of the last update: a layer for each tile with slopes and their
  // squares; then, with two fields or three, a layer for each with the others.
  //
  // fields  of vtkWaterSlopePasses, 1 to 3
  vtkTextureObject* Upload(vtkOpenGLRenderWindow* window, int fields);

  // On a GPU, computes the texture of a time ahead of its use, if the last frame used it: the GPU
  // then works on it while the CPU still submits the scene. Does nothing otherwise.
  void Begin(vtkOpenGLRenderWindow* window, const water_cascades& cascades, const water_sea& sea,
    double time, int fields);

  // In its place, where there is no memory for it: a flat sea.
  vtkTextureObject* UploadFlat(vtkOpenGLRenderWindow* window, int fields);

  // The texture of the foam that its crests have left, as of a time.
  vtkTextureObject* UploadOldFoam(
    vtkOpenGLRenderWindow* window, const water_old_foam& foam, const water_sea& sea, double time)
  {
    return this->OldFoam.Upload(window, foam, sea, time);
  }

  // Why the CPU made the last texture though there is a GPU; nullptr: it did not.
  const char* GetDetour() const { return this->Detour; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool IsSoftware(vtkOpenGLRenderWindow* window);
  bool DrawTexture(vtkOpenGLRenderWindow* window, int fields);
  void FillTexels(int fields);

  water_cascades Cascades = water_cascades();
  double Time = 0.0;
  vtkWaterSeaTile Tiles[WATER_CASCADES_MAX];
  vtkWaterSlopePasses Passes;
  water_cascade_fields Fields[WATER_CASCADES_MAX] = {};
  std::vector<float> Texels;
  int UploadedFields = 0; // 0: nothing is uploaded
  bool IsInUse = false;   // since the last Begin
  vtkWaterSlopeTexture Texture;
  vtkWaterOldFoam OldFoam;
  const char* Detour = nullptr;
  vtkWeakPointer<vtkOpenGLRenderWindow> AskedWindow; // what executes GL
  bool IsSoftwareWindow = false;
};

#endif
