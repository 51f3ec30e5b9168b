// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPropRecords: what a renderer's frames remember of its props, in its order: what was read
// of each for the plan, the modification times that this depends on, and a stamp for its picture.
//
// Most props are the same in most frames. Of a plain actor the times tell that all is as it was, in
// a tenth of the time that it takes to read it anew; of all others the plan's part is read in every
// frame. See Documentation/decisions/015-prop-records.md.
#ifndef vtkWaterPropRecords_h
#define vtkWaterPropRecords_h

#include "vtkInformation.h" // for members
#include "vtkProp.h"
#include "vtkSmartPointer.h"
#include "vtkWaterPropTimes.h"
#include "water_types.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

class vtkObject;
class vtkOpenGLRenderPass;
class vtkRenderer;
struct vtkWaterSnapshot;

class vtkWaterPropRecords
{
public:
  // A frame begins: puts the shader key on visible actors that have no keys of their own and have
  // been reflected before. The others' shaders stay VTK's until they are.
  void Begin(vtkRenderer* renderer, vtkOpenGLRenderPass* key);
  // It has ended: the key is taken off.
  //
  // Returns what held the props; to be dropped last, as that may run the user's code.
  std::vector<vtkSmartPointer<vtkProp>> End();

  // The prop is being drawn with the key: its times are asked now, while what they are read from is
  // near at hand, and not again in this frame. Nothing is asked of those that were read before.
  void Ask(vtkProp* prop);

  // Props of the renderer that are not plain actors without keys of this window alone: they may be
  // in other windows, too, and have parts, a stand-in and other keys. True as long as no prop comes
  // or goes.
  const std::vector<vtkProp*>& FindOthers(vtkRenderer* renderer);
  const std::vector<vtkProp*>& GetOthers() const { return this->Others; }
  // May another window have had any of them when the frame began, or what is drawn for it?
  bool AreElsewhere() const { return this->HasElsewhere; }

  // Brings up to date what the plan must know of all props.
  //
  // mirrored   the water that is mirrored at
  // isRefused  whether the driver refuses a prop's shader with the lines that reflections need;
  //            empty: of none
  void Read(vtkRenderer* renderer, const vtkWaterSnapshot& mirrored,
    const std::function<bool(vtkProp*)>& isRefused);

  // All of these by the place among the renderer's props, as they were read last.
  size_t GetCount() const { return this->Records.size(); }
  vtkProp* GetProp(size_t i) const { return this->Records[i]->Prop; }
  const water_prop& GetRead(size_t i) const { return this->Records[i]->Read; }
  // The prop, or what stands in for it.
  vtkProp* GetDrawn(size_t i) const { return this->Records[i]->Drawn; }
  // Is it a plain actor of polygons, where its bounds were read last? Then it is no volume, and has
  // no levels of detail.
  bool IsPlain(size_t i) const { return this->Records[i]->IsKnown; }
  // Is it certain that such an actor has data that need not be brought up to date for its draw?
  bool IsUpToDate(size_t i) const { return this->IsPlain(i) && this->Records[i]->IsWhole; }
  // Is it certain that all of it is opaque?
  bool IsOpaque(size_t i) const { return this->IsPlain(i) && this->Records[i]->IsOpaque; }
  // Has that actor translucent polygons?
  bool IsTranslucent(size_t i) const { return this->Records[i]->IsTranslucent; }

  // The drawn prop is about to be drawn in a mirrored view: it has the key from now on.
  void Reflect(size_t i);

  // A number that is another one whenever the picture of the drawn prop may be, in all frames of
  // all renderers.
  vtkMTimeType GetStamp(vtkRenderer* renderer, size_t i);
  // The same of the prop itself.
  vtkMTimeType GetOwnStamp(vtkRenderer* renderer, size_t i);

private:
  struct Picture
  {
    void Update(vtkRenderer* renderer, vtkProp* prop);
    // A prop that another one stood in for may be gone, and its times must not be asked then.
    bool IsUnchanged(const vtkProp* prop) const
    {
      return prop == this->Of && this->Times.AreUnchanged();
    }

    const vtkProp* Of = nullptr; // compared only: whose times these are
    vtkWaterPropTimes Times;
    vtkMTimeType Stamp = 0;
  };
  struct Dereference
  {
    void operator()(vtkInformation* keys) const;
  };
  using KeysPointer = std::unique_ptr<vtkInformation, Dereference>;
  struct Record
  {
    vtkProp* Prop = nullptr;         // there, while it is in the renderer's list
    const char* ClassName = nullptr; // its class's own text, so that its address tells the class
    bool IsPlain = false;            // of exactly the class that VTK makes for vtkActor
    bool IsReflected = false;        // has been once
    bool IsKnown = false;            // what was read holds as long as the times do
    bool IsWhole = false;            // of what is known: is it drawn in one piece?
    bool IsOpaque = false;           // is all of it?
    bool IsTranslucent = false;      // has it translucent polygons?
    uint64_t AskedIn = 0;            // the frame in which the times were asked while it was drawn
    vtkProp* Drawn = nullptr;
    water_prop Read = water_prop();
    Picture Mirrored;
    std::unique_ptr<Picture> Own; // of the prop itself, if another one is drawn for it
    // With the key alone; nullptr: the prop has them, or none were needed. They are moved with
    // their only reference, because VTK collects garbage whenever a second reference to such an
    // object is released.
    KeysPointer Keys;
    vtkInformation* GivenKeys = nullptr; // compared: the prop may have dropped them
    vtkMTimeType KeysTime = 0;
  };
  using RecordPointer = std::unique_ptr<Record>;

  // Calls back for each of the renderer's props, in its order, with its record.
  template <typename Function>
  void Walk(vtkRenderer* renderer, const Function& function);
  Record& Match(size_t i, vtkProp* prop);
  void EndMatching(size_t count);
  bool IsOfWindow(vtkProp* prop, vtkRenderer* renderer);
  static bool HasOwnKeysOnly(const Record& record);
  bool IsUnchanged(const Record& record) const;
  void PutKey(Record& record);
  void TakeKeyOff(Record& record, vtkProp* prop);
  void ReadAnew(vtkRenderer* renderer, Record& record, const vtkWaterSnapshot& mirrored,
    const std::function<bool(vtkProp*)>& isRefused);

  std::vector<RecordPointer> Records;
  std::unordered_multimap<vtkProp*, RecordPointer> Loose; // while props are matched
  std::vector<RecordPointer> Dropped;                     // in this frame
  std::vector<Record*> Keyed;
  std::vector<vtkSmartPointer<vtkProp>> Held; // their props
  vtkOpenGLRenderPass* Key = nullptr;         // the thread's, which outlives frames
  std::vector<vtkProp*> Others;
  std::vector<vtkObject*> OfWindow; // renderers of the same window, while props are looked at
  uint64_t FrameCount = 0;
  bool HasElsewhere = false;
  size_t NextAsked = 0;   // of those with the key: which is drawn next, as a rule
  int MissCount = 0;      // how often it was another one in this frame
  bool IsRead = false;    // in this frame, so that asking while they are drawn is of no use
  bool IsSettled = false; // nothing at all has changed while they were read
};

#endif
