// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterReflectionPass
 * @brief   renders the mirrored scene of a water surface into a texture
 *
 * Every vtkWaterActor has one of its own and needs no other (vtkWaterActor::GetReflectionPass).
 * Composing one by hand, at the head of a renderer's chain of passes, works too: it renders the
 * reflections of the renderer's waters and then its delegate. It takes charge of the first water
 * of the renderer and of those in the same plane; others keep their own passes.
 *
 * @code
 * vtkNew<vtkWaterReflectionPass> pass;
 * pass->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
 * renderer->SetPass(pass);
 * @endcode
 *
 * The mirrored view holds opaque and translucent geometry and volumes, lit by the scene's lights
 * where they really are, cut away behind the plane, without the water itself. Other waters are in
 * it with their colour and the background's reflection. It is flipped in x.
 *
 * The environment variable VTK_WATER_DEBUG=1 turns ShowReflection on without a change of code;
 * VTK_WATER_SOFTWARE=0 or =1 has any renderer taken for a GPU, or for one without (debugging.md).
 *
 * @sa vtkWaterActor
 */
#ifndef vtkWaterReflectionPass_h
#define vtkWaterReflectionPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRenderingWaterModule.h" // for the export macro
#include "vtkSmartPointer.h"         // for members
#include "vtkWrappingHints.h"        // for VTK_WRAPEXCLUDE

#include <memory> // for std::shared_ptr
#include <set>    // for std::set

class vtkWaterReflection;

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkInformationIntegerKey;
class vtkInformationObjectBaseKey;
class vtkRenderer;
class vtkTextureObject;

