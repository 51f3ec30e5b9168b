// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterClusters.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"
#include "vtkWaterAccess.h"
#include "vtkWaterGL.h"
#include "vtkWaterMeshTraits.h"
#include "vtkWaterProps.h"

#include <algorithm>
#include <exception>
#include <new>
#include <thread>

namespace
{
// What the vertices that the GPU has are relative to: VTK shifts those of meshes that are large, or
// far off.
std::array<double, 3> OriginOf(vtkOpenGLPolyDataMapper* mapper)
{
  std::array<double, 3> origin{};
  double scale[3];
  vtkWaterMeshTraits::ReadShiftAndScale(mapper, origin.data(), scale);
  return origin;
}

// Calls back for every number below a count, at the same time if the machine lets us.
template <typename Function>
void ForEach(int count, const Function& function)
{
  std::vector<std::thread> others;
  others.reserve(static_cast<size_t>(count)); // nothing throws between here and their ends
  for (int i = 1; i < count; ++i)
  {
    try
    {
      others.emplace_back(function, i);
    }
    catch (const std::exception&) // no more threads, or no memory for one
    {
      function(i);
    }
  }
  function(0);
  for (std::thread& other : others)
  {
    other.join();
  }
}

bool AreWorth(const water_plan& plan, vtkOpenGLPolyDataMapper* mapper)
{
  const size_t count = vtkWaterAccess::PolyDataMapper::TrianglesOf(mapper)->IndexCount / 3;
  return plan.is_software ? water_clusters_count(count) > 0 : water_runs_are_worth(count);
}
}

//------------------------------------------------------------------------------
vtkWaterClusters::vtkWaterClusters()
  : Drawer(vtkSmartPointer<vtkCallbackCommand>::New())
{
  this->Drawer->SetClientData(this);
  this->Drawer->SetCallback([](vtkObject* mapper, unsigned long, void* clusters, void*) {
    auto* self = static_cast<vtkWaterClusters*>(clusters);
    if (vtkWaterAccess::PolyDataMapper::AreTrianglesNext(
          static_cast<vtkOpenGLPolyDataMapper*>(mapper)))
    {
      self->DrawnRuns->Draw(self->Own, *self->ClipDistance);
    }
  });
}

//------------------------------------------------------------------------------
vtkWaterClusters::~vtkWaterClusters()
{
  this->TakeBack();
}

//------------------------------------------------------------------------------
bool vtkWaterClusters::CanLead(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  auto* mapper = actor ? vtkOpenGLPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  const auto it = this->Meshes.find(mapper);
  return mapper && it != this->Meshes.end() && it->second.Mapper && !it->second.Boxes.empty() &&
    it->second.State == StateOf(mapper, actor) &&
    !vtkWaterMeshTraits::HasOwnShaders(mapper, actor) &&
    !vtkWaterMeshTraits::HasOwnDepths(mapper, actor) && vtkWaterProps::IsInWorld(actor) &&
    vtkWaterMeshTraits::IsOpaqueEverywhere(actor) &&
    vtkWaterMeshTraits::HasTrianglesOnly(mapper, actor->GetProperty());
}

//------------------------------------------------------------------------------
void vtkWaterClusters::BeginView(const water_plan& plan, const water_visibility* seen, int samples,
  vtkWaterClipDistance* clipDistance)
{
  for (auto it = this->Meshes.begin(); it != this->Meshes.end();)
  {
    it = it->second.Mapper ? std::next(it) : this->Meshes.erase(it);
  }
  this->ClipDistance = clipDistance;
  this->Target = { seen, nullptr, samples, 0 };
  this->Shortage = vtkWaterShortage();
  glGetIntegerv(GL_SUBPIXEL_BITS, &this->Target.subpixel_bits);
  if (plan.is_software)
  {
    const int* rect = plan.texture_rect_px;
    try
    {
      this->Depths.resize(static_cast<size_t>(rect[2]) * static_cast<size_t>(rect[3]));
    }
    catch (const std::bad_alloc&)
    {
      this->Shortage.What = "no memory for the depths that cull parts of large meshes";
      return;
    }
    water_triangle_cull_begin(rect, seen, this->Depths.data());
    this->Target.depths = this->Depths.data();
  }
}

//------------------------------------------------------------------------------
size_t vtkWaterClusters::BeginLeading(const std::vector<vtkProp*>& props)
{
  this->HasLeading = true;
  this->Trends = {};
  const auto other = std::find_if_not(
    props.begin(), props.end(), [this](vtkProp* prop) { return this->CanLead(prop); });
  return static_cast<size_t>(other - props.begin());
}

//------------------------------------------------------------------------------
void vtkWaterClusters::EndLeading()
{
  // what they were like in this view tells how to draw them in the next
  int nearerSteps = 0;
  int fartherSteps = 0;
  for (const water_trend& trend : this->Trends)
  {
    nearerSteps += trend.nearer_steps;
    fartherSteps += trend.farther_steps;
  }
  this->FarFirst = this->FarFirst != (nearerSteps > fartherSteps);
  this->HasLeading = false;
}

//------------------------------------------------------------------------------
int vtkWaterClusters::Reserve(const Mesh& mesh, bool isSoftware)
{
  const int bandCount =
    water_clusters_bands(isSoftware, mesh.Indices.size() / 3, std::thread::hardware_concurrency());
  const size_t workCount = static_cast<size_t>(bandCount) * mesh.Boxes.size();
  // never smaller again: a mesh that leads has had its memory, and is not drawn whole among others
  // that are reversed
  this->Work.resize(std::max(this->Work.size(), workCount));
  this->Selected.resize(std::max(this->Selected.size(), mesh.Indices.size()));
  return bandCount;
}

