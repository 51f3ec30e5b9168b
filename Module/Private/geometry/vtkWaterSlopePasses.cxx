// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSlopePasses.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkWaterFftFS.h"
#include "vtkWaterFramebuffers.h"
#include "vtkWaterGL.h"
#include "vtkWaterQueryResult.h"
#include "vtkWaterScopedPlainDraws.h"
#include "vtkWaterSeaSpectrumFS.h"
#include "vtkWaterSlopeTexture.h"
#include "vtkWaterUniforms.h"
#include "water_tile_time.h"
#include "water_turns.h"

#include <algorithm>

namespace
{
// The two pairs of each field; of the slopes the second is not used.
constexpr water_tile_pair kPairs[vtkWaterSlopePasses::FIELDS][2] = { { WATER_PAIR_SLOPES,
                                                                       WATER_PAIR_SLOPES },
  { WATER_PAIR_STRETCH, WATER_PAIR_SHEAR }, { WATER_PAIR_CHOP, WATER_PAIR_HEIGHT } };
constexpr size_t kWordsPerTexel = 4;
const char* const kRefused = "the GPU rejects its passes";

// Textures are read by shaders while an object of this class lives.
struct ScopedTextures
{
  explicit ScopedTextures(std::initializer_list<vtkTextureObject*> textures)
    : Textures(textures)
  {
    for (vtkTextureObject* texture : this->Textures)
    {
      texture->Activate();
    }
  }
  ~ScopedTextures()
  {
    for (vtkTextureObject* texture : this->Textures)
    {
      texture->Deactivate();
    }
  }

  std::vector<vtkTextureObject*> Textures;
};

vtkSmartPointer<vtkTextureObject> MakeTexture(vtkOpenGLRenderWindow* window)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New(); // each texel as it is
  texture->SetContext(window);
  return texture;
}
}

//------------------------------------------------------------------------------
vtkWaterSlopePasses::vtkWaterSlopePasses() = default;

//------------------------------------------------------------------------------
vtkWaterSlopePasses::~vtkWaterSlopePasses() = default;

//------------------------------------------------------------------------------
const char* vtkWaterSlopePasses::FindUnits(const Inputs& sea)
{
  for (size_t i = 0; i < sea.Tiles.size(); ++i)
  {
    const Tile& tile = sea.Tiles[i];
    if (this->HasFields == 0)
    {
      const double largest = *std::max_element(tile.Frequencies->begin(), tile.Frequencies->end());
      this->Exponents[i] = water_turns_exponent(largest);
    }
    uint32_t units[2];
    if (!water_turns_time(water_tile_clock(tile.Shape, sea.Time), this->Exponents[i], units))
    {
      return "the time is too large for the phases of a GPU";
    }
    this->Units[2 * i] = static_cast<int>(units[0]);
    this->Units[2 * i + 1] = static_cast<int>(units[1]);
  }
  return nullptr;
}

//------------------------------------------------------------------------------
const char* vtkWaterSlopePasses::Draw(
  vtkOpenGLRenderWindow* window, const Inputs& sea, int fields, vtkWaterSlopeTexture& texture)
{
  if (window == this->RefusedBy)
  {
    return kRefused;
  }
  if (vtkWaterQueryResult::IsAnyAwaited()) // it would count our draws, too
  {
    return "a query counts what is drawn";
  }
  water_fft plan;
  const size_t size = sea.Tiles.front().Shape->size;
  const size_t count = sea.Tiles.size();
  if (!water_fft_plan(size, &plan))
  {
    return "the tile's size has a prime factor that is too large for a pass";
  }
  if (const char* reason = this->FindUnits(sea))
  {
    return reason;
  }
  if (size != this->Plan.size || count != this->Count)
  {
    if (size * count > static_cast<size_t>(vtkTextureObject::GetMaximumTextureSize(window)))
    {
      return "the tiles are larger than a texture can be";
    }
    this->ReleaseGraphicsResources(nullptr);
    this->Plan = plan;
    this->Count = count;
  }
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglActiveTexture activeTexture(state);
  state->PushFramebufferBindings();
  bool isDrawn = this->Prepare(window, sea, fields);
  for (int i = 0; i < fields && isDrawn; ++i)
  {
    vtkWaterScopedPlainDraws plain(state);
    const int size_px[2] = { static_cast<int>(size), static_cast<int>(size * count) };
    plain.SetSize(size_px);
    isDrawn = this->DrawSpectrum(window, sea.Time, i) && this->Transform(window, i);
    for (size_t tile = 0; tile < count && isDrawn; ++tile) // the last target is bound
    {
      texture.CopyLayer(static_cast<unsigned int>(static_cast<size_t>(i) * count + tile),
        static_cast<unsigned int>(tile * size));
    }
  }
  state->PopFramebufferBindings();
  if (!isDrawn)
  {
    this->ReleaseGraphicsResources(nullptr);
    this->RefusedBy = window;
    return kRefused;
  }
  return nullptr;
}

