// SPDX-License-Identifier: BSD-3-Clause
// WaterFaultyScene.h: the shared scene with its water's errors and its picture as bytes.
#ifndef WaterFaultyScene_h
#define WaterFaultyScene_h

#include "WaterTestScene.h"

#include "vtkCallbackCommand.h"
#include "vtkUnsignedCharArray.h"

#include <string>
#include <vector>

struct FaultyScene : public WaterTestScene
{
  std::vector<std::string> Errors;

  FaultyScene()
  {
    this->AddThings<vtkPolyDataMapper>();
    this->AddWater();
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
