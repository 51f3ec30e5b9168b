// SPDX-License-Identifier: BSD-3-Clause
// WaterFaultyScene.h: the shared scene with its water's errors and its picture as bytes.
#ifndef WaterFaultyScene_h
#define WaterFaultyScene_h

#include "WaterTestScene.h"

#include "vtkCallbackCommand.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

// Are two pictures the same, byte for byte? Says how they differ.
inline bool WaterSame(
  const std::vector<unsigned char>& found, const std::vector<unsigned char>& expected)
{
  if (found.size() != expected.size())
  {
    return false;
  }
  size_t count = 0;
  int largest = 0;
  for (size_t i = 0; i < found.size(); ++i)
  {
    const int difference = std::abs(static_cast<int>(found[i]) - static_cast<int>(expected[i]));
    count += difference > 0 ? 1 : 0;
    largest = std::max(largest, difference);
  }
  if (count > 0)
  {
    std::cout << count << " bytes differ, by " << largest << " at most" << std::endl;
  }
  return count == 0;
}

struct FaultyScene : public WaterTestScene
{
  std::vector<std::string> Errors;

  explicit FaultyScene(vtkRenderWindow* window = WaterTestWindow())
    : WaterTestScene(window)
  {
    this->AddThings<vtkPolyDataMapper>();
    this->AddWater();
    // the medium's own colour is not known where there is no view
    this->Water->GetWaterProperty()->SetDeepColor(0.02, 0.09, 0.13);
    vtkNew<vtkCallbackCommand> note;
    note->SetClientData(&this->Errors);
    note->SetCallback([](vtkObject*, unsigned long, void* errors, void* text) {
      static_cast<std::vector<std::string>*>(errors)->push_back(static_cast<char*>(text));
    });
    this->Water->AddObserver(vtkCommand::ErrorEvent, note);
  }

  std::vector<unsigned char> Picture()
  {
    this->Window->Render();
    return this->Read();
  }

  // The picture that was rendered.
  std::vector<unsigned char> Read()
  {
    vtkNew<vtkUnsignedCharArray> pixels;
    const int* size = this->Window->GetSize();
    this->Window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
    return std::vector<unsigned char>(
      pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
  }

  // The same with water that reflects nothing.
  std::vector<unsigned char> Plain()
  {
    auto* look = this->Water->GetWaterProperty();
    look->SetReflectanceModeToConstant();
    look->SetReflectance(0.0);
    return this->Picture();
  }
};

#endif
