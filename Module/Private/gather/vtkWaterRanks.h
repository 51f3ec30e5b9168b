// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterRanks: what this process tells the other ranks of a sort-last renderer, and hears from
// them. What that means is decided by the core (water_ranks.h). Each call is one or two
// collectives: all ranks call the same ones in the same order, or none.
#ifndef vtkWaterRanks_h
#define vtkWaterRanks_h

#include "vtkMultiProcessController.h" // for members
#include "vtkSmartPointer.h"
#include "vtkWaterRankWatch.h"
#include "vtkWaterSource.h"
#include "water_rank_pixels.h"
#include "water_ranks.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

class vtkWaterRanks
{
public:
  // What all ranks' draws come to.
  struct Drawing
  {
    water_ranks_drawing Result = WATER_RANKS_FAILED;
    size_t BadRank = 0;
    bool HasBlended = false;
    std::vector<std::array<double, 6>> Bounds; // of what each rank blends
  };

  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const { return this->Controller; }

  // Seconds that this process waits for the others before it is ended; 0: no limit.
  void SetWaitLimit(double seconds);
  double GetWaitLimit() const { return this->WaitLimit; }

  // Does a controller have nothing to speak by? It is not initialised yet, or finalised: VTK prints
  // an error each time that it is asked for its processes.
  bool IsMute() const { return this->Controller && !this->Controller->GetCommunicator(); }
  vtkWaterError DescribeMute() const;

  // The rank whose picture shows the water, where pictures are blended in an order; -1: all do. The
  // root's number counts.
  void SetFarthest(int rank) { this->Farthest = rank; }
  int GetFarthest() const { return this->Farthest; }
  // Does this rank's picture show it, by what was agreed last?
  bool ShowsWater() const
  {
    return !this->AreSeveral() ||
      water_rank_shows_water(
        this->AgreedFarthest, static_cast<size_t>(this->Controller->GetLocalProcessId()));
  }

  // Are pictures blended in an order, by what was agreed last?
  bool AreBlended() const { return this->AreSeveral() && this->AgreedFarthest >= 0; }

  // This rank's part of the space, in which it shows translucent water; empty: all of the space.
  void SetRegion(const double region[6]) { std::copy_n(region, 6, this->Region); }
  const double* GetRegion() const { return this->Region; }
  bool HasRegion() const { return this->AreSeveral() && water_rank_region_is_there(this->Region); }

  // Are there others? A controller of one process is as good as none.
  bool AreSeveral() const { return this->GetProcessCount() > 1; }

  // 0 without a controller that can speak.
  int GetProcessCount() const
  {
    return this->Controller && !this->IsMute() ? this->Controller->GetNumberOfProcesses() : 0;
  }

  // How many processes MPI has started together with this one, as Open MPI and those of MPICH's
  // kind tell each; 0: not known.
  static int GetStartedCount();

  // Another number for each controller; 0 without others: a view that ranks have joined is not that
  // of one, and the reverse.
  vtkMTimeType GetStamp() const { return this->AreSeveral() ? this->Stamp : 0; }

  // "rank 1 of 4", or "(none)" without a controller, "(no communicator)" of one that is mute.
  std::string GetText() const;

  // What all ranks know of a frame. false: they differ, and nothing more may be sent in it; or they
  // cannot be reached.
  //
  // mine    format and scene_size are filled in here
  // bounds   of the scenes of all ranks; min > max: there are none. Of this rank's, if the others
  //          cannot be reached
  // areGone  set: water_ranks_are_gone
  bool JoinFrames(water_rank_frame mine, double bounds[6], bool* areGone, vtkWaterError& error);

  // What all ranks know of the ground, one rank after the other. false: they cannot be reached, or
  // one of them has an error.
  //
  // mine      as many numbers on all ranks
  // hasError  this rank's numbers mean nothing
  bool JoinGrounds(
    const std::vector<double>& mine, bool hasError, std::vector<double>& all, vtkWaterError& error);

  // What they know of a mirrored view, likewise; scene becomes the one that all of them plan.
  //
  // scene   this rank's; on return its props are in `props`
  // joined  with the place of this rank's props in them
  bool JoinViews(const water_rank_view& mine, water_scene& scene, std::vector<water_prop>& props,
    water_ranks_view& joined, vtkWaterError& error);

  // Does each of these hold on all ranks? None does if they cannot be reached.
  void HoldOnAll(std::vector<int>& claims);

  // Makes of the ranks' rectangles (x, y, width, height; nothing in it if one of the last two is
  // not positive) the one around all of them. false: they cannot be reached.
  //
  // samples  a pixel that each has; 0 if not all have as many
  bool JoinRects(int rect[4], int& samples);

  // What becomes of a mirrored view that all have drawn, or could not draw.
  Drawing JoinDrawn(const water_rank_drawn& mine);

  // Keeps the nearest pixel of all ranks, place by place; the background is the root's. false: they
  // cannot be reached, or have sent something else.
  //
  // bytes  of water_rank_pixels_limit
  bool KeepNearest(water_rank_picture& picture, std::vector<unsigned char>& bytes);

  // Blends all ranks' layers over each other. false: as above.
  //
  // order   the ranks, from front to back
  // spare   a layer of the same size to compute with
  bool BlendInOrder(const std::vector<size_t>& order, water_rank_picture& layer,
    water_rank_picture& spare, std::vector<unsigned char>& bytes);

private:
  // What copies of this share: they speak by the same controller.
  struct Line
  {
    vtkWaterRankWatch Watch;
    bool IsLost = false; // once a call has failed, ranks are not at one place any more
  };

  // Does one or more collective calls unless the others are lost; watched, and lost if they fail.
  template <typename Calls>
  bool Speak(const char* what, Calls calls);
  // Brings all pictures together at the first rank of an order, and from there to all.
  template <typename Merge>
  bool Reduce(const std::vector<size_t>& order, water_rank_picture& picture,
    std::vector<unsigned char>& bytes, Merge merge);
  bool GatherNumbers(const char* what, const double* mine, size_t count, std::vector<double>& all);
  vtkWaterError Describe(water_status status, size_t rank) const;

  vtkSmartPointer<vtkMultiProcessController> Controller;
  std::shared_ptr<Line> Shared;
  double WaitLimit = 0.0;
  int Farthest = -1;
  int AgreedFarthest = -1;
  double Region[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  vtkMTimeType Stamp = 0;
};

#endif
