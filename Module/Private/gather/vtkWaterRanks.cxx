// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterRanks.h"

#include "vtkTimeStamp.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <numeric>

namespace
{
const char* const kUnreachable = "the other ranks cannot be reached";

const int kTag = 719; // of pixels

enum : unsigned char
{
  SENT_NOTHING, // a rank has received what it cannot read
  SENT_PICTURE
};

vtkWaterError Unreachable()
{
  vtkWaterError error;
  error.Kind = kUnreachable;
  error.Text = error.Kind + ". The water shows its plain colour.";
  return error;
}
}

//------------------------------------------------------------------------------
std::string vtkWaterRanks::GetText() const
{
  if (!this->Controller)
  {
    return "(none)";
  }
  if (this->IsMute())
  {
    return "(no communicator)";
  }
  return "rank " + std::to_string(this->Controller->GetLocalProcessId()) + " of " +
    std::to_string(this->Controller->GetNumberOfProcesses());
}

//------------------------------------------------------------------------------
vtkWaterError vtkWaterRanks::DescribeMute() const
{
  vtkWaterError error;
  error.Kind = water_status_text(WATER_RANKS_NO_COMMUNICATOR);
  error.Text = error.Kind + "; this " + this->Controller->GetClassName() +
    " has none. The water shows its plain colour; SetController(nullptr) lets it reflect what this "
    "process has.";
  return error;
}

//------------------------------------------------------------------------------
int vtkWaterRanks::GetStartedCount()
{
  for (const char* name : { "OMPI_COMM_WORLD_SIZE", "PMI_SIZE" })
  {
    const char* count = std::getenv(name);
    if (count)
    {
      return std::atoi(count);
    }
  }
  return 0;
}

//------------------------------------------------------------------------------
void vtkWaterRanks::SetController(vtkMultiProcessController* controller)
{
  if (controller == this->Controller)
  {
    return; // ranks that are lost stay lost
  }
  vtkTimeStamp now; // of all objects of this class another
  now.Modified();
  this->Stamp = now.GetMTime();
  this->Controller = controller;
  this->Shared = controller ? std::make_shared<Line>() : nullptr;
  this->SetWaitLimit(this->WaitLimit);
}

//------------------------------------------------------------------------------
void vtkWaterRanks::SetWaitLimit(double seconds)
{
  this->WaitLimit = seconds;
  if (this->Shared)
  {
    this->Shared->Watch.SetLimit(seconds);
  }
}

//------------------------------------------------------------------------------
template <typename Calls>
bool vtkWaterRanks::Speak(const char* what, Calls calls)
{
  const std::shared_ptr<Line> line = this->Shared;
  if (line->IsLost)
  {
    return false;
  }
  line->Watch.Begin(this->GetText(), what);
  line->IsLost = true; // also if a call throws
  try
  {
    line->IsLost = !calls();
  }
  catch (...)
  {
    line->Watch.End();
    throw;
  }
  line->Watch.End();
  return !line->IsLost;
}

//------------------------------------------------------------------------------
bool vtkWaterRanks::GatherNumbers(
  const char* what, const double* mine, size_t count, std::vector<double>& all)
{
  const auto ranks = static_cast<size_t>(this->Controller->GetNumberOfProcesses());
  std::vector<double> own(mine, mine + count);
  own.push_back(WATER_RANKS_IS_HERE);
  all.assign(own.size() * ranks, 0.0);
  const bool isReached = this->Speak(what, [&]() {
    return this->Controller->AllGather(
             own.data(), all.data(), static_cast<vtkIdType>(own.size())) != 0 &&
      water_ranks_take_numbers(all.data(), count, ranks);
  });
  all.resize(count * ranks);
  return isReached;
}

//------------------------------------------------------------------------------
vtkWaterError vtkWaterRanks::Describe(water_status status, size_t rank) const
{
  vtkWaterError error;
  error.Kind = water_status_text(status);
  error.Text = error.Kind + "; rank " + std::to_string(rank) +
    (status == WATER_RANKS_BAD_WATER ? " has one (this is rank "
                                     : " differs from rank 0 (this is rank ") +
    std::to_string(this->Controller->GetLocalProcessId()) + "). The water shows its plain colour.";
  return error;
}

//------------------------------------------------------------------------------
bool vtkWaterRanks::JoinFrames(
  water_rank_frame mine, double bounds[6], bool* areGone, vtkWaterError& error)
{
  *areGone = false;
  std::copy_n(mine.scene_bounds, 6, bounds);
  constexpr size_t size = sizeof(water_rank_frame) / sizeof(double);
  mine.format = WATER_RANKS_FORMAT;
  mine.scene_size = sizeof(water_scene);
  double numbers[size];
  std::memcpy(numbers, &mine, sizeof mine);
  std::vector<double> all;
  if (!this->GatherNumbers("what each shows in a frame", numbers, size, all))
  {
    error = Unreachable();
    return false;
  }
  std::vector<water_rank_frame> frames(all.size() / size);
  std::memcpy(frames.data(), all.data(), all.size() * sizeof(double));
  size_t bad = 0;
  const water_status status = water_ranks_join_frames(frames.data(), frames.size(), bounds, &bad);
  if (status != WATER_OK)
  {
    error = this->Describe(status, bad);
  }
  *areGone = status == WATER_OK && water_ranks_are_gone(frames.data(), frames.size());
  return status == WATER_OK;
}

