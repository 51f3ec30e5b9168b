// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterCaustics.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkWaterBedFS.h"
#include "vtkWaterFramebuffers.h"
#include "vtkWaterGL.h"
#include "vtkWaterLightFS.h"
#include "vtkWaterLightVS.h"
#include "vtkWaterScopedPlainDraws.h"
#include "vtkWaterUniforms.h"
#include "water_caustics.h"

#include <initializer_list>
#include <new>

namespace
{
// What is drawn is added up, and points have the sizes that their vertices say, while an object of
// this class lives.
struct ScopedSum
{
  explicit ScopedSum(vtkOpenGLState* state)
    : HadSizes(glIsEnabled(GL_PROGRAM_POINT_SIZE))
  {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    glGetIntegerv(GL_BLEND_EQUATION_RGB, &this->Equations[0]);
    glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &this->Equations[1]);
    glBlendEquation(GL_FUNC_ADD);
    glEnable(GL_PROGRAM_POINT_SIZE);
  }
  ~ScopedSum()
  {
    glBlendEquationSeparate(
      static_cast<GLenum>(this->Equations[0]), static_cast<GLenum>(this->Equations[1]));
    if (!this->HadSizes)
    {
      glDisable(GL_PROGRAM_POINT_SIZE);
    }
  }
  ScopedSum(const ScopedSum&) = delete;
  ScopedSum& operator=(const ScopedSum&) = delete;

  GLboolean HadSizes;
  GLint Equations[2] = { 0, 0 };
};

// nullptr: the GPU has no memory for it, which VTK's textures do not say.
vtkSmartPointer<vtkTextureObject> MakeTexture(
  vtkOpenGLRenderWindow* window, const int size_px[2], int channels, int filter)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetMinificationFilter(filter);
  texture->SetMagnificationFilter(filter);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  GLint given = 0;
  if (texture->Allocate2D(static_cast<unsigned int>(size_px[0]),
        static_cast<unsigned int>(size_px[1]), channels, VTK_FLOAT))
  {
    texture->Activate();
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &given);
    texture->Deactivate();
  }
  return given == size_px[0] ? texture : nullptr;
}

// nullptr: it cannot be drawn into.
vtkSmartPointer<vtkOpenGLFramebufferObject> MakeFramebuffer(
  vtkOpenGLRenderWindow* window, std::initializer_list<vtkTextureObject*> targets)
{
  auto framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  framebuffer->SetContext(window);
  framebuffer->Bind();
  unsigned int count = 0;
  for (vtkTextureObject* target : targets)
  {
    framebuffer->AddColorAttachment(count++, target);
  }
  framebuffer->ActivateDrawBuffers(count);
  return vtkWaterFramebuffers::IsComplete() ? framebuffer : nullptr;
}

bool HasSize(vtkTextureObject* texture, const int size_px[2])
{
  return texture && static_cast<int>(texture->GetWidth()) == size_px[0] &&
    static_cast<int>(texture->GetHeight()) == size_px[1];
}

}

//------------------------------------------------------------------------------
vtkWaterCaustics::vtkWaterCaustics() = default;

//------------------------------------------------------------------------------
vtkWaterCaustics::~vtkWaterCaustics() = default;

//------------------------------------------------------------------------------
bool vtkWaterCaustics::Ensure(vtkOpenGLRenderWindow* window, const water_caustics& caustics)
{
  if (!HasSize(this->Photons[0], caustics.count))
  {
    for (auto& texture : this->Photons)
    {
      texture = MakeTexture(window, caustics.count, 4, vtkTextureObject::Nearest);
    }
    this->PhotonFramebuffer = this->Photons[0] && this->Photons[1]
      ? MakeFramebuffer(window, { this->Photons[0], this->Photons[1] })
      : nullptr;
  }
  if (!HasSize(this->Light, caustics.texture_px))
  {
    this->Light = MakeTexture(window, caustics.texture_px, 1, vtkTextureObject::Linear);
    if (this->Light && caustics.is_level)
    {
      this->Light->SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
    }
    this->LightFramebuffer = this->Light ? MakeFramebuffer(window, { this->Light }) : nullptr;
  }
  if (!HasSize(this->Beds[0], caustics.bed_px))
  {
    for (int i = 0; i < 2; ++i)
    {
      this->Beds[i] = MakeTexture(window, caustics.bed_px, 1, vtkTextureObject::Linear);
      this->BedFramebuffers[i] =
        this->Beds[i] ? MakeFramebuffer(window, { this->Beds[i] }) : nullptr;
    }
  }
  if (!this->Points)
  {
    this->Points = vtkSmartPointer<vtkOpenGLVertexArrayObject>::New();
  }
  return this->PhotonFramebuffer && this->LightFramebuffer && this->BedFramebuffers[0] &&
    this->BedFramebuffers[1];
}

