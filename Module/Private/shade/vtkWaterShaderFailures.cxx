// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterShaderFailures.h"

#include "vtkAbstractMapper.h"
#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkVersionMacros.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWaterAccess.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace
{
// What the driver says of one shader of a program; empty: nothing.
std::string GetLog(vtkShader::Type type, const std::string& source)
{
  vtkNew<vtkShader> shader;
  shader->SetType(type);
  shader->SetSource(source);
  if (source.empty() || shader->Compile())
  {
    shader->Cleanup();
    return "";
  }
  return shader->GetError();
}

vtkAbstractMapper* GetMapperOf(vtkProp* part)
{
  auto* actor = vtkActor::SafeDownCast(part);
  return actor ? actor->GetMapper() : nullptr;
}

bool HasKeys(vtkProp* prop, vtkInformation* keys)
{
  if (prop->IsA("vtkAxesActor"))
  {
    // the one prop with parts that does not hand its keys on to them
    vtkNew<vtkPropCollection> parts;
    prop->GetActors(parts);
    vtkCollectionSimpleIterator it;
    parts->InitTraversal(it);
    while (vtkProp* part = parts->GetNextProp(it))
    {
      if (HasKeys(part, keys))
      {
        return true;
      }
    }
  }
  return prop->GetPropertyKeys() == keys;
}

// Is a part a prop, or in it? Keys do not tell: a prop hands its own on to its parts, but other
// props may share them.
bool IsIn(vtkProp* part, vtkProp* prop)
{
  if (part == prop)
  {
    return true;
  }
  const int consumers = part->GetNumberOfConsumers();
  for (int i = 0; i < consumers; ++i)
  {
    vtkProp* whole = vtkProp::SafeDownCast(part->GetConsumer(i));
    if (whole && IsIn(whole, prop))
    {
      return true;
    }
  }
  // an actor inside of a prop has no consumer, only its keys
  return consumers == 0 && part->GetPropertyKeys() && HasKeys(prop, part->GetPropertyKeys());
}
}

