// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterShaderHook.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"
#include "vtkWaterBlocks.h"
#include "vtkWaterClipDistance.h"
#include "vtkWaterClusters.h"
#include "vtkWaterCompat.h"
#include "vtkWaterGL.h"
#include "vtkWaterMeshTraits.h"
#include "vtkWaterMirroredFS.h"
#include "vtkWaterMirroredVS.h"
#include "vtkWaterNormalsVS.h"
#include "vtkWaterPeelFS.h"
#include "vtkWaterPlainFS.h"
#include "vtkWaterPropRecords.h"
#include "vtkWaterShaderText.h"
#include "vtkWaterSource.h"
#include "vtkWaterSurfaceShader.h"
#include "vtkWaterUniforms.h"
#include "vtkWaterVolumeFS.h"
#include "water_mirror.h"
#include "water_types.h"

#include <algorithm>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkWaterShaderHook);

using namespace vtkWaterShaderText;

namespace
{
// Does the prop have no highlights? A change of its property makes the mapper ask again.
bool IsMatte(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  return actor && !actor->GetBackfaceProperty() && actor->GetProperty()->GetSpecular() <= 0.0;
}

// Calls the slots of a water's shader where VTK's code has what they need.
void CallSlots(std::string& vertexShader, std::string& fragmentShader, vtkAbstractMapper* mapper)
{
  if (Declares(vertexShader, "waterMeasureSlope") &&
    vertexShader.find(" normalMC;") == std::string::npos)
  {
    InsertBefore(vertexShader, "void waterMeasureSlope(", vtkWaterNormalsVS);
  }
  if (Declares(fragmentShader, "waterShade"))
  {
    if (vtkWaterMeshTraits::ShowsScalars(mapper))
    {
      // what the mapper's scalars show without light
      InsertBefore(fragmentShader, "//VTK::Light::Impl",
        "\n  waterTakeData(ambientColor + diffuseColor, opacity, opacityUniform);");
    }
    if (Declares(fragmentShader, "waterTakeMatter"))
    {
      InsertBefore(fragmentShader, "//VTK::Light::Impl", "\n  waterTakeMatter(waterSide > 0.0);");
    }
    InsertBefore(fragmentShader, "//VTK::Light::Impl", "\n  waterShade(gl_FragData[0]);");
    if (Declares(fragmentShader, "waterKeptData"))
    {
      InsertBefore(fragmentShader, "//VTK::Light::Impl", "\n  gl_FragData[1] = waterKeptData();");
    }
  }
}
}

//------------------------------------------------------------------------------
vtkWaterShaderHook::vtkWaterShaderHook()
{
  this->SetActiveDrawBuffers(1); // volume mappers ask the last pass of the list
}

//------------------------------------------------------------------------------
vtkWaterShaderHook::~vtkWaterShaderHook() = default;

