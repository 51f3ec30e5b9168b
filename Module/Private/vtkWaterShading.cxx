// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterShading.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkWaterActor.h"
#include "vtkWaterCompat.h"
#include "vtkWaterGL.h"
#include "vtkWaterLookupFS.h"
#include "vtkWaterMirroredFS.h"
#include "vtkWaterMirroredVS.h"
#include "vtkWaterOffsetFS.h"
#include "vtkWaterOptics.h"
#include "vtkWaterProperty.h"
#include "vtkWaterSurfaceFS.h"
#include "vtkWaterVolumeFS.h"
#include "vtkWaterWavesFS.h"
#include "vtkWaterWavySurfaceFS.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkWaterShading);

namespace
{
constexpr double kFarUp = 1e30; // for a float
constexpr int kRestSteps = 3;   // Newton's steps; the error is under a pixel's slope after two

// Puts text before a tag and keeps the tag for whoever comes next.
void InsertBefore(std::string& source, const std::string& tag, const std::string& text)
{
  vtkShaderProgram::Substitute(source, tag, text + "\n" + tag, false);
}

// Puts declarations before the tag that all of VTK's shaders have, or, where the user's own
// replacement took that, before main. Returns whether they are in.
bool InsertDeclarations(std::string& source, const std::string& text)
{
  const std::string tag = "//VTK::Clip::Dec";
  const std::string place = source.find(tag) != std::string::npos ? tag : "void main(";
  return vtkShaderProgram::Substitute(source, place, text + "\n" + place, false);
}

bool Declares(const std::string& source, const std::string& function)
{
  return source.find(function + "(") != std::string::npos;
}

void InsertAfter(std::string& source, const std::string& tag, const std::string& text)
{
  vtkShaderProgram::Substitute(source, tag, tag + "\n" + text, false);
}

// Does the prop have no highlights? A change of its property makes the mapper ask again.
bool IsMatte(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  return actor && !actor->GetBackfaceProperty() && actor->GetProperty()->GetSpecular() <= 0.0;
}

void SetUniform2(vtkShaderProgram* program, const char* name, const double value[2])
{
  if (program->IsUniformUsed(name))
  {
    const float single[2] = { static_cast<float>(value[0]), static_cast<float>(value[1]) };
    program->SetUniform2f(name, single);
  }
}

void SetUniform3(vtkShaderProgram* program, const char* name, const double value[3])
{
  if (program->IsUniformUsed(name))
  {
    const float single[3] = { static_cast<float>(value[0]), static_cast<float>(value[1]),
      static_cast<float>(value[2]) };
    program->SetUniform3f(name, single);
  }
}

void SetUniform4(
  vtkShaderProgram* program, const char* name, const double value[4], bool isUsed = true)
{
  if (program->IsUniformUsed(name))
  {
    float single[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
    if (isUsed)
    {
      std::transform(
        value, value + 4, single, [](double component) { return static_cast<float>(component); });
    }
    program->SetUniform4f(name, single);
  }
}

// A 4 x 3 matrix given by rows, as the first columns of a 4 x 4 one.
void SetUniform4x3(vtkShaderProgram* program, const char* name, const double rows[12])
{
  if (program->IsUniformUsed(name))
  {
    float columns[16] = {};
    for (int row = 0; row < 4; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        columns[4 * column + row] = static_cast<float>(rows[3 * row + column]);
      }
    }
    program->SetUniformMatrix4x4(name, columns);
  }
}

void SetUniform(vtkShaderProgram* program, const char* name, int value)
{
  if (program->IsUniformUsed(name))
  {
    program->SetUniformi(name, value);
  }
}

void SetUniform(vtkShaderProgram* program, const char* name, double value)
{
  if (program->IsUniformUsed(name))
  {
    program->SetUniformf(name, static_cast<float>(value));
  }
}
}

//------------------------------------------------------------------------------
void vtkWaterSetUniformMatrix3(vtkShaderProgram* program, const char* name, const double rows[9])
{
  if (program->IsUniformUsed(name))
  {
    float columns[9]; // GL wants columns: the one place that transposes
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        columns[3 * column + row] = static_cast<float>(rows[3 * row + column]);
      }
    }
    program->SetUniformMatrix3x3(name, columns);
  }
}

//------------------------------------------------------------------------------
vtkWaterShading::vtkWaterShading()
  : Keys(this)
{
  this->SetActiveDrawBuffers(1); // volume mappers ask the last pass of the list
}

