// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterReflectionChoice.cxx: the part of vtkWaterReflection that knows what is drawn in a view
// of either kind, the mirrored one or the own view: the props that a plan has chosen.
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkWaterPropRecords.h"
#include "vtkWaterReflection.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkProp* vtkWaterReflection::GetDrawn(const Frame& frame, const Choice& choice, size_t i)
{
  return choice.IsDirect ? frame.Records->GetProp(i) : frame.Records->GetDrawn(i);
}

//------------------------------------------------------------------------------
void vtkWaterReflection::FindDrawn(
  const Frame& frame, const Attempt& attempt, const Choice& choice, std::vector<vtkProp*>& drawn)
{
  drawn.clear();
  for (size_t i = 0; i < choice.Reasons.size(); ++i)
  {
    if (choice.Reasons[i] == WATER_CULL_NONE)
    {
      drawn.push_back(GetDrawn(frame, choice, i));
      if (!frame.Records->IsPlain(i) && drawn.back()->IsA("vtkLODProp3D"))
      {
        // It chooses its level here, which the renderer has not come to yet, and never does for a
        // prop that only the mirrored view shows.
        drawn.back()->SetAllocatedRenderTime(
          attempt.Waters.front()->Actor->GetAllocatedRenderTime(), frame.Renderer);
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterReflection::CountReasons()
{
  int* counts = this->Report.ReasonCounts;
  std::fill_n(counts, static_cast<int>(WATER_CULL_REASON_COUNT), 0);
  for (const water_cull_reason reason : this->Reasons)
  {
    ++counts[reason];
  }
}

//------------------------------------------------------------------------------
void vtkWaterReflection::Sign(const Frame& frame, const Choice& choice,
  const vtkWaterMirroredView::Draft& draft, vtkWaterSignature& signature) const
{
  signature.Read(frame.Renderer);
  for (size_t i = 0; i < choice.Reasons.size(); ++i)
  {
    if (choice.Reasons[i] == WATER_CULL_NONE)
    {
      signature.AddProp(GetDrawn(frame, choice, i),
        choice.IsDirect ? frame.Records->GetOwnStamp(frame.Renderer, i)
                        : frame.Records->GetStamp(frame.Renderer, i));
    }
  }
  signature.Add(static_cast<vtkMTimeType>(choice.Plan.samples));
  signature.Add(choice.Plan.is_half_float ? 1 : 0);
  signature.Add(this->Ranks.GetStamp());
  signature.AddSky(choice.Plan.sky, this->Gathered.Sky);
  signature.Add(draft.HasMarchedRays ? 1 : 0);
  signature.Add(draft.WantsPeel ? 1 : 0);
  if (draft.Shadows)
  {
    signature.AddShadows(frame.Renderer, draft.Shadows, *frame.Records);
  }
}

//------------------------------------------------------------------------------
void vtkWaterReflection::SortDrawn(
  const Frame& frame, const Choice& choice, vtkWaterMirroredView::Draft& draft) const
{
  for (size_t i = 0; i < choice.Reasons.size(); ++i)
  {
    if (choice.Reasons[i] == WATER_CULL_NONE)
    {
      const bool isPlain = frame.Records->IsPlain(i);
      vtkProp* drawn = GetDrawn(frame, choice, i);
      frame.Records->Reflect(i);
      draft.Known.emplace_back();
      draft.Known.back().MayBeCut =
        !isPlain || water_plan_cuts(&choice.Plan, this->Gathered.Props[i].bounds);
      draft.Known.back().IsUpToDate = frame.Records->IsUpToDate(i);
      draft.Known.back().IsOpaque = frame.Records->IsOpaque(i);
      if (!isPlain)
      {
        draft.Others.push_back(drawn);
      }
      if (!isPlain || frame.Records->IsTranslucent(i))
      {
        draft.Blended.push_back(drawn);
      }
    }
  }
}
