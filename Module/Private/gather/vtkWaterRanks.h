// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterRanks: what this process tells the other ranks of a sort-last renderer, and hears from
// them. What that means is decided by the core (water_ranks.h). Each call is one or two
// collectives: all ranks call the same ones in the same order, or none.
#ifndef vtkWaterRanks_h
#define vtkWaterRanks_h

#include "vtkMultiProcessController.h" // for members
#include "vtkSmartPointer.h"
#include "vtkWaterSource.h"
#include "water_ranks.h"

#include <string>
#include <vector>

class vtkWaterRanks
{
public:
  void SetController(vtkMultiProcessController* controller) { this->Controller = controller; }
  vtkMultiProcessController* GetController() const { return this->Controller; }

  // Are there others? A controller of one process is as good as none.
  bool AreSeveral() const
  {
    return this->Controller && this->Controller->GetNumberOfProcesses() > 1;
  }

  // "rank 1 of 4", or "(none)" without a controller.
  std::string GetText() const;

  // What all ranks know of a frame. false: they differ, and nothing more may be sent in it; or they
  // cannot be reached.
  //
  // mine    format and scene_size are filled in here
  // bounds   of the scenes of all ranks; min > max: there are none
  // areGone  set: water_ranks_are_gone
  bool JoinFrames(water_rank_frame mine, double bounds[6], bool* areGone, vtkWaterError& error);

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
  bool JoinRects(int rect[4]);

  // Keeps the nearest pixel of all ranks, place by place. false: they cannot be reached.
  bool KeepNearest(std::vector<water_rank_pixel>& pixels);

private:
  bool GatherNumbers(const double* mine, size_t count, std::vector<double>& all);
  vtkWaterError Describe(water_status status, size_t rank) const;

  vtkSmartPointer<vtkMultiProcessController> Controller;
};

#endif
