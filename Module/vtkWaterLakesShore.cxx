// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterLakesShore.cxx: the part of vtkWaterLakes that has the shore cut while it is drawn. See
// Documentation/decisions/024-steps-of-data.md.
#include "vtkAbstractMapper.h"
#include "vtkAlgorithmOutput.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTimeStamp.h"
#include "vtkWaterColumns.h"
#include "vtkWaterCompat.h"
#include "vtkWaterFrame.h"
#include "vtkWaterLakesInternals.h"
#include "vtkWaterMeshTraits.h"
#include "vtkWaterSource.h"
#include "vtkWaterSurfaceFilter.h"
#include "vtkWaterUncutMapper.h"
#include "water_plane.h"
#include "water_shore_draw.h"

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Brings a filter's input up to date, as an update of the filter would.
vtkDataSet* UpdateInput(vtkAlgorithm* filter)
{
  vtkAlgorithmOutput* input = filter->GetInputConnection(0, 0);
  filter->UpdateInformation();
  filter->PropagateUpdateExtent();
  auto* executive =
    vtkStreamingDemandDrivenPipeline::SafeDownCast(input->GetProducer()->GetExecutive());
  if (!executive)
  {
    return nullptr;
  }
  // a filter that is up to date passes no time on, and another consumer may have asked for one
  // since
  vtkInformationDoubleKey* step = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
  vtkInformation* asked = filter->GetOutputInformation(0);
  vtkInformation* of = filter->GetInputInformation(0, 0);
  if (asked->Has(step))
  {
    of->Set(step, asked->Get(step));
  }
  else
  {
    of->Remove(step);
  }
  executive->PropagateUpdateExtent(input->GetIndex());
  if (!executive->UpdateData(input->GetIndex()))
  {
    return nullptr;
  }
  return vtkDataSet::SafeDownCast(filter->GetInputDataObject(0, 0));
}

// Does VTK draw the water as triangles, by shaders of its own?
bool IsPlainDraw(vtkMapper* mapper, vtkActor* water)
{
  vtkProperty* property = water->GetProperty();
  return vtkWaterMeshTraits::AsPolyDataMapper(mapper) &&
    !vtkWaterMeshTraits::HasOwnShaders(mapper, water) &&
    property->GetRepresentation() == VTK_SURFACE && !property->GetEdgeVisibility() &&
    !property->GetVertexVisibility();
}
}

//------------------------------------------------------------------------------
void vtkWaterLakes::SetShoreCut(int cut)
{
  vtkWaterSetInRange(ShoreCut, cut, CUT_AUTOMATIC, CUT_WHILE_DRAWN);
}

//------------------------------------------------------------------------------
const char* vtkWaterLakes::GetShoreCutAsString() const
{
#define WATER_SHORE_CUT_NAME(name) "CUT_" #name,
  static const char* const names[] = { WATER_SHORE_CUT_LIST(WATER_SHORE_CUT_NAME) };
#undef WATER_SHORE_CUT_NAME
  return names[this->ShoreCut];
}

//------------------------------------------------------------------------------
bool vtkWaterLakes::GetIsShoreCutWhileDrawn() const
{
  return this->Internal->IsUncut;
}

//------------------------------------------------------------------------------
void vtkWaterLakes::ReadRenderer(vtkRenderer* renderer)
{
  Internals& internal = *this->Internal;
  const bool isGL = vtkOpenGLRenderer::SafeDownCast(renderer) &&
    vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  internal.IsSoftware = !isGL || vtkWaterFrame::Of(renderer).IsSoftware();
  internal.ClipsWell = isGL && vtkWaterFrame::Of(renderer).ClipsWell(this->GetWater());
}

