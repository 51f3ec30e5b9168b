// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterLakes.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWaterActor.h"
#include "vtkWaterCompat.h"
#include "vtkWaterGather.h"
#include "vtkWaterLakesInternals.h"
#include "vtkWaterPlanesFilter.h"
#include "vtkWaterSource.h"
#include "vtkWaterSurfaceFilter.h"
#include "vtkWeakPointer.h"
#include "water_seen.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkWaterLakes);

namespace
{
constexpr int kPlanes = 16; // by default

// Does a mapper show several data sets? A part of a surface is not one of its inputs then.
bool IsComposite(vtkMapper* mapper)
{
  vtkInformation* port =
    mapper->GetNumberOfInputPorts() ? mapper->GetInputPortInformation(0) : nullptr;
  const int count = port ? port->Length(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE()) : 0;
  for (int i = 0; i < count; ++i)
  {
    const std::string type = port->Get(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), i);
    if (type == "vtkCompositeDataSet" || type == "vtkDataObject") // the latter: any of them
    {
      return true;
    }
  }
  return false;
}

// The plane of a block, moved as the water is.
void MovePlane(vtkPolyData* block, vtkMatrix4x4* toWorld, vtkPlane* plane)
{
  double origin[4] = { 0.0, 0.0, 0.0, 1.0 };
  double normal[4] = { 0.0, 0.0, 1.0, 0.0 };
  block->GetFieldData()->GetArray("WaterPlaneOrigin")->GetTuple(0, origin);
  block->GetFieldData()->GetArray("WaterPlaneNormal")->GetTuple(0, normal);
  vtkNew<vtkMatrix4x4> ofNormals;
  vtkMatrix4x4::Invert(toWorld, ofNormals);
  ofNormals->Transpose();
  toWorld->MultiplyPoint(origin, origin);
  ofNormals->MultiplyPoint(normal, normal);
  plane->SetOrigin(origin);
  plane->SetNormal(normal);
}

// Do the parts of a block have no plane, so that no mirrored view is right for them?
bool IsRest(vtkPolyData* block)
{
  vtkDataArray* isRest = block->GetFieldData()->GetArray("WaterIsRest");
  return isRest && isRest->GetComponent(0, 0) > 0.0;
}

// The share of the picture that the parts of a block cover.
double ShareOf(
  const water_camera& eye, const water_plane& plane, vtkPolyData* block, vtkMatrix4x4* toWorld)
{
  auto* bounds =
    vtkArrayDownCast<vtkDoubleArray>(block->GetFieldData()->GetArray("WaterPartBounds"));
  return bounds ? water_seen_share_of_parts(&eye, &plane, bounds->GetPointer(0),
                    static_cast<size_t>(bounds->GetNumberOfTuples()), &toWorld->Element[0][0])
                : 0.0;
}
}

//------------------------------------------------------------------------------
vtkWaterLakes::vtkWaterLakes()
  : Internal(std::make_unique<Internals>())
{
  this->Internal->Waters.push_back(vtkSmartPointer<vtkWaterActor>::New());
  this->Internal->Filter->SetMaximumNumberOfPlanes(kPlanes);
}

//------------------------------------------------------------------------------
vtkWaterLakes::~vtkWaterLakes() = default;

