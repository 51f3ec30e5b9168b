// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterC: the C interface, vtkWaterC.h. Copies and calls; what the objects report by an
// ErrorEvent, and every exception, becomes a status.
#include "vtkWaterC.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkAutoInit.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWaterActor.h"
#include "vtkWaterOffScreen.h"
#include "vtkWaterProperty.h"
#include "vtkWaterReflectionPass.h"

#include <cmath>
#include <cstring>
#include <exception>
#include <list>
#include <new>
#include <string>

// A C program includes nothing that would register VTK's OpenGL classes.
VTK_MODULE_INIT(vtkRenderingOpenGL2);

struct vtk_water_pass
{
  vtkWaterReflectionPass* Object = nullptr;
};

struct vtk_water_actor
{
  vtkNew<vtkWaterActor> Object;
  vtk_water_pass Pass;
};

struct vtk_water_scene
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

namespace
{
thread_local std::string lastError;

constexpr double kSmallestAngleToUp = 1e-6; // radians

const char* const statusTexts[VTK_WATER_STATUS_COUNT] = { "done", "an argument is NULL",
  "a value is out of range", "nothing can render here", "out of memory", "failed" };

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

vtk_water_status Fail(vtk_water_status status, const std::string& message)
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
    return VTK_WATER_NO_MEMORY;
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

// Asks for one value of a thing.
template <typename Handle, typename Value, typename Function>
vtk_water_status Ask(Handle* handle, Value* value, Function function) noexcept
{
  return Guarded([&] {
    if (!handle || !value)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, handle ? "the output is NULL" : "the handle is NULL");
    }
    *value = function(handle->Object);
    return VTK_WATER_OK;
  });
}

bool AreFinite(const double* values, size_t count)
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

bool IsColor(const double color[3])
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

vtkSmartPointer<vtkPolyData> MakeMesh(
  const double* points, size_t pointCount, const int64_t* triangles, size_t triangleCount)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  places->SetNumberOfPoints(static_cast<vtkIdType>(pointCount));
  for (size_t i = 0; i < pointCount; ++i)
  {
    places->SetPoint(static_cast<vtkIdType>(i), points + 3 * i);
  }
  vtkNew<vtkCellArray> cells;
  for (size_t i = 0; i < triangleCount; ++i)
  {
    cells->InsertNextCell({ static_cast<vtkIdType>(triangles[3 * i]),
      static_cast<vtkIdType>(triangles[3 * i + 1]), static_cast<vtkIdType>(triangles[3 * i + 2]) });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(places);
  data->SetPolys(cells);
  return data;
}
}

//------------------------------------------------------------------------------
const char* vtk_water_status_text(vtk_water_status status)
{
  return status >= 0 && status < VTK_WATER_STATUS_COUNT ? statusTexts[status] : "unknown status";
}

const char* vtk_water_last_error(void)
{
  return lastError.c_str();
}

int vtk_water_interface_version(void)
{
  return 1;
}

//------------------------------------------------------------------------------
vtk_water_status vtk_water_actor_new(vtk_water_actor** actor)
{
  return Guarded([&] {
    if (!actor)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "the output is NULL");
    }
    *actor = new vtk_water_actor;
    return VTK_WATER_OK;
  });
}

void vtk_water_actor_delete(vtk_water_actor* actor)
{
  delete actor;
}

vtk_water_status vtk_water_actor_set_level(vtk_water_actor* actor, double z)
{
  return Change(actor, [=](vtkWaterActor* water, vtkWaterProperty*) { water->SetLevel(z); });
}

vtk_water_status vtk_water_actor_set_plane(
  vtk_water_actor* actor, const double origin[3], const double normal[3])
{
  return Guarded([&] {
    if (!actor || !origin || !normal)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "actor, origin or normal is NULL");
    }
    const bool isZero = normal[0] == 0.0 && normal[1] == 0.0 && normal[2] == 0.0;
    if (!AreFinite(origin, 3) || !AreFinite(normal, 3) || isZero)
    {
      return Fail(VTK_WATER_BAD_VALUE, "origin and normal must be finite, the normal not zero");
    }
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(const_cast<double*>(origin));
    plane->SetNormal(const_cast<double*>(normal));
    actor->Object->SetPlane(plane);
    return VTK_WATER_OK;
  });
}

vtk_water_status vtk_water_actor_set_sheet_bounds(vtk_water_actor* actor, const double bounds[4])
{
  if (!bounds)
  {
    return Guarded([] { return Fail(VTK_WATER_NULL_ARGUMENT, "bounds is NULL"); });
  }
  return Change(
    actor, [=](vtkWaterActor* water, vtkWaterProperty*) { water->SetSheetBounds(bounds); });
}

