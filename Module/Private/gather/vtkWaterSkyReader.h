// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSkyReader: the renderer's background, and the skyboxes over it -> water_sky and the
// textures that it names. A water finds its sky by itself.
#ifndef vtkWaterSkyReader_h
#define vtkWaterSkyReader_h

#include "vtkSmartPointer.h"
#include "vtkTexture.h" // for members
#include "water_types.h"

class vtkRenderer;
class vtkSkybox;

// What a water_sky is looked up in; nullptr: it needs none.
struct vtkWaterSkyTextures
{
  vtkSmartPointer<vtkTexture> Screen;
  vtkSmartPointer<vtkTexture> Map; // a picture in longitude and latitude, or a cube map
  vtkSmartPointer<vtkTexture> Floor;
};

// A renderer's background as it was, for frames in which something else blanks it.
struct vtkWaterKeptBackground
{
  bool IsKept = false;
  water_sky Sky = water_sky();
  vtkWaterSkyTextures Textures;
};

namespace vtkWaterSkyReader
{
// Has it a pixel to show, and is it a cube map if one is wanted?
bool HasData(vtkTexture* texture, bool isCube);

// What the renderer paints before all props. Forgets skyboxes.
void ReadBackground(vtkRenderer* renderer, water_sky& sky, vtkWaterSkyTextures& textures);

// A visible skybox over what was read before: a floor beside the others, of which VTK shows the
// last.
//
// Returns false, and leaves all as it is, when its texture has no data.
bool ReadSkybox(
  vtkRenderer* renderer, vtkSkybox* skybox, water_sky& sky, vtkWaterSkyTextures& textures);

// Both of them, of all the renderer's props.
void Read(vtkRenderer* renderer, water_sky& sky, vtkWaterSkyTextures& textures);
}

#endif