class VTKRENDERINGWATER_EXPORT vtkWaterReflectionPass : public vtkOpenGLRenderPass
{
public:
  static vtkWaterReflectionPass* New();
  vtkTypeMacro(vtkWaterReflectionPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What happened to a prop in the mirrored view, and why (GetFateCount).
   */
  enum Fates
  {
    DRAWN = 0,
    INVISIBLE,
    WATER_ITSELF,
    MARKED_NOT_REFLECTED,
    OVERLAY,
    LABEL,
    EMPTY,
    BEHIND_PLANE,
    OUT_OF_VIEW,
    OUT_OF_WATER, ///< in view of the mirror, but no visible water reflects it
    TOO_SMALL,    ///< see SetMinimumPropSize
    REFUSED,      ///< the driver refuses its shader with the lines that reflections need
    NUMBER_OF_FATES
  };

  /**
   * What was decided for the last frame, and why (GetDecision).
   */
  enum Decisions
  {
    NOT_PLANNED = 0,
    RENDERED,
    FAILED,
    SELECTING,
    EDGE_ON,
    WATER_OUT_OF_VIEW,
    NO_REFLECTANCE,
    STATIC_ENVIRONMENT,
    REUSED, ///< nothing has changed since the last mirrored view
    FACING_AWAY,
    HIDDEN, ///< behind the scene
    FAINT,  ///< see SetReflectanceError
    SHARED, ///< a sheet of the same plane has the mirrored view; its pass has the numbers
    NUMBER_OF_DECISIONS
  };

  /**
   * What is left undone where nobody sees it (SetSkips): bits.
   */
  enum Skips
  {
    SKIP_NONE = 0,
    UNSEEN_WATER = 1 << 0,    ///< the mirrored view, of water out of view or facing away
    HIDDEN_WATER = 1 << 1,    ///< of water behind the scene
    FAINT_WATER = 1 << 2,     ///< of water that reflects next to nothing
    UNCHANGED_VIEWS = 1 << 3, ///< one that would be the last one again
    SHARED_VIEWS = 1 << 4,    ///< one that another sheet of the same plane has
    PROPS = 1 << 5,           ///< props that no visible water reflects
    PIECES = 1 << 6,          ///< parts of large meshes, likewise
    PIXELS = 1 << 7,          ///< pixels of the mirrored view, likewise, and with PROPS and PIECES
                              ///< what only hidden pixels of water would reflect
    SKIP_ALL = (1 << 8) - 1
  };

  ///@{
  /**
   * What renders the frame after the reflections, when the pass is composed by hand. nullptr means
   * a vtkRenderStepsPass. Default is nullptr.
   */
  void SetDelegatePass(vtkRenderPass* pass);
  vtkRenderPass* GetDelegatePass();
  ///@}

  ///@{
  /**
   * Pixels of the texture per pixel of the viewport along each axis, in [1/64, 16]. Another value
   * is refused with an error and the last good one stays. Default is 1.
   */
  void SetTextureScale(double scale);
  double GetTextureScale() const;
  ///@}

  ///@{
  /**
   * Samples per pixel of the mirrored view, 0 to 32 and at most what the GPU has: 0 and 1 mean
   * none. -1: none for waves, whose rays sample edges themselves; with samples, texels at edges mix
   * two things, and show as webs around reflections. For calm water as many as the window's
   * MultiSamples, at most 8, and at least 4 by the quality "high". Default is -1.
   */
  void SetMultiSamples(int samples);
  int GetMultiSamples() const;
  ///@}

  enum ColorPrecisions
  {
    AUTOMATIC = 0,
    EIGHT_BIT = 1,
    HALF_FLOAT = 2
  };

  ///@{
  /**
   * What the mirrored view's colours are stored in. They are linear, as the picture's, and not tone
   * mapped. EIGHT_BIT holds [0, 1]; HALF_FLOAT holds any light with 11 bits, at a tenth more time
   * on software renderers. AUTOMATIC: half floats when the renderer has a pass that keeps
   * more than 8 bits, as a tone mapping does, or one that is not VTK's; else 8 bits, as the
   * picture. Default is AUTOMATIC.
   */
  void SetColorPrecision(int precision);
  int GetColorPrecision() const;
  void SetColorPrecisionToAutomatic() { this->SetColorPrecision(AUTOMATIC); }
  void SetColorPrecisionToEightBit() { this->SetColorPrecision(EIGHT_BIT); }
  void SetColorPrecisionToHalfFloat() { this->SetColorPrecision(HALF_FLOAT); }
  const char* GetColorPrecisionAsString() const;
  ///@}

  ///@{
  /**
   * How far behind the plane geometry is kept in the mirrored view, in the scene's unit: finite
   * and not negative. Default is 0.
   */
  void SetClipMargin(double margin);
  double GetClipMargin() const;
  ///@}

  ///@{
  /**
   * What may be left undone: Skips, or-ed. None of it changes the picture, but for what
   * MinimumPropSize (of PROPS) and ReflectanceError (of FAINT_WATER) allow; SKIP_NONE renders
   * everything in every frame, to compare with. Default is SKIP_ALL.
   */
  void SetSkips(int skips);
  int GetSkips() const;
  ///@}

  ///@{
  /**
   * Props whose picture in the mirrored view is smaller than this, both ways, are left out: pixels
   * of the texture, not negative. Default is 0: none is.
   */
  void SetMinimumPropSize(double pixels);
  double GetMinimumPropSize() const;
  ///@}

  ///@{
  /**
   * Share of the light that may be neglected, in [0, 1]: no mirrored view is rendered while no
   * visible pixel reflects more, as with 0.03 for a pool that is seen straight down. Default is 0:
   * none, as the least share can be what a pixel is rounded up by.
   */
  void SetReflectanceError(double share);
  double GetReflectanceError() const;
  ///@}

  ///@{
  /**
   * With waves: size of the mirrored view over that of the picture, in [1, 2], as reflected rays
   * leave the picture at its edges; 0: by the waves' slope, at most 1.25. Texels keep their size,
   * the texture grows. Default is 0.
   */
  void SetGuardBand(double band);
  double GetGuardBand() const;
  ///@}

  ///@{
  /**
   * Show the reflection texture in the lower left quarter of the viewport, as the water sees it
   * (not flipped). For debugging. Default is off, or on with VTK_WATER_DEBUG=1.
   */
  vtkSetMacro(ShowReflection, bool);
  vtkGetMacro(ShowReflection, bool);
  vtkBooleanMacro(ShowReflection, bool);
  ///@}

  ///@{
  /**
   * Colour (RGBA) and depth of the last mirrored view, flipped in x; nullptr before the
   * first. They belong to the pass, and only the part that the water can look up is drawn.
   */
  vtkTextureObject* GetReflectionTexture();
  vtkTextureObject* GetReflectionDepthTexture();
  ///@}

  /**
   * Number of mirrored views rendered since the pass was made.
   */
  vtkIdType GetNumberOfReflectionRenders() const;

  /**
   * Number of props in the last mirrored view.
   */
  int GetNumberOfPropsReflected() const { return this->GetFateCount(DRAWN); }

  ///@{
  /**
   * Number of the renderer's props that met a fate (Fates) in the last plan, 0 for an unknown
   * fate; and the fate in words.
   */
  int GetFateCount(int fate) const;
  static const char* GetFateAsString(int fate);
  ///@}

  enum Qualities
  {
    FIXED = 0,
    TARGET_ERROR = 1,
    TIME_BUDGET = 2,
    UPDATE_RATE = 3
  };

  ///@{
  /**
   * How the texture's scale and the steps of ray traced lookups are chosen. FIXED: TextureScale,
   * and the steps that are set. TARGET_ERROR: as coarse as the median error of the lookup stays
   * within TargetError, by the waves' slopes and what a pixel sees of them. TIME_BUDGET: by what
   * the mirrored view and the surface took on the GPU in the frames before. UPDATE_RATE: likewise,
   * for half of the time that the window's DesiredUpdateRate leaves for a frame; a picture that
   * stands still is fine at once. The last three go along a ladder of eight steps, with texture
   * scales from 1 to 0.25 in place of TextureScale and no more steps of rays than are set, and do
   * not change back and forth. On a software renderer the GPU's times are the processor's, with all
   * that was put off until then. Source: Documentation/decisions/010-quality.md. Default is FIXED.
   */
  void SetQuality(int quality);
  int GetQuality() const;
  void SetQualityToFixed() { this->SetQuality(FIXED); }
  void SetQualityToTargetError() { this->SetQuality(TARGET_ERROR); }
  void SetQualityToTimeBudget() { this->SetQuality(TIME_BUDGET); }
  void SetQualityToUpdateRate() { this->SetQuality(UPDATE_RATE); }
  const char* GetQualityAsString() const;
  ///@}

  ///@{
  /**
   * Median distance, in pixels of the picture, that a reflection may be found off its place, in
   * [1e-3, 1e3]; texels that are as large as pixels are off by 0.4. Default is 1.
   */
  void SetTargetError(double pixels);
  double GetTargetError() const;
  ///@}

  ///@{
  /**
   * Milliseconds a frame for all waters of a renderer whose quality goes by a budget, in
   * [1e-3, 1e6]; they share it by the area that is seen of them. Default is 10.
   */
  void SetTimeBudget(double milliseconds);
  double GetTimeBudget() const;
  ///@}

  /**
   * Step of the ladder in the last frame, 0 (finest) to 7; -1: the quality is fixed.
   */
  int GetQualityStep() const;

  /**
   * Texture scale of the last frame: TextureScale, or what the quality chose.
   */
  double GetTextureScaleInUse() const;

  ///@{
  /**
   * Let times and numbers be taken. Default is off, which asks nothing of the GPU.
   */
  void SetInstrumentation(bool instrumentation);
  bool GetInstrumentation() const;
  vtkBooleanMacro(Instrumentation, bool);
  ///@}

  ///@{
  /**
   * Milliseconds that the last of each took with Instrumentation on: reading the scene and
   * planning, on the CPU; drawing the mirrored view and the surface, on the GPU, of the last that
   * it has finished. The surface's time includes that of copying what is seen through it. NaN: not
   * known.
   */
  double GetLastGatherTime() const;
  double GetLastPlanTime() const;
  double GetLastReflectionTime();
  double GetLastSurfaceTime();
  ///@}

  ///@{
  /**
   * Triangles (or other primitives) and fragments of opaque geometry that were drawn in the last
   * mirrored view with Instrumentation on; fragments that the depth test rejected do not count.
   * They wait for the GPU, a second at most. -1: not known.
   */
  vtkIdType GetNumberOfTrianglesReflected();
  vtkIdType GetNumberOfFragmentsReflected();
  ///@}

  ///@{
  /**
   * What was decided last (Decisions), and in words.
   */
  int GetDecision() const;
  const char* GetDecisionAsString() const;
  ///@}

  /**
   * A prop with this key (any value but 0) in its property keys is left out of reflections.
   */
  static vtkInformationIntegerKey* NOT_REFLECTED();

  /**
   * A prop with this key is drawn in reflections by the prop that the key holds: a coarser model of
   * a large mesh, say. That one is placed and coloured by itself, need not be in a renderer, and is
   * drawn whenever the prop would be; its own visibility and keys do not count. A water stands in
   * for nothing. The key of a prop that holds the prop itself is taken away when a frame begins:
   * the two would keep each other alive. A loop over several props is yours to break.
   */
  static vtkInformationObjectBaseKey* STAND_IN();

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * Sets all that says how the mirrored view is rendered to what another pass has.
   */
  void CopySettings(vtkWaterReflectionPass* other);

  /**
   * What renders the mirrored views; not for use.
   */
  VTK_WRAPEXCLUDE vtkWaterReflection& GetReflection();

protected:
  vtkWaterReflectionPass();
  ~vtkWaterReflectionPass() override;

private:
  vtkWaterReflectionPass(const vtkWaterReflectionPass&) = delete;
  void operator=(const vtkWaterReflectionPass&) = delete;

  void RenderReflectionAndDelegate(const vtkRenderState* s);
  void RenderReflection(const vtkRenderState* s);
  vtkRenderPass* FindDelegate();
  template <typename T, typename V>
  void Set(const char* name, T& setting, V value, V low, V high);

  std::shared_ptr<vtkWaterReflection> Reflection; // shared: one in use outlives the pass
  vtkSmartPointer<vtkRenderPass> DelegatePass;
  vtkSmartPointer<vtkRenderPass> DefaultDelegate; // when there is no other
  std::set<vtkRenderer*> Rendering;               // in the middle of Render
  bool HasCycle = false;                          // the chain of delegates leads back
  bool IsVisiting = false;                        // the chain
  bool ShowReflection = false;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif
