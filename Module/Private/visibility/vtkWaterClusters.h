// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterClusters: draws of large meshes only the clusters that the mirrored view can show.
//
// A mapper draws the triangles that its index buffer lists. For the time of a draw in the mirrored
// view it gets another list, in which clusters are left out (water_clusters.h): the same vertices,
// the same order, so every pixel is the same as before. Large meshes that are drawn before all else
// may be drawn backwards, the last triangle of the last of them first, with a depth test that keeps
// the first of equally far ones: this, too, gives the same pixels. On a GPU the mapper draws
// nothing itself, and runs of its own list are drawn in the moment before (vtkWaterRuns). See
// Documentation/decisions/009-skips.md.
#ifndef vtkWaterClusters_h
#define vtkWaterClusters_h

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWaterRuns.h"
#include "vtkWaterShortage.h"
#include "vtkWeakPointer.h"
#include "water_clusters.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

class vtkAbstractMapper;
class vtkActor;
class vtkCallbackCommand;
class vtkDataArray;
class vtkOpenGLIndexBufferObject;
class vtkOpenGLPolyDataMapper;
class vtkProp;
class vtkShaderProgram;
class vtkWaterClipDistance;

class vtkWaterClusters
{
public:
  vtkWaterClusters();
  ~vtkWaterClusters();

  // Another reflection texture is about to be drawn.
  //
  // seen          what of it is looked up; nullptr: all of it
  // samples       of its pixels
  // clipDistance  that is on where a draw is cut
  void BeginView(const water_plan& plan, const water_visibility* seen, int samples,
    vtkWaterClipDistance* clipDistance);

  // How many of the props, from the first on, are nothing but large opaque meshes, as far as is
  // known from the last frame. They are about to be drawn: in their order, or, if IsReversed, from
  // the last of them to the first, with the depth test GL_LESS.
  size_t BeginLeading(const std::vector<vtkProp*>& props);
  bool IsReversed() const { return this->HasLeading && this->FarFirst; }

  // All of them are drawn.
  void EndLeading();

  // From now on nothing is left out because something before it hides it.
  void ForgetDepths() { this->Target.depths = nullptr; }

  // A mapper is about to draw a prop with a program: gives it its clusters, if the mesh is large,
  // in a form that can be cut, and parts of it cannot be seen. Without memory for them it draws
  // all.
  void Give(
    const water_plan& plan, vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop);

  // Of the last of the meshes that were drawn whole for want of memory since BeginView.
  const vtkWaterShortage& GetShortage() const { return this->Shortage; }

  // The prop is drawn: the mapper gets its own index buffer back.
  void TakeBack();

  void ReleaseGraphicsResources();

private:
  vtkWaterClusters(const vtkWaterClusters&) = delete;
  void operator=(const vtkWaterClusters&) = delete;

  using MeshState = std::array<vtkMTimeType, 6>;

  struct Mesh
  {
    vtkWeakPointer<vtkOpenGLPolyDataMapper> Mapper;
    MeshState State{};                    // of what the index buffer was made from
    vtkSmartPointer<vtkDataArray> Points; // as they were then
    std::vector<uint32_t> Indices;
    std::vector<std::array<double, 6>> Boxes; // empty: it cannot be cut
    vtkSmartPointer<vtkOpenGLIndexBufferObject> Drawn;
    vtkWaterRuns Runs; // on a GPU, in place of points, indices and boxes
  };

  static MeshState StateOf(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor);
  static void Read(vtkOpenGLPolyDataMapper* mapper, Mesh& mesh);
  static bool Describe(vtkDataArray* points, Mesh& mesh, water_mesh& described);
  // What is known of a mapper's mesh; nullptr: it cannot be cut.
  Mesh* UpdateMesh(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor, bool isSoftware);
  void GiveParts(const water_plan& plan, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor);
  // How many bands of the picture a mesh is looked at in, with the memory for them; bad_alloc.
  int Reserve(const Mesh& mesh, bool isSoftware);
  // Selects the indices that are drawn; how many there are.
  size_t Select(const water_plan& plan, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor,
    const Mesh& mesh, const water_mesh& described);
  // Draws runs of a mesh when the mapper is about to draw all of it.
  void GiveRuns(
    const water_plan& plan, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor, Mesh& mesh);
  // Gives the mapper the selected indices in place of its own.
  void Swap(vtkOpenGLPolyDataMapper* mapper, Mesh& mesh, size_t count);
  bool CanLead(vtkProp* prop);

  std::map<vtkOpenGLPolyDataMapper*, Mesh> Meshes;
  std::vector<uint32_t> Selected;
  std::vector<water_cluster_work> Work;
  water_clusters_target Target{};
  std::vector<float> Depths;
  std::array<water_trend, WATER_CLUSTERS_BANDS_MAX> Trends{};
  vtkWaterShortage Shortage;
  bool HasLeading = false;                        // are being drawn
  bool FarFirst = false;                          // is the leading meshes' own order
  vtkSmartPointer<vtkOpenGLPolyDataMapper> Given; // has a buffer of ours
  vtkSmartPointer<vtkOpenGLIndexBufferObject> Own;
  vtkSmartPointer<vtkCallbackCommand> Drawer;   // of runs, while a mapper has it
  const vtkWaterRuns* DrawnRuns = nullptr;      // by it; nullptr: none
  vtkWaterClipDistance* ClipDistance = nullptr; // of the view
};

#endif
