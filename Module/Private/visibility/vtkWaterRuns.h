// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterRuns: a large mesh on a GPU, of which the mirrored view draws the runs of triangles that
// it can show (water_runs.h), from the mapper's own index buffer.
#ifndef vtkWaterRuns_h
#define vtkWaterRuns_h

#include "water_runs.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkDataArray;
class vtkOpenGLIndexBufferObject;
class vtkWaterClipDistance;

class vtkWaterRuns
{
public:
  // Reads where the triangles of an index buffer are. Nothing is known afterwards if the mesh is
  // small, or its points are not those of the buffer.
  void Read(vtkOpenGLIndexBufferObject* buffer, const water_points& points, size_t pointCount);
  bool IsKnown() const { return !this->Boxes.empty(); }

  // Chooses what is drawn in a view. false: all of it.
  bool Select(const water_clusters_view& view);

  // Draws what was chosen. All else that a draw needs is bound; a clip distance that is on is
  // turned off meanwhile for what it cannot cut.
  void Draw(vtkOpenGLIndexBufferObject* buffer, vtkWaterClipDistance& clipDistance) const;

private:
  water_runs_mesh Mesh = water_runs_mesh(); // points into Boxes
  std::vector<std::array<double, 6>> Boxes;
  std::vector<uint8_t> Places;
  std::vector<water_run> Runs;
  size_t RunCount = 0;
  std::vector<int> Counts; // of indices, for GL
  std::vector<const void*> Offsets;
};

#endif
