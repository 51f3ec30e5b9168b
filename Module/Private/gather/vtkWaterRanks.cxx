// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterRanks.h"

#include "vtkCommunicator.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace
{
const char* const kUnreachable = "the other ranks cannot be reached";

// Pixels travel as doubles, which no communicator splits; nothing computes with these.
class NearestPixels : public vtkCommunicator::Operation
{
public:
  void Function(const void* lower, void* nearest, vtkIdType length, int) override
  {
    water_ranks_nearest(static_cast<const water_rank_pixel*>(lower),
      static_cast<water_rank_pixel*>(nearest), static_cast<size_t>(length));
  }
  int Commutative() override { return 0; } // of pixels of one depth, the lower rank's is kept
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
  return "rank " + std::to_string(this->Controller->GetLocalProcessId()) + " of " +
    std::to_string(this->Controller->GetNumberOfProcesses());
}

//------------------------------------------------------------------------------
bool vtkWaterRanks::GatherNumbers(const double* mine, size_t count, std::vector<double>& all)
{
  all.resize(count * static_cast<size_t>(this->Controller->GetNumberOfProcesses()));
  return this->Controller->AllGather(mine, all.data(), static_cast<vtkIdType>(count)) != 0;
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
  constexpr size_t size = sizeof(water_rank_frame) / sizeof(double);
  mine.format = WATER_RANKS_FORMAT;
  mine.scene_size = sizeof(water_scene);
  double numbers[size];
  std::memcpy(numbers, &mine, sizeof mine);
  std::vector<double> all;
  if (!this->GatherNumbers(numbers, size, all))
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
bool vtkWaterRanks::JoinViews(const water_rank_view& mine, water_scene& scene,
  std::vector<water_prop>& props, water_ranks_view& joined, vtkWaterError& error)
{
  constexpr size_t size = sizeof(water_rank_view) / sizeof(double);
  double numbers[size];
  std::memcpy(numbers, &mine, sizeof mine);
  std::vector<double> all;
  error = Unreachable();
  if (!this->GatherNumbers(numbers, size, all))
  {
    return false;
  }
  std::vector<water_rank_view> views(all.size() / size);
  std::memcpy(views.data(), all.data(), all.size() * sizeof(double));
  const auto rank = static_cast<size_t>(this->Controller->GetLocalProcessId());
  size_t bad = 0;
  const water_status status =
    water_ranks_join_views(views.data(), views.size(), rank, &joined, &bad);
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
  if (!this->Controller->AllGatherV(reinterpret_cast<const char*>(scene.props),
        reinterpret_cast<char*>(props.data()), lengths[rank], lengths.data(), offsets.data()) ||
    !this->Controller->Broadcast(reinterpret_cast<char*>(&root), sizeof root, 0))
  {
    return false;
  }
  scene = water_ranks_scene(&root, &joined, props.data());
  error = vtkWaterError();
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterRanks::HoldOnAll(std::vector<int>& claims)
{
  std::vector<int> joined(claims.size());
  if (!this->Controller->AllReduce(claims.data(), joined.data(),
        static_cast<vtkIdType>(claims.size()), vtkCommunicator::MIN_OP))
  {
    std::fill(joined.begin(), joined.end(), 0);
  }
  claims.swap(joined);
}

//------------------------------------------------------------------------------
bool vtkWaterRanks::JoinRects(int rect[4])
{
  constexpr int none = std::numeric_limits<int>::max();
  const bool isEmpty = rect[2] <= 0 || rect[3] <= 0;
  // the ends as negative numbers: the least of all ranks' is asked
  const int mine[4] = { isEmpty ? none : rect[0], isEmpty ? none : rect[1],
    isEmpty ? none : -(rect[0] + rect[2]), isEmpty ? none : -(rect[1] + rect[3]) };
  int all[4];
  if (!this->Controller->AllReduce(mine, all, 4, vtkCommunicator::MIN_OP))
  {
    return false;
  }
  const bool areEmpty = all[0] == none;
  rect[0] = areEmpty ? 0 : all[0];
  rect[1] = areEmpty ? 0 : all[1];
  rect[2] = areEmpty ? 0 : -all[2] - all[0];
  rect[3] = areEmpty ? 0 : -all[3] - all[1];
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterRanks::KeepNearest(std::vector<water_rank_pixel>& pixels)
{
  std::vector<double> sent(pixels.size());
  std::vector<double> nearest(pixels.size());
  std::memcpy(sent.data(), pixels.data(), pixels.size() * sizeof(double));
  NearestPixels operation;
  if (!this->Controller->AllReduce(
        sent.data(), nearest.data(), static_cast<vtkIdType>(sent.size()), &operation))
  {
    return false;
  }
  std::memcpy(pixels.data(), nearest.data(), pixels.size() * sizeof(double));
  return true;
}