//------------------------------------------------------------------------------
bool vtkWaterSlopePasses::Prepare(vtkOpenGLRenderWindow* window, const Inputs& sea, int fields)
{
  const bool isReady = this->Table && this->Table->GetContext() == window;
  if (!isReady)
  {
    this->ReleaseGraphicsResources(nullptr);
    this->UploadTable(window);
  }
  if (this->HasFields == 0)
  {
    this->UploadFrequencies(window, sea);
  }
  for (; this->HasFields < fields; ++this->HasFields)
  {
    if (!this->MakeTargetsOf(window, this->HasFields))
    {
      return false;
    }
    this->UploadWaves(window, sea, this->HasFields);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterSlopePasses::MakeTarget(vtkOpenGLRenderWindow* window, int components, Target& target)
{
  const auto size = static_cast<unsigned int>(this->Plan.size);
  target.Texture = MakeTexture(window);
  if (!target.Texture->Allocate2D(
        size, size * static_cast<unsigned int>(this->Count), components, VTK_FLOAT))
  {
    return false;
  }
  target.Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  target.Framebuffer->SetContext(window);
  target.Framebuffer->Bind();
  target.Framebuffer->AddColorAttachment(0, target.Texture);
  target.Framebuffer->ActivateBuffer(0);
  target.Framebuffer->ActivateReadBuffer(0);
  return vtkWaterFramebuffers::IsComplete();
}

//------------------------------------------------------------------------------
bool vtkWaterSlopePasses::MakeTargetsOf(vtkOpenGLRenderWindow* window, int fields)
{
  const bool areSlopes = fields == SLOPES;
  bool isMade = !areSlopes || this->Whole.Texture || this->MakeTarget(window, 4, this->Whole);
  for (Target& target : this->Targets[areSlopes ? 0 : 1])
  {
    isMade = isMade && (target.Texture || this->MakeTarget(window, areSlopes ? 2 : 4, target));
  }
  return isMade;
}

//------------------------------------------------------------------------------
void vtkWaterSlopePasses::UploadTable(vtkOpenGLRenderWindow* window)
{
  const size_t line = 4 * this->Plan.size;
  std::vector<float> table(line * static_cast<size_t>(this->Plan.count));
  for (int pass = 0; pass < this->Plan.count; ++pass)
  {
    water_fft_table(&this->Plan, pass, table.data() + line * static_cast<size_t>(pass));
  }
  this->Table = MakeTexture(window);
  this->Table->Create2DFromRaw(static_cast<unsigned int>(this->Plan.size),
    static_cast<unsigned int>(this->Plan.count), 4, VTK_FLOAT, table.data());
}

//------------------------------------------------------------------------------
void vtkWaterSlopePasses::UploadFrequencies(vtkOpenGLRenderWindow* window, const Inputs& sea)
{
  const auto size = static_cast<unsigned int>(this->Plan.size);
  const size_t quadrant = this->Plan.size / 2 * (this->Plan.size / 2);
  std::vector<uint32_t> words(kWordsPerTexel * quadrant * this->Count, 0);
  uint32_t* word = words.data();
  for (size_t tile = 0; tile < this->Count; ++tile)
  {
    for (double frequency : *sea.Tiles[tile].Frequencies)
    {
      water_turns_frequency(frequency, this->Exponents[tile], word);
      word += kWordsPerTexel;
    }
  }
  this->Frequencies = MakeTexture(window);
  this->Frequencies->SetInternalFormat(GL_RGBA32UI);
  this->Frequencies->SetFormat(GL_RGBA_INTEGER);
  this->Frequencies->SetDataType(GL_UNSIGNED_INT);
  this->Frequencies->Create2DFromRaw(size / 2, size / 2 * static_cast<unsigned int>(this->Count),
    static_cast<int>(kWordsPerTexel), VTK_UNSIGNED_INT, words.data());
}

//------------------------------------------------------------------------------
void vtkWaterSlopePasses::UploadWaves(vtkOpenGLRenderWindow* window, const Inputs& sea, int fields)
{
  const auto size = static_cast<unsigned int>(this->Plan.size);
  const size_t numbers = 4 * this->Plan.size * this->Plan.size; // of a tile
  std::vector<float> waves(numbers * this->Count);
  for (int i = 0; i < 2; ++i)
  {
    if (i > 0 && kPairs[fields][i] == kPairs[fields][0])
    {
      this->Waves[fields][i] = this->Waves[fields][0];
      continue;
    }
    for (size_t tile = 0; tile < this->Count; ++tile)
    {
      water_tile_pair_waves(sea.Tiles[tile].Shape, sea.Tiles[tile].Amplitudes->data(),
        kPairs[fields][i], waves.data() + tile * numbers);
    }
    this->Waves[fields][i] = MakeTexture(window);
    this->Waves[fields][i]->Create2DFromRaw(
      size, size * static_cast<unsigned int>(this->Count), 4, VTK_FLOAT, waves.data());
  }
}

//------------------------------------------------------------------------------
bool vtkWaterSlopePasses::DrawSpectrum(vtkOpenGLRenderWindow* window, double time, int fields)
{
  vtkShaderProgram* program = this->Spectrum.Ready(window, vtkWaterSeaSpectrumFS);
  if (!program)
  {
    return false;
  }
  const auto& waves = this->Waves[fields];
  const ScopedTextures textures({ waves[0], waves[1], this->Frequencies });
  vtkWaterUniforms::Set(program, "waterSlopeWaves", waves[0]);
  vtkWaterUniforms::Set(program, "waterOtherWaves", waves[1]);
  vtkWaterUniforms::Set(program, "waterFrequencies", this->Frequencies);
  vtkWaterUniforms::Set(program, "waterTimeSign", time < 0.0 ? -1.0 : 1.0);
  program->SetUniform1iv("waterUnits", 2 * WATER_CASCADES_MAX, this->Units);
  vtkWaterUniforms::Set(program, "waterPairs", fields == SLOPES ? 1 : 2);
  this->Targets[fields == SLOPES ? 0 : 1][0].Framebuffer->Bind();
  this->Spectrum.Draw();
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterSlopePasses::Transform(vtkOpenGLRenderWindow* window, int fields)
{
  vtkShaderProgram* program = this->Fft.Ready(window, vtkWaterFftFS);
  if (!program)
  {
    return false;
  }
  const bool areSlopes = fields == SLOPES;
  const Target* targets = this->Targets[areSlopes ? 0 : 1];
  const ScopedTextures textures({ targets[0].Texture, targets[1].Texture, this->Table });
  vtkWaterUniforms::Set(program, "waterFftTable", this->Table);
  const int last = 2 * this->Plan.count - 1;
  for (int i = 0; i <= last; ++i)
  {
    const int pass = i % this->Plan.count;
    const size_t radix = this->Plan.radix[pass];
    const double numbers[4] = { static_cast<double>(radix),
      static_cast<double>(this->Plan.size / radix), static_cast<double>(pass),
      i < this->Plan.count ? 0.0 : 1.0 };
    vtkWaterUniforms::Set(program, "waterField", targets[i % 2].Texture);
    vtkWaterUniforms::Set4(program, "waterFftPass", numbers);
    const bool isWhole = i == last && areSlopes;
    vtkWaterUniforms::Set(program, "waterFftCount", areSlopes ? 1 : 2);
    vtkWaterUniforms::Set(program, "waterFftSquares", isWhole ? 1 : 0);
    (isWhole ? this->Whole : targets[(i + 1) % 2]).Framebuffer->Bind();
    this->Fft.Draw();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterSlopePasses::ReleaseGraphicsResources(vtkWindow* window)
{
  for (Target* target : { &this->Targets[0][0], &this->Targets[0][1], &this->Targets[1][0],
         &this->Targets[1][1], &this->Whole })
  {
    if (target->Framebuffer && window)
    {
      target->Framebuffer->ReleaseGraphicsResources(window);
    }
    // without a window the destructors free what is left, through VTK's resource callbacks
    *target = Target();
  }
  for (auto& waves : this->Waves)
  {
    waves[0] = nullptr;
    waves[1] = nullptr;
  }
  this->Frequencies = nullptr;
  this->Table = nullptr;
  this->Spectrum.ReleaseGraphicsResources();
  this->Fft.ReleaseGraphicsResources();
  this->RefusedBy = nullptr;
  this->HasFields = 0;
}