//------------------------------------------------------------------------------
size_t vtkWaterClusters::Select(const water_plan& plan, vtkOpenGLPolyDataMapper* mapper,
  vtkActor* actor, const Mesh& mesh, const water_mesh& described)
{
  water_clusters_target target = this->Target;
  if (vtkWaterMeshTraits::HasOwnDepths(mapper, actor))
  {
    target.depths = nullptr;
  }
  const bool isSolid = vtkWaterMeshTraits::IsSolid(mapper, actor);
  const double* modelToWorld = &actor->GetMatrix()->Element[0][0];
  const std::array<double, 3> origin = OriginOf(mapper);
  const int bandCount = this->Reserve(mesh, plan.is_software);
  ForEach(bandCount, [&](int band) {
    water_clusters_view view;
    water_clusters_view_make(
      &plan, &target, band, bandCount, isSolid, modelToWorld, origin.data(), &view);
    water_clusters_mark(&view, &described, this->IsReversed(), &this->Trends[band],
      this->Work.data() + static_cast<size_t>(band) * mesh.Boxes.size());
  });
  return water_clusters_copy(
    &described, this->IsReversed(), this->Work.data(), bandCount, this->Selected.data());
}

//------------------------------------------------------------------------------
void vtkWaterClusters::Swap(vtkOpenGLPolyDataMapper* mapper, Mesh& mesh, size_t count)
{
  if (!mesh.Drawn)
  {
    mesh.Drawn = vtkSmartPointer<vtkOpenGLIndexBufferObject>::New();
  }
  if (count > 0)
  {
    mesh.Drawn->Upload(this->Selected.data(), count, vtkOpenGLBufferObject::ElementArrayBuffer);
  }
  else if (!mesh.Drawn->IsReady())
  {
    mesh.Drawn->GenerateBuffer(vtkOpenGLBufferObject::ElementArrayBuffer);
  }
  mesh.Drawn->IndexCount = count;
  vtkOpenGLIndexBufferObject*& slot = vtkWaterAccess::PolyDataMapper::TrianglesOf(mapper);
  this->Given = mapper;
  this->Own.TakeReference(slot); // the mapper's reference, until it has it back
  slot = mesh.Drawn;
  mesh.Drawn->Register(mapper);
}

//------------------------------------------------------------------------------
void vtkWaterClusters::Give(
  const water_plan& plan, vtkShaderProgram* program, vtkAbstractMapper* anyMapper, vtkProp* prop)
{
  this->TakeBack(); // of another part of an assembly
  // asked of every prop: what tells most is asked first
  auto* mapper = vtkWaterMeshTraits::AsPolyDataMapper(anyMapper);
  if (!mapper || !AreWorth(plan, mapper))
  {
    return;
  }
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!vtkWaterMeshTraits::CanBeCut(program, mapper, actor))
  {
    return;
  }
  try
  {
    this->GiveParts(plan, mapper, actor);
  }
  catch (const std::bad_alloc&)
  {
    this->TakeBack();
    this->Meshes.erase(mapper); // it is read again in the next view
    this->Shortage.What = "no memory for the parts of a large mesh";
    this->Shortage.TriangleCount =
      vtkWaterAccess::PolyDataMapper::TrianglesOf(mapper)->IndexCount / 3;
  }
}

//------------------------------------------------------------------------------
void vtkWaterClusters::GiveParts(
  const water_plan& plan, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
{
  Mesh* mesh = this->UpdateMesh(mapper, actor, plan.is_software);
  if (mesh && !plan.is_software)
  {
    this->GiveRuns(plan, mapper, actor, *mesh);
    return;
  }
  water_mesh described;
  if (!mesh || !Describe(mesh->Points, *mesh, described))
  {
    return;
  }
  const size_t count = this->Select(plan, mapper, actor, *mesh, described);
  if (count != mesh->Indices.size() || this->IsReversed())
  {
    this->Swap(mapper, *mesh, count);
  }
}

//------------------------------------------------------------------------------
void vtkWaterClusters::GiveRuns(
  const water_plan& plan, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor, Mesh& mesh)
{
  if (!vtkWaterAccess::PolyDataMapper::AreTrianglesNext(mapper))
  {
    return;
  }
  water_clusters_view view;
  water_clusters_view_make(&plan, &this->Target, 0, 1, vtkWaterMeshTraits::IsSolid(mapper, actor),
    &actor->GetMatrix()->Element[0][0], OriginOf(mapper).data(), &view);
  if (mesh.Runs.Select(view))
  {
    this->Swap(mapper, mesh, 0);
    this->DrawnRuns = &mesh.Runs;
    mapper->AddObserver(vtkCommand::UpdateShaderEvent, this->Drawer); // after all uniforms are set
  }
}

//------------------------------------------------------------------------------
void vtkWaterClusters::TakeBack()
{
  if (!this->Given)
  {
    return;
  }
  if (this->DrawnRuns)
  {
    this->Given->RemoveObserver(this->Drawer);
    this->DrawnRuns = nullptr;
  }
  vtkOpenGLIndexBufferObject*& slot = vtkWaterAccess::PolyDataMapper::TrianglesOf(this->Given);
  slot->UnRegister(this->Given);
  slot = this->Own;
  this->Own->Register(this->Given);
  this->Own = nullptr;
  this->Given = nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterClusters::ReleaseGraphicsResources()
{
  this->TakeBack();
  for (auto& mesh : this->Meshes)
  {
    if (mesh.second.Drawn)
    {
      mesh.second.Drawn->ReleaseGraphicsResources();
    }
  }
  this->Meshes.clear();
}
