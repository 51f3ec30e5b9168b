// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterActorInternals.h: what vtkWaterActor keeps besides what is set, for its source files: the
// source of its snapshots, its surface, and what is wrong with it.
#ifndef vtkWaterActorInternals_h
#define vtkWaterActorInternals_h

#include "vtkMapper.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWaterActor.h"
#include "vtkWaterGrid.h"
#include "vtkWaterGround.h"
#include "vtkWaterHorizon.h"
#include "vtkWaterHulls.h"
#include "vtkWaterMeshHeights.h"
#include "vtkWaterMeshPlacement.h"
#include "vtkWaterReflectionPass.h"
#include "vtkWaterSea.h"
#include "vtkWaterSecondarySurface.h"
#include "vtkWaterSheet.h"
#include "vtkWaterSource.h"
#include "vtkWaterSurfaceShader.h"
#include "vtkWaterVertexData.h"
#include "vtkWaterWarmUp.h"
#include "vtkWeakPointer.h"
#include "water_buffer.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkWaterOcclusion;
class vtkWaterRanks;

struct vtkWaterActor::Internals : public vtkWaterSource
{
  struct SourcedError
  {
    std::string Kind; // the same for the same error with another value
    std::string Text;
    vtkWeakPointer<vtkRenderer> Renderer;
    bool IsOfSheet = false; // and of no renderer
  };

  explicit Internals(vtkWaterActor* self)
    : Self(self)
    , WarmUp(*this)
  {
  }

  vtkActor* GetProp() override { return this->Self; }
  vtkWaterSnapshotPointer Take(vtkRenderer* renderer) override;
  void ReadPlane(water_plane* plane, double origin[3]) override;
  bool IsClear() override;
  void Report(vtkRenderer* renderer, const vtkWaterError& error) override;
  bool HasSheetError() const override;
  void SetSceneBounds(const double* bounds) override;
  bool HasAutomaticExtent() override;
  bool IsGroundJoined() override;
  std::vector<double> ReadGroundPart() override;
  std::vector<double> JoinGround(const std::vector<double>& parts) override;
  void JoinGroundBelow(const std::vector<double>& parts) override;
  void SetMayMirror(bool mayMirror) override;
  void SetDrawnMapper(vtkMapper* mapper) override;
  void SetIsDrawing(bool isDrawing) override;
  void Probe(vtkRenderer* renderer) override;
  vtkWaterReflection& GetOwnReflection() override;
  vtkWaterReflection* GetComposedReflection() override;
  void SetComposedPass(vtkWaterReflectionPass* pass) override { this->Self->ComposedPass = pass; }

