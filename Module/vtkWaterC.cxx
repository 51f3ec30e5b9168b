// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterC: the C interface, vtkWaterC.h: statuses, waters and their passes. Copies and calls.
#include "vtkWaterC.h"

#include "vtkPlane.h"
#include "vtkWaterCInternals.h"
#include "vtkWaterReflectionPass.h"

using namespace vtkWaterC;

thread_local std::string vtkWaterC::lastError;

namespace
{
const char* const statusTexts[VTK_WATER_STATUS_COUNT] = { "done", "an argument is NULL",
  "a value is out of range", "nothing can render here", "out of memory", "failed" };

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
}

//------------------------------------------------------------------------------
const char* vtk_water_status_text(vtk_water_status status)
{
  const int place = status; // a C program may hand over any number
  return place >= 0 && place < VTK_WATER_STATUS_COUNT ? statusTexts[place] : "unknown status";
}

const char* vtk_water_last_error(void)
{
  return lastError.c_str();
}

int vtk_water_interface_version(void)
{
  return 1;
}

const char* vtk_water_version(void)
{
  return WATER_VERSION;
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
    std::string wrong = DescribeBadPlace("origin", origin);
    if (wrong.empty() && (isZero || !AreFinite(normal, 3)))
    {
      wrong = "normal is " + TextOf(normal) + "; it must be finite and not zero";
    }
    if (!wrong.empty())
    {
      return Fail(VTK_WATER_BAD_VALUE, wrong);
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

vtk_water_status vtk_water_actor_set_sheet_to_automatic(vtk_water_actor* actor)
{
  return Change(
    actor, [](vtkWaterActor* water, vtkWaterProperty*) { water->SetSheetToAutomatic(); });
}

vtk_water_status vtk_water_actor_set_sheet_to_horizon(vtk_water_actor* actor)
{
  return Change(actor, [](vtkWaterActor* water, vtkWaterProperty*) { water->SetSheetToHorizon(); });
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

vtk_water_status vtk_water_pass_set_time_budget(vtk_water_pass* pass, double milliseconds)
{
  return Guarded([&] {
    if (!pass)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "pass is NULL");
    }
    const ErrorWatch watch(pass->Object);
    if (milliseconds != 0.0)
    {
      pass->Object->SetTimeBudget(milliseconds);
    }
    if (lastError.empty())
    {
      pass->Object->SetQuality(
        milliseconds != 0.0 ? vtkWaterReflectionPass::TIME_BUDGET : vtkWaterReflectionPass::FIXED);
    }
    return VTK_WATER_OK;
  });
}

vtk_water_status vtk_water_pass_set_secondary_reflections(vtk_water_pass* pass, int reflections)
{
  return Guarded([&] {
    if (!pass)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "pass is NULL");
    }
    if (reflections != 0 && reflections != 1)
    {
      return Fail(VTK_WATER_BAD_VALUE,
        "secondary reflections is " + std::to_string(reflections) + "; it must be 0 or 1");
    }
    pass->Object->SetSecondaryReflections(reflections == 1);
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