vtk_water_status vtk_water_actor_set_preset(vtk_water_actor* actor, const char* name)
{
  return Change(actor, [=](vtkWaterActor*, vtkWaterProperty* look) { look->SetPreset(name); });
}

vtk_water_status vtk_water_actor_add_wave(vtk_water_actor* actor, double amplitude,
  double wavelength, double direction_deg, double phase_deg, double steepness)
{
  return Change(actor, [=](vtkWaterActor*, vtkWaterProperty* look) {
    look->AddWave(amplitude, wavelength, direction_deg, phase_deg, steepness);
  });
}

vtk_water_status vtk_water_actor_remove_all_waves(vtk_water_actor* actor)
{
  return Change(actor, [](vtkWaterActor*, vtkWaterProperty* look) { look->RemoveAllWaves(); });
}

vtk_water_status vtk_water_actor_set_wind(vtk_water_actor* actor, double speed)
{
  return Change(actor, [=](vtkWaterActor*, vtkWaterProperty* look) {
    if (speed != 0.0)
    {
      look->SetWindSpeed(speed);
    }
    if (lastError.empty())
    {
      look->SetSea(speed != 0.0);
    }
  });
}

vtk_water_status vtk_water_actor_set_time(vtk_water_actor* actor, double seconds)
{
  return Change(actor, [=](vtkWaterActor* water, vtkWaterProperty*) { water->SetTime(seconds); });
}

vtk_water_status vtk_water_actor_get_wave_height(
  vtk_water_actor* actor, double x, double y, double* height)
{
  return Ask(actor, height, [=](vtkWaterActor* water) { return water->GetWaveHeight(x, y); });
}

vtk_water_status vtk_water_actor_get_vtk_object(vtk_water_actor* actor, void** vtk_object)
{
  return Ask(actor, vtk_object, [](vtkWaterActor* water) -> void* { return water; });
}

//------------------------------------------------------------------------------
vtk_water_status vtk_water_actor_get_pass(vtk_water_actor* actor, vtk_water_pass** pass)
{
  return Guarded([&] {
    if (!actor || !pass)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "actor or the output is NULL");
    }
    actor->Pass.Object = actor->Object->GetReflectionPass();
    *pass = &actor->Pass;
    return VTK_WATER_OK;
  });
}

vtk_water_status vtk_water_pass_set_texture_scale(vtk_water_pass* pass, double scale)
{
  return Guarded([&] {
    if (!pass)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "pass is NULL");
    }
    const ErrorWatch watch(pass->Object);
    pass->Object->SetTextureScale(scale);
    return VTK_WATER_OK;
  });
}

vtk_water_status vtk_water_pass_get_render_count(vtk_water_pass* pass, int64_t* count)
{
  return Ask(
    pass, count, [](vtkWaterReflectionPass* it) { return it->GetNumberOfReflectionRenders(); });
}

vtk_water_status vtk_water_pass_get_prop_count(vtk_water_pass* pass, int64_t* count)
{
  return Ask(
    pass, count, [](vtkWaterReflectionPass* it) { return it->GetNumberOfPropsReflected(); });
}

vtk_water_status vtk_water_pass_get_decision(vtk_water_pass* pass, const char** text)
{
  return Ask(pass, text, [](vtkWaterReflectionPass* it) { return it->GetDecisionAsString(); });
}

//------------------------------------------------------------------------------
vtk_water_status vtk_water_scene_new(int width, int height, vtk_water_scene** scene)
{
  return Guarded([&] {
    if (!scene)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "the output is NULL");
    }
    if (width < 1 || width > 16384 || height < 1 || height > 16384)
    {
      return Fail(VTK_WATER_BAD_VALUE,
        "size is " + std::to_string(width) + " x " + std::to_string(height) +
          " pixels; both must lie in [1, 16384]");
    }
    if (!vtkWaterOffScreen::EnableIfNeeded())
    {
      return Fail(VTK_WATER_NO_OPENGL, vtkWaterOffScreen::GetReason());
    }
    vtk_water_scene* made = new vtk_water_scene;
    made->Window->SetOffScreenRendering(true);
    made->Window->SetSize(width, height);
    made->Window->AddRenderer(made->Renderer);
    *scene = made;
    return VTK_WATER_OK;
  });
}

void vtk_water_scene_delete(vtk_water_scene* scene)
{
  delete scene;
}

vtk_water_status vtk_water_scene_set_sky(
  vtk_water_scene* scene, const double bottom[3], const double top[3])
{
  return Guarded([&] {
    if (!scene || !bottom || !top)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "scene, bottom or top is NULL");
    }
    if (!IsColor(bottom) || !IsColor(top))
    {
      return Fail(VTK_WATER_BAD_VALUE, "red, green and blue must lie in [0, 1]");
    }
    scene->Renderer->GradientBackgroundOn();
    scene->Renderer->SetBackground(bottom[0], bottom[1], bottom[2]);
    scene->Renderer->SetBackground2(top[0], top[1], top[2]);
    return VTK_WATER_OK;
  });
}

