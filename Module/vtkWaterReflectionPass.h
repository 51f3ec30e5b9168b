// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterReflectionPass
 * @brief   renders the mirrored scene of a water surface into a texture
 *
 * Every vtkWaterActor has its own pass and needs no other (vtkWaterActor::GetReflectionPass). You
 * can also add one at the head of a renderer's chain of passes. It then renders the reflections of
 * the renderer's waters, followed by its delegate. It controls the first water of the renderer and
 * those in the same plane; other waters keep their own passes.
 *
 * @code
 * vtkNew<vtkWaterReflectionPass> pass;
 * pass->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
 * renderer->SetPass(pass);
 * @endcode
 *
 * The mirrored view contains opaque and translucent geometry and volumes. They are lit by the
 * scene's lights at their real positions, and clipped at the plane. It does not contain the water
 * itself. Other waters appear in it with their own colour, and reflect the sky or, with
 * SetSecondaryReflections, the scene. The mirrored view is flipped in x.
 *
 * The environment variable VTK_WATER_DEBUG=1 turns ShowReflection on. VTK_WATER_SOFTWARE=0 makes
 * the module treat any renderer as a GPU, VTK_WATER_SOFTWARE=1 as a software renderer
 * (debugging.md).
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
class vtkMultiProcessController;
class vtkRenderer;
class vtkTextureObject;

