// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNormalMaps: the layers of normal maps of a water, and the built-in map.
#ifndef vtkWaterNormalMaps_h
#define vtkWaterNormalMaps_h

#include "vtkSmartPointer.h"
#include "vtkTexture.h" // for members
#include "water_normals.h"

#include <string>
#include <vector>

class vtkWaterNormalMaps
{
public:
  static constexpr size_t Limit = 2;

  struct Layer
  {
    vtkSmartPointer<vtkTexture> Texture;
    water_normal_map Map;
  };

  // Adds a layer; nullptr is the built-in texture.
  //
  // Returns nothing, or what is wrong and what is accepted; then no layer is added.
  std::string Add(vtkTexture* texture, const water_normal_map& map);

  // What is wrong with a layer's texture, which may have changed since it was added; empty when
  // nothing is. Brings it up to date.
  static std::string Check(const Layer& layer);

  // When the picture of a layer that is right changed last.
  static vtkMTimeType GetTime(const Layer& layer);

  // The layer's slopes for a vtkWaterSlopeTexture, and its size, when it is right.
  static std::vector<float> GetTexels(const Layer& layer, int size[2]);

  std::vector<Layer> Layers;
};

#endif