//------------------------------------------------------------------------------
void vtkWaterLakes::EndFrame()
{
  for (const auto& water : this->Internal->Waters)
  {
    water->GetSource()->SetIsDrawing(false);
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkWaterLakes::FindShownNames() const
{
  std::vector<std::string> names;
  const vtkWaterActor* first = this->GetWater();
  for (const std::string& name :
    { first->GetFlowArrayName(), first->GetMatterArrayName(), first->GetFoamArrayName() })
  {
    if (!name.empty())
    {
      names.push_back(name);
    }
  }
  return names;
}

//------------------------------------------------------------------------------
bool vtkWaterLakes::ReadUncut(vtkAlgorithmOutput* input)
{
  Internals& internal = *this->Internal;
  auto* surface = vtkWaterSurfaceFilter::SafeDownCast(input->GetProducer());
  const water_shore_renderer renderer = { static_cast<water_shore_cut_setting>(this->ShoreCut),
    internal.IsSoftware, internal.ClipsWell, IsPlainDraw(internal.Mapper, this->GetWater()),
    surface && surface->GetNumberOfInputConnections(0) > 0 };
  vtkDataSet* data = water_shore_draw_is_wanted(&renderer) ? UpdateInput(surface) : nullptr;
  if (!data)
  {
    internal.Key = Internals::UncutKey();
    return false;
  }
  Internals::UncutKey key;
  key.Input = data;
  key.Times = { data->GetMTime(), surface->GetMTime(), internal.Filter->GetMTime(),
    internal.Mapper->GetMTime() };
  key.Shown = this->FindShownNames();
  if (key == internal.Key)
  {
    return internal.IsUncutExact;
  }
  internal.Key = key;
  vtkTimeStamp now;
  now.Modified();
  internal.UncutTime = now.GetMTime();
  surface->IsCutMissing = true;
  vtkNew<vtkPolyData> mesh;
  vtkWaterColumns& columns = internal.Columns;
  if (!surface->ReadStep(data, mesh, columns))
  {
    internal.Uncut.Forget(); // no surface, which has been said
    internal.IsUncutExact = true;
    return true;
  }
  vtkWaterUncutSurface::Given given;
  given.Mesh = mesh;
  given.Scale = surface->GetVerticalScale();
  const double* up = internal.Filter->GetUpDirection();
  const water_plane level = { { up[0], up[1], up[2] }, 0.0 };
  water_plane unit = level;
  water_plane_normalise(&level, &unit); // the setter has checked it
  std::copy_n(unit.normal, 3, given.Up);
  given.MostPlanes = static_cast<size_t>(internal.Filter->GetMaximumNumberOfPlanes());
  for (const std::string& name : key.Shown)
  {
    given.Shown.push_back(mesh->GetPointData()->GetArray(name.c_str()));
  }
  vtkMapper* mapper = internal.Mapper;
  if (mapper->GetScalarVisibility())
  {
    int isOfCells = 0;
    vtkAbstractArray* colors = vtkAbstractMapper::GetAbstractScalars(mesh, mapper->GetScalarMode(),
      mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), isOfCells);
    given.Shown.push_back(isOfCells == 0 ? vtkDataArray::SafeDownCast(colors) : nullptr);
  }
  internal.IsUncutExact = internal.Uncut.Make(given, columns);
  return internal.IsUncutExact;
}

//------------------------------------------------------------------------------
vtkMapper* vtkWaterLakes::FindDrawnMapper(size_t number) const
{
  const Internals& internal = *this->Internal;
  return internal.IsUncut && number < internal.DrawnMappers.size()
    ? internal.DrawnMappers[number].Get()
    : nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterLakes::ShowUncut(size_t number, vtkPolyData* part, vtkMapper* mapper)
{
  Internals& internal = *this->Internal;
  internal.DrawnMappers.resize(internal.Waters.size());
  internal.CutParts.resize(internal.Waters.size());
  vtkSmartPointer<vtkMapper>& drawn = internal.DrawnMappers[number];
  vtkSmartPointer<vtkWaterCutPart>& cut = internal.CutParts[number];
  if (!drawn)
  {
    drawn = vtkSmartPointer<vtkWaterUncutMapper>::New(); // of the mapper's class: IsPlainDraw
  }
  if (!cut)
  {
    cut = vtkSmartPointer<vtkWaterCutPart>::New();
  }
  drawn->ShallowCopy(internal.Mapper);
  drawn->SetInputDataObject(0, part);
  cut->SetInputDataObject(0, part);
  mapper->SetInputConnection(0, cut->GetOutputPort());
  internal.Waters[number]->SetMapper(mapper);
  internal.Waters[number]->GetSource()->SetDrawnMapper(drawn);
}
VTK_ABI_NAMESPACE_END
