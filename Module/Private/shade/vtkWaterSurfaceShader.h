// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSurfaceShader: a water's own draw: the shader of its features, its textures and uniforms.
#ifndef vtkWaterSurfaceShader_h
#define vtkWaterSurfaceShader_h

#include "vtkSmartPointer.h"
#include "vtkWaterBackdrop.h"
#include "vtkWaterCaustics.h"
#include "vtkWaterClipDistance.h"
#include "vtkWaterIsotropicTexture.h"
#include "vtkWaterSkyReader.h"
#include "vtkWaterSlopeTexture.h"
#include "vtkWaterSnapshot.h"
#include "vtkWaterSurfaceBuffer.h"
#include "vtkWaterVertexData.h"
#include "water_caustics_plan.h"
#include "water_grid.h"
#include "water_shafts.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkAbstractMapper;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkOpenGLRenderer;
class vtkShaderProgram;
class vtkTexture;
class vtkTextureObject;
class vtkWaterFog;
class vtkWaterRanks;
class vtkWindow;

class vtkWaterSurfaceShader
{
public:
  // What the reflection texture has of translucent things; all nullptr: nothing in it is.
  struct Layer
  {
    vtkTextureObject* Opaque = nullptr; // all else
    vtkTextureObject* Color = nullptr;  // times alpha, and alpha
    vtkTextureObject* Depth = nullptr;  // of all
  };

  // The water's own view of what lies beyond it; color nullptr: there is none.
  struct Beyond
  {
    vtkTextureObject* Color = nullptr;
    vtkTextureObject* Depth = nullptr;
    const double* PictureScale = nullptr; // part of it that the eye sees, per axis
    Layer Translucent;                    // color nullptr: nothing is kept apart
  };

  // What keeps the sun off; depth nullptr: nothing does, or it is not known.
  struct Shade
  {
    vtkTextureObject* Depth = nullptr;
    double Scale = 0.0; // water_plan.sun_view_depth
    double Bottom = 0.0;
  };

  // What may be the sky, water_sky_view.h; color nullptr: there is no view of it.
  struct Around
  {
    vtkTextureObject* Color = nullptr;
    vtkTextureObject* Depth = nullptr;
    const water_plan* Plan = nullptr; // that it was drawn by
  };

  // What is drawn.
  struct Inputs
  {
    vtkOpenGLRenderer* Renderer = nullptr;
    vtkWaterFog* Fog = nullptr;             // of the renderer
    const water_plan* Plan = nullptr;       // nullptr: show the plain colour
    vtkTextureObject* Reflection = nullptr; // any texture when nothing is reflected
    vtkTextureObject* ReflectionDepth = nullptr;
    Layer Translucent;
    Beyond OwnView;
    Shade SunView;
    Around SkyView;
    vtkTextureObject* PeelColor = nullptr; // nullptr: there is no peel
    vtkTextureObject* PeelDepth = nullptr;
    int MostSteps = 0; // of the march
    int MostProbes = 0;
    bool IsAtRest = true; // the surface is the snapshot's mesh; false: waves move it
    const water_grid_view* View = nullptr; // waves move the vertices; nullptr: they do not
    const double* RowDir = nullptr;        // of the grid under them
    double HorizonDepths[3] = {};          // of an endless surface: water_horizon_depths
    bool IsSecondary = false;              // in the mirrored view of another water
    bool IsWarmUp = false;                 // no pixel is drawn: what takes long is made
    vtkWaterSkyTextures Sky;               // of the plan's sky
    vtkWaterRanks* Ranks = nullptr;        // that show the scene together; nullptr: there are none
    bool AddsFog = false;                  // to all that the eye sees, which is in the water
  };

  // Of the last draw.
  water_feature_set GetFeatures() const { return this->Features; }
  bool GetIsSecondary() const { return this->Drawn.IsSecondary; }
  bool GetIsEndless() const { return this->Water && this->Water->IsEndless; }

  // The source that defines waterShade, for the triangles of the surface.
  static std::string GetShader(water_feature_set features);

  // Is the surface drawn into a buffer, from which it is shaded?
  bool GetIsBuffered() const { return this->Has(WATER_FEATURE_BUFFERED); }
  vtkWaterSurfaceBuffer Buffer;
  // Shades what the buffer has; the mapper is that of the mesh. false: the driver refuses that.
  bool ShadeBuffer(vtkAbstractMapper* mapper);

  // The source of the fragments that follow light from the surface to the bed.
  static std::string GetPhotonShader(water_feature_set features);

  // The source that defines waterKeepDepth, and waterDisplace or waterMeasure, for vertices.
  static std::string GetVertexShader(water_feature_set features);

  // Has it a picture of its surroundings, which it reflects in place of the scene's sky?
  static bool HasOwnSky(const vtkWaterSnapshot& water);

  // Is another shader needed than for the last draw?
  bool UpdateFeatures(water_feature_set features);

  // The driver has refused the shader of these features: the plain colour is shown until there are
  // others, or another context.
  void SetIsRefused() { this->IsRefused = true; }
  bool GetIsRefused() const { return this->IsRefused; }

  // VTK draws with the program that was in use before when one does not compile: none.
  void ReleaseShader();

  // The surface is drawn between the two.
  void Begin(const vtkWaterSnapshotPointer& water, const Inputs& inputs);
  void End();

  // vertices  that are about to be drawn
  void SetParameters(
    vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkOpenGLVertexArrayObject* vertices);

