// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterCScene.cxx: the part of the C interface, vtkWaterC.h, that makes scenes and renders them,
// for programs without VTK. Copies and calls.
#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkAutoInit.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWaterCInternals.h"
#include "vtkWaterOffScreen.h"
#include "vtkWaterReflectionPass.h"
#include "water_plane.h"

#include <cstring>
#include <list>

// A C program includes nothing that would register VTK's OpenGL classes.
VTK_MODULE_INIT(vtkRenderingOpenGL2);

using namespace vtkWaterC;

struct vtk_water_scene
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkLight> Sun; // in the renderer when it was set
  bool HasLights = false;

  // Adds a light; the first takes the place of VTK's own, which a frame without lights has made.
  void AddLight(vtkLight* light)
  {
    if (!this->HasLights)
    {
      this->Renderer->RemoveAllLights();
      this->HasLights = true;
    }
    if (!this->Renderer->GetLights()->IsItemPresent(light))
    {
      this->Renderer->AddLight(light);
    }
  }
};

namespace
{
constexpr double kSmallestAngleToUp = 1e-6; // radians
constexpr double kSunColor[3] = { 1.0, 0.95, 0.87 };
}

//------------------------------------------------------------------------------
vtk_water_status vtk_water_scene_new(int width, int height, vtk_water_scene** scene)
{
  return Guarded([&] {
    if (!scene)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "the output is NULL");
    }
    const std::string wrong = DescribeBadSize(width, height);
    if (!wrong.empty())
    {
      return Fail(VTK_WATER_BAD_VALUE, wrong);
    }
    if (!vtkWaterOffScreen::EnableIfNeeded())
    {
      return Fail(VTK_WATER_NO_OPENGL, vtkWaterOffScreen::GetReason());
    }
    vtk_water_scene* made = new vtk_water_scene;
    made->Window->SetOffScreenRendering(true);
    made->Window->SetSize(width, height);
    made->Window->AddRenderer(made->Renderer);
    made->Renderer->SetEnvironmentUp(0.0, 0.0, 1.0);
    made->Renderer->SetEnvironmentRight(1.0, 0.0, 0.0);
    made->Sun->SetLightTypeToSceneLight();
    made->Sun->SetFocalPoint(0.0, 0.0, 0.0);
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
    std::string wrong = DescribeBadColor("bottom", bottom);
    wrong = wrong.empty() ? DescribeBadColor("top", top) : wrong;
    if (!wrong.empty())
    {
      return Fail(VTK_WATER_BAD_VALUE, wrong);
    }
    scene->Renderer->GradientBackgroundOn();
    scene->Renderer->SetBackground(bottom[0], bottom[1], bottom[2]);
    scene->Renderer->SetBackground2(top[0], top[1], top[2]);
    return VTK_WATER_OK;
  });
}

vtk_water_status vtk_water_scene_set_sun(
  vtk_water_scene* scene, double azimuth_deg, double elevation_deg, const double color[3])
{
  return Guarded([&] {
    if (!scene)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "scene is NULL");
    }
    const double* rgb = color ? color : kSunColor;
    if (!std::isfinite(azimuth_deg) || !(elevation_deg >= 0.0 && elevation_deg <= 90.0))
    {
      return Fail(VTK_WATER_BAD_VALUE,
        "azimuth is " + TextOf(azimuth_deg) + " and elevation " + TextOf(elevation_deg) +
          " degrees; the azimuth must be finite, and the elevation must lie in [0, 90]");
    }
    const std::string wrong = DescribeBadColor("color", rgb);
    if (!wrong.empty())
    {
      return Fail(VTK_WATER_BAD_VALUE, wrong);
    }
    const double up[3] = { 0.0, 0.0, 1.0 };
    double direction[3];
    water_plane_sky_direction(up, vtkMath::RadiansFromDegrees(azimuth_deg),
      vtkMath::RadiansFromDegrees(elevation_deg), direction);
    scene->Sun->SetPosition(direction);
    scene->Sun->SetColor(rgb[0], rgb[1], rgb[2]);
    scene->AddLight(scene->Sun);
    return VTK_WATER_OK;
  });
}

vtk_water_status vtk_water_scene_add_light(
  vtk_water_scene* scene, const double position[3], const double color[3], double intensity)
{
  return Guarded([&] {
    if (!scene || !position || !color)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "scene, position or color is NULL");
    }
    std::string wrong = DescribeBadPlace("position", position);
    wrong = wrong.empty() ? DescribeBadColor("color", color) : wrong;
    if (wrong.empty() && (!(intensity >= 0.0) || !std::isfinite(intensity)))
    {
      wrong = "intensity is " + TextOf(intensity) + "; it must be finite and not negative";
    }
    if (!wrong.empty())
    {
      return Fail(VTK_WATER_BAD_VALUE, wrong);
    }
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPositional(true);
    light->SetConeAngle(180.0); // to all sides
    light->SetPosition(position[0], position[1], position[2]);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetColor(color[0], color[1], color[2]);
    light->SetIntensity(intensity);
    scene->AddLight(light);
    return VTK_WATER_OK;
  });
}

vtk_water_status vtk_water_scene_remove_all_lights(vtk_water_scene* scene)
{
  return Guarded([&] {
    if (!scene)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "scene is NULL");
    }
    scene->Renderer->RemoveAllLights();
    scene->HasLights = false;
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
    const std::string wrong = IsColor(color)
      ? DescribeBadMesh(points, point_count, triangles, triangle_count)
      : DescribeBadColor("color", color);
    if (!wrong.empty())
    {
      return Fail(VTK_WATER_BAD_VALUE, wrong);
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
    std::string wrong = DescribeBadPlace("eye", eye);
    wrong = wrong.empty() ? DescribeBadPlace("target", target) : wrong;
    wrong = wrong.empty() ? DescribeBadPlace("up", up) : wrong;
    if (wrong.empty() && isPoint)
    {
      wrong = "eye and target are both " + TextOf(eye) + "; they must be apart";
    }
    if (wrong.empty() && !isTurned)
    {
      wrong =
        "up is " + TextOf(up) + "; it must be neither zero nor along the view " + TextOf(view);
    }
    if (wrong.empty() && !(angle_deg >= 1.0 && angle_deg <= 170.0))
    {
      wrong = "angle is " + TextOf(angle_deg) + "; it must lie in [1, 170] degrees";
    }
    if (!wrong.empty())
    {
      return Fail(VTK_WATER_BAD_VALUE, wrong);
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