//------------------------------------------------------------------------------
void vtkWaterShaderHook::BeginMirroredView(const View& view)
{
  this->Mirrored = view;
  this->IsPeeling = false;
  this->SetUp.clear();
  this->LastSetUp = nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterShaderHook::EndMirroredView()
{
  this->Mirrored = View();
  this->IsPeeling = false;
  this->DepthWriter = nullptr;
  this->SetUp.clear();
  this->LastSetUp = nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterShaderHook::ReplaceForWater(vtkWaterSource& water, std::string& vertexShader,
  const std::string& geometryShader, std::string& fragmentShader) const
{
  if (this->Surface && this->Surface->GetIsRefused())
  {
    InsertDeclarations(fragmentShader, vtkWaterPlainFS);
    return;
  }
  water_feature_set features =
    this->Surface ? this->Surface->GetFeatures() : water.Take(nullptr)->Features;
  constexpr water_feature_set ofVertices = WATER_FEATURE_DISPLACED | WATER_FEATURE_SEA_MOVES |
    WATER_FEATURE_MESH | WATER_FEATURE_SLOPED | WATER_FEATURE_FLOW | WATER_FEATURE_MATTER |
    WATER_FEATURE_FOAM_DATA | WATER_FEATURE_BUFFERED | WATER_FEATURE_SHORE;
  // a geometry shader would have to pass the place at rest, or the height, on
  const bool canAskVertices =
    geometryShader.empty() && vertexShader.find("//VTK::CustomEnd::Impl") != std::string::npos;
  if (!canAskVertices)
  {
    features &= ~ofVertices;
  }
  if (InsertDeclarations(vertexShader, vtkWaterSurfaceShader::GetVertexShader(features)))
  {
    if (features & WATER_FEATURE_DISPLACED)
    {
      InsertBefore(vertexShader, "//VTK::CustomEnd::Impl", "  waterDisplace(gl_Position);");
    }
    else if (features & WATER_FEATURE_MESH)
    {
      InsertBefore(vertexShader, "//VTK::CustomEnd::Impl", "  waterMeasure(vertexMC);");
    }
    if (features & WATER_FEATURE_SLOPED)
    {
      InsertBefore(
        vertexShader, "//VTK::CustomEnd::Impl", "  waterMeasureSlope(vertexMC, normalMC);");
    }
    if (features & WATER_FEATURE_FLOW)
    {
      InsertBefore(vertexShader, "//VTK::CustomEnd::Impl", "  waterMeasureFlow();");
    }
    if (features & WATER_FEATURE_MATTER)
    {
      InsertBefore(vertexShader, "//VTK::CustomEnd::Impl", "  waterMeasureMatter();");
    }
    if (features & WATER_FEATURE_FOAM_DATA)
    {
      InsertBefore(vertexShader, "//VTK::CustomEnd::Impl", "  waterMeasureFoam();");
    }
    if (features & WATER_FEATURE_SHORE)
    {
      InsertBefore(vertexShader, "//VTK::CustomEnd::Impl", "  waterCutShore();");
    }
    InsertBefore(vertexShader, "//VTK::CustomEnd::Impl", "  waterKeepDepth(gl_Position);");
  }
  InsertDeclarations(fragmentShader, vtkWaterSurfaceShader::GetShader(features));
}

//------------------------------------------------------------------------------
bool vtkWaterShaderHook::PreReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  this->Failures.Judge();
  if (vtkWaterSource* water = vtkWaterSource::Of(prop))
  {
    this->ReplaceForWater(*water, vertexShader, geometryShader, fragmentShader);
    if (!this->Surface || !this->Surface->GetIsSecondary())
    {
      return true;
    }
  }
  if (this->Failures.Has(prop))
  {
    return true;
  }
  const int refusals = this->Failures.GetCount(prop);
  const std::string attempt = refusals > 0 ? "// after refusal " + std::to_string(refusals) : "";
  if (!InsertDeclarations(fragmentShader, vtkWaterMirroredFS + attempt))
  {
    return true; // not a shader that can be helped
  }
  // Opaque geometry is cut by a clip distance. It needs a vertex shader that ends the chain (a
  // geometry shader would have to pass the distance on), and must not be on for the full-screen
  // quads that blend translucent geometry: those two discard.
  const bool canClipVertices = this->CanClip && geometryShader.empty() &&
    vertexShader.find("//VTK::CustomEnd::Impl") != std::string::npos &&
    !prop->HasTranslucentPolygonalGeometry();
  if (canClipVertices && InsertDeclarations(vertexShader, vtkWaterMirroredVS))
  {
    InsertBefore(vertexShader, "//VTK::CustomEnd::Impl", "  waterClipVertex(gl_Position);");
  }
  else
  {
    InsertBefore(fragmentShader, "//VTK::Clip::Impl", "  waterClip();");
  }
  if (this->PeelTime.GetMTime() > 0 && InsertDeclarations(fragmentShader, vtkWaterPeelFS))
  {
    InsertBefore(fragmentShader, "//VTK::Clip::Impl", "  waterPeelOff();");
  }
  // the tags of VTK's ray caster; no other shader has them
  InsertAfter(fragmentShader, "//VTK::Clipping::Dec", vtkWaterVolumeFS);
  InsertAfter(fragmentShader, "//VTK::Clipping::Init", "  waterClipRay();");
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterShaderHook::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  vtkWaterShaderFailures::Prepare(mapper);
  if (prop->IsA("vtkWaterActor"))
  {
    CallSlots(vertexShader, fragmentShader, mapper);
    if (this->Surface)
    {
      this->SetIsAwaited(true);
      this->Surface->ReleaseShader();
    }
    return true;
  }
  vtkOpenGLRenderWindow* window = this->Window;
  if (window)
  {
    // a mapper whose shader is refused draws with the program that is in use, whosever that is
    window->GetShaderCache()->ReleaseCurrentShader();
  }
  if (!Declares(fragmentShader, "waterHeadlight"))
  {
    return true;
  }
  MoveHeadlight(fragmentShader);
  if (Declares(fragmentShader, "waterHeadlightPlace"))
  {
    MoveHeadlightOfVolumes(fragmentShader);
  }
  // VTK's code for a single headlight takes the light for the view; a mapper that has no such line
  // (unlit, other lights) needs nothing
  vtkShaderProgram::Substitute(fragmentShader, "float sf = pow(df, specularPower);",
    IsMatte(prop)
      ? "df = waterHeadlightDiffuse(normalVCVSOutput); float sf = 0.0;"
      : "float sf = pow(waterHeadlight(normalVCVSOutput, vertexVC.xyz, df), specularPower);",
    false);
  if (window)
  {
    this->Failures.Await(
      prop, mapper, window, this->IsInMirroredView(), vertexShader, geometryShader, fragmentShader);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterShaderHook::BeginSurface(vtkWaterSurfaceShader* surface, vtkOpenGLState* probed)
{
  this->Surface = surface;
  this->Probed = probed;
  this->SetIsAwaited(false);
}

//------------------------------------------------------------------------------
bool vtkWaterShaderHook::EndSurface()
{
  const bool isRefused = this->IsAwaited;
  this->SetIsAwaited(false);
  this->Surface->EndDraw();
  this->Surface = nullptr;
  return !isRefused;
}

//------------------------------------------------------------------------------
void vtkWaterShaderHook::SetIsAwaited(bool isAwaited)
{
  if (this->IsAwaited != isAwaited)
  {
    // a mapper whose program was refused draws all the same, with none: some drivers show something
    isAwaited ? glEnable(GL_RASTERIZER_DISCARD) : glDisable(GL_RASTERIZER_DISCARD);
    this->IsAwaited = isAwaited;
  }
}

//------------------------------------------------------------------------------
bool vtkWaterShaderHook::SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper,
  vtkProp* prop, vtkOpenGLVertexArrayObject* vertices)
{
  if (vtkWaterSource::Of(prop))
  {
    // a mapper whose new program was refused still has its last one, which is not in use
    if (this->Surface && program->isBound())
    {
      this->SetIsAwaited(false);
      this->Surface->SetParameters(program, mapper, vertices);
      if (this->Surface->GetIsSecondary())
      {
        this->SetUp.erase(program); // two waters may share it, and one be cut already
        this->LastSetUp = nullptr;
        this->SetMirroredParameters(program, mapper, prop); // which cut it
      }
      if (this->Probed)
      {
        this->Probed->vtkglDepthMask(GL_FALSE); // the actor has just set it, and resets it
      }
    }
  }
  else if (program->isBound())
  {
    if (this->Failures.AreAwaited()) // asked of every prop, and rarely so
    {
      this->Failures.Arrive(prop, mapper);
    }
    this->SetMirroredParameters(program, mapper, prop);
    if (this->Records && !this->IsInMirroredView())
    {
      this->Records->Ask(prop);
    }
    if (this->Mirrored.Clusters)
    {
      this->Mirrored.Clusters->Give(*this->Mirrored.Plan, program, mapper, prop);
      this->Mirrored.Blocks->Hide(*this->Mirrored.Plan, mapper, prop);
    }
  }
  if (this->DepthWriter)
  {
    this->DepthWriter->vtkglDepthMask(GL_TRUE); // the actor has just set it, and resets it
  }
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkWaterShaderHook::GetShaderStageMTime()
{
  return std::max(this->Failures.GetTime(), this->PeelTime.GetMTime());
}

//------------------------------------------------------------------------------
void vtkWaterShaderHook::WantPeel()
{
  if (this->PeelTime.GetMTime() == 0)
  {
    this->PeelTime.Modified();
  }
}

//------------------------------------------------------------------------------
int vtkWaterShaderHook::GetPeelUnit(vtkOpenGLRenderWindow* window)
{
  return window->GetTextureUnitManager()->GetNumberOfTextureUnits() - 1;
}

//------------------------------------------------------------------------------
void vtkWaterShaderHook::SetPeeling(bool isPeeling)
{
  this->IsPeeling = isPeeling;
  this->SetUp.clear(); // they know the other draw
  this->LastSetUp = nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterShaderHook::SetPeelParameters(vtkShaderProgram* program)
{
  double peel[3] = { 0.0, 0.0, 0.0 };
  if (this->IsPeeling && this->Mirrored.Plan) // none: in a frame in the middle of it
  {
    peel[0] = this->Mirrored.Plan->reflection_tolerance[1];
    peel[1] = this->Mirrored.Plan->reflection_z_infinity;
    peel[2] = 1.0;
  }
  vtkWaterUniforms::Set3(program, "waterPeel", peel);
  vtkWaterUniforms::Set(program, "waterPeelDepth", GetPeelUnit(this->Window));
}

//------------------------------------------------------------------------------
void vtkWaterShaderHook::SetClipDistance(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, bool isCut)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  const bool mayBeCut =
    this->MayBeCut || !actor || vtkWaterMeshTraits::HasOwnShaders(mapper, actor);
  // off for a part of an assembly whose program has none: what it would cut is undefined
  this->Mirrored.ClipDistance->Set(isCut && mayBeCut &&
    !prop->IsRenderingTranslucentPolygonalGeometry() &&
    program->IsUniformUsed("waterClipPosition"));
}

//------------------------------------------------------------------------------
void vtkWaterShaderHook::SetMirroredParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop)
{
  static const double keepAll[4] = { 0.0, 0.0, 0.0, 1.0 };
  const water_plan* plan = this->Mirrored.Plan;
  // an endless water is laid where it is not cut; its depths do not tell where it is
  const bool isCut = plan && !(this->Surface && this->Surface->GetIsEndless());
  if (plan)
  {
    this->SetClipDistance(program, mapper, prop, isCut);
  }
  // props share programs, and a program keeps its uniforms
  if (program == std::exchange(this->LastSetUp, program) || !this->SetUp.insert(program).second)
  {
    return;
  }
  vtkWaterUniforms::Set4(program, "waterClipWindow", isCut ? plan->clip_plane_window : keepAll);
  double position[4] = { 0.0, 0.0, 0.0, 1.0 };
  double constant = 0.0;
  if (isCut)
  {
    water_mirror_clip_position(
      plan->mirrored.view_to_clip, plan->clip_plane_clip, position, &constant);
  }
  vtkWaterUniforms::Set4(program, "waterClipPosition", position);
  vtkWaterUniforms::Set(program, "waterClipConstant", constant);
  vtkWaterUniforms::Set4(program, "waterClipView", isCut ? plan->clip_plane_view : keepAll);
  double headlight[4] = { 0.0, 0.0, -1.0, 0.0 };
  double place[4] = { 0.0, 0.0, 0.0, 0.0 };
  if (plan)
  {
    std::copy(plan->headlight_dir, plan->headlight_dir + 3, headlight);
    std::copy(plan->headlight_position, plan->headlight_position + 3, place);
    headlight[3] = place[3] = 1.0;
  }
  vtkWaterUniforms::Set4(program, "waterHeadlightVC", headlight);
  vtkWaterUniforms::Set4(program, "waterHeadlightPlaceVC", place);
  if (this->PeelTime.GetMTime() > 0 && this->Window)
  {
    this->SetPeelParameters(program);
  }
  // VTK sets the lights of a program, which are in view space, once per camera or light change by
  // their modification times; main and mirrored camera share the program.
  program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
}

//------------------------------------------------------------------------------
void vtkWaterShaderHook::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "In a mirrored view: " << (this->IsInMirroredView() ? "yes" : "no") << "\n";
}

VTK_ABI_NAMESPACE_END