//------------------------------------------------------------------------------
void vtkWaterLakes::SetMapper(vtkMapper* mapper)
{
  if (mapper && IsComposite(mapper))
  {
    const char* now = this->GetMapper() ? this->GetMapper()->GetClassName() : "nullptr";
    vtkErrorMacro("Mapper is a " << mapper->GetClassName()
                                 << "; it must show one data set, as a vtkPolyDataMapper does. "
                                    "Append the blocks' polygons to one mesh. It stays "
                                 << now << ".");
    return;
  }
  if (this->Internal->Mapper != mapper)
  {
    this->Internal->Mapper = mapper;
    this->Internal->BuiltTime = 0;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMapper* vtkWaterLakes::GetMapper() const
{
  return this->Internal->Mapper;
}

//------------------------------------------------------------------------------
vtkWaterSurfaceFilter* vtkWaterLakes::SetData(vtkAlgorithmOutput* mesh, const std::string& level,
  const std::string& depth, const std::string& bed)
{
  if (!mesh)
  {
    this->SetMapper(nullptr);
    return nullptr;
  }
  vtkNew<vtkWaterSurfaceFilter> surface;
  surface->SetInputConnection(mesh);
  surface->SetLevelArrayName(level);
  surface->SetDepthArrayName(depth);
  surface->SetBedArrayName(bed);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(surface->GetOutputPort());
  mapper->ScalarVisibilityOff();
  this->SetMapper(mapper);
  return surface;
}

//------------------------------------------------------------------------------
void vtkWaterLakes::SetUpDirection(double x, double y, double z)
{
  this->Internal->Filter->SetUpDirection(x, y, z);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkWaterLakes::GetUpDirection(double direction[3]) const
{
  this->Internal->Filter->GetUpDirection(direction);
}

//------------------------------------------------------------------------------
void vtkWaterLakes::SetMaximumNumberOfMirrors(int mirrors)
{
  vtkWaterSetInRange(MaximumNumberOfMirrors, mirrors, 0, 4096);
}

//------------------------------------------------------------------------------
void vtkWaterLakes::SetMaximumNumberOfPlanes(int planes)
{
  const int now = this->GetMaximumNumberOfPlanes();
  if (planes < 1 || planes > 4096)
  {
    vtkErrorMacro("MaximumNumberOfPlanes is " << planes << "; it must lie in [1, 4096]. It stays "
                                              << now << ".");
  }
  else if (planes != now)
  {
    this->Internal->Filter->SetMaximumNumberOfPlanes(planes);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkWaterLakes::GetMaximumNumberOfPlanes() const
{
  return this->Internal->Filter->GetMaximumNumberOfPlanes();
}

//------------------------------------------------------------------------------
int vtkWaterLakes::GetNumberOfWaters() const
{
  return static_cast<int>(this->Internal->Waters.size());
}

//------------------------------------------------------------------------------
vtkWaterActor* vtkWaterLakes::GetWater(int number) const
{
  return number >= 0 && number < this->GetNumberOfWaters()
    ? this->Internal->Waters[static_cast<size_t>(number)].Get()
    : nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterLakes::AddTo(vtkRenderer* renderer)
{
  auto& hosts = this->Internal->Hosts;
  const bool isThere = std::any_of(hosts.begin(), hosts.end(),
    [renderer](const Internals::Host& host) { return host.Renderer == renderer; });
  if (!renderer)
  {
    return;
  }
  this->Update();
  for (const auto& water : this->Internal->Waters)
  {
    renderer->AddActor(water); // once; it may have been removed since the last frame
  }
  if (isThere)
  {
    return;
  }
  vtkNew<vtkCallbackCommand> command;
  this->Register(nullptr); // the renderer's
  command->SetClientData(this);
  command->SetClientDataDeleteCallback(
    [](void* self) { static_cast<vtkWaterLakes*>(self)->UnRegister(nullptr); });
  command->SetCallback([](vtkObject* caller, unsigned long event, void* self, void*) {
    const vtkSmartPointer<vtkWaterLakes> lakes = static_cast<vtkWaterLakes*>(self);
    event == vtkCommand::StartEvent ? lakes->BeginFrame(static_cast<vtkRenderer*>(caller))
                                    : lakes->EndFrame();
  });
  Internals::Host host;
  host.Renderer = renderer;
  host.Observers[0] = renderer->AddObserver(vtkCommand::StartEvent, command);
  host.Observers[1] = renderer->AddObserver(vtkCommand::EndEvent, command);
  hosts.push_back(host);
}

//------------------------------------------------------------------------------
void vtkWaterLakes::RemoveFrom(vtkRenderer* renderer)
{
  const vtkSmartPointer<vtkWaterLakes> held = this;
  auto& hosts = this->Internal->Hosts;
  const auto found = std::find_if(hosts.begin(), hosts.end(),
    [renderer](const Internals::Host& host) { return host.Renderer == renderer; });
  if (!renderer || found == hosts.end())
  {
    return;
  }
  const std::array<unsigned long, 2> observers = { found->Observers[0], found->Observers[1] };
  hosts.erase(found);
  for (const auto& water : this->Internal->Waters)
  {
    renderer->RemoveActor(water);
  }
  this->AllowMirrors();
  for (unsigned long observer : observers)
  {
    renderer->RemoveObserver(observer);
  }
}

//------------------------------------------------------------------------------
void vtkWaterLakes::BeginFrame(vtkRenderer* renderer)
{
  if (!renderer->HasViewProp(this->GetWater()))
  {
    this->RemoveFrom(renderer);
    return;
  }
  this->ReadRenderer(renderer);
  this->Update();
  this->ChooseMirrors(renderer);
  for (const auto& water : this->Internal->Waters)
  {
    water->GetSource()->SetIsDrawing(
      !renderer->GetSelector()); // cells are selected of the cut mesh
  }
}

//------------------------------------------------------------------------------
void vtkWaterLakes::Update()
{
  Internals& internal = *this->Internal;
  internal.ForgetTheGone();
  vtkMapper* mapper = internal.Mapper;
  vtkAlgorithmOutput* input = mapper && mapper->GetNumberOfInputConnections(0) > 0
    ? mapper->GetInputConnection(0, 0)
    : nullptr;
  if (internal.Input != input)
  {
    internal.Input = input;
    internal.BuiltTime = 0;
  }
  internal.IsUncut = input && this->ReadUncut(input);
  if (input && !internal.IsUncut)
  {
    // as a mapper does, at the time that was asked of it: a filter behind it would not see that
    // time, and stay as it is
    input->GetProducer()->Update(input->GetIndex());
    internal.Filter->SetInputDataObject(
      input->GetProducer()->GetOutputDataObject(input->GetIndex()));
    internal.Filter->Update();
  }
  else if (!input)
  {
    internal.Filter->SetInputDataObject(nullptr);
  }
  this->Rebuild();
  this->Follow();
}

//------------------------------------------------------------------------------
void vtkWaterLakes::Rebuild()
{
  Internals& internal = *this->Internal;
  vtkWaterActor* first = this->GetWater();
  first->ComputeMatrix();
  std::array<double, 16> matrix;
  std::copy_n(&first->GetMatrix()->Element[0][0], 16, matrix.begin());
  vtkMTimeType time = 1;
  const std::vector<vtkPolyData*> parts = this->FindParts(&time);
  const vtkMTimeType mapperTime = internal.Mapper ? internal.Mapper->GetMTime() : 0;
  if (time == internal.BuiltTime && mapperTime == internal.MapperTime && matrix == internal.Matrix)
  {
    return;
  }
  internal.BuiltTime = time;
  internal.MapperTime = mapperTime;
  internal.Matrix = matrix;
  this->Resize(std::max<size_t>(parts.size(), 1));
  for (size_t i = 0; i < internal.Waters.size(); ++i)
  {
    const bool isThere = i < parts.size();
    this->ShowPart(i, isThere ? parts[i] : internal.Nothing.Get());
    if (isThere)
    {
      vtkNew<vtkPlane> plane;
      MovePlane(parts[i], first->GetMatrix(), plane);
      internal.Waters[i]->SetPlane(plane);
    }
  }
  if (internal.Hosts.empty()) // otherwise each frame of theirs chooses
  {
    this->AllowMirrors();
  }
  internal.FollowedTime = 0;
}

//------------------------------------------------------------------------------
std::vector<vtkPolyData*> vtkWaterLakes::FindParts(vtkMTimeType* time) const
{
  const Internals& internal = *this->Internal;
  std::vector<vtkPolyData*> parts;
  if (internal.IsUncut)
  {
    *time = internal.UncutTime;
    for (const auto& block : internal.Uncut.GetBlocks())
    {
      parts.push_back(block);
    }
    return parts;
  }
  // the filter keeps the planes of an input that is gone
  const bool hasInput = internal.Mapper && internal.Filter->GetNumberOfInputConnections(0) > 0;
  auto* planes = hasInput
    ? vtkMultiBlockDataSet::SafeDownCast(internal.Filter->GetOutputDataObject(0))
    : nullptr;
  const unsigned int count = planes ? planes->GetNumberOfBlocks() : 0;
  *time = planes ? planes->GetMTime() : 1;
  for (unsigned int i = 0; i < count; ++i)
  {
    parts.push_back(vtkPolyData::SafeDownCast(planes->GetBlock(i)));
  }
  return parts;
}

//------------------------------------------------------------------------------
void vtkWaterLakes::Resize(size_t count)
{
  auto& waters = this->Internal->Waters;
  while (waters.size() < count)
  {
    waters.push_back(vtkSmartPointer<vtkWaterActor>::New());
    for (const Internals::Host& host : this->Internal->Hosts)
    {
      host.Renderer->AddActor(waters.back());
    }
  }
  while (waters.size() > count)
  {
    for (const Internals::Host& host : this->Internal->Hosts)
    {
      host.Renderer->RemoveActor(waters.back());
    }
    waters.pop_back();
  }
}

//------------------------------------------------------------------------------
void vtkWaterLakes::ShowPart(size_t number, vtkPolyData* part)
{
  Internals& internal = *this->Internal;
  internal.Mappers.resize(internal.Waters.size());
  vtkSmartPointer<vtkMapper>& mapper = internal.Mappers[number];
  if (!mapper || (internal.Mapper && !mapper->IsA(internal.Mapper->GetClassName())))
  {
    mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    if (internal.Mapper)
    {
      mapper.TakeReference(internal.Mapper->NewInstance());
    }
  }
  if (internal.Mapper)
  {
    mapper->ShallowCopy(internal.Mapper);
  }
  if (internal.IsUncut && vtkWaterUncutMesh::SafeDownCast(part))
  {
    this->ShowUncut(number, part, mapper);
    return;
  }
  mapper->SetInputDataObject(0, part);
  internal.Waters[number]->SetMapper(mapper);
}

//------------------------------------------------------------------------------
void vtkWaterLakes::Follow()
{
  Internals& internal = *this->Internal;
  vtkWaterActor* first = this->GetWater();
  const vtkMTimeType time = first->GetMTime();
  if (time == internal.FollowedTime)
  {
    return;
  }
  internal.FollowedTime = time;
  for (size_t i = 1; i < internal.Waters.size(); ++i)
  {
    vtkWaterActor* water = internal.Waters[i];
    const vtkSmartPointer<vtkMapper> mapper = water->GetMapper();
    const vtkSmartPointer<vtkPlane> plane = water->GetPlane();
    water->ShallowCopy(first);
    water->SetMapper(mapper);
    water->GetSource()->SetDrawnMapper(this->FindDrawnMapper(i));
    water->SetPlane(plane);
  }
}

//------------------------------------------------------------------------------
void vtkWaterLakes::AllowMirrors()
{
  vtkMTimeType time = 1;
  const std::vector<vtkPolyData*> parts = this->FindParts(&time);
  for (size_t i = 0; i < this->Internal->Waters.size(); ++i)
  {
    const bool isRest = i < parts.size() && IsRest(parts[i]);
    this->Internal->Waters[i]->GetSource()->SetMayMirror(!isRest);
  }
}

//------------------------------------------------------------------------------
void vtkWaterLakes::ChooseMirrors(vtkRenderer* renderer)
{
  const auto& waters = this->Internal->Waters;
  const water_camera eye = vtkWaterGather::ReadCamera(renderer);
  vtkMTimeType time = 1;
  const std::vector<vtkPolyData*> parts = this->FindParts(&time);
  // their shares do not matter, and those of many parts take long
  const bool haveAll = waters.size() <= static_cast<size_t>(this->MaximumNumberOfMirrors);
  std::vector<double> shares;
  for (size_t i = 0; i < waters.size(); ++i)
  {
    water_plane plane;
    double origin[3];
    waters[i]->GetSource()->ReadPlane(&plane, origin);
    const bool mayBeMirrored =
      !haveAll && i < parts.size() && !IsRest(parts[i]) && waters[i]->GetVisibility() != 0;
    shares.push_back(mayBeMirrored ? ShareOf(eye, plane, parts[i], waters[i]->GetMatrix()) : 0.0);
  }
  auto hasView = std::make_unique<bool[]>(waters.size());
  water_seen_choose(
    shares.data(), shares.size(), static_cast<size_t>(this->MaximumNumberOfMirrors), hasView.get());
  for (size_t i = 0; i < waters.size(); ++i)
  {
    waters[i]->GetSource()->SetMayMirror(hasView[i] && !(i < parts.size() && IsRest(parts[i])));
  }
}

//------------------------------------------------------------------------------
void vtkWaterLakes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumNumberOfMirrors: " << this->MaximumNumberOfMirrors << "\n";
  os << indent << "ShoreCut: " << this->GetShoreCutAsString() << "\n";
  os << indent << "IsShoreCutWhileDrawn: " << (this->GetIsShoreCutWhileDrawn() ? "yes" : "no")
     << "\n";
  os << indent << "NumberOfWaters: " << this->GetNumberOfWaters() << "\n";
  os << indent << "Mapper: " << this->GetMapper() << "\n";
  os << indent << "PlanesFilter:\n";
  this->Internal->Filter->PrintSelf(os, indent.GetNextIndent());
}
VTK_ABI_NAMESPACE_END
