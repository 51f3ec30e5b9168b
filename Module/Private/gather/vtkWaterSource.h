// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSource: what a water is to those below it: where its snapshot comes from, and who is told
// what is wrong. vtkWaterActor implements it.
#ifndef vtkWaterSource_h
#define vtkWaterSource_h

#include "vtkWaterSnapshot.h"

#include <string>
#include <vector>

class vtkMapper;
class vtkProp;
class vtkRenderer;
class vtkWaterReflection;
class vtkWaterReflectionPass;

struct vtkWaterError
{
  std::string Kind; // the same for the same error with another value; empty: no error
  std::string Text; // with the value
};

class vtkWaterSource
{
public:
  virtual ~vtkWaterSource() = default;

  // The source of a prop that is a water; nullptr: it is no water. Defined by vtkWaterActor, which
  // alone knows the class.
  static vtkWaterSource* Of(vtkProp* prop);

  virtual vtkActor* GetProp() = 0;

  // The water in the frame that is being rendered; the same all through it, unless it is changed.
  virtual vtkWaterSnapshotPointer Take(vtkRenderer* renderer) = 0;

  // Two questions that need no snapshot: they are asked of waters that are not drawn, too.
  virtual void ReadPlane(water_plane* plane, double origin[3]) = 0;
  virtual bool IsClear() = 0; // is the scene seen through it?

  // Reports an error once, until it changes or is gone (empty).
  //
  // renderer  of the plan that failed; nullptr: it is the sheet
  virtual void Report(vtkRenderer* renderer, const vtkWaterError& error) = 0;
  virtual bool HasSheetError() const = 0;

  // What the scenes of all ranks take together; the sheet is laid, and lengths are read, by that.
  //
  // bounds  min > max: there is nothing; nullptr: there are no other ranks
  virtual void SetSceneBounds(const double* bounds) = 0;

  // Does the ground decide how far it extends? Ranks then join what they know of the ground, once
  // the bounds of their scenes are joined. Errors end in exceptions of the standard library.
  virtual bool HasAutomaticExtent() = 0;
  virtual bool IsGroundJoined() = 0; // does the last join still hold?
  // This rank's part, for all ranks; with the parts of all ranks, what is below; with that of all,
  // the ground.
  virtual std::vector<double> ReadGroundPart() = 0;
  virtual std::vector<double> JoinGround(const std::vector<double>& parts) = 0;
  virtual void JoinGroundBelow(const std::vector<double>& parts) = 0;

  // May it have a mirrored view? Those who share the views of a frame among waters say so; whether
  // it is to have one at all, the user says.
  virtual void SetMayMirror(bool mayMirror) = 0;

  // A mapper that draws the water in place of its own, which shows the same to all others: between
  // the two calls of SetIsDrawing, and when the water is asked for its bounds. nullptr: none does.
  virtual void SetDrawnMapper(vtkMapper* mapper) = 0;
  virtual void SetIsDrawing(bool isDrawing) = 0;

  // Draws the surface to be counted, without a trace.
  virtual void Probe(vtkRenderer* renderer) = 0;

  // The mirrored view of its own pass, and of one composed by hand that has taken charge; nullptr:
  // none has.
  virtual vtkWaterReflection& GetOwnReflection() = 0;
  virtual vtkWaterReflection* GetComposedReflection() = 0;
  virtual void SetComposedPass(vtkWaterReflectionPass* pass) = 0;
};

#endif
