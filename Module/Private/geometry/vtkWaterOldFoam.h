// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterOldFoam: the texture of the foam that crests of a wind sea have left (water_old_foam.h).
//
// It changes once in a step of earlier times, not in every picture. What broke at an earlier time
// is kept while it leaves foam, and is the same whether it was kept or is computed anew. The
// CPU computes it for both kinds of renderer: a transform of at most 256 x 256 points a step.
// What has no memory throws std::bad_alloc, and is tried anew when it is asked for again.
#ifndef vtkWaterOldFoam_h
#define vtkWaterOldFoam_h

#include "vtkWaterSeaTile.h"
#include "vtkWaterSlopeTexture.h"
#include "water_old_foam.h"

#include <map>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

class vtkWaterOldFoam
{
public:
  // The texture at a time, of one layer: the numbers of water_old_foam_join. Without old foam it
  // has one texel, of 0. All have been checked.
  vtkTextureObject* Upload(
    vtkOpenGLRenderWindow* window, const water_old_foam& foam, const water_sea& sea, double time);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void FillTexels(const water_sea& sea, double newest);

  water_old_foam Foam = water_old_foam();
  water_sea Sea = water_sea();
  vtkWaterSeaTile Tile;
  std::map<double, std::vector<unsigned char>> Shares; // by the number of the earlier time
  std::vector<float> Texels;
  double Uploaded = 0.0; // the newest of the earlier times in the texture
  bool IsUploaded = false;
  vtkWaterSlopeTexture Texture;
  vtkWaterSlopeTexture None; // for a sea without old foam
};

#endif
