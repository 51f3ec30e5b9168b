// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterReflectionRankViews.cxx: the part of vtkWaterReflection that draws the own view, the sun
// view or the sky view together with the other ranks of a sort-last renderer. All ranks plan it, as
// looks and scene are those of all; each comes here if the plan is to draw it, and never else. See
// Documentation/decisions/023-ranks.md.
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkWaterReflection.h"
#include "vtkWaterShaderHook.h"

#include <exception>

//------------------------------------------------------------------------------
vtkWaterError vtkWaterReflection::DrawOtherOfAll(const Frame& frame, Attempt& part,
  const Choice& choice, const water_scene& scene, water_plan& plan,
  std::vector<water_cull_reason>& reasons, const Other& other)
{
  enum
  {
    CAN_DRAW,   // no mirrored view has failed, and this one can be drawn
    GOES_ON,    // nothing has ended the draw
    IS_THE_SAME // as the last one
  };
  std::vector<int> claims = { 1, 1, 0 };
  claims[GOES_ON] = this->GetPlannedView() == part.Drawn.get() && !part.IsAborted &&
    !frame.Renderer->GetRenderWindow()->GetAbortRender();
  const bool hasMirrored = this->Report.Decision != WATER_NO_REFLECT_FAILED;
  const auto fail = [&part](const std::string& text) {
    part.FailureText = text;
    part.Failure = part.FailureText.c_str();
  };
  try
  {
    claims[IS_THE_SAME] = this->ReviseOther(frame, part, choice, scene, reasons, other);
  }
  catch (const std::exception& thrown)
  {
    fail(std::string("reading its props was ended by an exception (") + thrown.what() + ")");
  }
  claims[CAN_DRAW] = hasMirrored && !part.Failure;
  this->Ranks.HoldOnAll(claims);
  if (!claims[CAN_DRAW] || !claims[GOES_ON])
  {
    plan.decision = WATER_NO_REFLECT_FAILED;
    if (!hasMirrored || claims[CAN_DRAW])
    {
      return vtkWaterError(); // has been said, or is none
    }
    if (!part.Failure)
    {
      fail("another rank could not draw its part");
    }
    return this->CommitOther(frame, part, plan, other);
  }
  if (claims[IS_THE_SAME])
  {
    plan.decision = WATER_REUSE;
    return Describe(other.View->Drawn.GetShortage());
  }
  part.Draft.Ranks = &this->Ranks;
  part.Draft.Agree = [this, &frame, &part](
                       const water_rank_drawn& mine) -> const vtkWaterRanks::Drawing& {
    return this->JoinDrawn(frame, part, mine);
  };
  part.AgreementsDue = 1;
  try
  {
    part.Failure = this->CarryOutOther(frame, part, choice, *other.View);
  }
  catch (const std::exception& thrown)
  {
    fail(std::string("its draw was ended by an exception (") + thrown.what() + ")");
  }
  // what one rank's driver refused is left out of the next one, of all ranks
  const bool isOfOther = !part.Failure;
  const bool isRefused = this->FinishDrawn(frame, part, plan);
  if (isOfOther && part.Failure)
  {
    fail("rank " + std::to_string(part.Drawing.BadRank) + " could not draw its part");
  }
  part.IsAborted = part.IsAborted || isRefused;
  return this->CommitOther(frame, part, plan, other);
}