  // After the mapper has drawn.
  void EndDraw() { this->ShoreClip.Off(); }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkOpenGLRenderWindow* GetWindow() const;
  bool Has(water_feature_set features) const { return (this->Features & features) != 0; }
  void Use(const char* name, vtkTextureObject* texture)
  {
    this->Active.emplace_back(name, texture);
  }
  void Activate(); // what is in use
  // Colour of infinitely deep water in the light of what is drawn.
  void FindDeepColor(double color[3]) const;
  void FindExtinction(double extinction[3]) const;
  // Coefficients of the water as they are used in this scene.
  void Dim(const double coefficients[3], double dimmed[3]) const;
  void BeginMedium(const int viewport_px[4]);
  bool HasOwnView() const; // is it that, and not the picture, what is seen through the water?
  void BeginWaves();
  void BeginSea();
  void BeginOldFoam();
  void BeginReflection(const int viewport_px[4]);
  void UseReflection(); // what rays in the reflection texture look up
  void BeginSky();
  void BindSky(const char* name, vtkTexture* texture);
  // Light that waves gather, and the fog that is drawn in it, of textures that are active.
  void BeginLight(const int viewport_px[4]);
  // Draws the light on the bed.
  void BeginCaustics(const int viewport_px[4]);
  // The same of the light around an eye in the water.
  void BeginShafts(const int viewport_px[4]);
  water_caustics_input FindCausticsInput(const int viewport_px[4]) const;
  // Between an eye in the water and all that is drawn so far.
  void DrawFog();
  void UploadWaves(const double origin[2]);
  void UploadNormalMap(size_t number);
  void UploadHulls();
  // Samplers of different kinds may not share a texture unit, even if nothing is read from them: GL
  // then draws nothing. A new program has all of them at unit 0, and a draw that only asks whether
  // the water is visible has no textures.
  void PartSamplers(vtkShaderProgram* program);
  void SetDisplacement(vtkShaderProgram* program);
  void SetVertexHeights(vtkShaderProgram* program, vtkAbstractMapper* mapper);
  // Of a mesh that is not flat, from its vertex origin.
  void SetVertexPlaces(vtkShaderProgram* program, const double shift[3], const double scale[3],
    const double origin[3]);
  // A sampler that is not looked at, but must have a texture.
  void SetNoTexture(vtkShaderProgram* program, const char* name);
  void SetViewParameters(vtkShaderProgram* program);
  void SetMediumParameters(vtkShaderProgram* program);
  void SetRegionParameters(vtkShaderProgram* program); // of a rank
  void SetReflectionParameters(vtkShaderProgram* program);
  void SetSkyParameters(vtkShaderProgram* program);
  void SetSunParameters(vtkShaderProgram* program);
  void SetCausticParameters(vtkShaderProgram* program);
  void SetPhotonParameters(vtkShaderProgram* program);
  void SetHazeParameters(vtkShaderProgram* program);
  void SetShaftParameters(vtkShaderProgram* program);
  void SetSeaParameters(vtkShaderProgram* program);
  void SetNormalMapParameters(vtkShaderProgram* program);
  void SetFlowParameters(vtkShaderProgram* program);

  // Of arrays of the mesh.
  void SetVertexData(
    vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkOpenGLVertexArrayObject* vertices);
  // Cuts a mesh at the shore while it is drawn.
  void CutShore(
    vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkOpenGLVertexArrayObject* vertices);
  // Says what is wrong with an array's values, once.
  void TellWrong(const vtkWaterVertexData& data, const char* setting, const std::string& name,
    std::string& said) const;
  void SetMatterParameters(vtkShaderProgram* program);

  water_feature_set Features = 0;
  bool IsRefused = false;
  // Drawing runs the user's observers, who may drop any of these.
  vtkWaterSnapshotPointer Water; // that is drawn
  Inputs Drawn;
  bool IsFlat = false; // it is seen as if it lay in the plane
  water_plan Plan = water_plan();
  std::vector<std::pair<const char*, vtkSmartPointer<vtkTextureObject>>> Active; // by name
  std::vector<std::pair<const char*, std::unique_ptr<vtkWaterIsotropicTexture>>>
    SkyTextures;                           // bound, by name
  vtkSmartPointer<vtkTextureObject> Waves; // a row per wave
  int WaveCount = 0;
  vtkSmartPointer<vtkTextureObject> Hulls; // the table of what floats in the water
  vtkWaterHullTablePointer HullTable;      // that it has
  bool IsSteep = false;                    // some of them move their points
  bool HasSea = false;                     // brought to the time of the draw
  const char* SeaDetour = nullptr;         // of which has been spoken
  bool IsSeaFlat = false;                  // for want of memory, which has been said
  bool IsFoamFresh = false;                // the same of what whitecaps leave
  vtkWaterSlopeTexture NormalMaps[vtkWaterNormalMaps::Limit];
  std::pair<vtkTexture*, vtkMTimeType> NormalMapTimes[vtkWaterNormalMaps::Limit] = {}; // of those
  double NormalMapTexels[vtkWaterNormalMaps::Limit] = {};                              // their size
  vtkWaterVertexData Flow;
  vtkWaterVertexData Matter;
  vtkWaterVertexData Foam;
  vtkWaterVertexData Shore;
  vtkWaterClipDistance ShoreClip{ 1 };
  std::string MatterWrong; // with its values, which has been said of the array
  std::string FoamWrong;
  vtkWaterCaustics Caustics;
  water_caustics Light = water_caustics(); // of the draw
  bool HasLight = false;
  vtkWaterCaustics ShaftLight;
  water_shafts Shafts = water_shafts(); // of the draw
  bool HasShafts = false;
  vtkWaterBackdrop Backdrop;
  bool HasBackdrop = false;
  double PictureScale[2] = { 1.0, 1.0 }; // part that the eye sees of what the water shows
};

#endif
