// SPDX-License-Identifier: BSD-3-Clause
// WaterPictures.h: a window's picture as bytes, and how far two of them are apart.
#ifndef WaterPictures_h
#define WaterPictures_h

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

// Red, green, blue and alpha of each pixel, rows from below; the window has been rendered.
inline std::vector<unsigned char> WaterRead(vtkRenderWindow* window)
{
  vtkNew<vtkUnsignedCharArray> pixels;
  const int* size = window->GetSize();
  window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
  return std::vector<unsigned char>(
    pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
}

struct WaterDifference
{
  double Share; // of the pixels that are off by more than 1 of 255
  double Rms;   // of 255
};

inline WaterDifference WaterCompare(
  const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  size_t off = 0;
  double sum = 0.0;
  for (size_t i = 0; i < a.size(); i += 4)
  {
    bool isOff = false;
    for (size_t k = 0; k < 3; ++k)
    {
      const double difference = std::abs(a[i + k] - b[i + k]);
      isOff = isOff || difference > 1.0;
      sum += difference * difference;
    }
    off += isOff;
  }
  const double pixels = static_cast<double>(a.size()) / 4.0;
  return { static_cast<double>(off) / pixels, std::sqrt(sum / (3.0 * pixels)) };
}

// Leaves a picture in the folder WATER_TEST_OUTPUT, if that is set.
inline void WaterLeave(
  std::string name, const std::vector<unsigned char>& picture, vtkRenderWindow* window)
{
  const char* folder = std::getenv("WATER_TEST_OUTPUT");
  if (!folder)
  {
    return;
  }
  std::replace(name.begin(), name.end(), ' ', '-');
  std::ofstream file(std::string(folder) + "/" + name + ".ppm", std::ios::binary);
  const auto width = static_cast<size_t>(window->GetSize()[0]);
  file << "P6 " << width << " " << picture.size() / 4 / width << " 255\n";
  for (size_t row = picture.size() / 4 / width; row-- > 0;)
  {
    for (size_t i = row * width; i < (row + 1) * width; ++i)
    {
      file.write(reinterpret_cast<const char*>(&picture[4 * i]), 3);
    }
  }
}

#endif