class VTKRENDERINGWATER_EXPORT vtkWaterReflectionPass : public vtkOpenGLRenderPass
{
public:
  static vtkWaterReflectionPass* New();
  vtkTypeMacro(vtkWaterReflectionPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What happened to a prop in the mirrored view: it was drawn, or the reason why it was left out
   * (GetFateCount).
   */
  enum Fates
  {
    DRAWN = 0,
    INVISIBLE,
    WATER_ITSELF,
    MARKED_NOT_REFLECTED,
    OVERLAY,
    LABEL, ///< billboards, rulers, axes and texts that face the camera; see NOT_REFLECTED
    EMPTY,
    BEHIND_PLANE,
    OUT_OF_VIEW,
    OUT_OF_WATER, ///< in the mirrored view, but no visible water reflects it
    TOO_SMALL,    ///< see SetMinimumPropSize
    REFUSED,      ///< the driver rejects its shader with the lines that reflections need
    NUMBER_OF_FATES
  };

  /**
   * The decision for the last frame, with its reason (GetDecision).
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
    HIDDEN, ///< other objects hide the water
    FAINT,  ///< see SetReflectanceError
    SHARED, ///< another water in the same plane has the mirrored view; see its pass
    NUMBER_OF_DECISIONS
  };

  /**
   * Optimisations that skip invisible work (SetSkips): bits.
   */
  enum Skips
  {
    SKIP_NONE = 0,
    UNSEEN_WATER = 1 << 0,    ///< the mirrored view of water that is out of view or faces away
    HIDDEN_WATER = 1 << 1,    ///< the mirrored view of water that other objects hide
    FAINT_WATER = 1 << 2,     ///< the mirrored view of water that reflects almost nothing
    UNCHANGED_VIEWS = 1 << 3, ///< a mirrored view equal to the previous one
    SHARED_VIEWS = 1 << 4,    ///< a mirrored view that another water in the same plane has
    PROPS = 1 << 5,           ///< props that no visible water reflects
    PIECES = 1 << 6,          ///< parts of large meshes, and blocks of composite data, that no
                              ///< visible water reflects
    PIXELS = 1 << 7,          ///< pixels of the mirrored view that no visible water reflects; in
                              ///< software rendering, with PROPS or PIECES, also the props or
                              ///< pieces that only hidden pixels of water reflect
    SKIP_ALL = (1 << 8) - 1
  };

  ///@{
  /**
   * The pass that renders the frame after the reflections, if this pass was added to a renderer by
   * hand. nullptr means a vtkRenderStepsPass. Default is nullptr.
   */
  void SetDelegatePass(vtkRenderPass* pass);
  vtkRenderPass* GetDelegatePass();
  ///@}

  ///@{
  /**
   * Texture scale: pixels of the reflection texture per pixel of the viewport along each axis, in
   * [1/64, 16]. Other values are rejected with an error and the last valid one stays. Default is 1.
   */
  void SetTextureScale(double scale);
  double GetTextureScale() const;
  ///@}

  ///@{
  /**
   * Samples per pixel of the mirrored view, 0 to 32, limited to what the GPU supports; 0 and 1 turn
   * multisampling off. -1, the default, chooses the number. With waves it is 0, because the rays
   * sample edges themselves, and texels that mix two objects at an edge would show as webs around
   * reflections. With calm water it is the window's MultiSamples, at most 8, and at least 4 with
   * the ray-trace quality "high".
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
   * Storage of the colours of the mirrored view. They are linear, like those of the picture, and
   * not tone mapped. EIGHT_BIT holds [0, 1]. HALF_FLOAT holds any light with 11 bits, and takes a
   * tenth more time on software renderers. AUTOMATIC: half floats if the renderer has a pass that
   * keeps more than 8 bits, such as tone mapping, or a pass that is not VTK's; otherwise 8 bits,
   * like the picture. Default is AUTOMATIC.
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
   * Clip margin: how far behind the plane geometry is kept in the mirrored view, in the scene's
   * unit: in [0, 1e100]. Default is 0.
   */
  void SetClipMargin(double margin);
  double GetClipMargin() const;
  ///@}

  ///@{
  /**
   * The optimisations in use: Skips, or-ed. They do not change the picture, except as far as
   * MinimumPropSize (for PROPS) and ReflectanceError (for FAINT_WATER) allow. SKIP_NONE renders
   * everything in every frame, for comparison. Default is SKIP_ALL.
   */
  void SetSkips(int skips);
  int GetSkips() const;
  ///@}

  ///@{
  /**
   * Smallest prop size: props whose picture in the mirrored view is smaller than this in both
   * directions are left out. In pixels of the texture, not negative. Default is 0: no prop is left
   * out.
   */
  void SetMinimumPropSize(double pixels);
  double GetMinimumPropSize() const;
  ///@}

  ///@{
  /**
   * Share of the light that may be neglected (ReflectanceError), in [0, 1]: no mirrored view is
   * rendered while no visible pixel reflects more. 0.03, for example, skips the reflection of a
   * pool seen from straight above. Default is 0: nothing is neglected, because even the smallest
   * share can change how a pixel is rounded.
   */
  void SetReflectanceError(double share);
  double GetReflectanceError() const;
  ///@}

  ///@{
  /**
   * Guard band for waves: size of the mirrored view relative to that of the picture, in [1, 2].
   * Reflected rays leave the picture at its edges; the guard band shows what they meet there. 0:
   * chosen from the waves' slope, at most 1.25. Texels keep their size, so the texture grows.
   * Default is 0.
   */
  void SetGuardBand(double band);
  double GetGuardBand() const;
  ///@}

  ///@{
  /**
   * Whether other waters, in other planes, reflect the scene where they appear in this water's
   * reflection (one bounce). Off: they reflect only the sky there. On: for each such plane that the
   * reflection shows, another mirrored view is rendered (a secondary view). In it, waters reflect
   * only the sky. Waves of other waters appear as roughness, as without this setting. Clear water
   * keeps the colour of deep water there. If the pass has a controller of several ranks, the
   * setting has no effect, and one warning says so. Source:
   * Documentation/decisions/011-water-in-water.md. Default is off.
   */
  void SetSecondaryReflections(bool reflections);
  bool GetSecondaryReflections() const;
  vtkBooleanMacro(SecondaryReflections, bool);
  ///@}

  ///@{
  /**
   * Whether to show the reflection texture in the lower left quarter of the viewport, as the water
   * sees it (not flipped). For debugging. Default is off, or on if VTK_WATER_DEBUG=1.
   */
  vtkSetMacro(ShowReflection, bool);
  vtkGetMacro(ShowReflection, bool);
  vtkBooleanMacro(ShowReflection, bool);
  ///@}

  ///@{
  /**
   * Colour (RGBA) and depth of the last mirrored view (the reflection texture), flipped in x;
   * nullptr before the first. They belong to the pass. Only the part that the water can look up is
   * drawn.
   */
  vtkTextureObject* GetReflectionTexture();
  vtkTextureObject* GetReflectionDepthTexture();
  ///@}

  /**
   * Number of mirrored views rendered since the pass was made.
   */
  vtkIdType GetNumberOfReflectionRenders() const;

  ///@{
  /**
   * The additional view of what lies below clear water
   * (vtkWaterProperty::SetRefractionSourceToOwnView): the number of these views rendered since the
   * pass was made, the decision for the last frame (Decisions), and its text.
   */
  vtkIdType GetNumberOfOwnViewRenders() const;
  int GetOwnViewDecision() const;
  const char* GetOwnViewDecisionAsString() const;
  ///@}

  /**
   * Number of secondary views rendered since the pass was made (SetSecondaryReflections).
   */
  vtkIdType GetNumberOfSecondaryRenders() const;

  /**
   * Number of props in the last mirrored view.
   */
  int GetNumberOfPropsReflected() const { return this->GetFateCount(DRAWN); }

  ///@{
  /**
   * Number of the renderer's props that had this fate (Fates) in the last plan; 0 for an unknown
   * fate.
   * GetFateAsString returns the fate in words.
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
   * Strategy that chooses the texture scale and the steps of ray-traced lookups. FIXED:
   * TextureScale and the steps that are set. TARGET_ERROR: as coarse as possible while the median
   * error of the lookup stays within TargetError; the error is estimated from the waves' slopes and
   * the area of a pixel on the water. TIME_BUDGET: from the time that the mirrored view and the
   * surface took on the GPU in previous frames. UPDATE_RATE: as TIME_BUDGET, with half of the
   * frame time that the window's DesiredUpdateRate allows; a still picture is refined at once.
   *
   * The last three use a ladder of eight steps, with texture scales from 1 to 0.25 instead of
   * TextureScale, and at most the ray steps that are set. They do not oscillate between two steps.
   * On a software renderer, the GPU time is CPU time, including deferred work. Source:
   * Documentation/decisions/010-quality.md. Default is FIXED.
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
   * Target error: the accepted median distance, in pixels of the picture, of a reflection from its
   * correct place, in [1e-3, 1e3]. Texels as large as pixels cause an error of 0.4. Default is 1.
   */
  void SetTargetError(double pixels);
  double GetTargetError() const;
  ///@}

  ///@{
  /**
   * Time budget in milliseconds per frame for all waters of a renderer whose quality is
   * TIME_BUDGET, in [1e-3, 1e6]. They share it by their visible area. Default is 10.
   */
  void SetTimeBudget(double milliseconds);
  double GetTimeBudget() const;
  ///@}

  /**
   * Step of the quality ladder in the last frame, 0 (finest) to 7; -1 if the quality is fixed.
   */
  int GetQualityStep() const;

  /**
   * Texture scale of the last frame: TextureScale, or the scale that the quality strategy chose.
   */
  double GetTextureScaleInUse() const;

  ///@{
  /**
   * Controller of a parallel program whose ranks (processes) each hold a part of one scene. Each
   * rank mirrors its own part, the parts are joined, and the water of every rank reflects the whole
   * scene. Compositing the picture is left to VTK, for example to
   * vtkCompositedSynchronizedRenderers. Every rank must set its own controller for its own pass,
   * render as often as the others, and have the same waters with the same plane, look, time and
   * settings. If waters differ, if a rank has an error, if an exception ends its mirrored view, or
   * if a rank hides or deletes a water after it was shown, all ranks report an error and show the
   * plain colour. While a rank has no controller, has not shown the water yet, or does not render,
   * the others wait for it, as in any collective call (SetRankWaitLimit). For frames that one rank
   * renders alone, set nullptr on all ranks. vtkWaterLakes does not support ranks: only its first
   * water has the controller.
   *
   * A mesh may be split over the ranks. Translucent props and volumes are blended rank by rank:
   * those of each rank have a bounding box, and the mirrored camera determines the order of
   * these boxes. The result is correct if the boxes do not overlap. Pixels of textures (normal
   * maps, environment) are not compared.
   *
   * A controller of a single process has no effect. If MPI has started several processes, it is an
   * error, and the water reflects only this rank's part. A controller that is not initialised, or
   * is finalised, is an error until another is set, and the water shows its plain colour. MPI
   * itself ends ranks that render after MPI_Finalize with a controller that is not finalised.
   *
   * Source: Documentation/decisions/023-ranks.md. Default is nullptr.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

  ///@{
  /**
   * Longest time in seconds, in [0, 1e6], that this process waits for the other ranks in one call;
   * 0 means no limit. A collective call of a communicator cannot be ended from outside. When the
   * limit is exceeded, the process therefore prints what it is waiting for, and ends at once with
   * EXIT_FAILURE, without calling destructors; mpirun then ends the other ranks. Without a limit,
   * it prints this message after 10 s and continues to wait. The time includes the slowest rank's
   * draw. Each water's pass has its own limit. Default is 0.
   */
  void SetRankWaitLimit(double seconds);
  double GetRankWaitLimit() const;
  ///@}

  ///@{
  /**
   * Rank whose picture shows the water, for engines that blend the ranks' pictures in order and
   * do not compare their depths: vtkCompositeRGBAPass, and vtkIceTCompositePass with ordered
   * compositing. It must be the rank that the engine treats as the farthest from the eye. Set it
   * before each frame in which it changes; all ranks use the number set on rank 0. The pictures of
   * the other ranks are transparent black where their water is, so that they hide neither the water
   * nor the objects in it. They keep the objects in front of their water. In [-1, ranks - 1]; -1:
   * all ranks draw the water, for engines that compare depths. Has no effect without other ranks.
   * Translucent water also needs SetRankRegion.
   * Source: Documentation/decisions/023-ranks.md. Default is -1.
   */
  void SetFarthestRank(int rank);
  int GetFarthestRank() const;
  ///@}

  ///@{
  /**
   * The part of space whose data this rank draws, for translucent water (an Opacity below 1, of the
   * water or of its actor) and engines that blend the ranks' pictures in order: a box (xmin,
   * xmax, ymin, ymax, zmin, zmax) in world coordinates, such as a region of the engine's k-d tree.
   * Each rank then draws the water inside its own box, and all boxes together must contain all of
   * the water: a side without a neighbour is -infinity or infinity. Set it on all ranks. Opaque and
   * clear water do not use it (SetFarthestRank). Each minimum must be below its maximum. Default is
   * an empty box (minima above maxima): each rank draws all of the water. Source:
   * Documentation/decisions/023-ranks.md.
   */
  void SetRankRegion(const double bounds[6]);
  void ResetRankRegion();
  const double* GetRankRegion() const VTK_SIZEHINT(6);
  ///@}

  /**
   * Stores a renderer's present background (colours, gradient, textures). Later frames reflect it,
   * whatever the renderer's background is while they are drawn. Use it with engines that set the
   * background to black while they draw, as IceT's compositing pass does, and call it again when
   * the background has changed. Textures are not copied: a change of their pixels is reflected.
   * nullptr, the default: the renderer's own background is reflected.
   */
  void KeepBackground(vtkRenderer* renderer);

  /**
   * Number of pixels of the mirrored view, the own view, the sun view and the sky view that the
   * ranks joined in the last frame; 0 if all were reused, or without other ranks.
   */
  vtkIdType GetNumberOfPixelsJoined() const;

  ///@{
  /**
   * Whether to measure times and counts. Default is off, which sends no queries to the GPU.
   */
  void SetInstrumentation(bool instrumentation);
  bool GetInstrumentation() const;
  vtkBooleanMacro(Instrumentation, bool);
  ///@}

  ///@{
  /**
   * Milliseconds of the last measurement with Instrumentation on. Gathering the scene and planning
   * are measured on the CPU. Drawing the mirrored view (with its secondary views) and the surface
   * is measured on the GPU, for the last drawing that it has finished. The surface's time includes
   * the copy of what is visible through it. NaN: unknown.
   */
  double GetLastGatherTime() const;
  double GetLastPlanTime() const;
  double GetLastReflectionTime();
  double GetLastSurfaceTime();
  ///@}

  ///@{
  /**
   * Number of triangles (or other primitives) and of fragments of opaque geometry drawn in the last
   * mirrored view with Instrumentation on. Fragments rejected by the depth test do not count. These
   * functions wait for the GPU, at most a second. -1: unknown.
   */
  vtkIdType GetNumberOfTrianglesReflected();
  vtkIdType GetNumberOfFragmentsReflected();
  ///@}

  ///@{
  /**
   * Whether the surface of a user's mesh with many small triangles may be shaded once per pixel,
   * from a buffer. This is faster with software rendering, and the picture is the same, except for
   * rounding and at the borders of the surface. Default is on. A GPU never uses a buffer.
   */
  void SetSurfaceBuffer(bool surfaceBuffer);
  bool GetSurfaceBuffer() const;
  vtkBooleanMacro(SurfaceBuffer, bool);
  ///@}

  ///@{
  /**
   * Whether the last draw of the surface used such a buffer; a text that says so, or why it did
   * not.
   */
  bool GetSurfaceIsBuffered() const;
  const char* GetSurfaceBufferUseAsString() const;
  ///@}

  ///@{
  /**
   * The last decision (Decisions), and its text.
   */
  int GetDecision() const;
  const char* GetDecisionAsString() const;
  ///@}

  /**
   * Property key that leaves a prop out of reflections, with any value except 0. The value 0 makes
   * a prop reflected that is left out without the key: rulers, axes (vtkCubeAxesActor,
   * vtkAxesActor, vtkPolarAxesActor, vtkGridAxesActor3D and others), and a vtkFollower with a
   * vtkVectorText.
   * vtkBillboardTextActor3D and vtkFlagpoleLabel are never reflected.
   */
  static vtkInformationIntegerKey* NOT_REFLECTED();

  /**
   * Property key with a prop that replaces this prop in reflections, for example a coarser model of
   * a large mesh. The replacement has its own position and colour and need not be in a renderer. It
   * is drawn whenever the original prop would be; its own visibility and keys are ignored. Water
   * cannot be a replacement. If a prop's key holds the prop itself, the key is removed at the start
   * of a frame, because the reference would keep the prop alive. A cycle of several props is not
   * detected; break it yourself.
   */
  static vtkInformationObjectBaseKey* STAND_IN();

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * Copies all settings of the mirrored view from another pass, except the controller.
   */
  void CopySettings(vtkWaterReflectionPass* other);

  /**
   * Internal renderer of the mirrored views; not for use.
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

  std::shared_ptr<vtkWaterReflection> Reflection; // shared: it outlives the pass while in use
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
