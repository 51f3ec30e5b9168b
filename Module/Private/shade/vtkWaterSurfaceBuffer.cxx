// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSurfaceBuffer.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkWaterBoundPicture.h"
#include "vtkWaterBufferOneFS.h"
#include "vtkWaterBufferPutFS.h"
#include "vtkWaterBufferSampleFS.h"
#include "vtkWaterBufferSortFS.h"
#include "vtkWaterFramebuffers.h"
#include "vtkWaterGL.h"
#include "vtkWaterScopedPlainDraws.h"
#include "vtkWaterScopedSamples.h"
#include "vtkWaterUniforms.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace
{
constexpr float kNothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };

// Draws into colours of the framebuffer that is bound. Not through VTK's state, which looks at the
// first one alone.
void DrawInto(unsigned int first, unsigned int count)
{
  std::vector<GLenum> buffers(count);
  std::iota(buffers.begin(), buffers.end(), GL_COLOR_ATTACHMENT0 + first);
  glDrawBuffers(static_cast<GLsizei>(count), buffers.data());
}

vtkSmartPointer<vtkOpenGLFramebufferObject> MakeFramebuffer(vtkOpenGLRenderWindow* window,
  std::initializer_list<vtkTextureObject*> colors, vtkTextureObject* depth)
{
  auto made = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  made->SetContext(window);
  made->Bind();
  unsigned int number = 0;
  for (vtkTextureObject* color : colors)
  {
    if (color)
    {
      made->AddColorAttachment(number++, color);
    }
  }
  if (depth)
  {
    made->AddDepthAttachment(depth);
  }
  DrawInto(0, number);
  return made;
}

// The framebuffer that is bound gets the depth of the picture; 0: none.
void AttachDepth(unsigned int texture, int samples)
{
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
    samples > 0 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, texture, 0);
}
}

