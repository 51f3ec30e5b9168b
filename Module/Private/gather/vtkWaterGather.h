// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterGather: VTK renderer, camera, props -> water_scene. The only reader of VTK state.
#ifndef vtkWaterGather_h
#define vtkWaterGather_h

#include "water_grid.h"
#include "water_plan.h"

#include <vector>

class vtkCamera;
class vtkLight;
class vtkProp;
class vtkProp3D;
class vtkPropCollection;
class vtkRenderer;
class vtkWaterActor;
class vtkWaterProperty;

struct vtkWaterGather
{
  water_scene scene;              // points into props
  std::vector<water_prop> props;  // of all view props, in the renderer's order
  std::vector<vtkProp*> vtkProps; // or what stands in for them
  vtkCamera* camera = nullptr;    // the one read last
  double WaveNumber = 0.0;        // typical of the waves, rad per unit; 0: not known
  bool IsRough = false;           // one of the waters blurs its reflection
  bool HasMarchedRays = false;    // one of the waters follows rays through the reflection texture

  // Reads everything but the settings of the pass (texture_scale, max_texture_px, clip_margin).
  //
  // waters  the surfaces that share the plane of the first; at least one
  void Read(
    vtkRenderer* renderer, const std::vector<vtkWaterActor*>& waters, const int viewport_px[2]);

  // The first water of a list of props, and all that share its plane.
  static std::vector<vtkWaterActor*> FindWaters(vtkProp** props, int count);

  static bool AreCoplanar(vtkWaterActor* a, vtkWaterActor* b);

  // Do they lie in one plane, as far as rounding can tell, whichever way their normals point?
  static bool AreInOnePlane(vtkWaterActor* a, vtkWaterActor* b);

  // Another water for the mirrored view of one, water_secondary.h.
  //
  // eye  of the picture; the renderer's camera is the mirrored one
  static water_scene ReadSecondary(
    vtkRenderer* renderer, vtkWaterActor* water, const water_camera& eye);

  // The camera alone: matrices of the renderer's active camera for its viewport.
  static water_camera ReadCamera(vtkRenderer* renderer);

  // The plane of a water, and a point of it: the origin, unless the vtkPlane has an offset or a
  // transform.
  static water_plane ReadPlane(vtkWaterActor* water);
  static void ReadPlaneOrigin(vtkWaterActor* water, double origin[3]);

  // The brightest scene light that is on; nullptr: there is none.
  static vtkLight* FindSun(vtkRenderer* renderer);

  // The eye over a water's plane, for what displaces its points. false: there is nothing to see.
  static bool ReadView(vtkRenderer* renderer, vtkWaterActor* water, water_grid_view* view);
  // Height of the waves that move a water's surface, over the plane where the eye is.
  static double ReadSurfaceHeight(vtkRenderer* renderer, vtkWaterActor* water);

  // What is drawn for a prop in the mirrored view: the prop, or what stands in for it.
  static vtkProp* FindStandIn(vtkProp* prop);

  // What the plan must know of a prop.
  //
  // drawn     the prop or its stand-in, which has the place
  // mirrored  the water that is mirrored at
  static water_prop ReadProp(vtkProp* prop, vtkProp* drawn, vtkWaterActor* mirrored);

  // vtkProp::GetBounds, which asks the pipeline whether it is up to date: ten times as long as all
  // else that is read of a prop. Of an actor that shows data as it is given, the data's time tells.
  static const double* GetBounds(vtkProp* prop);

  // Does the prop's place count in the world, and not on the device or in a room?
  static bool IsInWorld(vtkProp3D* prop);

  // The parts of a prop that is an assembly of any kind; nullptr: it is none.
  static vtkPropCollection* GetParts(vtkProp* prop);

  // Is the prop a water, or is one among its parts? Such an assembly must not be asked for its
  // bounds, nor drawn again, while it is being drawn: it would rebuild the list that it walks.
  static bool HoldsWater(vtkProp* prop);

  // Is it a volume, or is one among its parts or levels of detail?
  static bool HoldsVolume(vtkProp* prop);

  // The water's optics; constant 0 only if nothing is reflected.
  static water_look ReadLook(vtkWaterProperty* property);
};

#endif
