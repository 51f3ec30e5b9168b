// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterLakesInternals.h: what vtkWaterLakes keeps besides what is set, for its source files.
#ifndef vtkWaterLakesInternals_h
#define vtkWaterLakesInternals_h

#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWaterActor.h"
#include "vtkWaterColumns.h"
#include "vtkWaterCutPart.h"
#include "vtkWaterLakes.h"
#include "vtkWaterPlanesFilter.h"
#include "vtkWaterUncutSurface.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

struct vtkWaterLakes::Internals
{
  struct Host // that the waters are in
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    unsigned long Observers[2] = {}; // of the begin and the end of a frame
  };

  struct UncutKey // what an uncut surface depends on
  {
    void* Input = nullptr; // compared only
    std::array<vtkMTimeType, 4> Times{};
    std::vector<std::string> Shown;
    bool operator==(const UncutKey& other) const
    {
      return this->Input == other.Input && this->Times == other.Times && this->Shown == other.Shown;
    }
  };

  // Renderers that are gone have let go of the waters.
  void ForgetTheGone()
  {
    this->Hosts.erase(std::remove_if(this->Hosts.begin(), this->Hosts.end(),
                        [](const Host& host) { return !host.Renderer; }),
      this->Hosts.end());
  }

  vtkSmartPointer<vtkMapper> Mapper;
  const void* Input = nullptr; // of the mapper, in the last update; compared only
  vtkNew<vtkWaterPlanesFilter> Filter;
  vtkNew<vtkPolyData> Nothing; // that the first one shows when there is no water
  std::vector<vtkSmartPointer<vtkWaterActor>> Waters;
  std::vector<vtkSmartPointer<vtkMapper>> Mappers;        // theirs
  std::vector<vtkSmartPointer<vtkMapper>> DrawnMappers;   // of meshes that are cut while drawn
  std::vector<vtkSmartPointer<vtkWaterCutPart>> CutParts; // of the same
  std::vector<Host> Hosts;
  vtkWaterColumns Columns; // of the last step; its memory is used again
  vtkWaterUncutSurface Uncut;
  bool IsUncut = false;       // the waters are its blocks, else those of the filter
  bool IsUncutExact = false;  // as far as is known of the step
  bool IsSoftware = true;     // the renderer of the last frame; none has been drawn yet
  bool ClipsWell = false;     // the same
  vtkMTimeType UncutTime = 0; // a time for each step that was read
  UncutKey Key;               // what that is of
  vtkMTimeType BuiltTime = 0; // of the planes
  vtkMTimeType MapperTime = 0;
  vtkMTimeType FollowedTime = 0;
  std::array<double, 16> Matrix{}; // of the first water, that planes have been moved by
};

#endif