vtk_water_status vtk_water_scene_add_mesh(vtk_water_scene* scene, const double* points,
  size_t point_count, const int64_t* triangles, size_t triangle_count, const double color[3])
{
  return Guarded([&] {
    if (!scene || !points || !triangles || !color)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "scene, points, triangles or color is NULL");
    }
    if (!AreFinite(points, 3 * point_count) || !IsColor(color))
    {
      return Fail(
        VTK_WATER_BAD_VALUE, "points must be finite; red, green and blue must lie in [0, 1]");
    }
    for (size_t i = 0; i < 3 * triangle_count; ++i)
    {
      if (triangles[i] < 0 || static_cast<uint64_t>(triangles[i]) >= point_count)
      {
        return Fail(VTK_WATER_BAD_VALUE,
          "triangle " + std::to_string(i / 3) + " names point " + std::to_string(triangles[i]) +
            "; there are " + std::to_string(point_count));
      }
    }
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(MakeMesh(points, point_count, triangles, triangle_count));
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(color[0], color[1], color[2]);
    scene->Renderer->AddActor(actor);
    return VTK_WATER_OK;
  });
}

vtk_water_status vtk_water_scene_add_water(vtk_water_scene* scene, vtk_water_actor* actor)
{
  return Guarded([&] {
    if (!scene || !actor)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "scene or actor is NULL");
    }
    scene->Renderer->AddActor(actor->Object);
    return VTK_WATER_OK;
  });
}

vtk_water_status vtk_water_scene_set_camera(vtk_water_scene* scene, const double eye[3],
  const double target[3], const double up[3], double angle_deg)
{
  return Guarded([&] {
    if (!scene || !eye || !target || !up)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "scene, eye, target or up is NULL");
    }
    const bool isPoint = eye[0] == target[0] && eye[1] == target[1] && eye[2] == target[2];
    double view[3];
    vtkMath::Subtract(target, eye, view);
    // VTK draws nothing with an up along the view; 0 for one of no length
    const double angleToUp = vtkMath::AngleBetweenVectors(view, up);
    const bool isTurned =
      angleToUp > kSmallestAngleToUp && angleToUp < vtkMath::Pi() - kSmallestAngleToUp;
    if (!AreFinite(eye, 3) || !AreFinite(target, 3) || !AreFinite(up, 3) || isPoint || !isTurned ||
      !(angle_deg >= 1.0 && angle_deg <= 170.0))
    {
      return Fail(VTK_WATER_BAD_VALUE,
        "eye, target and up must be finite, eye and target apart, up not zero nor along the view, "
        "the angle (" +
          std::to_string(angle_deg) + ") in [1, 170] degrees");
    }
    vtkCamera* camera = scene->Renderer->GetActiveCamera();
    camera->SetPosition(eye);
    camera->SetFocalPoint(target);
    camera->SetViewUp(up);
    camera->SetViewAngle(angle_deg);
    return VTK_WATER_OK;
  });
}

vtk_water_status vtk_water_scene_render(
  vtk_water_scene* scene, unsigned char* pixels, size_t byte_count)
{
  return Guarded([&] {
    if (!scene)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "scene is NULL");
    }
    const int* size = scene->Window->GetSize();
    const size_t width = static_cast<size_t>(size[0]), height = static_cast<size_t>(size[1]);
    if (pixels && byte_count < 3 * width * height)
    {
      return Fail(VTK_WATER_BAD_VALUE,
        std::to_string(byte_count) + " bytes are too few for " + std::to_string(width) + " x " +
          std::to_string(height) + " x 3");
    }
    // what waters report meanwhile is said with the picture that shows the rest
    std::list<ErrorWatch> watches;
    vtkActorCollection* actors = scene->Renderer->GetActors();
    vtkCollectionSimpleIterator next;
    actors->InitTraversal(next);
    while (vtkActor* actor = actors->GetNextActor(next))
    {
      if (auto* water = vtkWaterActor::SafeDownCast(actor))
      {
        watches.emplace_back(water);
        watches.emplace_back(water->GetReflectionPass());
      }
    }
    scene->Renderer->ResetCameraClippingRange();
    scene->Window->Render();
    if (!pixels)
    {
      return VTK_WATER_OK;
    }
    vtkNew<vtkUnsignedCharArray> picture;
    scene->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, picture);
    for (size_t row = 0; row < height; ++row)
    {
      std::memcpy(pixels + 3 * width * row,
        picture->GetPointer(static_cast<vtkIdType>(3 * width * (height - 1 - row))), 3 * width);
    }
    return VTK_WATER_OK;
  });
}