//------------------------------------------------------------------------------
vtkWaterShading::~vtkWaterShading() = default;

//------------------------------------------------------------------------------
vtkWaterShading* vtkWaterShading::GetOfThread()
{
  static thread_local vtkNew<vtkWaterShading> shading;
  return shading;
}

//------------------------------------------------------------------------------
vtkWaterShading::Variants vtkWaterShading::GetVariant(vtkWaterProperty* property)
{
  if (property->GetNumberOfWaves() == 0)
  {
    return CALM;
  }
  return property->GetLookup() == vtkWaterProperty::RAY_TRACED ? RAY_TRACED : OFFSET;
}

//------------------------------------------------------------------------------
void vtkWaterShading::BeginMirroredView(const water_plan& plan)
{
  this->MirroredView = &plan;
  this->SetUp.clear();
}

//------------------------------------------------------------------------------
void vtkWaterShading::EndMirroredView()
{
  this->MirroredView = nullptr;
  this->SetUp.clear();
}

//------------------------------------------------------------------------------
bool vtkWaterShading::PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
  std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  if (prop->IsA("vtkWaterActor"))
  {
    std::string surface = vtkWaterSurfaceFS;
    const Variants variant = GetVariant(static_cast<vtkWaterActor*>(prop)->GetWaterProperty());
    if (variant != CALM)
    {
      surface = std::string(vtkWaterWavesFS) + "\n" +
        (variant == RAY_TRACED ? vtkWaterLookupFS : vtkWaterOffsetFS) + "\n" +
        vtkWaterWavySurfaceFS;
    }
    InsertDeclarations(fragmentShader, std::string(vtkWaterOptics) + "\n" + surface);
    return true;
  }
  if (!InsertDeclarations(fragmentShader, vtkWaterMirroredFS))
  {
    return true; // not a shader that can be helped
  }
  // Opaque geometry is cut by a clip distance. It needs a vertex shader that ends the chain (a
  // geometry shader would have to pass the distance on), and must not be on for the full-screen
  // quads that blend translucent geometry: those two discard.
  const bool canClipVertices = geometryShader.empty() &&
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
  // the tags of VTK's ray caster; no other shader has them
  InsertAfter(fragmentShader, "//VTK::Clipping::Dec", vtkWaterVolumeFS);
  InsertAfter(fragmentShader, "//VTK::Clipping::Init", "  waterClipRay();");
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterShading::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  if (prop->IsA("vtkWaterActor"))
  {
    if (Declares(fragmentShader, "waterShade"))
    {
      InsertBefore(fragmentShader, "//VTK::Light::Impl", "\n  waterShade(gl_FragData[0]);");
    }
    return true;
  }
  if (!Declares(fragmentShader, "waterHeadlight"))
  {
    return true;
  }
  // VTK's code for a single headlight takes the light for the view; a mapper that has no such line
  // (unlit, other lights) needs nothing
  vtkShaderProgram::Substitute(fragmentShader, "float sf = pow(df, specularPower);",
    IsMatte(prop)
      ? "df = waterHeadlightDiffuse(normalVCVSOutput); float sf = 0.0;"
      : "float sf = pow(waterHeadlight(normalVCVSOutput, vertexVC.xyz, df), specularPower);",
    false);
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterShading::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  if (prop->IsA("vtkWaterActor"))
  {
    this->SetSurfaceParameters(program);
  }
  else
  {
    this->SetMirroredParameters(program, prop);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterShading::SetMirroredParameters(vtkShaderProgram* program, vtkProp* prop)
{
  static const double keepAll[4] = { 0.0, 0.0, 0.0, 1.0 };
  const water_plan* plan = this->MirroredView;
  if (plan && !prop->IsRenderingTranslucentPolygonalGeometry() &&
    program->IsUniformUsed("waterClipPosition"))
  {
    glEnable(GL_CLIP_DISTANCE0); // vtkWaterMirror turns it off again
  }
  // props share programs, and a program keeps its uniforms
  if (!this->SetUp.insert(program).second)
  {
    return;
  }
  SetUniform4(program, "waterClipWindow", plan ? plan->clip_plane_window : keepAll);
  SetUniform4(program, "waterClipPosition", plan ? plan->clip_plane_clip : keepAll);
  SetUniform4(program, "waterClipView", plan ? plan->clip_plane_view : keepAll);
  double headlight[4] = { 0.0, 0.0, -1.0, 0.0 };
  if (plan)
  {
    std::copy(plan->headlight_dir, plan->headlight_dir + 3, headlight);
    headlight[3] = 1.0;
  }
  SetUniform4(program, "waterHeadlightVC", headlight);
  // VTK sets the lights of a program, which are in view space, once per camera or light change by
  // their modification times; main and mirrored camera share the program.
  program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
}

//------------------------------------------------------------------------------
void vtkWaterShading::SetSurfaceParameters(vtkShaderProgram* program)
{
  if (!this->Surface)
  {
    return; // drawn by somebody else than vtkWaterActor::Render: nothing to say
  }
  const vtkWaterSurface& surface = *this->Surface;
  if (program->IsUniformUsed("waterReflection"))
  {
    program->SetUniformi("waterReflection", surface.Reflection->GetTextureUnit());
  }
  if (program->IsUniformUsed("waterIsReflecting"))
  {
    program->SetUniformi("waterIsReflecting", surface.Plan ? 1 : 0);
  }
  SetUniform3(program, "waterDeepColor", surface.Property->GetDeepColor());
  SetUniform(program, "waterOpacity", surface.Property->GetOpacity());
  if (surface.Plan)
  {
    int viewport[4];
    surface.Reflection->GetContext()->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
    const double inverse[4] = { static_cast<double>(viewport[0]), static_cast<double>(viewport[1]),
      1.0 / viewport[2], 1.0 / viewport[3] };
    SetUniform4(program, "waterViewport", inverse);
    SetUniform4(program, "waterNormalClip", surface.Plan->normal_clip);
    SetUniform4(program, "waterPlaneClip", surface.Plan->plane_clip, !surface.IsFlat);
    vtkWaterSetUniformMatrix3(program, "waterNdcToRay", surface.Plan->ndc_to_ray);
    SetUniform(program, "waterEta", surface.Plan->eta);
    SetUniform(program, "waterReflectance", surface.Plan->reflectance);
    if (surface.Waves)
    {
      this->SetWaveParameters(program);
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterShading::SetWaveParameters(vtkShaderProgram* program)
{
  const vtkWaterSurface& surface = *this->Surface;
  const water_plan& plan = *surface.Plan;
  vtkWaterProperty* property = surface.Property;
  SetUniform(program, "waterWaves", surface.Waves->GetTextureUnit());
  SetUniform(program, "waterWaveCount", surface.WaveCount);
  SetUniform(program, "waterRestSteps", surface.IsSteep ? kRestSteps : 0);
  vtkWaterSetUniformMatrix3(program, "waterNdcToPlane", plan.ndc_to_plane);
  SetUniform(program, "waterSide", plan.side == WATER_BELOW ? -1.0 : 1.0);
  SetUniform(program, "waterReflectionDepth", surface.ReflectionDepth->GetTextureUnit());
  SetUniform4x3(program, "waterDirToMap", plan.dir_to_map);
  SetUniform4x3(program, "waterDirToEye", plan.dir_to_eye);
  SetUniform(program, "waterDepthScale", plan.depth_scale);
  SetUniform(program, "waterMapTop", std::min(plan.map_top, kFarUp));
  SetUniform(program, "waterMapZInfinity", plan.map_z_infinity);
  SetUniform2(program, "waterMapTolerance", plan.map_tolerance);
  SetUniform2(program, "waterMapScale", plan.map_scale);
  SetUniform(program, "waterSteps", property->GetRayTraceSteps());
  SetUniform(program, "waterProbes", property->GetRayTraceProbes());
  SetUniform(program, "waterLookup", property->GetLookup());
  SetUniform(program, "waterOffsetScale", property->GetOffsetScale());
  SetUniform(program, "waterOutput", property->GetOutput());
  vtkRenderer* renderer = surface.Renderer;
  const bool hasGradient = renderer->GetGradientBackground() && !renderer->GetTexturedBackground();
  const double* bottom = renderer->GetBackground();
  const double* top = hasGradient ? renderer->GetBackground2() : bottom;
  const double bottomKnown[4] = { bottom[0], bottom[1], bottom[2], 1.0 };
  const double topKnown[4] = { top[0], top[1], top[2], 1.0 };
  SetUniform4(program, "waterSkyBottom", bottomKnown);
  SetUniform4(program, "waterSkyTop", topKnown);
}

//------------------------------------------------------------------------------
void vtkWaterShading::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "In a mirrored view: " << (this->MirroredView ? "yes" : "no") << "\n";
}

VTK_ABI_NAMESPACE_END
