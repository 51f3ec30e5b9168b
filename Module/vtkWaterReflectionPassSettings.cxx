// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterReflectionPassSettings.cxx: the part of vtkWaterReflectionPass that is set and asked for.
#include "vtkMath.h"
#include "vtkTextureObject.h"
#include "vtkWaterCompat.h"
#include "vtkWaterReflection.h"
#include "vtkWaterReflectionPass.h"
#include "water_plan.h"
#include "water_ranks.h"

#include <algorithm>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

// The public enums are the core's: each of them, value by value.
#define WATER_SAME(mine, its)                                                                      \
  static_assert(static_cast<int>(vtkWaterReflectionPass::mine) == static_cast<int>(its),           \
    #mine " mirrors the core's " #its)
WATER_SAME(DRAWN, WATER_CULL_NONE);
WATER_SAME(INVISIBLE, WATER_CULL_INVISIBLE);
WATER_SAME(WATER_ITSELF, WATER_CULL_WATER);
WATER_SAME(MARKED_NOT_REFLECTED, WATER_CULL_NOT_REFLECTED);
WATER_SAME(OVERLAY, WATER_CULL_OVERLAY);
WATER_SAME(LABEL, WATER_CULL_LABEL);
WATER_SAME(EMPTY, WATER_CULL_EMPTY);
WATER_SAME(BEHIND_PLANE, WATER_CULL_BEHIND_PLANE);
WATER_SAME(OUT_OF_VIEW, WATER_CULL_OUT_OF_VIEW);
WATER_SAME(OUT_OF_WATER, WATER_CULL_OUT_OF_WATER);
WATER_SAME(TOO_SMALL, WATER_CULL_TOO_SMALL);
WATER_SAME(REFUSED, WATER_CULL_REFUSED);
WATER_SAME(NUMBER_OF_FATES, WATER_CULL_REASON_COUNT);
WATER_SAME(NOT_PLANNED, WATER_NOT_PLANNED);
WATER_SAME(RENDERED, WATER_REFLECT);
WATER_SAME(FAILED, WATER_NO_REFLECT_FAILED);
WATER_SAME(SELECTING, WATER_NO_REFLECT_SELECTING);
WATER_SAME(EDGE_ON, WATER_NO_REFLECT_EDGE_ON);
WATER_SAME(WATER_OUT_OF_VIEW, WATER_NO_REFLECT_OUT_OF_VIEW);
WATER_SAME(NO_REFLECTANCE, WATER_NO_REFLECT_NO_REFLECTANCE);
WATER_SAME(STATIC_ENVIRONMENT, WATER_NO_REFLECT_ENVIRONMENT);
WATER_SAME(REUSED, WATER_REUSE);
WATER_SAME(FACING_AWAY, WATER_NO_REFLECT_FACING_AWAY);
WATER_SAME(HIDDEN, WATER_NO_REFLECT_HIDDEN);
WATER_SAME(FAINT, WATER_NO_REFLECT_FAINT);
WATER_SAME(SHARED, WATER_NO_REFLECT_SHARED);
WATER_SAME(NUMBER_OF_DECISIONS, WATER_DECISION_COUNT);
WATER_SAME(UNSEEN_WATER, WATER_MAY_SKIP_UNSEEN);
WATER_SAME(HIDDEN_WATER, WATER_MAY_SKIP_HIDDEN);
WATER_SAME(FAINT_WATER, WATER_MAY_SKIP_FAINT);
WATER_SAME(UNCHANGED_VIEWS, WATER_MAY_SKIP_UNCHANGED);
WATER_SAME(SHARED_VIEWS, WATER_MAY_SKIP_SHARED);
WATER_SAME(PROPS, WATER_MAY_SKIP_PROPS);
WATER_SAME(PIECES, WATER_MAY_SKIP_CLUSTERS);
WATER_SAME(PIXELS, WATER_MAY_SKIP_PIXELS);
WATER_SAME(SKIP_ALL, WATER_MAY_SKIP_ALL);
WATER_SAME(AUTOMATIC, WATER_COLOR_AUTOMATIC);
WATER_SAME(EIGHT_BIT, WATER_COLOR_EIGHT_BIT);
WATER_SAME(HALF_FLOAT, WATER_COLOR_HALF_FLOAT);
WATER_SAME(FIXED, WATER_QUALITY_FIXED);
WATER_SAME(TARGET_ERROR, WATER_QUALITY_TARGET_ERROR);
WATER_SAME(TIME_BUDGET, WATER_QUALITY_TIME_BUDGET);
WATER_SAME(UPDATE_RATE, WATER_QUALITY_UPDATE_RATE);

namespace
{
constexpr double kLargest = std::numeric_limits<double>::max();
}

//------------------------------------------------------------------------------
template <typename T, typename V>
void vtkWaterReflectionPass::Set(const char* name, T& setting, V value, V low, V high)
{
  const T given = static_cast<T>(value);
  if (!(value >= low && value <= high)) // NaN neither
  {
    vtkErrorMacro(<< name << " is " << value << "; it must lie in [" << low << ", " << high
                  << "]. It stays " << setting << ".");
  }
  else if (setting != given)
  {
    setting = given;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetTextureScale(double scale)
{
  this->Set("TextureScale", this->Reflection->Settings.texture_scale, scale, 1.0 / 64.0, 16.0);
}

//------------------------------------------------------------------------------
double vtkWaterReflectionPass::GetTextureScale() const
{
  return this->Reflection->Settings.texture_scale;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetMultiSamples(int samples)
{
  this->Set("MultiSamples", this->Reflection->Settings.multi_samples, samples, -1, 32);
}

//------------------------------------------------------------------------------
int vtkWaterReflectionPass::GetMultiSamples() const
{
  return this->Reflection->Settings.multi_samples;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetColorPrecision(int precision)
{
  this->Set("ColorPrecision", this->Reflection->Settings.color_precision, precision,
    static_cast<int>(AUTOMATIC), static_cast<int>(HALF_FLOAT));
}

//------------------------------------------------------------------------------
int vtkWaterReflectionPass::GetColorPrecision() const
{
  return static_cast<int>(this->Reflection->Settings.color_precision);
}

//------------------------------------------------------------------------------
const char* vtkWaterReflectionPass::GetColorPrecisionAsString() const
{
  static const char* const names[] = { "AUTOMATIC", "EIGHT_BIT", "HALF_FLOAT" };
  return names[this->GetColorPrecision()];
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetClipMargin(double margin)
{
  this->Set("ClipMargin", this->Reflection->Settings.clip_margin, margin, 0.0, kLargest);
}

//------------------------------------------------------------------------------
double vtkWaterReflectionPass::GetClipMargin() const
{
  return this->Reflection->Settings.clip_margin;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetSkips(int skips)
{
  this->Set("Skips", this->Reflection->Settings.skips, skips, static_cast<int>(SKIP_NONE),
    static_cast<int>(SKIP_ALL));
}

//------------------------------------------------------------------------------
int vtkWaterReflectionPass::GetSkips() const
{
  return static_cast<int>(this->Reflection->Settings.skips);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetMinimumPropSize(double pixels)
{
  this->Set("MinimumPropSize", this->Reflection->Settings.prop_px_min, pixels, 0.0, kLargest);
}

//------------------------------------------------------------------------------
double vtkWaterReflectionPass::GetMinimumPropSize() const
{
  return this->Reflection->Settings.prop_px_min;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetReflectanceError(double share)
{
  this->Set("ReflectanceError", this->Reflection->Settings.reflectance_error, share, 0.0, 1.0);
}

//------------------------------------------------------------------------------
double vtkWaterReflectionPass::GetReflectanceError() const
{
  return this->Reflection->Settings.reflectance_error;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetQuality(int quality)
{
  this->Set("Quality", this->Reflection->Settings.quality, quality, static_cast<int>(FIXED),
    static_cast<int>(UPDATE_RATE));
}

//------------------------------------------------------------------------------
int vtkWaterReflectionPass::GetQuality() const
{
  return static_cast<int>(this->Reflection->Settings.quality);
}

//------------------------------------------------------------------------------
const char* vtkWaterReflectionPass::GetQualityAsString() const
{
  static const char* const names[] = { "FIXED", "TARGET_ERROR", "TIME_BUDGET", "UPDATE_RATE" };
  return names[this->GetQuality()];
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetTargetError(double pixels)
{
  this->Set("TargetError", this->Reflection->Settings.target_error_px, pixels, 1e-3, 1e3);
}

//------------------------------------------------------------------------------
double vtkWaterReflectionPass::GetTargetError() const
{
  return this->Reflection->Settings.target_error_px;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetRankWaitLimit(double seconds)
{
  double limit = this->GetRankWaitLimit();
  this->Set("RankWaitLimit", limit, seconds, 0.0, 1e6);
  this->Reflection->Ranks.SetWaitLimit(limit);
}

//------------------------------------------------------------------------------
double vtkWaterReflectionPass::GetRankWaitLimit() const
{
  return this->Reflection->Ranks.GetWaitLimit();
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetFarthestRank(int rank)
{
  int farthest = this->GetFarthestRank();
  this->Set("FarthestRank", farthest, rank, -1, std::numeric_limits<int>::max());
  this->Reflection->Ranks.SetFarthest(farthest);
}

//------------------------------------------------------------------------------
int vtkWaterReflectionPass::GetFarthestRank() const
{
  return this->Reflection->Ranks.GetFarthest();
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetRankRegion(const double bounds[6])
{
  if (!water_rank_region_is_there(bounds))
  {
    vtkErrorMacro("RankRegion is (" << bounds[0] << ", " << bounds[1] << ", " << bounds[2] << ", "
                                    << bounds[3] << ", " << bounds[4] << ", " << bounds[5]
                                    << "); it must have each minimum below its maximum, and no "
                                       "NaN. It stays as it was.");
    return;
  }
  if (!std::equal(bounds, bounds + 6, this->GetRankRegion()))
  {
    this->Reflection->Ranks.SetRegion(bounds);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::ResetRankRegion()
{
  const double none[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  if (!std::equal(none, none + 6, this->GetRankRegion()))
  {
    this->Reflection->Ranks.SetRegion(none);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const double* vtkWaterReflectionPass::GetRankRegion() const
{
  return this->Reflection->Ranks.GetRegion();
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetTimeBudget(double milliseconds)
{
  this->Set("TimeBudget", this->Reflection->Settings.time_budget_ms, milliseconds, 1e-3, 1e6);
}

//------------------------------------------------------------------------------
double vtkWaterReflectionPass::GetTimeBudget() const
{
  return this->Reflection->Settings.time_budget_ms;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetGuardBand(double band)
{
  double& setting = this->Reflection->Settings.guard_band;
  if (!(band == 0.0 || (band >= 1.0 && band <= 2.0)))
  {
    vtkErrorMacro("GuardBand is " << band
                                  << "; it must lie in [1, 2], or be 0 (by the waves' slope). "
                                  << "It stays " << setting << ".");
  }
  else if (setting != band)
  {
    setting = band;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkWaterReflectionPass::GetGuardBand() const
{
  return this->Reflection->Settings.guard_band;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetSecondaryReflections(bool reflections)
{
  this->Set("SecondaryReflections", this->Reflection->Settings.secondary_reflections, reflections,
    false, true);
}

//------------------------------------------------------------------------------
bool vtkWaterReflectionPass::GetSecondaryReflections() const
{
  return this->Reflection->Settings.secondary_reflections;
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterReflectionPass::GetNumberOfSecondaryRenders() const
{
  return this->Reflection->GetReport().SecondaryRenderCount;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetSurfaceBuffer(bool surfaceBuffer)
{
  if (this->Reflection->Settings.MayBuffer != surfaceBuffer)
  {
    this->Reflection->Settings.MayBuffer = surfaceBuffer;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkWaterReflectionPass::GetSurfaceBuffer() const
{
  return this->Reflection->Settings.MayBuffer;
}

//------------------------------------------------------------------------------
bool vtkWaterReflectionPass::GetSurfaceIsBuffered() const
{
  return this->Reflection->GetReport().BufferUse == WATER_BUFFER_IN_USE;
}

//------------------------------------------------------------------------------
const char* vtkWaterReflectionPass::GetSurfaceBufferUseAsString() const
{
  return water_buffer_text(this->Reflection->GetReport().BufferUse);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetInstrumentation(bool instrumentation)
{
  // no modification: it changes nothing that is rendered
  this->Reflection->Settings.IsInstrumented = instrumentation;
  if (!instrumentation)
  {
    this->Reflection->ForgetTimes();
  }
}

//------------------------------------------------------------------------------
bool vtkWaterReflectionPass::GetInstrumentation() const
{
  return this->Reflection->Settings.IsInstrumented;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::CopySettings(vtkWaterReflectionPass* other)
{
  const bool isInstrumented = this->GetInstrumentation();
  this->Reflection->Settings = other->Reflection->Settings;
  this->Reflection->Settings.IsInstrumented = isInstrumented;
  this->Modified();
}

//------------------------------------------------------------------------------
double vtkWaterReflectionPass::GetLastGatherTime() const
{
  return this->Reflection->GetReport().GatherTime;
}

//------------------------------------------------------------------------------
double vtkWaterReflectionPass::GetLastPlanTime() const
{
  return this->Reflection->GetReport().PlanTime;
}

//------------------------------------------------------------------------------
int vtkWaterReflectionPass::GetQualityStep() const
{
  return this->Reflection->GetReport().QualityStep;
}

//------------------------------------------------------------------------------
double vtkWaterReflectionPass::GetTextureScaleInUse() const
{
  return this->Reflection->GetReport().TextureScale;
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterReflectionPass::GetNumberOfReflectionRenders() const
{
  return this->Reflection->GetReport().RenderCount;
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterReflectionPass::GetNumberOfOwnViewRenders() const
{
  return this->Reflection->GetReport().OwnViewRenderCount;
}

//------------------------------------------------------------------------------
int vtkWaterReflectionPass::GetOwnViewDecision() const
{
  return this->Reflection->GetReport().OwnViewDecision;
}

//------------------------------------------------------------------------------
const char* vtkWaterReflectionPass::GetOwnViewDecisionAsString() const
{
  return water_decision_text(this->Reflection->GetReport().OwnViewDecision);
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterReflectionPass::GetReflectionTexture()
{
  return this->Reflection->GetColor();
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterReflectionPass::GetReflectionDepthTexture()
{
  return this->Reflection->GetDepth();
}

//------------------------------------------------------------------------------
int vtkWaterReflectionPass::GetFateCount(int fate) const
{
  return fate >= 0 && fate < WATER_CULL_REASON_COUNT
    ? this->Reflection->GetReport().ReasonCounts[fate]
    : 0;
}

//------------------------------------------------------------------------------
const char* vtkWaterReflectionPass::GetFateAsString(int fate)
{
  return fate >= 0 && fate < WATER_CULL_REASON_COUNT
    ? water_cull_reason_text(static_cast<water_cull_reason>(fate))
    : "unknown fate";
}

//------------------------------------------------------------------------------
int vtkWaterReflectionPass::GetDecision() const
{
  return this->Reflection->GetReport().Decision;
}

//------------------------------------------------------------------------------
const char* vtkWaterReflectionPass::GetDecisionAsString() const
{
  return water_decision_text(this->Reflection->GetReport().Decision);
}

//------------------------------------------------------------------------------
double vtkWaterReflectionPass::GetLastReflectionTime()
{
  return this->Reflection->AskTime();
}

//------------------------------------------------------------------------------
double vtkWaterReflectionPass::GetLastSurfaceTime()
{
  return this->Reflection->Ask(vtkMath::Nan(),
    [](vtkWaterGpuQueries& queries) { return queries.GetTime(vtkWaterGpuQueries::SURFACE); });
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterReflectionPass::GetNumberOfTrianglesReflected()
{
  return this->Reflection->Ask(
    vtkIdType(-1), [](vtkWaterGpuQueries& queries) { return queries.GetTriangles(); });
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterReflectionPass::GetNumberOfFragmentsReflected()
{
  return this->Reflection->Ask(
    vtkIdType(-1), [](vtkWaterGpuQueries& queries) { return queries.GetFragments(); });
}

//------------------------------------------------------------------------------
// Long because there are many settings.
void vtkWaterReflectionPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DelegatePass: ";
  if (!this->DelegatePass)
  {
    os << "(none)\n";
  }
  else if (this->IsVisiting)
  {
    os << "leads back to this pass\n";
  }
  else
  {
    os << "\n";
    this->IsVisiting = true;
    this->DelegatePass->PrintSelf(os, indent.GetNextIndent());
    this->IsVisiting = false;
  }
  os << indent << "TextureScale: " << this->GetTextureScale() << "\n";
  os << indent << "MultiSamples: " << this->GetMultiSamples() << "\n";
  os << indent << "ColorPrecision: " << this->GetColorPrecisionAsString() << "\n";
  os << indent << "ClipMargin: " << this->GetClipMargin() << "\n";
  os << indent << "GuardBand: " << this->GetGuardBand() << "\n";
  os << indent << "SecondaryReflections: " << (this->GetSecondaryReflections() ? "on" : "off")
     << "\n";
  os << indent << "Skips: " << this->GetSkips() << "\n";
  os << indent << "MinimumPropSize: " << this->GetMinimumPropSize() << "\n";
  os << indent << "ReflectanceError: " << this->GetReflectanceError() << "\n";
  os << indent << "SurfaceBuffer: " << (this->GetSurfaceBuffer() ? "on" : "off") << "\n";
  os << indent << "Instrumentation: " << (this->GetInstrumentation() ? "on" : "off") << "\n";
  if (this->GetInstrumentation())
  {
    const vtkIndent next = indent.GetNextIndent();
    os << next << "LastGatherTime: " << this->GetLastGatherTime() << " ms\n";
    os << next << "LastPlanTime: " << this->GetLastPlanTime() << " ms\n";
    os << next << "LastReflectionTime: " << this->GetLastReflectionTime() << " ms\n";
    os << next << "LastSurfaceTime: " << this->GetLastSurfaceTime() << " ms\n";
    os << next << "TrianglesReflected: " << this->GetNumberOfTrianglesReflected() << "\n";
    os << next << "FragmentsReflected: " << this->GetNumberOfFragmentsReflected() << "\n";
  }
  os << indent << "Quality: " << this->GetQualityAsString() << "\n";
  os << indent << "TargetError: " << this->GetTargetError() << "\n";
  os << indent << "TimeBudget: " << this->GetTimeBudget() << "\n";
  os << indent << "QualityStep: " << this->GetQualityStep() << "\n";
  os << indent << "TextureScaleInUse: " << this->GetTextureScaleInUse() << "\n";
  os << indent << "Controller: " << this->Reflection->Ranks.GetText() << "\n";
  os << indent << "FarthestRank: " << this->GetFarthestRank() << "\n";
  os << indent << "RankRegion:";
  for (int i = 0; i < 6; ++i)
  {
    os << " " << this->GetRankRegion()[i];
  }
  os << "\n";
  os << indent << "RankWaitLimit: " << this->GetRankWaitLimit() << " s\n";
  os << indent << "ShowReflection: " << (this->ShowReflection ? "on" : "off") << "\n";
  os << indent << "NumberOfReflectionRenders: " << this->GetNumberOfReflectionRenders() << "\n";
  os << indent << "NumberOfOwnViewRenders: " << this->GetNumberOfOwnViewRenders() << "\n";
  os << indent << "Last own view: " << this->GetOwnViewDecisionAsString() << "\n";
  os << indent << "NumberOfSecondaryRenders: " << this->GetNumberOfSecondaryRenders() << "\n";
  os << indent << "Last plan: " << this->GetDecisionAsString() << "\n";
  const water_plan& plan = this->Reflection->GetPlan();
  if (this->GetDecision() == RENDERED || this->GetDecision() == REUSED)
  {
    const vtkIndent next = indent.GetNextIndent();
    os << next << "Texture: " << plan.texture_px[0] << " x " << plan.texture_px[1]
       << " pixels, drawn in " << plan.texture_rect_px[2] << " x " << plan.texture_rect_px[3]
       << " at (" << plan.texture_rect_px[0] << ", " << plan.texture_rect_px[1] << ")\n";
    os << next << "Seen from " << (plan.side == WATER_BELOW ? "below" : "above") << "\n";
    for (int fate = 0; fate < WATER_CULL_REASON_COUNT; ++fate)
    {
      os << next << "Props " << GetFateAsString(fate) << ": " << this->GetFateCount(fate) << "\n";
    }
  }
}
VTK_ABI_NAMESPACE_END