//------------------------------------------------------------------------------
bool vtkWaterRanks::JoinGrounds(
  const std::vector<double>& mine, bool hasError, std::vector<double>& all, vtkWaterError& error)
{
  std::vector<double> sent(mine);
  sent.push_back(hasError ? 1.0 : 0.0);
  std::vector<double> got;
  if (!this->GatherNumbers("the ground below the water", sent.data(), sent.size(), got))
  {
    error = Unreachable();
    return false;
  }
  all.clear();
  const auto size = static_cast<std::ptrdiff_t>(sent.size());
  for (auto first = got.begin(); first != got.end(); first += size)
  {
    if (*(first + size - 1) != 0.0)
    {
      error =
        this->Describe(WATER_RANKS_BAD_WATER, static_cast<size_t>((first - got.begin()) / size));
      return false;
    }
    all.insert(all.end(), first, first + size - 1);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterRanks::JoinViews(const water_rank_view& mine, water_scene& scene,
  std::vector<water_prop>& props, water_ranks_view& joined, vtkWaterError& error)
{
  constexpr size_t size = sizeof(water_rank_view) / sizeof(double);
  double numbers[size];
  std::memcpy(numbers, &mine, sizeof mine);
  std::vector<double> all;
  error = Unreachable();
  if (!this->GatherNumbers("what each knows of a mirrored view", numbers, size, all))
  {
    return false;
  }
  std::vector<water_rank_view> views(all.size() / size);
  std::memcpy(views.data(), all.data(), all.size() * sizeof(double));
  const auto rank = static_cast<size_t>(this->Controller->GetLocalProcessId());
  size_t bad = 0;
  const water_status status =
    water_ranks_join_views(views.data(), views.size(), rank, &joined, &bad);
  if (status == WATER_RANKS_NO_SUCH_RANK)
  {
    error.Kind = std::string(water_status_text(status)) + "; it is " +
      std::to_string(static_cast<int>(views[0].farthest_rank)) + ", of " +
      std::to_string(views.size()) + " ranks";
    error.Text = error.Kind + ". The water shows its plain colour.";
    return false;
  }
  if (status != WATER_OK)
  {
    error = this->Describe(status, bad);
    return false;
  }
  std::vector<vtkIdType> lengths;
  std::vector<vtkIdType> offsets;
  vtkIdType end = 0;
  for (const water_rank_view& view : views)
  {
    lengths.push_back(static_cast<vtkIdType>(view.prop_count * sizeof(water_prop)));
    offsets.push_back(end);
    end += lengths.back();
  }
  props.resize(joined.prop_count);
  water_scene root = scene;
  const bool isReached = this->Speak("the props of all", [&]() {
    return this->Controller->AllGatherV(reinterpret_cast<const char*>(scene.props),
             reinterpret_cast<char*>(props.data()), lengths[rank], lengths.data(),
             offsets.data()) &&
      this->Controller->Broadcast(reinterpret_cast<char*>(&root), sizeof root, 0);
  });
  if (!isReached)
  {
    return false;
  }
  this->AgreedFarthest = joined.farthest_rank;
  scene = water_ranks_scene(&root, &joined, props.data());
  error = vtkWaterError();
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterRanks::HoldOnAll(std::vector<int>& claims)
{
  // gathered, not reduced: what a communicator makes of a rank that it has lost can be any number
  const std::vector<double> mine(claims.begin(), claims.end());
  std::vector<double> all;
  if (!this->GatherNumbers("whether all can go on", mine.data(), mine.size(), all))
  {
    std::fill(claims.begin(), claims.end(), 0);
    return;
  }
  for (size_t i = 0; i < all.size(); ++i)
  {
    int& claim = claims[i % claims.size()];
    claim = claim && all[i] != 0.0 ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
bool vtkWaterRanks::JoinRects(int rect[4], int& samples)
{
  constexpr size_t size = sizeof(water_rank_part) / sizeof(double);
  double mine[size] = { 0.0, 0.0, 0.0, 0.0, static_cast<double>(samples) };
  std::copy_n(rect, 4, mine);
  std::vector<double> all;
  if (!this->GatherNumbers("the part of the picture below the surface", mine, size, all))
  {
    return false;
  }
  std::vector<water_rank_part> parts(all.size() / size);
  std::memcpy(parts.data(), all.data(), all.size() * sizeof(double));
  samples = water_ranks_join_parts(parts.data(), parts.size(), rect);
  return true;
}

//------------------------------------------------------------------------------
vtkWaterRanks::Drawing vtkWaterRanks::JoinDrawn(const water_rank_drawn& mine)
{
  constexpr size_t size = sizeof(water_rank_drawn) / sizeof(double);
  double numbers[size];
  std::memcpy(numbers, &mine, sizeof mine);
  std::vector<double> all;
  Drawing made;
  if (!this->GatherNumbers("the draw of the mirrored view", numbers, size, all))
  {
    made.BadRank = static_cast<size_t>(this->Controller->GetLocalProcessId());
    return made;
  }
  std::vector<water_rank_drawn> drawn(all.size() / size);
  std::memcpy(drawn.data(), all.data(), all.size() * sizeof(double));
  made.Bounds.resize(drawn.size());
  made.Result = water_ranks_join_drawn(drawn.data(), drawn.size(),
    reinterpret_cast<double(*)[6]>(made.Bounds.data()), &made.HasBlended, &made.BadRank);
  return made;
}

//------------------------------------------------------------------------------
template <typename Merge>
bool vtkWaterRanks::Reduce(const std::vector<size_t>& order, water_rank_picture& picture,
  std::vector<unsigned char>& bytes, Merge merge)
{
  const auto self = static_cast<size_t>(this->Controller->GetLocalProcessId());
  const auto place =
    static_cast<size_t>(std::find(order.begin(), order.end(), self) - order.begin());
  const int first = static_cast<int>(order.front());
  bool isRead = true;
  // a rank that cannot read what was sent says so and continues, because the others do
  const auto write = [&](bool hasBackground) {
    bytes[0] = isRead ? SENT_PICTURE : SENT_NOTHING;
    return static_cast<vtkIdType>(
      isRead ? 1 + water_rank_pixels_encode(&picture, hasBackground, bytes.data() + 1) : 1);
  };
  for (size_t step = 1; step < order.size() && place % step == 0; step *= 2)
  {
    if (place % (2 * step) != 0)
    {
      const vtkIdType count = write(false);
      if (!this->Controller->Send(bytes.data(), count, static_cast<int>(order[place - step]), kTag))
      {
        return false;
      }
    }
    else if (place + step < order.size())
    {
      if (!this->Controller->Receive(bytes.data(), static_cast<vtkIdType>(bytes.size()),
            static_cast<int>(order[place + step]), kTag))
      {
        return false;
      }
      const auto count = static_cast<size_t>(this->Controller->GetCount());
      isRead =
        isRead && count > 0 && bytes[0] == SENT_PICTURE && merge(bytes.data() + 1, count - 1);
    }
  }
  vtkIdType count = place == 0 ? write(true) : 0;
  if (!this->Controller->Broadcast(&count, 1, first) || count < 1 ||
    count > static_cast<vtkIdType>(bytes.size()) ||
    !this->Controller->Broadcast(bytes.data(), count, first))
  {
    return false;
  }
  if (place == 0 || bytes[0] != SENT_PICTURE)
  {
    return bytes[0] == SENT_PICTURE;
  }
  if (!picture.depths)
  {
    std::fill_n(picture.colors, picture.words * picture.pixel_count, 0u); // where nothing is sent
  }
  return water_rank_pixels_merge(
    bytes.data() + 1, static_cast<size_t>(count) - 1, WATER_RANK_REPLACE, &picture);
}

//------------------------------------------------------------------------------
bool vtkWaterRanks::KeepNearest(water_rank_picture& picture, std::vector<unsigned char>& bytes)
{
  std::vector<size_t> order(static_cast<size_t>(this->Controller->GetNumberOfProcesses()));
  std::iota(order.begin(), order.end(), size_t(0)); // of pixels of one depth, the lower rank's
  return this->Speak("the nearest pixels of all", [&]() {
    return this->Reduce(order, picture, bytes, [&](const unsigned char* sent, size_t count) {
      return water_rank_pixels_merge(sent, count, WATER_RANK_NEAREST, &picture);
    });
  });
}

//------------------------------------------------------------------------------
bool vtkWaterRanks::BlendInOrder(const std::vector<size_t>& order, water_rank_picture& layer,
  water_rank_picture& spare, std::vector<unsigned char>& bytes)
{
  const auto blend = [&](const unsigned char* sent, size_t count) {
    std::fill_n(spare.colors, spare.words * spare.pixel_count, 0u);
    const bool isRead = water_rank_pixels_merge(sent, count, WATER_RANK_REPLACE, &spare);
    water_rank_pixels_over(layer.colors, layer.words, layer.pixel_count, spare.colors);
    std::swap(layer.colors, spare.colors);
    return isRead;
  };
  return this->Speak(
    "the blended layers of all", [&]() { return this->Reduce(order, layer, bytes, blend); });
}