  // What a surface that is not the own sheet at rest is. Warns of a mesh of the user's that does
  // not lie in the plane.
  void ReadMesh(const water_plane& plane, vtkWaterMesh* mesh);
  // The colour of vtkActor's own property is the water's, unless the look has one that was set.
  void ColorLook(vtkWaterLook* look);
  // Do waves move the surface itself?
  bool IsDisplaced() const;
  // The look in the scene's unit.
  void Describe(vtkWaterLook& look);
  // What the water's renderers show, on all ranks.
  void FindSceneBounds(const std::vector<vtkRenderer*>& scene, double bounds[6]);
  const vtkWaterRanks& GetRanks(); // of the pass that draws its mirrored view
  // Is a frame being rendered whose water all ranks draw, whatever each of them sees of it?
  bool IsDrawnOnAllRanks();
  // The same, while cullers ask.
  bool IsKeptFromCullers();
  // What the eye sees of an endless sheet, in a frame that ranks render together: IceT composites
  // their pictures only where there are bounds. false: no bounds are needed, or none of it is seen.
  bool FindSeenBounds(double bounds[6]);
  // Of what the water's renderers show, units; 0: there is nothing.
  double GetSceneDiagonal();
  // The waves at the actor's time, in the scene's unit.
  std::vector<water_wave_term> GetWaveTerms(const vtkWaterLook& look) const;
  // The wind sea at the actor's time; nullptr when it is off.
  vtkWaterSea* GetSeaAtTime();
  // Asks the wind sea at the actor's time, if there is one. false: there is no memory for it.
  bool AskSea(const std::function<void(vtkWaterSea&)>& ask);
  // The surface over a place, of all waves at the actor's time; false: it is not known.
  bool FindSurface(double x, double y, water_wave_point* point);
  // The same over many places, count of x, y and a third number.
  bool FindSurfaces(const double* places, size_t count, water_wave_point* points);
  // Takes heights over the plane to heights over the waves: count of x, y, height. false: the waves
  // are not known.
  bool LowerByWaves(double* places, size_t count);
  // Adds the waterlines of what floats in the water. Says what is wrong with it, once.
  void CutHulls(vtkWaterSnapshot& water);
  // Can the mesh's array of this name be used? Says what is wrong with it, once.
  //
  // setting  that names it
  // without  what there is without it
  // said     what was said last
  bool CanUse(const vtkWaterVertexData::Use& use, const std::string& name, const char* setting,
    const char* without, std::string& said);
  // The plane as it is used, and as it was given.
  void ReadPlaces(vtkWaterSnapshot& water);
  // Where the surface is, and its mesh.
  void ReadExtent(vtkWaterSnapshot& water);
  // Lets arrays of the mesh add to the features that are known of it.
  void ReadData(vtkWaterSnapshot& water);
  // Lets the current of the mesh carry the waves.
  void ReadFlow(vtkWaterSnapshot& water);
  // Lets data of the mesh say what matter the water carries.
  void ReadMatter(vtkWaterSnapshot& water);
  // The same of how much foam there is; before the look is known, which depends on it.
  void ReadFoam(vtkWaterSnapshot& water);
  // The own sheet as this eye sees it; a user's mapper is drawn as it is.
  vtkMapper* LayGrid(const vtkWaterSnapshot& water, const water_grid_view& view, vtkMapper* mapper);
  // The endless sheet as the renderer's active camera sees it; a user's mapper, or a sheet with an
  // end, is drawn as it is. nullptr: nothing of it is seen.
  //
  // eye   of that camera
  // kept  where the sheet is wanted, as in water_horizon_make
  vtkMapper* LayHorizon(const vtkWaterSnapshot& water, vtkRenderer* renderer,
    const water_camera& eye, const double* kept, vtkMapper* mapper);
  // The mapper to draw with where nothing cuts a mesh at the shore: the plain shader does not.
  vtkMapper* CutMapper(vtkMapper* mapper) const;
  // Draws the surface with its shader, or with the plain one when the driver refuses that. Without
  // a mapper there is nothing to draw.
  void DrawSurface(vtkWaterSurfaceShader& surface, vtkRenderer* renderer, vtkMapper* mapper);
  // Should the surface be shaded once a pixel?
  water_buffer_use JudgeBuffer(const vtkWaterSnapshot& water,
    const vtkWaterSurfaceShader::Inputs& inputs, water_feature_set features, bool isSoftware,
    vtkMapper* mapper);
  // Draws it that way. false: nothing is drawn, the driver refuses that.
  bool DrawBuffered(vtkRenderer* renderer, vtkMapper* mapper, vtkWaterOcclusion& occlusion);

  vtkWaterActor* Self;
  vtkWaterSheet Sheet;
  vtkWaterGround Ground;
  vtkWaterMeshPlacement Placement; // of a mesh in the sheet's place
  vtkWaterMeshHeights Heights;     // of the same
  vtkWaterGrid Grid;               // the sheet when it is displaced
  vtkWaterHorizon Horizon;         // the sheet when it has no end
  vtkWaterSurfaceShader Surface;
  vtkWaterSecondarySurface Secondary;        // that reflects the sky
  vtkWaterSecondarySurface SecondaryOfScene; // that looks a secondary view up
  vtkWaterSea Sea;
  vtkWaterHulls Hulls;
  std::string HullError; // of the last frame
  std::string FlowError; // the same
  std::string MatterError;
  std::string FoamError;
  vtkWaterHullTablePointer HullTable;
  std::pair<vtkMTimeType, double> HullTime = { 0, 0.0 }; // that it is of, and the scene's unit then
  vtkWaterWarmUp WarmUp;
  vtkSmartPointer<vtkMapper> OtherMapper; // the drawn one; while it draws, the actor's own
  bool IsDrawing = false;
  std::vector<SourcedError> Errors;
  bool IsUpdatingSheet = false;
  bool MayMirror = true;
  bool IsSeaUnknown = false;      // for want of memory, which has been said
  bool HasRankBounds = false;     // the scene is that of several ranks
  double RankBounds[6] = {};      // of them all
  vtkMTimeType FittedFrame = 0;   // of which the sheet is
  vtkMTimeType MeasuredFrame = 0; // of which the diagonal is
  double SceneDiagonal = 0.0;
  bool IsProbing = false;                         // is drawn only to be counted
  std::weak_ptr<const vtkWaterSnapshot> Snapshot; // held by the frame: the user's objects may go
  vtkMTimeType SnapshotFrame = 0;
  vtkMTimeType SnapshotTime = 0; // of the last change
};

#endif
