// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterCInternals.h: what the files of the C interface share: handles, and how what the objects
// report by an ErrorEvent, and every exception, becomes a status.
#ifndef vtkWaterCInternals_h
#define vtkWaterCInternals_h

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkWaterActor.h"
#include "vtkWaterC.h"
#include "vtkWaterProperty.h"

#include <cmath>
#include <cstring>
#include <exception>
#include <new>
#include <sstream>
#include <string>

struct vtk_water_pass
{
  vtkWaterReflectionPass* Object = nullptr;
};

struct vtk_water_actor
{
  vtkNew<vtkWaterActor> Object;
  vtk_water_pass Pass;
  vtkSmartPointer<vtkPolyData> Surface; // of vtk_water_actor_set_surface; nullptr: the sheet
};

namespace vtkWaterC
{
// What vtk_water_last_error returns.
extern thread_local std::string lastError;

// Adds what an object reports to lastError, and keeps it from being printed.
class ErrorWatch
{
public:
  explicit ErrorWatch(vtkObject* object)
    : Object(object)
  {
    this->Command->SetCallback([](vtkObject*, unsigned long, void*, void* text) {
      // "ERROR: In file, line\nclass (address): what"
      const char* what = static_cast<const char*>(text);
      const char* start = std::strstr(what, "): ");
      std::string message = start ? start + 3 : what;
      message.erase(message.find_last_not_of('\n') + 1);
      lastError += (lastError.empty() ? "" : " ") + message;
    });
    this->Tag = object->AddObserver("ErrorEvent", this->Command);
  }
  ~ErrorWatch() { this->Object->RemoveObserver(this->Tag); }
  ErrorWatch(const ErrorWatch&) = delete;
  void operator=(const ErrorWatch&) = delete;

private:
  vtkObject* Object;
  vtkNew<vtkCallbackCommand> Command;
  unsigned long Tag;
};

inline vtk_water_status Fail(vtk_water_status status, const std::string& message)
{
  lastError = message;
  return status;
}

// Runs what may throw. It returns a status, or nothing and reports by lastError.
template <typename Function>
vtk_water_status Guarded(Function function) noexcept
{
  try
  {
    lastError.clear();
    const vtk_water_status status = function();
    return status == VTK_WATER_OK && !lastError.empty() ? VTK_WATER_BAD_VALUE : status;
  }
  catch (const std::bad_alloc&)
  {
    return Fail(VTK_WATER_NO_MEMORY, "out of memory"); // so short that it needs none
  }
  catch (const std::exception& exception)
  {
    return Fail(VTK_WATER_FAILED, exception.what());
  }
  catch (...)
  {
    return VTK_WATER_FAILED;
  }
}

// A change of the water or its look.
template <typename Function>
vtk_water_status Change(vtk_water_actor* actor, Function function) noexcept
{
  return Guarded([&] {
    if (!actor)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "actor is NULL");
    }
    const ErrorWatch ofActor(actor->Object);
    const ErrorWatch ofLook(actor->Object->GetWaterProperty());
    function(actor->Object.Get(), actor->Object->GetWaterProperty());
    return VTK_WATER_OK;
  });
}

inline bool AreFinite(const double* values, size_t count)
{
  for (size_t i = 0; i < count; ++i)
  {
    if (!std::isfinite(values[i]))
    {
      return false;
    }
  }
  return true;
}

// Red, green and blue in [0, 1].
inline bool IsColor(const double color[3])
{
  for (int i = 0; i < 3; ++i)
  {
    if (!(color[i] >= 0.0 && color[i] <= 1.0))
    {
      return false;
    }
  }
  return true;
}

// Numbers as the texts of errors have them.
inline std::string TextOf(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

inline std::string TextOf(const double values[3])
{
  return "(" + TextOf(values[0]) + ", " + TextOf(values[1]) + ", " + TextOf(values[2]) + ")";
}

// What is wrong with a place and with a colour; empty: nothing.
inline std::string DescribeBadPlace(const std::string& name, const double place[3])
{
  return AreFinite(place, 3) ? "" : name + " is " + TextOf(place) + "; it must be finite";
}

inline std::string DescribeBadColor(const std::string& name, const double color[3])
{
  return IsColor(color)
    ? ""
    : name + " is " + TextOf(color) + "; red, green and blue must lie in [0, 1]";
}

// What is wrong with a mesh of a caller's; empty: nothing.
std::string DescribeBadMesh(
  const double* points, size_t pointCount, const int64_t* triangles, size_t triangleCount);

vtkSmartPointer<vtkPolyData> MakeMesh(
  const double* points, size_t pointCount, const int64_t* triangles, size_t triangleCount);

// A picture's size in words when it is none that can be; empty: it can.
std::string DescribeBadSize(int width, int height);
}
#endif
