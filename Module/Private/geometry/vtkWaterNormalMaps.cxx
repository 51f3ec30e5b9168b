// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterNormalMaps.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <sstream>

namespace
{
constexpr int kSmallestImage = 2;
constexpr int kLargestImage = 4096;
constexpr int kBuiltInSize = 256;
constexpr int kBuiltInSeed = 20061214;

vtkSmartPointer<vtkTexture> MakeBuiltIn()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(kBuiltInSize, kBuiltInSize, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  water_normals_fill(
    kBuiltInSize, kBuiltInSeed, static_cast<unsigned char*>(image->GetScalarPointer()));
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

// What is wrong with a texture as a normal map; empty when nothing is.
std::string CheckPicture(vtkTexture* texture)
{
  std::ostringstream wrong;
  vtkImageData* image = nullptr;
  if (!texture->GetCubeMap() && texture->GetNumberOfInputConnections(0) > 0)
  {
    texture->Update();
    image = texture->GetInput();
  }
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars)
  {
    return "the texture must hold one picture";
  }
  const int* size = image->GetDimensions();
  const int channels = scalars->GetNumberOfComponents();
  if (size[2] != 1 || size[0] < kSmallestImage || size[1] < kSmallestImage ||
    size[0] > kLargestImage || size[1] > kLargestImage)
  {
    wrong << "the picture is " << size[0] << " x " << size[1] << " x " << size[2]
          << "; it must be from " << kSmallestImage << " x " << kSmallestImage << " to "
          << kLargestImage << " x " << kLargestImage;
  }
  else if (channels != 3 && channels != 4)
  {
    wrong << "the picture has " << channels << " channel(s); it must have 3 or 4";
  }
  else if (!vtkUnsignedCharArray::SafeDownCast(scalars))
  {
    wrong << "the picture is of type " << scalars->GetDataTypeAsString()
          << "; it must be of 8 bits a channel (unsigned char)";
  }
  return wrong.str();
}
}

//------------------------------------------------------------------------------
std::string vtkWaterNormalMaps::Add(vtkTexture* texture, const water_normal_map& map)
{
  const water_status status = water_normals_check(&map);
  if (status != WATER_OK)
  {
    return water_status_text(status);
  }
  if (this->Layers.size() == Limit)
  {
    return "there are two normal maps already; at most two are accepted";
  }
  Layer layer{ texture ? vtkSmartPointer<vtkTexture>(texture) : MakeBuiltIn(), map };
  const std::string wrong = CheckPicture(layer.Texture);
  if (wrong.empty())
  {
    this->Layers.push_back(layer);
  }
  return wrong;
}

//------------------------------------------------------------------------------
std::string vtkWaterNormalMaps::Check(const Layer& layer)
{
  return CheckPicture(layer.Texture);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkWaterNormalMaps::GetTime(const Layer& layer)
{
  return std::max(layer.Texture->GetMTime(), layer.Texture->GetInput()->GetMTime());
}

//------------------------------------------------------------------------------
std::vector<float> vtkWaterNormalMaps::GetTexels(const Layer& layer, int size[2])
{
  vtkImageData* image = layer.Texture->GetInput();
  auto* pixels = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
  std::copy(image->GetDimensions(), image->GetDimensions() + 2, size);
  const auto count = static_cast<size_t>(size[0]) * static_cast<size_t>(size[1]);
  std::vector<float> texels(4 * count);
  water_normals_texels(pixels->GetPointer(0), static_cast<size_t>(pixels->GetNumberOfComponents()),
    count, texels.data());
  return texels;
}
