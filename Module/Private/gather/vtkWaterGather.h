// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterGather: VTK renderer, camera, lights, props and the waters' snapshots -> water_scene.
// What the plan knows of VTK, it knows from here.
#ifndef vtkWaterGather_h
#define vtkWaterGather_h

#include "vtkWaterSkyReader.h"
#include "vtkWaterSnapshot.h"
#include "water_grid.h"
#include "water_plan.h"

#include <functional>
#include <vector>

class vtkCamera;
class vtkProp;
class vtkRenderer;
class vtkWaterPropRecords;

// What a frame knows besides what is read.
struct vtkWaterFrameHints
{
  bool HasSceneDepth = false; // it shows all that can hide them
  bool IsSoftware = false;    // GL is executed by the CPU
  bool MayToneMap = false;    // a pass follows that may do it
  double BudgetMs = 0.0;      // of this frame, for a quality that follows a budget
  const vtkWaterKeptBackground* Background = nullptr; // instead of the renderer's, if it is kept
};

struct vtkWaterGather
{
  water_scene Scene = water_scene(); // points into Props
  std::vector<water_prop> Props;     // of all view props, in the renderer's order
  std::vector<vtkProp*> DrawnProps;  // or what stands in for them
  vtkWaterSkyTextures Sky;           // of Scene.sky
  bool HasEmptySkybox = false;       // a visible one without data in its texture
  vtkCamera* Camera = nullptr;       // the one read last
  double WaveNumber = 0.0;           // typical of the waves, rad per unit; 0: not known
  bool IsRough = false;              // one of the waters blurs its reflection
  bool HasMarchedRays = false;       // one of them traces rays in the reflection texture
  bool WantsPeel = false;            // and goes on behind edges
  bool IsAveraged = false;           // one of them is drawn for frames that are averaged

  // Reads all that the plan depends on, but for the props.
  //
  // waters    the surfaces that share the plane of the first; at least one
  // settings  of the pass in charge
  void Read(vtkRenderer* renderer, const std::vector<vtkWaterSnapshotPointer>& waters,
    const int viewport_px[2], const water_settings& settings, const vtkWaterFrameHints& hints);
  // The last part of it.
  //
  // mirrored   the first of the waters
  // isRefused  whether the driver refuses a prop's shader with the lines that reflections need;
  //            empty: of none
  void ReadProps(vtkRenderer* renderer, const vtkWaterSnapshot& mirrored,
    const std::function<bool(vtkProp*)>& isRefused, vtkWaterPropRecords& records);

  // Makes it the scene of a secondary view, after Read; of waters that are all rough, or none.
  //
  // mirrored  the plan in whose view the waters are drawn; it must outlive the scene
  void ReadAsSecondary(vtkRenderer* renderer, const water_plan& mirrored);

  // Another water for the mirrored view of one, water_secondary.h.
  //
  // eye  of the main view; the renderer's camera is the mirrored one
  // sky  of that
  static water_scene ReadSecondary(vtkRenderer* renderer, const vtkWaterSnapshot& water,
    const water_camera& eye, const water_sky& sky);

  // The camera alone: matrices of the renderer's active camera for its viewport.
  static water_camera ReadCamera(vtkRenderer* renderer);

  // Does a scene light shine that is the sun?
  static bool HasSun(vtkRenderer* renderer);

  // The eye over a water's plane, for what displaces its points. false: there is nothing to see.
  static bool ReadView(vtkRenderer* renderer, const vtkWaterSnapshot& water, water_grid_view* view);

private:
  water_camera PictureEye = water_camera(); // of a secondary view

  void ReadWaters(vtkRenderer* renderer, const std::vector<vtkWaterSnapshotPointer>& waters);
  void ReadSurface(const std::vector<vtkWaterSnapshotPointer>& waters);
  void ReadSkyboxes(vtkRenderer* renderer);
};

#endif
