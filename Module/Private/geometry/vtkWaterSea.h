// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSea: a wind sea at one time: heights and slopes on its tile, and the slopes as a texture.
//
// What somebody asks for is computed then, once for a time. A GPU computes the texture by itself
// (vtkWaterSlopePasses); heights and slopes for the processor, and the texture where GL is software
// or where the GPU cannot, by vtkWaterTransform. What has no memory throws std::bad_alloc, and is
// tried anew when it is asked for again. See Documentation/decisions/014-wind-sea.md.
#ifndef vtkWaterSea_h
#define vtkWaterSea_h

#include "vtkWaterSlopePasses.h"
#include "vtkWaterSlopeTexture.h"
#include "vtkWaterTransform.h"
#include "vtkWeakPointer.h"
#include "water_tile.h"

#include <vector>

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

class vtkWaterSea
{
public:
  // Brings the sea to a time; does nothing when it is there. All three have been checked.
  void Update(const water_tile& tile, const water_sea& sea, double time);

  // Bilinear on the tile, x and y in the plane's own axes; NaN when the place is not finite.
  double GetHeight(double x, double y);
  void GetSlope(double x, double y, double slope[2]);

  const water_tile& GetTile() const { return this->Tile; }

  // Slope variance along the plane's axes of the waves that are too short for the tile.
  const double* GetLeftOut() const { return this->LeftOut; }

  // Slopes and their squares with mip levels, as of the last update.
  vtkTextureObject* Upload(vtkOpenGLRenderWindow* window);

  // In its place, where there is no memory for it: a flat sea.
  vtkTextureObject* UploadFlat(vtkOpenGLRenderWindow* window);

  // Why the processor made the last texture though there is a GPU; nullptr: it did not.
  const char* GetDetour() const { return this->Detour; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  double Sample(const std::vector<double>& field, double x, double y) const;
  bool IsSoftware(vtkOpenGLRenderWindow* window);
  void UpdatePhasors();
  void UpdateHeights();
  void UpdateSlopes();

  water_tile Tile = water_tile();
  water_sea Sea = water_sea();
  double Time = 0.0;
  double LeftOut[2] = { 0.0, 0.0 };
  std::vector<double> Amplitudes; // empty: never updated
  std::vector<double> Frequencies;
  // of the time; empty: not asked for
  std::vector<double> Phasors;
  std::vector<double> Heights;
  std::vector<double> SlopesX;
  std::vector<double> SlopesY;
  std::vector<float> Texels;
  bool HasPhasors = false;
  bool HasHeights = false;
  bool HasSlopes = false;
  bool IsUploaded = false;
  vtkWaterTransform Transform;
  vtkWaterSlopePasses Passes;
  vtkWaterSlopeTexture Texture;
  const char* Detour = nullptr;
  vtkWeakPointer<vtkOpenGLRenderWindow> AskedWindow; // what executes GL
  bool IsSoftwareWindow = false;
};

#endif