//------------------------------------------------------------------------------
vtkMTimeType vtkWaterShaderFailures::GetTimeOf(vtkProp* part, vtkAbstractMapper* mapper)
{
  // not the prop's own, which changes whenever it moves
  vtkMTimeType time = std::max(mapper->GetMTime(), part->GetShaderProperty()->GetShaderMTime());
  if (auto* actor = vtkActor::SafeDownCast(part))
  {
    time = std::max(time, actor->GetProperty()->GetMTime());
  }
  else if (auto* volume = vtkVolume::SafeDownCast(part))
  {
    time = std::max(time, volume->GetProperty()->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
bool vtkWaterShaderFailures::Has(vtkProp* prop)
{
  if (this->Refused.empty())
  {
    return false;
  }
  for (Refusal& refusal : this->Refused)
  {
    if (!refusal.IsOver &&
      (!refusal.Part || !refusal.Mapper || GetMapperOf(refusal.Part) != refusal.ActorMapper ||
        GetTimeOf(refusal.Part, refusal.Mapper) != refusal.Time))
    {
      refusal.IsOver = true;
      this->Changed.Modified();
    }
  }
  const auto end = std::remove_if(this->Refused.begin(), this->Refused.end(),
    [](const Refusal& refusal) { return !refusal.Part; });
  this->Refused.erase(end, this->Refused.end());
  return std::any_of(this->Refused.begin(), this->Refused.end(),
    [prop](const Refusal& refusal) { return !refusal.IsOver && IsIn(refusal.Part, prop); });
}

//------------------------------------------------------------------------------
int vtkWaterShaderFailures::GetCount(vtkProp* prop) const
{
  const auto found = std::find_if(this->Refused.begin(), this->Refused.end(),
    [prop](const Refusal& refusal) { return refusal.Part && IsIn(refusal.Part, prop); });
  return found != this->Refused.end() ? found->Count : 0;
}

//------------------------------------------------------------------------------
void vtkWaterShaderFailures::Prepare(vtkAbstractMapper* mapper)
{
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0)
  auto* surface = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  vtkOpenGLHelper* built = surface ? vtkWaterAccess::PolyDataMapper::BuiltOf(surface) : nullptr;
  if (built && !built->Program)
  {
    // not for long: what is built, or nothing, takes its place at once
    static thread_local vtkNew<vtkShaderProgram> unbuilt;
    built->Program = unbuilt;
  }
#else
  (void)mapper; // it keeps the last one
#endif
}

//------------------------------------------------------------------------------
void vtkWaterShaderFailures::Await(vtkProp* part, vtkAbstractMapper* mapper,
  vtkOpenGLRenderWindow* window, bool isMirrored, const std::string& vertexShader,
  const std::string& geometryShader, const std::string& fragmentShader)
{
  this->Judge();
  this->Awaited =
    Written{ part, mapper, window, vertexShader, geometryShader, fragmentShader, isMirrored };
  this->IsAwaiting = true;
}

//------------------------------------------------------------------------------
void vtkWaterShaderFailures::Arrive(vtkProp* part, vtkAbstractMapper* mapper)
{
  if (this->Awaited.Part == part && this->Awaited.Mapper == mapper)
  {
    this->Awaited = Written();
    this->IsAwaiting = false;
  }
}

//------------------------------------------------------------------------------
void vtkWaterShaderFailures::Judge()
{
  if (!this->Awaited.Part)
  {
    return;
  }
  const Written written = std::exchange(this->Awaited, Written());
  this->IsAwaiting = false;
  if (!written.Mapper || !written.Window || this->Has(written.Part))
  {
    return;
  }
  auto found = std::find_if(this->Refused.begin(), this->Refused.end(),
    [&written](const Refusal& refusal) { return refusal.Part == written.Part; });
  if (found == this->Refused.end())
  {
    found = this->Refused.insert(found, Refusal());
  }
  found->Part = written.Part;
  found->Mapper = written.Mapper;
  found->ActorMapper = GetMapperOf(written.Part);
  found->Time = GetTimeOf(written.Part, written.Mapper);
  ++found->Count;
  found->IsOver = false;
  found->IsLost = !written.IsMirrored;
  this->Changed.Modified();
  this->IsMirroredNew = this->IsMirroredNew || written.IsMirrored;
  this->Texts.push_back(Describe(written));
}

//------------------------------------------------------------------------------
std::string vtkWaterShaderFailures::Describe(const Written& written)
{
  // as VTK's cache hands them to the driver, but for the user's replacements that come last
  std::string vertex = written.Vertex;
  std::string geometry = written.Geometry;
  std::string fragment = written.Fragment;
  vtkWaterAccess::ShaderCache::Finish(written.Window->GetShaderCache(), vertex, geometry, fragment);
  std::string log = GetLog(vtkShader::Vertex, vertex) + GetLog(vtkShader::Geometry, geometry) +
    GetLog(vtkShader::Fragment, fragment);
  if (log.empty())
  {
    log = "its shaders do not link, or are rejected with the user's replacements alone";
  }
  std::ostringstream text;
  text << "The driver rejects a shader of a prop (" << written.Part->GetClassName() << ", "
       << written.Part.GetPointer() << ") with the lines that reflections need: " << log
       << ". The prop is not reflected until its mapper or its properties change.";
  return text.str();
}

//------------------------------------------------------------------------------
bool vtkWaterShaderFailures::TakeMirrored()
{
  this->Judge();
  return std::exchange(this->IsMirroredNew, false);
}

//------------------------------------------------------------------------------
bool vtkWaterShaderFailures::HaveLost() const
{
  return std::any_of(this->Refused.begin(), this->Refused.end(),
    [](const Refusal& refusal) { return refusal.IsLost; });
}

//------------------------------------------------------------------------------
bool vtkWaterShaderFailures::TakeLost(vtkProp* prop)
{
  bool isLost = false;
  for (Refusal& refusal : this->Refused)
  {
    if (refusal.IsLost && refusal.Part && IsIn(refusal.Part, prop))
    {
      refusal.IsLost = false;
      isLost = true;
    }
  }
  return isLost;
}

//------------------------------------------------------------------------------
std::string vtkWaterShaderFailures::TakeText()
{
  std::string all;
  for (const std::string& text : std::exchange(this->Texts, {}))
  {
    all += (all.empty() ? "" : "\n") + text;
  }
  return all;
}
