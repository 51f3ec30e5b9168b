// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterPropRecords.h"

#include "vtkActor.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkTimeStamp.h"
#include "vtkWaterAccess.h"
#include "vtkWaterPropReader.h"
#include "vtkWaterProps.h"
#include "vtkWaterRenderPassKeys.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <utility>

namespace
{
constexpr size_t kMostAhead = 256; // props that are not drawn between two that are
constexpr int kMostMisses = 32;    // of a frame, in which props are drawn in an order of their own

// VTK's time, which every change of anything moves on.
vtkMTimeType Now()
{
  vtkTimeStamp now;
  now.Modified();
  return now.GetMTime();
}

// Do the times tell whether what is read of an actor for the plan holds? Bounds on the device
// depend on the camera, and other mappers have bounds of their own.
bool IsKnownByTimes(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  return vtkWaterProps::IsInWorld(actor) &&
    (!mapper || std::strcmp(mapper->GetClassName(), "vtkOpenGLPolyDataMapper") == 0);
}

// Of an actor that is known by times: are all of its data at its mapper at once?
bool IsInOnePiece(vtkActor* actor)
{
  auto* mapper = static_cast<vtkPolyDataMapper*>(actor->GetMapper());
  return mapper && mapper->GetNumberOfPieces() <= 1 && mapper->GetNumberOfSubPieces() <= 1;
}
}

//------------------------------------------------------------------------------
void vtkWaterPropRecords::Dereference::operator()(vtkInformation* keys) const
{
  // what is appended counts a reference twice, and only its removal takes back both
  while (keys->Length(vtkOpenGLRenderPass::RenderPasses()) > 0)
  {
    vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
    keys->Remove(passes, keys->Get(passes, 0));
  }
  keys->Delete();
}

//------------------------------------------------------------------------------
vtkWaterPropRecords::Record& vtkWaterPropRecords::Match(size_t i, vtkProp* prop)
{
  const char* name = prop->GetClassName();
  if (i < this->Records.size())
  {
    Record& record = *this->Records[i];
    if (record.Prop == prop && record.ClassName == name)
    {
      return record;
    }
    for (size_t k = i; k < this->Records.size(); ++k)
    {
      vtkProp* other = this->Records[k]->Prop;
      this->Loose.emplace(other, std::move(this->Records[k]));
    }
    this->Records.resize(i);
  }
  const auto found = this->Loose.find(prop);
  if (found != this->Loose.end() && found->second->ClassName == name)
  {
    this->Records.push_back(std::move(found->second));
    this->Loose.erase(found);
    return *this->Records.back();
  }
  RecordPointer record = std::make_unique<Record>();
  record->Prop = prop;
  record->ClassName = name;
  record->IsPlain = std::strcmp(name, "vtkOpenGLActor") == 0;
  this->Records.push_back(std::move(record));
  return *this->Records.back();
}

//------------------------------------------------------------------------------
void vtkWaterPropRecords::EndMatching(size_t count)
{
  for (auto& loose : this->Loose)
  {
    this->Dropped.push_back(std::move(loose.second));
  }
  this->Loose.clear();
  std::move(this->Records.begin() + static_cast<std::ptrdiff_t>(count), this->Records.end(),
    std::back_inserter(this->Dropped));
  this->Records.resize(count);
  if (this->Keyed.empty())
  {
    this->Dropped.clear();
  }
}

//------------------------------------------------------------------------------
template <typename Function>
void vtkWaterPropRecords::Walk(vtkRenderer* renderer, const Function& function)
{
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  size_t i = 0;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    function(this->Match(i++, prop));
  }
  this->EndMatching(i);
}