//------------------------------------------------------------------------------
bool vtkWaterCaustics::DrawBed(
  vtkOpenGLRenderWindow* window, const water_caustics& caustics, const Picture& picture)
{
  if (caustics.is_level)
  {
    const GLfloat depth[4] = { static_cast<GLfloat>(caustics.depth), 0.0f, 0.0f, 0.0f };
    this->BedFramebuffers[1]->Bind();
    glClearBufferfv(GL_COLOR, 0, depth);
    return true;
  }
  vtkShaderProgram* program = this->BedQuad.Ready(window, vtkWaterBedFS);
  if (!program)
  {
    return false;
  }
  namespace uniforms = vtkWaterUniforms;
  const double block[2] = { 1.0 / caustics.bed_px[0], 1.0 / caustics.bed_px[1] };
  uniforms::Set2(program, "waterBedBlock", block);
  uniforms::Set(program, "waterCausticDepth", caustics.depth);
  uniforms::Set4(program, "waterHeightClip", picture.HeightClip);
  uniforms::Set4(program, "waterClipW", picture.ClipW);
  for (int step = 0; step < 4; ++step)
  {
    vtkTextureObject* source = step == 0 ? picture.Depth : this->Beds[(step + 1) % 2].Get();
    const bool wasActive = step == 0;
    if (!wasActive)
    {
      source->Activate();
    }
    uniforms::Set(program, "waterBedSource", source);
    uniforms::Set(program, "waterBedStep", step);
    this->BedFramebuffers[step % 2]->Bind();
    this->BedQuad.Draw();
    if (!wasActive)
    {
      source->Deactivate();
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterCaustics::DrawPhotons(
  vtkOpenGLRenderWindow* window, const water_caustics& caustics, const Parameters& setParameters)
{
  vtkShaderProgram* program = this->Quad.Ready(window, this->PhotonShader.c_str());
  if (!program)
  {
    return false;
  }
  this->GetBed()->Activate();
  setParameters(program);
  namespace uniforms = vtkWaterUniforms;
  uniforms::Set3(program, "waterSunDir", caustics.sun_dir); // an eye under water has it from below
  uniforms::Set(program, "waterEta", caustics.index);
  const double step[2] = { 1.0 / caustics.count[0], 1.0 / caustics.count[1] };
  uniforms::Set2(program, "waterPhotonStep", step);
  uniforms::SetMatrix3(program, "waterPlaceToLight", caustics.place_to_light);
  uniforms::Set(program, "waterBed", this->GetBed());
  uniforms::Set2(program, "waterPhotonSearch", caustics.search);
  uniforms::SetMatrix3(program, "waterGridToSource", caustics.grid_to_source);
  uniforms::SetMatrix3(program, "waterPlaceToClip", caustics.place_to_clip);
  uniforms::Set3(program, "waterRiseClip", caustics.rise_clip);
  uniforms::Set2(program, "waterCalmWay", caustics.calm_way);
  uniforms::Set3(program, "waterTurn", caustics.turn);
  uniforms::Set3(program, "waterSunSpread", caustics.sun_spread);
  this->PhotonFramebuffer->Bind();
  this->Quad.Draw();
  this->GetBed()->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterCaustics::DrawLight(vtkOpenGLRenderWindow* window, const water_caustics& caustics)
{
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(vtkWaterLightVS, vtkWaterLightFS, "");
  if (!program || !program->GetCompiled())
  {
    return false;
  }
  const double texels[2] = { static_cast<double>(caustics.texture_px[0]),
    static_cast<double>(caustics.texture_px[1]) };
  for (auto& texture : this->Photons)
  {
    texture->Activate();
  }
  vtkWaterUniforms::Set(program, "waterPhotonPlace", this->Photons[0]);
  vtkWaterUniforms::Set(program, "waterPhotonShape", this->Photons[1]);
  vtkWaterUniforms::Set2(program, "waterCausticTexels", texels);
  this->LightFramebuffer->Bind();
  static const GLfloat dark[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 0, dark);
  {
    const ScopedSum sum(window->GetState());
    this->Points->Bind();
    glDrawArrays(GL_POINTS, 0, caustics.count[0] * caustics.count[1]);
    this->Points->Release();
  }
  for (auto& texture : this->Photons)
  {
    texture->Deactivate();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterCaustics::AddLight(const water_caustics& caustics)
{
  const size_t count =
    static_cast<size_t>(caustics.count[0]) * static_cast<size_t>(caustics.count[1]);
  const size_t texels =
    static_cast<size_t>(caustics.texture_px[0]) * static_cast<size_t>(caustics.texture_px[1]);
  try
  {
    for (std::vector<float>& read : this->Read)
    {
      read.resize(4 * count);
    }
    this->Sum.assign(texels, 0.0f);
  }
  catch (const std::bad_alloc&)
  {
    return false;
  }
  GLint buffer = 0;
  glGetIntegerv(GL_READ_BUFFER, &buffer);
  for (unsigned int i = 0; i < 2; ++i)
  {
    glReadBuffer(GL_COLOR_ATTACHMENT0 + i);
    glReadPixels(
      0, 0, caustics.count[0], caustics.count[1], GL_RGBA, GL_FLOAT, this->Read[i].data());
  }
  glReadBuffer(static_cast<GLenum>(buffer));
  water_caustics_add(
    this->Read[0].data(), this->Read[1].data(), count, caustics.texture_px, this->Sum.data());
  this->Light->Activate();
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, caustics.texture_px[0], caustics.texture_px[1], GL_RED,
    GL_FLOAT, this->Sum.data());
  this->Light->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterCaustics::Draw(vtkOpenGLRenderWindow* window, const water_caustics& caustics,
  const Picture& picture, const std::string& photonShader, const Parameters& setParameters)
{
  const std::string source = "//VTK::System::Dec\n//VTK::Output::Dec\n" + photonShader;
  if (this->Window != window)
  {
    this->ReleaseGraphicsResources(nullptr);
    this->Window = window;
  }
  if (this->PhotonShader != source)
  {
    this->Quad.ReleaseGraphicsResources();
    this->PhotonShader = source;
    this->HasFailed = false;
  }
  if (this->HasFailed)
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglActiveTexture activeTexture(state);
  state->PushFramebufferBindings();
  {
    vtkWaterScopedPlainDraws plain(state);
    this->HasFailed = !this->Ensure(window, caustics);
    if (!this->HasFailed)
    {
      plain.SetSize(caustics.bed_px);
      this->HasFailed = !this->DrawBed(window, caustics, picture);
    }
    if (!this->HasFailed)
    {
      plain.SetSize(caustics.count);
      this->HasFailed = !this->DrawPhotons(window, caustics, setParameters);
    }
    if (!this->HasFailed)
    {
      plain.SetSize(caustics.texture_px);
      this->HasFailed =
        !(caustics.is_added ? this->AddLight(caustics) : this->DrawLight(window, caustics));
    }
  }
  state->PopFramebufferBindings();
  if (caustics.is_level && !this->HasFailed)
  {
    this->Light->Activate();
    glGenerateMipmap(GL_TEXTURE_2D);
    this->Light->Deactivate();
  }
  return !this->HasFailed;
}

//------------------------------------------------------------------------------
void vtkWaterCaustics::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto* framebuffer : { this->PhotonFramebuffer.Get(), this->LightFramebuffer.Get(),
         this->BedFramebuffers[0].Get(), this->BedFramebuffers[1].Get() })
  {
    if (framebuffer && window)
    {
      framebuffer->ReleaseGraphicsResources(window);
    }
  }
  for (auto* texture : { this->Photons[0].Get(), this->Photons[1].Get(), this->Light.Get(),
         this->Beds[0].Get(), this->Beds[1].Get() })
  {
    if (texture && window)
    {
      texture->ReleaseGraphicsResources(window);
    }
  }
  if (this->Points && window)
  {
    this->Points->ReleaseGraphicsResources();
  }
  // without a window the destructors free what is left, through VTK's resource callbacks
  this->PhotonFramebuffer = this->LightFramebuffer = nullptr;
  this->Photons[0] = this->Photons[1] = this->Light = nullptr;
  this->BedFramebuffers[0] = this->BedFramebuffers[1] = nullptr;
  this->Beds[0] = this->Beds[1] = nullptr;
  this->Points = nullptr;
  this->BedQuad.ReleaseGraphicsResources();
  this->Quad.ReleaseGraphicsResources();
  this->PhotonShader.clear();
  this->Window = nullptr;
  this->HasFailed = false;
}
