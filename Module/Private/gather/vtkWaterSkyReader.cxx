// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSkyReader.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSkybox.h"
#include "water_sky.h"

#include <algorithm>

namespace
{
constexpr double kGamma = 1.0 / 2.2; // of vtkSkybox's GammaCorrect

// What later VTKs have, and earlier ones do not: asked of the class and not of the version.
template <typename Renderer>
auto ReadGradientMode(Renderer* renderer, int)
  -> decltype(static_cast<int>(renderer->GetGradientMode()))
{
  return static_cast<int>(renderer->GetGradientMode());
}

template <typename Renderer>
int ReadGradientMode(Renderer*, long)
{
  return 0; // vertical
}

// The matrix's columns are the picture's axes.
template <typename Renderer>
auto ReadRotation(Renderer* renderer, vtkSkybox*, double rotation[9], int)
  -> decltype(renderer->GetEnvironmentRotationMatrix(), true)
{
  vtkMatrix3x3* matrix = renderer->GetEnvironmentRotationMatrix();
  for (int i = 0; i < 9; ++i)
  {
    rotation[i] = matrix->GetElement(i % 3, i / 3);
  }
  return true;
}

template <typename Renderer>
bool ReadRotation(Renderer*, vtkSkybox*, double*, long)
{
  return false;
}

template <typename Skybox>
auto ReadScale(Skybox* skybox, double scale[2], int)
  -> decltype(static_cast<void>(skybox->GetFloorTexCoordScale()))
{
  std::copy_n(skybox->GetFloorTexCoordScale(), 2, scale);
}

template <typename Skybox>
void ReadScale(Skybox*, double scale[2], long)
{
  scale[0] = scale[1] = 1.0;
}

bool HasPixels(vtkTexture* texture, int port)
{
  if (port >= texture->GetNumberOfInputPorts() || texture->GetNumberOfInputConnections(port) == 0)
  {
    return false;
  }
  texture->GetInputAlgorithm(port, 0)->Update();
  auto* image = vtkImageData::SafeDownCast(texture->GetInputDataObject(port, 0));
  return image && image->GetNumberOfPoints() > 0 && image->GetNumberOfCells() > 0 &&
    image->GetPointData()->GetScalars();
}
}

//------------------------------------------------------------------------------
bool vtkWaterSkyReader::HasData(vtkTexture* texture, bool isCube)
{
  if (!texture || texture->GetCubeMap() != isCube)
  {
    return false;
  }
  bool hasAll = true;
  for (int port = 0; port < (isCube ? 6 : 1); ++port)
  {
    hasAll = hasAll && HasPixels(texture, port);
  }
  return hasAll;
}

//------------------------------------------------------------------------------
void vtkWaterSkyReader::ReadBackground(
  vtkRenderer* renderer, water_sky& sky, vtkWaterSkyTextures& textures)
{
  textures = vtkWaterSkyTextures();
  sky = water_sky();
  water_sky_map_none(&sky.map);
  vtkCamera* camera = renderer->GetActiveCamera();
  const bool isRight = camera->GetStereo() && !camera->GetLeftEye();
  vtkTexture* picture = isRight && renderer->GetRightBackgroundTexture()
    ? renderer->GetRightBackgroundTexture()
    : renderer->GetBackgroundTexture();
  const bool hasGradient = renderer->GetGradientBackground();
  if (renderer->GetTexturedBackground() && HasData(picture, false))
  {
    sky.screen = WATER_SCREEN_PICTURE;
    textures.Screen = picture;
  }
  else if (hasGradient)
  {
    const int mode = ReadGradientMode(renderer, 0);
    sky.screen = static_cast<water_screen>(WATER_SCREEN_VERTICAL + mode);
  }
  const bool isTwo = sky.screen != WATER_SCREEN_COLOR && sky.screen != WATER_SCREEN_PICTURE;
  std::copy_n(renderer->GetBackground(), 3, sky.bottom);
  std::copy_n(isTwo ? renderer->GetBackground2() : renderer->GetBackground(), 3, sky.top);
  sky.alpha = renderer->GetBackgroundAlpha();
}

//------------------------------------------------------------------------------
bool vtkWaterSkyReader::ReadSkybox(
  vtkRenderer* renderer, vtkSkybox* skybox, water_sky& sky, vtkWaterSkyTextures& textures)
{
  const int projection = skybox->GetProjection();
  const bool isCube = projection == vtkSkybox::Cube;
  vtkTexture* texture = skybox->GetTexture();
  if (!HasData(texture, isCube))
  {
    return false;
  }
  double plane[4];
  double right[3];
  std::copy_n(skybox->GetFloorPlane(), 4, plane);
  std::copy_n(skybox->GetFloorRight(), 3, right);
  const double exponent = skybox->GetGammaCorrect() ? kGamma : 1.0;
  if (projection == vtkSkybox::Floor)
  {
    double scale[2];
    ReadScale(skybox, scale, 0);
    water_sky_floor_make(plane, right, scale, &sky.floor);
    sky.floor.exponent = exponent;
    textures.Floor = texture;
    return true;
  }
  double rotation[9] = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  const bool isRotated = ReadRotation(renderer, skybox, rotation, 0);
  if (isCube)
  {
    water_sky_map_cube(rotation, isRotated, &sky.map);
  }
  else
  {
    if (!isRotated)
    {
      water_sky_rotation_on_floor(plane, right, rotation);
    }
    const bool isLeft = renderer->GetActiveCamera()->GetLeftEye() != 0;
    projection == vtkSkybox::StereoSphere ? water_sky_map_stereo(rotation, isLeft, &sky.map)
                                          : water_sky_map_sphere(rotation, &sky.map);
    sky.map.level = isRotated ? 0.0 : 1.0; // VTK 9.1 shows the second level, if there is one
  }
  sky.map.exponent = exponent;
  textures.Map = texture;
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterSkyReader::Read(vtkRenderer* renderer, water_sky& sky, vtkWaterSkyTextures& textures)
{
  ReadBackground(renderer, sky, textures);
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    auto* skybox = vtkSkybox::SafeDownCast(prop);
    if (skybox && skybox->GetVisibility())
    {
      (void)ReadSkybox(renderer, skybox, sky, textures);
    }
  }
}