//------------------------------------------------------------------------------
bool vtkWaterSurfaceBuffer::CanServe(vtkOpenGLRenderWindow* window)
{
  const vtkWaterBoundPicture picture;
  return picture.HasTextures() && vtkWaterBoundPicture::HasOneBuffer() &&
    picture.Get(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL) == 0 &&
    picture.Get(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE) == 0 &&
    !window->GetUseSRGBColorSpace(); // which would encode the colours of a mean, not of samples
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTextureObject> vtkWaterSurfaceBuffer::MakeTexture(
  int components, int type, int samples)
{
  auto made = vtkSmartPointer<vtkTextureObject>::New();
  made->SetContext(this->Window);
  made->SetSamples(samples);
  made->SetMinificationFilter(vtkTextureObject::Nearest);
  made->SetMagnificationFilter(vtkTextureObject::Nearest);
  made->SetWrapS(vtkTextureObject::ClampToEdge);
  made->SetWrapT(vtkTextureObject::ClampToEdge);
  const auto width = static_cast<unsigned int>(this->Size[0]);
  const auto height = static_cast<unsigned int>(this->Size[1]);
  const bool isMade = components == 0
    ? made->AllocateDepth(width, height, vtkTextureObject::Float32)
    : made->Allocate2D(width, height, components, type);
  return isMade ? made : nullptr;
}

//------------------------------------------------------------------------------
bool vtkWaterSurfaceBuffer::Ensure(const int viewport[4], bool hasData)
{
  const vtkWaterBoundPicture picture;
  const int size[2] = { viewport[0] + viewport[2], viewport[1] + viewport[3] };
  std::copy_n(viewport, 4, this->Viewport);
  if (this->KeptFramebuffer && std::equal(size, size + 2, this->Size) &&
    this->Samples == picture.Samples && this->ColorType == picture.GetColorType() &&
    this->HasData == hasData)
  {
    return true;
  }
  vtkOpenGLRenderWindow* window = this->Window;
  this->ReleaseGraphicsResources(nullptr);
  this->Window = window;
  std::copy_n(size, 2, this->Size);
  this->Samples = picture.Samples;
  this->ColorType = picture.GetColorType();
  this->HasData = hasData;
  this->Kept = this->MakeTexture(4, VTK_FLOAT, this->Samples);
  this->KeptData = hasData ? this->MakeTexture(4, VTK_FLOAT, this->Samples) : nullptr;
  for (int i = 0; i < 2; ++i)
  {
    this->Texels[i] = this->MakeTexture(4, VTK_FLOAT, 0);
    this->Data[i] = hasData ? this->MakeTexture(4, VTK_FLOAT, 0) : nullptr;
    this->Shaded[i] = this->MakeTexture(4, this->ColorType, 0);
  }
  this->Masks = this->MakeTexture(4, VTK_UNSIGNED_CHAR, 0);
  this->Depth = this->MakeTexture(0, 0, 0);
  if (!this->Kept || !this->Texels[0] || !this->Texels[1] || !this->Masks || !this->Depth ||
    !this->Shaded[0] || !this->Shaded[1] ||
    (hasData && (!this->KeptData || !this->Data[0] || !this->Data[1])))
  {
    return false;
  }
  this->SortedFramebuffer = MakeFramebuffer(window,
    { this->Texels[0], this->Texels[1], this->Masks, this->Data[0], this->Data[1] }, this->Depth);
  bool isComplete = vtkWaterFramebuffers::IsComplete();
  this->ShadedFramebuffer =
    MakeFramebuffer(window, { this->Shaded[0], this->Shaded[1] }, this->Depth);
  isComplete = isComplete && vtkWaterFramebuffers::IsComplete();
  this->KeptFramebuffer = MakeFramebuffer(window, { this->Kept, this->KeptData }, nullptr);
  return isComplete;
}

//------------------------------------------------------------------------------
vtkWaterSurfaceBuffer::Keeping::Keeping(
  vtkWaterSurfaceBuffer& buffer, vtkOpenGLRenderWindow* window, const int viewport[4], bool hasData)
  : Buffer(buffer)
  , State(window->GetState())
  , IsBlending(window->GetState()->GetEnumState(GL_BLEND))
  , IsReady(false)
{
  if (buffer.Window != window)
  {
    buffer.ReleaseGraphicsResources(nullptr);
    buffer.Window = window;
  }
  if (buffer.HasFailed)
  {
    return;
  }
  this->State->PushFramebufferBindings();
  const unsigned int depth = vtkWaterBoundPicture().GetDepthTexture();
  if (buffer.Ensure(viewport, hasData))
  {
    buffer.KeptFramebuffer->Bind();
    DrawInto(0, hasData ? 2 : 1);
    AttachDepth(depth, buffer.Samples);
    this->IsReady = vtkWaterFramebuffers::IsComplete();
  }
  if (!this->IsReady)
  {
    this->State->PopFramebufferBindings();
    buffer.ReleaseGraphicsResources(nullptr);
    buffer.HasFailed = true;
    return;
  }
  const vtkOpenGLState::ScopedglEnableDisable scissor(this->State, GL_SCISSOR_TEST);
  this->State->vtkglDisable(GL_SCISSOR_TEST);
  for (int i = 0; i < (hasData ? 2 : 1); ++i)
  {
    glClearBufferfv(GL_COLOR, i, kNothing);
  }
  this->State->vtkglDisable(GL_BLEND);
}

//------------------------------------------------------------------------------
vtkWaterSurfaceBuffer::Keeping::~Keeping()
{
  if (this->IsReady)
  {
    AttachDepth(0, this->Buffer.Samples);
    this->State->SetEnumState(GL_BLEND, this->IsBlending);
    this->State->PopFramebufferBindings();
  }
}

//------------------------------------------------------------------------------
bool vtkWaterSurfaceBuffer::Sort(const std::function<void(vtkShaderProgram*)>& setUp)
{
  static const std::string sources[2] = { std::string(vtkWaterBufferSortFS) + vtkWaterBufferOneFS,
    std::string(vtkWaterBufferSortFS) + vtkWaterBufferSampleFS };
  vtkOpenGLState* state = this->Window->GetState();
  vtkShaderProgram* program =
    this->SortQuad.Ready(this->Window, sources[this->Samples > 0 ? 1 : 0].c_str());
  if (!program)
  {
    return false;
  }
  this->SortedFramebuffer->Bind();
  DrawInto(0, this->HasData ? 5 : 3);
  const vtkWaterScopedOverwrite overwrite(state, this->Viewport);
  setUp(program);
  vtkWaterUniforms::Set(program, "waterBufferSamples", std::max(this->Samples, 1));
  vtkWaterUniforms::Set(program, "waterBufferHasData", this->HasData ? 1 : 0);
  if (this->Samples > 0)
  {
    const vtkWaterScopedSamples samples(
      state, this->Kept->GetHandle(), (this->HasData ? this->KeptData : this->Kept)->GetHandle());
    vtkWaterUniforms::Set(program, "waterBufferKept", 0);
    vtkWaterUniforms::Set(program, "waterBufferKeptData", 1);
    this->SortQuad.Draw();
    return true;
  }
  vtkTextureObject* data = this->HasData ? this->KeptData : this->Kept;
  this->Kept->Activate();
  data->Activate();
  vtkWaterUniforms::Set(program, "waterBufferKept", this->Kept);
  vtkWaterUniforms::Set(program, "waterBufferKeptData", data);
  this->SortQuad.Draw();
  data->Deactivate();
  this->Kept->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterSurfaceBuffer::ShadeTexels(
  const std::string& shader, const std::function<void(vtkShaderProgram*)>& setUp)
{
  if (this->Shader != shader)
  {
    this->ShadeQuad.ReleaseGraphicsResources();
    this->Shader = shader;
  }
  vtkShaderProgram* program = this->ShadeQuad.Ready(this->Window, this->Shader.c_str());
  if (!program)
  {
    return false;
  }
  vtkOpenGLState* state = this->Window->GetState();
  this->ShadedFramebuffer->Bind();
  const vtkWaterScopedOverwrite overwrite(state, this->Viewport);
  state->vtkglDepthMask(GL_FALSE);
  setUp(program);
  vtkWaterUniforms::Set(program, "waterBufferHasData", this->HasData ? 1 : 0);
  for (int i = 0; i < (this->Samples > 0 ? 2 : 1); ++i)
  {
    vtkTextureObject* data = this->HasData ? this->Data[i] : this->Texels[i];
    DrawInto(static_cast<unsigned int>(i), 1);
    state->vtkglDepthFunc(i == 0 ? GL_GEQUAL : GL_EQUAL); // the quad lies at 0.5
    this->Texels[i]->Activate();
    data->Activate();
    vtkWaterUniforms::Set(program, "waterBuffer", this->Texels[i]);
    vtkWaterUniforms::Set(program, "waterBufferData", data);
    this->ShadeQuad.Draw();
    data->Deactivate();
    this->Texels[i]->Deactivate();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterSurfaceBuffer::Put(const std::function<void(vtkShaderProgram*)>& setUp)
{
  vtkShaderProgram* program = this->PutQuad.Ready(this->Window, vtkWaterBufferPutFS);
  if (!program)
  {
    return false;
  }
  vtkOpenGLState* state = this->Window->GetState();
  const vtkWaterScopedPlainDraws plain(state);
  const vtkOpenGLState::ScopedglDepthMask depthMask(state);
  state->vtkglDepthMask(GL_FALSE);
  setUp(program);
  const std::initializer_list<std::pair<const char*, vtkTextureObject*>> textures = {
    { "waterShadedNear", this->Shaded[0] }, { "waterShadedFar", this->Shaded[1] },
    { "waterShadedMasks", this->Masks }
  };
  for (const auto& [name, texture] : textures)
  {
    texture->Activate();
    vtkWaterUniforms::Set(program, name, texture);
  }
  if (this->Samples == 0)
  {
    vtkWaterUniforms::Set(program, "waterShadedSample", 0);
    this->PutQuad.Draw();
  }
  else
  {
    const vtkWaterScopedSampleMask mask(state);
    for (int i = 0; i < this->Samples; ++i)
    {
      vtkWaterUniforms::Set(program, "waterShadedSample", i);
      glSampleMaski(0, 1u << i);
      this->PutQuad.Draw();
    }
  }
  for (const auto& named : textures)
  {
    named.second->Deactivate();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterSurfaceBuffer::Shade(
  const std::string& shader, const std::function<void(vtkShaderProgram*)>& setUp)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->PushFramebufferBindings();
  bool isShaded = this->Sort(setUp) && this->ShadeTexels(shader, setUp);
  state->PopFramebufferBindings();
  isShaded = isShaded && this->Put(setUp);
  this->HasFailed = !isShaded;
  return isShaded;
}

//------------------------------------------------------------------------------
void vtkWaterSurfaceBuffer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->SortQuad.ReleaseGraphicsResources();
  this->ShadeQuad.ReleaseGraphicsResources();
  this->PutQuad.ReleaseGraphicsResources();
  this->Shader.clear();
  for (auto* framebuffer :
    { &this->KeptFramebuffer, &this->SortedFramebuffer, &this->ShadedFramebuffer })
  {
    if (*framebuffer && window)
    {
      (*framebuffer)->ReleaseGraphicsResources(window);
    }
    *framebuffer = nullptr;
  }
  for (auto* texture :
    { &this->Kept, &this->KeptData, &this->Texels[0], &this->Texels[1], &this->Data[0],
      &this->Data[1], &this->Masks, &this->Depth, &this->Shaded[0], &this->Shaded[1] })
  {
    if (*texture && window)
    {
      (*texture)->ReleaseGraphicsResources(window);
    }
    *texture = nullptr; // without a window the destructors free what is left
  }
  this->HasFailed = false;
  this->Window = nullptr;
}
