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
void vtkWaterReflection::Fail(Attempt& part, const std::string& text)
{
  part.FailureText = text;
  part.Failure = part.FailureText.c_str();
}

//------------------------------------------------------------------------------
water_decision vtkWaterReflection::AgreeOnOther(const Frame& frame, Attempt& part,
  const Choice& choice, const water_scene& scene, std::vector<water_cull_reason>& reasons,
  const Other& other)
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
  try
  {
    claims[IS_THE_SAME] = this->ReviseOther(frame, part, choice, scene, reasons, other);
  }
  catch (const std::exception& thrown)
  {
    Fail(part, std::string("reading its props was ended by an exception (") + thrown.what() + ")");
  }
  claims[CAN_DRAW] = hasMirrored && !part.Failure;
  this->Ranks.HoldOnAll(claims);
  if (!claims[CAN_DRAW] && hasMirrored && !part.Failure)
  {
    Fail(part, "another rank could not draw its part");
  }
  if (!claims[CAN_DRAW] || !claims[GOES_ON])
  {
    return WATER_NO_REFLECT_FAILED;
  }
  return claims[IS_THE_SAME] ? WATER_REUSE : WATER_REFLECT;
}

//------------------------------------------------------------------------------
vtkWaterError vtkWaterReflection::DrawOtherOfAll(const Frame& frame, Attempt& part,
  const Choice& choice, const water_scene& scene, water_plan& plan,
  std::vector<water_cull_reason>& reasons, const Other& other)
{
  plan.decision = this->AgreeOnOther(frame, part, choice, scene, reasons, other);
  if (plan.decision == WATER_REUSE)
  {
    return Describe(other.View->Drawn.GetShortage());
  }
  if (plan.decision == WATER_NO_REFLECT_FAILED)
  {
    // without a failure it has been said of the mirrored view, or the user has ended the draw
    return part.Failure ? this->CommitOther(frame, part, plan, other) : vtkWaterError();
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
    Fail(part, std::string("its draw was ended by an exception (") + thrown.what() + ")");
  }
  const bool isOfOther = !part.Failure;
  // what one rank's driver refused is left out of the next one, of all ranks
  const bool isRefused = this->FinishDrawn(frame, part, plan);
  if (isOfOther && part.Failure)
  {
    Fail(part, "rank " + std::to_string(part.Drawing.BadRank) + " could not draw its part");
  }
  part.IsAborted = part.IsAborted || isRefused;
  return this->CommitOther(frame, part, plan, other);
}
