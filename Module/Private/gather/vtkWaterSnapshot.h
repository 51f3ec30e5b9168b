// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSnapshot: all that a frame knows of a water, as plain data: the actor and its property
// fill it once a frame, and nobody below them asks these classes for anything.
#ifndef vtkWaterSnapshot_h
#define vtkWaterSnapshot_h

#include "vtkSmartPointer.h"
#include "vtkTexture.h" // for members
#include "vtkWaterHulls.h"
#include "vtkWaterMeshHeights.h"
#include "vtkWaterNormalMaps.h"
#include "water_beyond.h"
#include "water_cascade.h"
#include "water_features.h"
#include "water_medium.h"
#include "water_old_foam.h"
#include "water_types.h"
#include "water_units.h"
#include "water_waves.h"

#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkObject;
class vtkWaterSea;

// Numbers as vtkWaterProperty has them, but with the lengths of waves and of ways through water in
// the scene's unit; the sea's stay in metres.
struct vtkWaterLook
{
  double MetresPerUnit = 1.0;
  double NaturalDepth = 0.0; // of the deepest bed; water_units_dim
  bool HasGround = false;    // under all of the water
  water_units_bed Bed = WATER_UNITS_BED_UNEVEN;
  double SceneDiagonal = 0.0;
  bool HidesWaves = false;          // they are too short for the scene
  water_look Optics = water_look(); // constant 0 only if nothing is reflected
  water_feature_look Has = water_feature_look();
  double DataOpacity = 1.0;
  double Opacity = 1.0;
  double DeepColor[3] = {};  // under white daylight, unless it is given
  bool HasDeepColor = false; // it is given, whatever the light
  water_medium Medium = water_medium();
  double Extinction[3] = {}; // absorption + scattering
  water_refraction_source RefractionSource = WATER_FROM_PICTURE;
  bool HasOwnView = false; // what lies below is seen in a view of its own, or in the picture
  double ShoreSoftness = 0.0;
  bool HasShoreSoftness = false; // it is given, however deep the bed is
  double DomePortRadius = 0.0;   // 0: none
  double SlopeVariance[3] = {};  // along, across a direction, degrees
  double MeanSlopes[3] = {};     // variances xx, yy, xy of all slopes, at all times
  double SlopeRMS = 0.0;
  double SlopeLookedUp = 0.0; // water_scene.slope_max
  double WaveNumber = 0.0;    // typical of the sines, rad/m; 0: not known
  double WaveHeightMax = 0.0;
  double WaveReach = 0.0; // how far steep waves move a point in the plane
  int WaveGridSize = 0;
  double Caustics = 0.0;
  double LightShafts = 0.0;
  bool RollsOff = true; // light over white does, unless tones are mapped
  double FoamDepth = 0.0;
  double FoamJacobian = 0.0; // crests are foam below it
  double FoamColor[3] = {};
  bool HasFoamData = false; // of a mesh, which say how much foam there is
  int Lookup = 0;
  double OffsetScale = 0.0;
  int RayTraceSteps = 0;
  int RayTraceProbes = 0;
  int RayTraceRays = 1;
  int RayTraceLayers = 1;
  double RayTraceFootprint = 1.0;
  int Output = 0;
  water_sea Sea = water_sea(); // in use if Has.has_sea
  water_cascades Cascades = water_cascades();
  double SeaBeyond[WATER_CASCADES_MAX + 1][3] = {}; // slope variances from a tile on: xx, yy, xy
  double SeaChoppiness = 0.0;
  double WhitecapJacobian = 0.0;             // crests of the sea are white below it
  water_old_foam OldFoam = water_old_foam(); // that such crests have left
  std::vector<vtkWaterNormalMaps::Layer> NormalMaps;
  vtkSmartPointer<vtkTexture> Environment;
  vtkSmartPointer<vtkObject> Property; // says what is wrong with them; compared
};

struct vtkWaterSnapshot
{
  vtkActor* Actor = nullptr;         // of the water: its mapper, VTK's property, its matrix
  water_plane Plane = water_plane(); // of any scale
  double Origin[3] = {};             // a point of it: the plane's own, unless that has an offset
  double GivenOrigin[3] = {};        // as the user gave them, for errors
  double GivenNormal[3] = {};
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 }; // min > max: it has no surface
  bool HasBorder = false;                                 // Sheet is where the water ends, at most
  bool IsSheet = false;                                   // the own one, and not moved
  double Sheet[4] = {};                                   // where it ends, in the plane's axes
  bool IsEndless = false;                                 // that reaches to the horizon
  vtkWaterMesh Mesh;                                      // that is drawn at rest
  double Time = 0.0;                                      // s
  vtkWaterLook Look;
  water_feature_set Features = 0;     // WATER_FEATURE_*
  std::vector<water_wave_term> Waves; // at the time
  vtkWaterHullTablePointer Hulls;     // what floats in it, at the time; nullptr: nothing
  std::string FlowArrayName;          // in use if WATER_FEATURE_FLOW is
  double FlowPeriod = 0.0;            // s
  double FlowLikeness = 0.0;          // of the waves that flow, water_flow.h
  double FlowBands[WATER_CASCADES_MAX][2] = { { 1.0, 2.0 }, { 1.0, 2.0 },
    { 1.0, 2.0 } };                           // of a wind sea's tiles, rad/unit
  std::string MatterArrayName;                // in use if WATER_FEATURE_MATTER is
  water_medium Matter = water_medium();       // per unit of concentration, and of the scene
  std::string FoamArrayName;                  // in use if WATER_FEATURE_FOAM_DATA is
  int FoamMeasure = 0;                        // water_foam_measure
  vtkWaterSea* Sea = nullptr;                 // the actor's; brought to the time by who needs it
  water_settings Settings = water_settings(); // of its own pass

  bool IsClear() const { return (this->Features & WATER_FEATURE_MEDIUM) != 0; }
  bool WantsOwnView() const { return this->IsClear() && this->Look.HasOwnView; }
  bool WantsSunView() const { return (this->Features & WATER_FEATURE_SHADOWS) != 0; }
  bool IsDisplaced() const { return (this->Features & WATER_FEATURE_DISPLACED) != 0; }
  // How many fields of the sea its texture has (vtkWaterSlopePasses).
  int GetSeaFields() const
  {
    const bool isWhite = (this->Features & WATER_FEATURE_WHITECAPS) != 0;
    return (this->Features & WATER_FEATURE_SEA_MOVES) != 0 ? 3 : isWhite ? 2 : 1;
  }
  bool IsRough() const { return (this->Features & WATER_FEATURE_ROUGH) != 0; }
  // Do rays go on behind edges?
  bool WantsPeel() const
  {
    return (this->Features & WATER_FEATURE_RAY_TRACED) != 0 && this->Look.RayTraceLayers > 1;
  }
  // Do the slopes of a mesh turn rays?
  bool IsSloped() const { return (this->Features & WATER_FEATURE_SLOPED) != 0; }
  bool NeedsRays() const { return water_features_needs_rays(&this->Look.Has) || this->IsSloped(); }
};

using vtkWaterSnapshotPointer = std::shared_ptr<const vtkWaterSnapshot>;

#endif
