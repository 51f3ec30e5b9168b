// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFrame: a renderer's frame with water, and what is kept of it for the next one: which
// props carry the shader key, which sheets share a mirrored view, when that is drawn, in which
// order, and how much time it may take. One for each renderer and thread. See
// Documentation/decisions/002-host.md and 009-skips.md.
#ifndef vtkWaterFrame_h
#define vtkWaterFrame_h

#include "vtkOpenGLRenderer.h" // for members
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"
#include "vtkWaterPropRecords.h"
#include "vtkWaterRanks.h"
#include "vtkWaterSource.h"
#include "vtkWaterSurfaceShader.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <string>
#include <vector>

class vtkCallbackCommand;
class vtkProp;
class vtkRenderWindow;
class vtkRenderer;
class vtkViewport;
class vtkWaterReflection;
class vtkWaterShaderHook;
struct water_plan;

class vtkWaterFrame
{
public:
  vtkWaterFrame() = default;
  ~vtkWaterFrame();

  // The frame of a renderer, in the thread that renders.
  static vtkWaterFrame& Of(vtkRenderer* renderer);

  // A number of the renderer's frame, never used twice; 0: none was begun.
  static vtkMTimeType NumberOf(vtkRenderer* renderer);

  // The one key of the thread that renders (Documentation/decisions/004-one-key.md).
  static vtkWaterShaderHook* GetHook();

  // The renderer that is looking through the user's camera, to show its picture; nullptr: this is
  // something else: a selection, a mirrored view, no OpenGL.
  static vtkOpenGLRenderer* FindMainView(vtkViewport* viewport);

  // Puts the key on every visible prop of the renderer until the frame ends (its EndEvent, or the
  // StartEvent of the next).
  void Begin(vtkWaterSource& water);
  vtkMTimeType GetNumber() const;

  // Holds a snapshot until the frame ends.
  void Keep(const vtkWaterSnapshotPointer& snapshot) { this->Snapshots.push_back(snapshot); }

  // Is its renderer still there?
  bool IsAlive() const { return this->Renderer != nullptr; }

  // What a water does when the renderer allots it time, before anything is drawn: the moment to
  // draw the mirrored view, or to put it off until the scene before the water is there.
  void Allot(vtkWaterSource& water);

  // What it does just before it is drawn: a mirrored view that was put off, or a nested one for a
  // draw whose camera was not the one mirrored before the frame.
  void Prepare(vtkWaterSource& water);

  // Draws the mirrored view for a pass that was composed by hand.
  void RenderComposed(vtkWaterReflection& reflection, const std::vector<vtkWaterSource*>& waters,
    const int viewport_px[2]);

  // Whose mirrored view the water looks up in this frame.
  vtkWaterReflection& GetReflection(vtkWaterSource& water);
  bool IsUnseen(vtkWaterSource& water);

  // What the water is shaded with.
  vtkWaterSurfaceShader::Inputs GetInputs(vtkWaterSource& water);

  // Does the CPU execute GL, and no GPU?
  bool IsSoftware();

  // Does the driver cut by clip distances as it should? The water is told if not, for debugging.
  bool ClipsWell(vtkProp* water);

  // Is this the first water that an eye is in, in this frame? The others add no fog.
  bool BeginFog(const water_plan& plan);

  // Draws the props again that this frame has lost because their shaders were refused with the
  // lines that reflections need.
  //
  // Returns what is to be said of it; empty: nothing.
  std::string MendFailures(vtkWaterSource& water);

private:
  vtkWaterFrame(const vtkWaterFrame&) = delete;
  void operator=(const vtkWaterFrame&) = delete;

  struct Group // of sheets that share a mirrored view
  {
    std::vector<vtkWeakPointer<vtkProp>> Sheets; // the first one has the pass in charge
    bool IsLate = false; // it is drawn just before the water, else before the frame
  };

  void End();
  // With other ranks: do all of them show the same waters in this frame? Asked of them once, before
  // anything is drawn. Waters are told how far the scene of all ranks reaches.
  bool Agree(vtkWaterReflection& reflection);
  bool Ask(vtkWaterError& error);
  // What the ranks know of the ground, for waters that choose their extent by it.
  bool JoinGrounds(const std::vector<vtkWaterSource*>& waters, vtkWaterError& error);
  bool HasRanks() const; // are there others to be asked in a frame without water?
  // Says so to the other ranks when this one shows none, which they may not know.
  void SayNoWater();
  std::vector<vtkWaterSource*> FindWatersOfRanks() const;
  const Group* FindGroup(vtkWaterSource& water) const;
  // Finds the sheets that share a mirrored view with a water, and when it is drawn.
  const Group& EnsureGroup(vtkWaterSource& water);
  std::vector<vtkWaterSource*> FindSheets(vtkWaterSource& water);
  static std::vector<vtkWaterSource*> GetSources(const Group& group);
  bool CanShare(vtkWaterSource& water, vtkWaterSource& other);
  // May the mirrored view be drawn in the middle of the main one, just before the water?
  bool CanBeLate(vtkWaterSource& water);
  bool HasPropsOfTheirView() const;
  // Is it likely that the picture before the water says what need not be drawn in it?
  bool IsWorthWaiting(const std::vector<vtkWaterSource*>& sheets);
  // Is all of them hidden by what has been drawn so far?
  bool AreHidden(const std::vector<vtkWaterSource*>& sheets);
  // Milliseconds that the sheets may take in this frame; 0: theirs is no budget.
  double FindBudget(const std::vector<vtkWaterSource*>& sheets);
  // Puts the water behind all other props in the order of this frame: what hides it, and what is
  // seen through it, is there before it. Of clear waters the farther ones come first.
  void DrawLast(vtkWaterSource& water);
  bool IsFresh(vtkWaterSource& water);
  void RenderShared(vtkWaterSource& water, const int viewport_px[2], bool isLate);
  void RenderBeforeFrame(vtkWaterSource& water);
  // A GPU computes the water's wind sea while the CPU submits the props: they need not wait for it.
  void BeginSea(vtkWaterSource& water);
  // Does the frame end here for a water without an extent? With other ranks it continues, to tell
  // them.
  static bool IsLeftOut(vtkWaterSource& water);
  vtkIdType GetSamples(vtkWaterSource& water);

  vtkWeakPointer<vtkOpenGLRenderer> Renderer;
  std::vector<vtkWaterSnapshotPointer> Snapshots;
  vtkWaterPropRecords Records; // the plain actors among them carry the key in this frame
  std::vector<vtkSmartPointer<vtkProp>> Keyed;  // and so do these
  vtkSmartPointer<vtkCallbackCommand> Observer; // nullptr: the key is not held
  vtkTimeStamp Number;
  std::vector<Group> Groups;
  vtkMTimeType GroupsNumber = 0; // of the frame that they are of
  vtkMTimeType FogNumber = 0;
  double FogEye[12] = {};                    // its directions
  vtkRenderWindow* SoftwareWindow = nullptr; // compared only
  bool IsSoftwareWindow = false;
  bool IsSilenceSaid = false;    // of a driver
  vtkMTimeType AgreedNumber = 0; // of the frame that the ranks were asked about
  bool AreAgreed = false;
  vtkWaterError RanksError;                          // when they have not
  std::weak_ptr<vtkWaterReflection> Asking;          // that asked them last
  vtkWaterRanks RanksAsked;                          // by which it did: it may be deleted
  vtkSmartPointer<vtkCallbackCommand> RanksObserver; // of frames in which no water may ask
};

#endif
