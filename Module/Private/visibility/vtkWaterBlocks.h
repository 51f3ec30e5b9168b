// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBlocks: draws of composite data only the blocks that the mirrored view can show.
//
// One mapper has the vertices of all blocks, and draws them block by block, those that are marked
// as visible. For the time of a draw in the mirrored view the marks of the others are cleared: no
// buffer is built again, the attributes are the user's, and what is drawn comes in the same order,
// so every pixel is the same as before. See Documentation/decisions/009-skips.md.
#ifndef vtkWaterBlocks_h
#define vtkWaterBlocks_h

#include "vtkSmartPointer.h"
#include "water_clusters.h"

#include <vector>

class vtkAbstractMapper;
class vtkOpenGLPolyDataMapper;
class vtkPolyData;
class vtkProp;

class vtkWaterBlocks
{
public:
  vtkWaterBlocks() = default;
  ~vtkWaterBlocks();

  // Another reflection texture is about to be drawn.
  //
  // seen  what of it is looked up; nullptr: all of it
  void BeginView(const water_visibility* seen) { this->Target.seen = seen; }

  // A mapper is about to draw a kind of primitives of a prop: if they are triangles, hides the
  // blocks that cannot be seen.
  void Hide(const water_plan& plan, vtkAbstractMapper* mapper, vtkProp* prop);

  // They are drawn: the blocks are as they were.
  void TakeBack();

private:
  vtkWaterBlocks(const vtkWaterBlocks&) = delete;
  void operator=(const vtkWaterBlocks&) = delete;

  water_clusters_target Target{};
  vtkSmartPointer<vtkOpenGLPolyDataMapper> Mapper; // of the hidden blocks
  std::vector<vtkPolyData*> Hidden;                // keys, not owned
};

#endif
