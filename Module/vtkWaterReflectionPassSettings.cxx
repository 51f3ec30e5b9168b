// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterReflectionPassSettings.cxx: the part of vtkWaterReflectionPass that is set and asked for.
#include "vtkMath.h"
#include "vtkTextureObject.h"
#include "vtkWaterCompat.h"
#include "vtkWaterReflectionPass.h"
#include "vtkWaterReflectionPassInternals.h"
#include "water_plan.h"

#include <limits>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetTextureScale(double scale)
{
  vtkWaterSetInRange(TextureScale, scale, 1.0 / 64.0, 16.0);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetMultiSamples(int samples)
{
  vtkWaterSetInRange(MultiSamples, samples, -1, 32);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetColorPrecision(int precision)
{
  vtkWaterSetInRange(ColorPrecision, precision, AUTOMATIC, HALF_FLOAT);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetClipMargin(double margin)
{
  vtkWaterSetInRange(ClipMargin, margin, 0.0, std::numeric_limits<double>::max());
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetSkips(int skips)
{
  vtkWaterSetInRange(Skips, skips, SKIP_NONE, SKIP_ALL);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetMinimumPropSize(double pixels)
{
  vtkWaterSetInRange(MinimumPropSize, pixels, 0.0, std::numeric_limits<double>::max());
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetReflectanceError(double share)
{
  vtkWaterSetInRange(ReflectanceError, share, 0.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetGuardBand(double band)
{
  if (!(band == 0.0 || (band >= 1.0 && band <= 2.0)))
  {
    vtkErrorMacro("GuardBand is " << band
                                  << "; it must lie in [1, 2], or be 0 (by the waves' slope). "
                                  << "It stays " << this->GuardBand << ".");
  }
  else if (this->GuardBand != band)
  {
    this->GuardBand = band;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetInstrumentation(bool instrumentation)
{
  // no modification: it changes nothing that is rendered
  this->Instrumentation = instrumentation;
  if (!instrumentation)
  {
    this->LastGatherTime = this->LastPlanTime = vtkMath::Nan();
  }
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterReflectionPass::GetReflectionTexture()
{
  Internals::View* view = this->Internal->GetPlannedView();
  return view ? view->Mirror.GetColor() : nullptr;
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterReflectionPass::GetReflectionDepthTexture()
{
  Internals::View* view = this->Internal->GetPlannedView();
  return view ? view->Mirror.GetDepth() : nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetQuality(int quality)
{
  vtkWaterSetInRange(Quality, quality, FIXED, UPDATE_RATE);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetTargetError(double pixels)
{
  vtkWaterSetInRange(TargetError, pixels, 1e-3, 1e3);
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::SetTimeBudget(double milliseconds)
{
  vtkWaterSetInRange(TimeBudget, milliseconds, 1e-3, 1e6);
}

//------------------------------------------------------------------------------
int vtkWaterReflectionPass::GetFateCount(int fate) const
{
  return fate >= 0 && fate < WATER_CULL_REASON_COUNT ? this->Internal->ReasonCounts[fate] : 0;
}

//------------------------------------------------------------------------------
const char* vtkWaterReflectionPass::GetFateAsString(int fate)
{
  return water_cull_reason_text(static_cast<water_cull_reason>(fate));
}

//------------------------------------------------------------------------------
int vtkWaterReflectionPass::GetDecision() const
{
  return this->Internal->Plan.decision;
}

//------------------------------------------------------------------------------
const char* vtkWaterReflectionPass::GetDecisionAsString() const
{
  return water_decision_text(this->Internal->Plan.decision);
}

//------------------------------------------------------------------------------
double vtkWaterReflectionPass::GetLastReflectionTime()
{
  return !this->Instrumentation
    ? vtkMath::Nan()
    : this->Internal->Ask(vtkMath::Nan(), [](vtkWaterGpuQueries& instruments) {
        return instruments.GetTime(vtkWaterGpuQueries::REFLECTION);
      });
}

//------------------------------------------------------------------------------
double vtkWaterReflectionPass::GetLastSurfaceTime()
{
  return !this->Instrumentation
    ? vtkMath::Nan()
    : this->Internal->Ask(vtkMath::Nan(), [](vtkWaterGpuQueries& instruments) {
        return instruments.GetTime(vtkWaterGpuQueries::SURFACE);
      });
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterReflectionPass::GetNumberOfTrianglesReflected()
{
  return !this->Instrumentation
    ? vtkIdType(-1)
    : this->Internal->Ask(
        vtkIdType(-1), [](vtkWaterGpuQueries& instruments) { return instruments.GetTriangles(); });
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterReflectionPass::GetNumberOfFragmentsReflected()
{
  return !this->Instrumentation
    ? vtkIdType(-1)
    : this->Internal->Ask(
        vtkIdType(-1), [](vtkWaterGpuQueries& instruments) { return instruments.GetFragments(); });
}

//------------------------------------------------------------------------------
bool vtkWaterReflectionPass::DrawsAs(vtkWaterReflectionPass* other) const
{
  return this->TextureScale == other->TextureScale && this->MultiSamples == other->MultiSamples &&
    this->ColorPrecision == other->ColorPrecision && this->ClipMargin == other->ClipMargin &&
    this->GuardBand == other->GuardBand && this->Skips == other->Skips &&
    this->MinimumPropSize == other->MinimumPropSize &&
    this->ReflectanceError == other->ReflectanceError && this->Quality == other->Quality &&
    this->TargetError == other->TargetError && this->TimeBudget == other->TimeBudget;
}

//------------------------------------------------------------------------------
void vtkWaterReflectionPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DelegatePass: ";
  if (!this->DelegatePass)
  {
    os << "(none)\n";
  }
  else if (this->Internal->IsVisiting)
  {
    os << "leads back to this pass\n";
  }
  else
  {
    os << "\n";
    this->Internal->IsVisiting = true;
    this->DelegatePass->PrintSelf(os, indent.GetNextIndent());
    this->Internal->IsVisiting = false;
  }
  os << indent << "TextureScale: " << this->TextureScale << "\n";
  os << indent << "MultiSamples: " << this->MultiSamples << "\n";
  os << indent << "ColorPrecision: " << this->ColorPrecision << "\n";
  os << indent << "ClipMargin: " << this->ClipMargin << "\n";
  os << indent << "GuardBand: " << this->GuardBand << "\n";
  os << indent << "Skips: " << this->Skips << "\n";
  os << indent << "MinimumPropSize: " << this->MinimumPropSize << "\n";
  os << indent << "ReflectanceError: " << this->ReflectanceError << "\n";
  os << indent << "Instrumentation: " << (this->Instrumentation ? "on" : "off") << "\n";
  if (this->Instrumentation)
  {
    const vtkIndent next = indent.GetNextIndent();
    os << next << "LastGatherTime: " << this->LastGatherTime << " ms\n";
    os << next << "LastPlanTime: " << this->LastPlanTime << " ms\n";
    os << next << "LastReflectionTime: " << this->GetLastReflectionTime() << " ms\n";
    os << next << "LastSurfaceTime: " << this->GetLastSurfaceTime() << " ms\n";
    os << next << "TrianglesReflected: " << this->GetNumberOfTrianglesReflected() << "\n";
    os << next << "FragmentsReflected: " << this->GetNumberOfFragmentsReflected() << "\n";
  }
  os << indent << "Quality: " << this->Quality << "\n";
  os << indent << "TargetError: " << this->TargetError << "\n";
  os << indent << "TimeBudget: " << this->TimeBudget << "\n";
  os << indent << "QualityStep: " << this->QualityStep << "\n";
  os << indent << "TextureScaleInUse: " << this->TextureScaleInUse << "\n";
  os << indent << "ShowReflection: " << (this->ShowReflection ? "on" : "off") << "\n";
  os << indent << "NumberOfReflectionRenders: " << this->NumberOfReflectionRenders << "\n";
  os << indent << "Last plan: " << this->GetDecisionAsString() << "\n";
  const water_plan& plan = this->Internal->Plan;
  if (water_plan_has_reflection(&plan))
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
