// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterProps: props and their parts, and what a renderer draws of them.
#ifndef vtkWaterProps_h
#define vtkWaterProps_h

#include <array>
#include <functional>
#include <vector>

class vtkProp;
class vtkProp3D;
class vtkPropCollection;
class vtkRenderer;

namespace vtkWaterProps
{
// What is drawn for a prop in the mirrored view, as its keys say
// (vtkWaterReflectionPass::STAND_IN); nullptr: the prop itself.
vtkProp* GetStandIn(vtkProp* prop);

// A prop that stands in for itself would never die: it holds its keys, and they hold it.
void DropOwnStandIn(vtkProp* prop);

// Calls back for a prop, what stands in for it, and the parts that do not get their keys from the
// prop.
void ForEachOf(vtkProp* prop, const std::function<void(vtkProp*)>& function);

// The same for all props.
void ForEach(vtkPropCollection* props, const std::function<void(vtkProp*)>& function);

// The parts of a prop that is an assembly of any kind; nullptr: it is none.
vtkPropCollection* GetParts(vtkProp* prop);

// Does a prop, or a part of it, have a property?
bool HasAny(vtkProp* prop, bool (*has)(vtkProp*));

// Is the prop a water, or is one among its parts? Such an assembly must not be asked for its
// bounds, nor drawn again, while it is being drawn: it would rebuild the list that it walks.
bool HoldsWater(vtkProp* prop);

// Is it drawn over the picture: a 2D prop, or any other that has 2D parts and nothing in the scene,
// as a widget's representation or a legend of scale?
bool IsOverlay(vtkProp* prop);

// Calls back for a prop that is a volume, or for those among its parts or levels of detail.
void ForEachVolume(vtkProp* prop, const std::function<void(vtkProp*)>& function);

// Is it a volume, or is one among its parts or levels of detail?
bool HoldsVolume(vtkProp* prop);

// The box of a volume, in its own space, and where that is.
struct Box
{
  std::array<double, 6> Bounds;
  std::array<double, 16> BoxToWorld;
};

// The boxes of a prop's volumes that show something, those of an assembly's parts one by one. What
// has volumes in another way, as levels of detail or several in one mapper, is one box.
std::vector<Box> GetVolumeBoxes(vtkProp* prop);

// Does the prop's place count in the world, and not on the device or in a room?
bool IsInWorld(vtkProp3D* prop);

// vtkProp::GetBounds, which asks the pipeline whether it is up to date: ten times as long as all
// else that is read of a prop. Of an actor that shows data as it is given, the data's time tells.
const double* GetBounds(vtkProp* prop);
}

// What a renderer draws in this frame, in its order, which may be changed.
struct vtkWaterDrawnProps
{
  explicit vtkWaterDrawnProps(vtkRenderer* renderer);

  vtkProp** Find(vtkProp* prop) const;
  bool Has(vtkProp* prop) const { return this->Find(prop) != this->End; }

  vtkProp** Begin;
  vtkProp** End;
};

#endif
