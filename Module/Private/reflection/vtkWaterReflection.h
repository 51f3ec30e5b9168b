// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterReflection: the mirrored views of one pass, each in five steps: gather, plan, revise,
// draw, commit. What is decided is decided by the core, before the third step ends. With secondary
// reflections, each other water in the mirrored view has one of its own, which is drawn before.
#ifndef vtkWaterReflection_h
#define vtkWaterReflection_h

#include "vtkOpenGLRenderWindow.h" // for templates
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"
#include "vtkWaterGather.h"
#include "vtkWaterMirroredView.h"
#include "vtkWaterOcclusion.h"
#include "vtkWaterRanks.h"
#include "vtkWaterSecondaryLookup.h"
#include "vtkWaterSignature.h"
#include "vtkWaterSource.h"
#include "vtkWaterSurfaceShader.h"
#include "vtkWeakPointer.h"
#include "water_buffer.h"
#include "water_quality.h"

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

class vtkRenderer;

class vtkWaterReflection
  : public std::enable_shared_from_this<vtkWaterReflection>
  , public vtkWaterSecondaryLookup
{
public:
  // What the pass has set.
  struct UserSettings : public water_settings
  {
    UserSettings();
    bool IsInstrumented = false; // times and numbers are taken
    bool MayBuffer = true;       // the surface of a user's mesh, to shade it once a pixel
  };
  UserSettings Settings;
  vtkWaterRanks Ranks;               // whose scenes are one
  vtkWaterKeptBackground Background; // that is reflected, if it is kept

  // Of the last frame, for whoever asks the pass.
  struct FrameReport
  {
    water_decision Decision = WATER_NOT_PLANNED;
    int QualityStep = WATER_QUALITY_NO_STEP;
    double TextureScale = 1.0;
    double GatherTime = std::numeric_limits<double>::quiet_NaN(); // ms
    double PlanTime = std::numeric_limits<double>::quiet_NaN();
    int ReasonCounts[WATER_CULL_REASON_COUNT] = {};
    vtkIdType RenderCount = 0; // ever
    water_decision OwnViewDecision = WATER_NOT_PLANNED;
    vtkIdType OwnViewRenderCount = 0;   // ever
    vtkIdType SunViewRenderCount = 0;   // ever
    vtkIdType SkyViewRenderCount = 0;   // ever
    vtkIdType SecondaryRenderCount = 0; // ever
    vtkIdType JoinedPixels = 0;         // that the ranks sent each other
    water_buffer_use BufferUse = WATER_BUFFER_NOT_DRAWN;
  };
  const FrameReport& GetReport() const { return this->Report; }
  void ForgetTimes();
  void SetBufferUse(water_buffer_use use) { this->Report.BufferUse = use; }
  const water_plan& GetPlan() const { return this->Plan; }

  // A frame in which a mirrored view is wanted.
  struct Frame
  {
    vtkRenderer* Renderer = nullptr;
    vtkMTimeType Number = 0; // 0: none was begun
    int Viewport_px[2] = {};
    vtkWaterShaderHook* Hook = nullptr;
    vtkWaterPropRecords* Records = nullptr; // of the renderer
    vtkWaterFrameHints Hints;
    // Are the waters behind what the bound framebuffer shows? Asked only if they would reflect: the
    // answer waits for what was drawn. Empty: not known.
    std::function<bool()> AreHidden;
    const vtkWaterError* RanksError = nullptr; // the ranks do not agree: there is no view
    const water_plan* Primary = nullptr; // of the mirrored view that a secondary one is drawn for
  };

  // Renders the mirrored view of waters in one plane for the renderer's active camera, unless the
  // plan says that it is not needed, and tells each of them what was wrong.
  //
  // Returns false if the ranks do not agree: none of them may send anything more in the frame.
  bool Render(const Frame& frame, const std::vector<vtkWaterSource*>& waters);

  // There is no view, for a reason that is known without a plan.
  void Decline(water_decision decision);

  // Was the frame planned for this water and the renderer's active camera?
  //
  // frame  its number
  bool IsFresh(vtkRenderer* renderer, vtkMTimeType frame, const vtkProp* water) const;

  // Is it known of the frame that no pixel of the water is seen?
  bool IsUnseen(vtkRenderer* renderer, vtkMTimeType frame, const vtkProp* water) const;

  // What a water of the frame is shaded with. Plan: nullptr when it has no view.
  vtkWaterSurfaceShader::Inputs GetInputs(
    vtkRenderer* renderer, vtkMTimeType frame, const vtkProp* water);

  // What another water in the mirrored view is shaded with.
  bool Find(const vtkProp* water, vtkWaterSurfaceShader::Inputs& inputs) override;

  // Shows the reflection texture in a corner of the renderer's viewport.
  void DrawCorner(vtkRenderer* renderer, vtkMTimeType frame, const vtkProp* water);

  // What of a renderer's view must outlive a draw in whose middle the user may release it.
  std::shared_ptr<void> Hold(vtkRenderer* renderer) { return this->GetView(renderer); }

  // How much is seen of the water that owns the pass, and what its draws take.
  vtkWaterOcclusion* GetOcclusion(vtkRenderer* renderer);
  vtkWaterGpuQueries* GetGpuQueries(vtkRenderer* renderer);

  // Should the next mirrored view wait for the main one? By how much of the water was seen.
  bool ShouldWait(vtkRenderer* renderer, double visible_px, bool isSoftware);

  // Of the last mirrored view; nullptr before the first.
  vtkTextureObject* GetColor();
  vtkTextureObject* GetDepth();

  // What the GPU queries of the last planned view say, if times and numbers are taken, with the
  // context that they measured in: another window's may be current.
  template <typename Value, typename Question>
  Value Ask(Value none, Question question);
  // ms of the last mirrored view and its secondary views; NaN: not known.
  double AskTime();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct OtherView // own view (water_beyond.h), sun view (water_sun_view.h), sky view
                   // (water_sky_view.h)
  {
    vtkWaterMirroredView Drawn; // nothing in it is mirrored
    water_plan DrawnPlan = water_plan();
    vtkWaterSignature DrawnSignature;
  };

  struct View // what belongs to one eye of a renderer
  {
    View() { water_quality_begin(&this->Quality); }

    vtkWeakPointer<vtkRenderer> Renderer;
    vtkWaterMirroredView Mirrored;
    water_plan DrawnPlan = water_plan(); // what the reflection texture shows was drawn by it
    vtkWaterSignature DrawnSignature;
    vtkTimeStamp DrawnTime;
    bool HasLevels = false;
    std::unique_ptr<OtherView> Own; // nullptr: no water wants one
    std::unique_ptr<OtherView> Sun;
    std::unique_ptr<OtherView> Sky;
    vtkWaterOcclusion Occlusion;
    water_quality_memory Quality;
  };
  using ViewPointer = std::shared_ptr<View>; // shared: a view in use outlives its release
  using Eye = std::pair<vtkRenderer*, bool>; // is it the second of two?

  struct Attempt // at a mirrored view
  {
    std::vector<vtkWaterSnapshotPointer> Waters;
    ViewPointer Drawn;
    std::vector<vtkSmartPointer<vtkProp>> Held; // while secondary views are drawn
    vtkWaterError Error;                        // of the plan
    vtkWaterError SecondaryError;               // of the first secondary view that has one
    vtkWaterSignature Signature;
    vtkWaterMirroredView::Draft Draft;
    const char* Failure = nullptr;
    std::string FailureText;        // what that is of, if it was made
    bool IsAborted = false;         // on any rank
    bool IsSecond = false;          // what was refused in the first one is left out
    vtkWaterRanks::Drawing Drawing; // of all ranks; with them only
    int AgreementsDue = 0;          // that the other ranks wait for
    size_t FirstProp = 0;           // of this rank's in the scene's props
    double MeasuredMs = 0.0;        // of the last view, on the slowest rank
  };

  struct SecondaryView // of the other waters in one plane
  {
    std::vector<const vtkProp*> Waters; // compared only; the first one tells it
    std::shared_ptr<vtkWaterReflection> Reflection;
    int IdleCount = 0; // mirrored views since it was last looked up
  };

  // false: the ranks do not agree.
  bool RenderView(
    const Frame& frame, const std::vector<vtkWaterSource*>& waters, vtkWaterError& error);
  // The secondary views, vtkWaterReflectionSecondary.cxx: of a plan that reflects; before its draw,
  // as draws do not nest.
  void RenderSecondary(const Frame& frame, Attempt& attempt);
  std::vector<std::vector<vtkWaterSource*>> FindSecondary(const Frame& frame) const;
  SecondaryView& EnsureSecondary(const std::vector<vtkWaterSource*>& waters);
  void DropSecondary(vtkRenderer* renderer);
  bool MayHaveSecondary(const Frame& frame) const;
  // Are the records of the gathered props? Not if an observer of a secondary view changed the
  // scene.
  bool HasPropsOf(const vtkWaterPropRecords& records) const;
  double MeasureSecondary(); // what the last view took as a secondary one, ms
  void SignSecondary(const Frame& frame, Attempt& attempt) const;
  void FillInputs(View& view, bool hasTexture, vtkWaterSurfaceShader::Inputs& inputs);

  void Gather(const Frame& frame, const std::vector<vtkWaterSource*>& waters, Attempt& attempt);
  double Measure(View& view); // what the last view took, ms, for a quality that asks
  bool PlanAndDraw(const Frame& frame, Attempt& attempt); // is there to be a second attempt?
  void ChooseQuality(const Frame& frame, Attempt& attempt);
  // With other ranks, vtkWaterReflectionRanks.cxx: the scene of all of them, or an error; is the
  // last reflection texture used by all; was the mirrored view drawn by all; what is thrown on one
  // rank is an error of all.
  bool JoinScene(const std::vector<vtkWaterSource*>& waters, Attempt& attempt);
  bool IsUnchangedOnAll(const Attempt& attempt, bool isUnchanged);
  const vtkWaterRanks::Drawing& JoinDrawn(
    const Frame& frame, Attempt& attempt, const water_rank_drawn& mine);
  // Is there to be a second attempt?
  bool FinishDrawn(const Frame& frame, Attempt& attempt, const water_plan& plan);
  bool GatherOrFail(
    const Frame& frame, const std::vector<vtkWaterSource*>& waters, Attempt& attempt);
  void DrawOrFail(const Frame& frame, Attempt& attempt);
  void RenderNothing(
    const Frame& frame, const std::vector<vtkWaterSource*>& waters, const vtkWaterError& error);
  void SetPlanned(const Frame& frame, const std::vector<const vtkProp*>& waters);
  void MakePlan(const Frame& frame, Attempt& attempt);
  void Revise(const Frame& frame, Attempt& attempt);
  void Draw(const Frame& frame, Attempt& attempt);
  vtkWaterError Commit(const Frame& frame, Attempt& attempt);
  static vtkWaterError Describe(const vtkWaterShortage& shortage);
  struct Choice // of the props for a view of any kind
  {
    const water_plan& Plan;
    const std::vector<water_cull_reason>& Reasons;
    bool IsDirect; // no prop stands in for another, as one may in a reflection
  };
  // The own view, the sun view and the sky view, vtkWaterReflectionOtherViews.cxx. Each returns
  // what went wrong with it.
  vtkWaterError RenderOtherViews(const Frame& frame, Attempt& attempt);
  vtkWaterError RenderOwnView(const Frame& frame, Attempt& attempt);
  vtkWaterError RenderSunView(const Frame& frame, Attempt& attempt);
  vtkWaterError RenderSkyView(const Frame& frame, Attempt& attempt);
  static bool WantOwnView(const Attempt& attempt);
  void MarkOwnProps(const Frame& frame); // in what was gathered
  water_scene GetSceneOfAll() const;     // with the props of all ranks
  struct Other                           // a view that is to be drawn
  {
    std::unique_ptr<OtherView>& View;
    vtkIdType& RenderCount;
    const char* Name;    // for errors
    const char* Without; // what the water shows then
    bool IsDirect;       // Choice
    bool IsDepth;        // Draft
    bool HasLayer;       // what is translucent is kept apart
  };
  // Plans the view, revises the plan, and carries it out.
  vtkWaterError RenderOther(
    const Frame& frame, Attempt& attempt, water_scene& scene, water_plan& plan, const Other& other);
  // part     the attempt at this view
  // scene    with this rank's props, and reasons are of them
  // choice   of plan and reasons
  vtkWaterError DrawOther(const Frame& frame, Attempt& part, const Choice& choice,
    const water_scene& scene, water_plan& plan, std::vector<water_cull_reason>& reasons,
    const Other& other);
  // Is the last one used again?
  bool ReviseOther(const Frame& frame, Attempt& part, const Choice& choice,
    const water_scene& scene, std::vector<water_cull_reason>& reasons, const Other& other);
  const char* CarryOutOther(
    const Frame& frame, Attempt& part, const Choice& choice, OtherView& own);
  vtkWaterError CommitOther(
    const Frame& frame, const Attempt& part, water_plan& plan, const Other& other);
  // With other ranks, vtkWaterReflectionRankViews.cxx: DrawOther, of what all of them have.
  // First they agree whether it is drawn, or used again, or cannot be drawn.
  vtkWaterError DrawOtherOfAll(const Frame& frame, Attempt& part, const Choice& choice,
    const water_scene& scene, water_plan& plan, std::vector<water_cull_reason>& reasons,
    const Other& other);
  water_decision AgreeOnOther(const Frame& frame, Attempt& part, const Choice& choice,
    const water_scene& scene, std::vector<water_cull_reason>& reasons, const Other& other);
  static void Fail(Attempt& part, const std::string& text);
  static void ReleaseOther(std::unique_ptr<OtherView>& view, vtkWindow* window);
  // Of what is chosen: the props, what they look like, and how they are drawn.
  static vtkProp* GetDrawn(const Frame& frame, const Choice& choice, size_t i);
  static void FindDrawn(
    const Frame& frame, const Attempt& attempt, const Choice& choice, std::vector<vtkProp*>& drawn);
  void Sign(const Frame& frame, const Choice& choice, const vtkWaterMirroredView::Draft& draft,
    vtkWaterSignature& signature) const;
  void SortDrawn(
    const Frame& frame, const Choice& choice, vtkWaterMirroredView::Draft& draft) const;
  void CountReasons();
  static bool IsSecondEye(vtkRenderer* renderer); // of a stereo pair, by the active camera
  ViewPointer GetView(vtkRenderer* renderer);
  View* GetPlannedView();
  const water_plan* GetFreshPlan(
    vtkRenderer* renderer, vtkMTimeType frame, const vtkProp* water) const;
  vtkOpenGLRenderWindow* GetWindowOf(View* view) const;

  std::map<Eye, ViewPointer> Views;
  vtkWaterGather Gathered;
  water_camera OwnEye = water_camera(); // the renderer's own; the scene's is the root's
  std::vector<water_prop> RankProps;    // of all ranks
  std::vector<water_cull_reason> Reasons;
  water_plan Plan = water_plan(); // of the last frame; const from the third step on
  bool HasView = false;           // the plan's, unless it could not be carried out
  bool HasOwnView = false;        // of that frame
  bool HasSunView = false;
  bool HasSkyView = false;
  water_quality_choice Quality = water_quality_choice();
  FrameReport Report;
  vtkWeakPointer<vtkRenderer> PlannedFor;
  bool PlannedForSecondEye = false;
  std::vector<const vtkProp*> PlannedWaters; // compared only
  vtkMTimeType PlannedFrame = 0;
  std::vector<SecondaryView> Secondary;
  bool IsSecondarySaid = false; // that the ranks have none
};

//------------------------------------------------------------------------------
template <typename Value, typename Question>
Value vtkWaterReflection::Ask(Value none, Question question)
{
  View* view = this->Settings.IsInstrumented ? this->GetPlannedView() : nullptr;
  vtkOpenGLRenderWindow* window = this->GetWindowOf(view);
  if (!window)
  {
    return none;
  }
  window->PushContext();
  const Value value = question(view->Mirrored.GetGpuQueries());
  window->PopContext();
  return value;
}

#endif