//------------------------------------------------------------------------------
bool vtkWaterPropRecords::IsOfWindow(vtkProp* prop, vtkRenderer* renderer)
{
  const int count = prop->GetNumberOfConsumers();
  for (int i = 0; i < count; ++i)
  {
    vtkObject* consumer = prop->GetConsumer(i);
    if (consumer != renderer &&
      std::find(this->OfWindow.begin(), this->OfWindow.end(), consumer) == this->OfWindow.end())
    {
      auto* other = vtkRenderer::SafeDownCast(consumer);
      if (!other || other->GetRenderWindow() != renderer->GetRenderWindow())
      {
        return false;
      }
      this->OfWindow.push_back(consumer);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterPropRecords::HasOwnKeysOnly(const Record& record)
{
  vtkInformation* keys = vtkWaterAccess::Prop::PropertyKeysOf(record.Prop);
  return !keys || (keys == record.GivenKeys && keys->GetMTime() == record.KeysTime);
}

//------------------------------------------------------------------------------
const std::vector<vtkProp*>& vtkWaterPropRecords::FindOthers(vtkRenderer* renderer)
{
  this->Others.clear();
  this->OfWindow.clear();
  this->Walk(renderer, [&](Record& record) {
    if (!record.IsPlain || vtkWaterAccess::Prop::PropertyKeysOf(record.Prop) ||
      !this->IsOfWindow(record.Prop, renderer))
    {
      this->Others.push_back(record.Prop);
    }
  });
  return this->Others;
}

//------------------------------------------------------------------------------
void vtkWaterPropRecords::PutKey(Record& record)
{
  if (!record.Keys)
  {
    record.Keys.reset(vtkInformation::New());
    record.Keys->Append(vtkOpenGLRenderPass::RenderPasses(), this->Key);
    record.KeysTime = record.Keys->GetMTime();
  }
  // silently: a key for a frame is no change of the prop
  record.GivenKeys = record.Keys.release();
  vtkWaterAccess::Prop::PropertyKeysOf(record.Prop) = record.GivenKeys;
  this->Keyed.push_back(&record);
  this->Held.emplace_back(record.Prop);
}

//------------------------------------------------------------------------------
void vtkWaterPropRecords::Begin(vtkRenderer* renderer, vtkOpenGLRenderPass* key)
{
  this->Key = key;
  this->Others.clear();
  this->OfWindow.clear();
  this->Held.reserve(this->Records.size());
  ++this->FrameCount;
  this->HasElsewhere = false;
  this->NextAsked = 0;
  this->MissCount = 0;
  this->IsRead = false;
  this->Walk(renderer, [&](Record& record) {
    vtkProp* prop = record.Prop;
    const bool hasKeys = vtkWaterAccess::Prop::PropertyKeysOf(prop) != nullptr;
    const bool isBare = record.IsPlain && !hasKeys;
    const bool isElsewhere = !this->IsOfWindow(prop, renderer);
    this->HasElsewhere = this->HasElsewhere || isElsewhere || hasKeys ||
      (!record.IsPlain && prop->IsA("vtkAxesActor"));
    if (!isBare || isElsewhere)
    {
      this->Others.push_back(prop);
    }
    // one that other renderers have may be reflected there, and its shader is not built by turns
    const bool mayBeReflected = record.IsReflected || prop->GetNumberOfConsumers() > 1;
    if (isBare && mayBeReflected && prop->GetVisibility())
    {
      this->PutKey(record);
    }
  });
}

//------------------------------------------------------------------------------
void vtkWaterPropRecords::Reflect(size_t i)
{
  Record& record = *this->Records[i];
  record.IsReflected = true;
  if (record.IsPlain && !vtkWaterAccess::Prop::PropertyKeysOf(record.Prop))
  {
    this->PutKey(record);
  }
}

//------------------------------------------------------------------------------
void vtkWaterPropRecords::Ask(vtkProp* prop)
{
  if (this->IsRead || this->MissCount == kMostMisses)
  {
    return;
  }
  // most are drawn in the order of the renderer's list
  const size_t end = std::min(this->Keyed.size(), this->NextAsked + kMostAhead);
  size_t i = this->NextAsked;
  while (i < end && this->Held[i] != prop)
  {
    ++i;
  }
  if (i == end)
  {
    ++this->MissCount;
    return;
  }
  this->NextAsked = i + 1;
  Record& record = *this->Keyed[i];
  if (record.IsKnown && record.AskedIn != this->FrameCount)
  {
    record.IsKnown = HasOwnKeysOnly(record) && record.Mirrored.IsUnchanged(record.Drawn);
    record.AskedIn = this->FrameCount;
  }
}

//------------------------------------------------------------------------------
bool vtkWaterPropRecords::IsUnchanged(const Record& record) const
{
  return record.IsKnown &&
    (record.AskedIn == this->FrameCount ||
      (HasOwnKeysOnly(record) && record.Mirrored.IsUnchanged(record.Drawn)));
}

//------------------------------------------------------------------------------
void vtkWaterPropRecords::TakeKeyOff(Record& record, vtkProp* prop)
{
  vtkInformation*& slot = vtkWaterAccess::Prop::PropertyKeysOf(prop);
  const bool isOurs = slot && slot == std::exchange(record.GivenKeys, nullptr) &&
    slot->GetReferenceCount() == 1 && slot->GetMTime() == record.KeysTime &&
    slot->Length(vtkOpenGLRenderPass::RenderPasses()) == 1;
  if (isOurs)
  {
    record.Keys.reset(std::exchange(slot, nullptr));
    return;
  }
  // somebody has put others beside it, or has them, too: they stay, without ours
  vtkWaterRenderPassKeys::Remove(prop, this->Key);
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkProp>> vtkWaterPropRecords::End()
{
  for (size_t i = 0; i < this->Keyed.size(); ++i)
  {
    this->TakeKeyOff(*this->Keyed[i], this->Held[i]);
  }
  this->Keyed.clear();
  this->Dropped.clear();
  return std::exchange(this->Held, {});
}

//------------------------------------------------------------------------------
void vtkWaterPropRecords::Picture::Update(vtkRenderer* renderer, vtkProp* prop)
{
  vtkWaterPropTimes times;
  times.Read(renderer, prop);
  if (prop != this->Of || !times.AreSameAs(this->Times))
  {
    this->Stamp = Now();
  }
  this->Of = prop;
  this->Times = std::move(times);
}

//------------------------------------------------------------------------------
void vtkWaterPropRecords::ReadAnew(vtkRenderer* renderer, Record& record,
  const vtkWaterSnapshot& mirrored, const std::function<bool(vtkProp*)>& isRefused)
{
  const bool isBare = record.IsPlain && HasOwnKeysOnly(record);
  record.IsKnown = false;
  record.Drawn = isBare ? record.Prop : vtkWaterPropReader::FindDrawn(record.Prop);
  const bool isRefusedNow = isRefused && isRefused(record.Drawn);
  record.Read = vtkWaterPropReader::Read(record.Prop, record.Drawn, mirrored, isRefusedNow);
  if (isBare && !isRefusedNow && IsKnownByTimes(static_cast<vtkActor*>(record.Prop)))
  {
    record.Mirrored.Update(renderer, record.Prop);
    record.IsKnown = record.Mirrored.Times.CanBeAsked();
    auto* actor = static_cast<vtkActor*>(record.Prop);
    record.IsTranslucent = record.IsKnown && actor->HasTranslucentPolygonalGeometry() != 0;
    record.IsOpaque = record.IsKnown && !record.IsTranslucent && actor->HasOpaqueGeometry() != 0;
    record.IsWhole = record.IsKnown && IsInOnePiece(actor);
  }
}

//------------------------------------------------------------------------------
void vtkWaterPropRecords::Read(vtkRenderer* renderer, const vtkWaterSnapshot& mirrored,
  const std::function<bool(vtkProp*)>& isRefused)
{
  this->IsRead = true;
  const vtkMTimeType begun = Now();
  this->Walk(renderer, [&](Record& record) {
    if (isRefused || !this->IsUnchanged(record))
    {
      this->ReadAnew(renderer, record, mirrored, isRefused);
    }
  });
  this->IsSettled = Now() == begun + 1;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkWaterPropRecords::GetStamp(vtkRenderer* renderer, size_t i)
{
  Record& record = *this->Records[i];
  if (record.IsKnown && this->IsSettled)
  {
    return record.Mirrored.Stamp;
  }
  if (!record.Mirrored.IsUnchanged(record.Drawn))
  {
    // bringing another prop's pipeline up to date may have run the user's code, and changed it
    record.IsKnown = false;
    record.Mirrored.Update(renderer, record.Drawn);
  }
  return record.Mirrored.Stamp;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkWaterPropRecords::GetOwnStamp(vtkRenderer* renderer, size_t i)
{
  Record& record = *this->Records[i];
  if (record.Drawn == record.Prop)
  {
    return this->GetStamp(renderer, i);
  }
  if (!record.Own)
  {
    record.Own = std::make_unique<Picture>();
  }
  record.Own->Update(renderer, record.Prop);
  return record.Own->Stamp;
}
