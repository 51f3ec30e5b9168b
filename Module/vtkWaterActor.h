// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterActor
 * @brief   a water surface that reflects its scene
 *
 * Add the actor to a renderer. Before each frame in which the water is visible, the actor renders
 * the mirrored scene into a texture and looks up its reflection there. The renderer's other
 * settings (FXAA, SSAO, depth peeling, multisampling, stereo, selection, the user's own passes) do
 * not change.
 *
 * @code
 * vtkNew<vtkWaterActor> water;
 * water->SetLevel(355.0);
 * renderer->AddActor(water);
 * @endcode
 *
 * Without a mapper, the actor builds its own sheet over the bounds of the scene, or to the horizon
 * (SetSheetToHorizon). A user's mapper (a lake polygon, a terrain-clipped sheet) replaces this
 * sheet; SetMapper(nullptr) restores it. The plane is always the mirror. To move the water, move
 * the plane: the actor's position moves only the surface. A user's mesh should lie in the plane.
 *
 * A problem with the scene (a zero normal, an empty scene, ...) is reported once per change by an
 * ErrorEvent of this object. The surface then shows its plain colour. A camera exactly on the plane
 * sees the view from slightly above it (a ten thousandth of its near plane's distance).
 *
 * @sa vtkWaterProperty vtkWaterReflectionPass
 */
#ifndef vtkWaterActor_h
#define vtkWaterActor_h

#include "vtkOpenGLActor.h"
#include "vtkRenderingWaterModule.h" // for the export macro
#include "vtkSmartPointer.h"         // for members
#include "vtkWeakPointer.h"          // for members
#include "vtkWrappingHints.h"        // for VTK_WRAPEXCLUDE

#include <array>
#include <memory> // for std::unique_ptr
#include <string>
#include <vector>

class vtkWaterSource;

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkOpenGLRenderer;
class vtkPlane;
class vtkRenderer;
class vtkWaterProperty;
class vtkWaterReflectionPass;

class VTKRENDERINGWATER_EXPORT vtkWaterActor : public vtkOpenGLActor
{
public:
  static vtkWaterActor* New();
  vtkTypeMacro(vtkWaterActor, vtkOpenGLActor);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Makes the water a horizontal plane at height z with +z up, in the scene's unit. A finite
   * value, at most 1e100 in size (the water reports an error for a larger one). Values that are not
   * finite are rejected with an error and the level stays unchanged. This call replaces the plane
   * with a new one. GetLevel returns the z of the plane's origin. Default is 0.
   */
  void SetLevel(double z);
  double GetLevel();
  ///@}

  ///@{
  /**
   * The plane of the water, with any orientation; its normal points out of the water. The actor
   * keeps a reference to it: changing the plane moves the water. It is never null: nullptr resets
   * it to level 0, the default.
   */
  void SetPlane(vtkPlane* plane);
  vtkPlane* GetPlane();
  ///@}

  ///@{
  /**
   * Bounds of the built-in sheet: xmin, xmax, ymin, ymax in the plane's own axes, in the scene's
   * unit. The origin of these axes is the plane's origin. The first axis is the world's x axis
   * projected onto the plane (y if the normal is within 45 degrees of x); the second is the cross
   * product of the normal and the first. For a horizontal sheet they are the world's x and y. The
   * values must be finite, with min < max; others are rejected with an error. This call turns off
   * SetSheetToHorizon and SetSheetToAutomatic. Default is none: the sheet covers the bounds of the
   * scene (ResetSheetBounds).
   */
  void SetSheetBounds(double xmin, double xmax, double ymin, double ymax);
  void SetSheetBounds(const double bounds[4])
  {
    this->SetSheetBounds(bounds[0], bounds[1], bounds[2], bounds[3]);
  }
  void ResetSheetBounds();
  vtkGetVector4Macro(SheetBounds, double);
  vtkGetMacro(UseSheetBounds, bool);
  ///@}

  ///@{
  /**
   * Extends the built-in sheet to the horizon: it fills the visible part of the plane for each
   * camera. Any plane has a horizon, but a parallel camera sees none. The sheet is not part of the
   * scene's bounds (GetBounds returns nullptr, except while several ranks draw a frame), is never
   * culled, and is not cut at the camera's near and far planes, which ResetCamera and
   * ResetCameraClippingRange set for the rest of the scene. The actor's position does not move it.
   * SetSheetBounds and ResetSheetBounds replace this setting; a user's mapper takes precedence over
   * it. Default is off.
   */
  void SetSheetToHorizon();
  vtkGetMacro(SheetToHorizon, bool);
  ///@}

  ///@{
  /**
   * Chooses the extent of the built-in sheet from the scene: as wide as the scene if it has ground
   * under all of its water, such as a terrain or a basin with a floor; to the horizon if objects
   * stand or float in open water. The choice is repeated when the scene changes; GetSheetToHorizon
   * returns whether the sheet now reaches to the horizon. SetSheetBounds, ResetSheetBounds and
   * SetSheetToHorizon replace this setting; call it again after them. Default is off.
   */
  void SetSheetToAutomatic();
  vtkGetMacro(SheetIsAutomatic, bool);
  ///@}

  ///@{
  /**
   * The look of the water. Never null: nullptr creates a new default one. ShallowCopy shares it; to
   * give a copy its own look, use vtkWaterProperty::DeepCopy. Do not confuse it with vtkActor's own
   * property. That property's representation and culling keep their meaning; its opacity
   * multiplies the water's. Its diffuse colour (SetColor) becomes the water's colour unless it is
   * white, VTK's default, or vtkWaterProperty::SetDeepColor was called. Edges and lighting are not
   * used.
   */
  void SetWaterProperty(vtkWaterProperty* property);
  vtkWaterProperty* GetWaterProperty();
  ///@}

  ///@{
  /**
   * Whether this water reflects the scene as its vtkWaterProperty says. Off: it reflects only the
   * sky, as with the ReflectionSource ENVIRONMENT, and no mirrored view is rendered for it. Default
   * is on.
   */
  void SetSceneReflection(bool isOn);
  vtkGetMacro(SceneReflection, bool);
  vtkBooleanMacro(SceneReflection, bool);
  ///@}

  ///@{
  /**
   * Whether the slopes of a user's mesh turn its reflections, as waves do. The slopes are those of
   * its point normals or, without any, of its triangles. Off: each point reflects as if the surface
   * were level there. Has no effect on a mesh that lies in its plane, or whose points are displaced
   * by waves (WaveGeometry). Default is on.
   */
  void SetMeshSlopes(bool isOn);
  vtkGetMacro(MeshSlopes, bool);
  vtkBooleanMacro(MeshSlopes, bool);
  ///@}

  ///@{
  /**
   * Name of an array of a user's mesh with the current that carries the waves: velocities in m/s
   * along the mesh's axes, with 2 or 3 components, per point or per cell. The waves (sines, wind
   * sea, normal maps) are carried at the velocity of each place, in addition to their own motion,
   * and are stretched where the current accelerates. Has no effect without waves, on waves that
   * displace the surface (WaveGeometry), or on the built-in sheet; caustics do not move with the
   * current. Velocities that are not finite, or faster than 1e4 m/s, count as 0. A missing array,
   * or one with another number of components, is reported as an error, once; there is then no
   * current. Changes of the array take effect in the next frame. The actor's matrix rotates
   * velocities, but does not scale them. Empty, the default: no current. Source: Vlachos 2010,
   * "Water flow in Portal 2" (two-phase flow map).
   */
  void SetFlowArrayName(const std::string& name);
  std::string GetFlowArrayName() const { return this->FlowArrayName; }
  ///@}

  ///@{
  /**
   * Seconds for which the current of FlowArrayName carries a layer of waves before the layer starts
   * again; two layers alternate. Where the velocity changes along this path, the waves are
   * stretched, less so with a shorter period. With a longer period, the eye can follow a wave
   * farther. The current hardly carries waves that are longer than the distance it covers in half a
   * period. In [1e-3, 1e6]; other values are rejected with an error. Default is 4.
   */
  void SetFlowPeriod(double seconds);
  vtkGetMacro(FlowPeriod, double);
  ///@}

  ///@{
  /**
   * Name of an array of a user's mesh with the concentration of matter that the water carries, such
   * as sediment, algae or a dye: one number per point or cell, finite and not negative. It absorbs
   * and scatters light (MatterAbsorption, MatterScattering) in addition to the water itself. Needs
   * vtkWaterProperty's Refraction, and a mapper with one data set. Along its whole refracted path,
   * each ray sees the concentration at the point of the surface where it enters the water: after x
   * metres exp(-(absorption + scattering) x) of the light remains. With the DeepColorMode MEDIUM
   * the colour of deep water follows the matter; a given colour does not. An eye in the water looks
   * through clear water. Where the concentration is 0, the picture is the same as without the
   * array. Negative values and values that are not finite count as 0; one warning reports them. A
   * missing array, or one with several components, is reported as an error, once; the water is then
   * clear. Changes of the array take effect in the next frame. Empty, the default: no matter.
   *
   * Source: Beer 1852.
   */
  void SetMatterArrayName(const std::string& name);
  std::string GetMatterArrayName() const { return this->MatterArrayName; }
  ///@}

  ///@{
  /**
   * What the matter of MatterArrayName absorbs, in 1/m per unit of its concentration, at 650, 550
   * and 450 nm (red, green, blue): in [0, 1e9]; other values are rejected with an error. Default is
   * (0.0032, 0.0110, 0.0376): suspended mineral sediment with concentrations in g/m^3 (equal to
   * mg/l).
   *
   * Source: Babin et al. 2003.
   */
  void SetMatterAbsorption(double red, double green, double blue);
  void SetMatterAbsorption(const double perUnit[3])
  {
    this->SetMatterAbsorption(perUnit[0], perUnit[1], perUnit[2]);
  }
  vtkGetVector3Macro(MatterAbsorption, double);
  ///@}

  ///@{
  /**
   * What the matter of MatterArrayName scatters, in 1/m per unit of its concentration, at 650, 550
   * and 450 nm (red, green, blue): in [0, 1e9]; other values are rejected with an error. As for
   * vtkWaterProperty's Scattering, count only light that is scattered backward; a dye scatters
   * nothing. Default is (0.012, 0.012, 0.012), that of the sediment of MatterAbsorption.
   *
   * Source: Neukermans et al. 2012.
   */
  void SetMatterScattering(double red, double green, double blue);
  void SetMatterScattering(const double perUnit[3])
  {
    this->SetMatterScattering(perUnit[0], perUnit[1], perUnit[2]);
  }
  vtkGetVector3Macro(MatterScattering, double);
  ///@}

  ///@{
  /**
   * Name of an array of a user's mesh that says how much foam there is: one number per point or
   * cell, whose meaning FoamMeasure sets. This foam looks like the water's other foam. Where both
   * are present, the larger cover counts. Needs a mapper with one data set.
   * Negative values and values that are not finite count as 0, and covers above 1 as 1; one warning
   * reports them. A missing array, or one with several components, is reported as an error,
   * once; there is then no foam from data. Changes of the array take effect in the next frame.
   * Empty, the default: no foam from data.
   */
  void SetFoamArrayName(const std::string& name);
  std::string GetFoamArrayName() const { return this->FoamArrayName; }
  ///@}

  enum FoamMeasures
  {
    COVER = 0,
    FROUDE_NUMBER = 1,
    BREAKING_INDEX = 2
  };

  ///@{
  /**
   * What the values of FoamArrayName are. COVER: the share of the surface that foam covers, in [0,
   * 1], such as the fraction of air at the surface. FROUDE_NUMBER: velocity over sqrt(g depth);
   * foam begins at 1, where a flow becomes faster than its waves, and covers everything from 1.7
   * on, where hydraulic jumps have breaking rollers. BREAKING_INDEX: height of the waves over the
   * depth; foam begins at 0.78, where waves break on a level bed, and covers everything from 1.13
   * on, where they break on a slope of 1 in 20. Between the two values the cover increases
   * linearly; this part has no source. Other numbers are rejected with an error. Default is COVER.
   *
   * Source: Chow 1959, "Open-Channel Hydraulics"; McCowan 1894; Weggel 1972.
   */
  void SetFoamMeasure(int measure);
  vtkGetMacro(FoamMeasure, int);
  void SetFoamMeasureToCover() { this->SetFoamMeasure(COVER); }
  void SetFoamMeasureToFroudeNumber() { this->SetFoamMeasure(FROUDE_NUMBER); }
  void SetFoamMeasureToBreakingIndex() { this->SetFoamMeasure(BREAKING_INDEX); }
  const char* GetFoamMeasureAsString() const;
  ///@}

  ///@{
  /**
   * Time of the waves in seconds, in [-1e15, 1e15]; other values are rejected with an error. The
   * picture depends only on this number, not on earlier frames. Default is 0.
   */
  void SetTime(double seconds);
  vtkGetMacro(Time, double);
  ///@}

  ///@{
  /**
   * Hulls that float in the water: boats, caissons, pontoons. No water is drawn inside a hull's
   * waterline, the line in which the surface of its mesh cuts the water surface, waves included.
   * The hold of an open boat is therefore dry, even if its walls are thick. A hull is the geometry
   * of the actor's mapper at the actor's position. The water only reads the actor; add it to the
   * renderer to show it (or show another actor in its place and pass one with a coarser mesh here).
   * The actor's visibility has no effect, nor has an assembly that contains it. Its data must be
   * one data set, not composite data. The mesh must be closed where the water cuts it: each edge
   * there must belong to two polygons, and a rim must lie above the highest wave. A hull that is
   * not closed there, a hull whose rim is under water, and nullptr are reported as an error, once;
   * such a hull has water inside. Everything inside a waterline is dry, including a moon pool.
   * Waves are evaluated at the mesh's points near the surface. Adding a hull twice has no effect.
   * Default: no hulls.
   */
  void AddHull(vtkActor* hull);
  void RemoveHull(vtkActor* hull);
  void RemoveAllHulls();
  int GetNumberOfHulls();
  // Returns nullptr if there is no hull of this number. Numbers start at 0.
  vtkActor* GetHull(int number);
  ///@}

  ///@{
  /**
   * Height and normal of the waves at a point, at the actor's time, for example for buoys and
   * picks. x, y and the normal's first two components are in the plane's own axes (SetSheetBounds);
   * its third component is along the plane's normal. The height is above the plane, in the scene's
   * unit. A wind sea is included, bilinear between the points of its tiles. Without waves the
   * results are 0 and (0, 0, 1). They are NaN if the point is not finite.
   */
  double GetWaveHeight(double x, double y);
  void GetWaveNormal(double x, double y, double normal[3]) VTK_SIZEHINT(normal, 3);
  ///@}

  /**
   * Unit vector from the water to a point in its sky, such as the sun. The azimuth is in degrees
   * from the plane's second axis towards the first (from north towards east for a horizontal
   * plane), the elevation in degrees above the plane; both must be finite. NaN if they are not, or
   * if the plane has no normal.
   */
  void GetSkyDirection(double azimuth, double elevation, double direction[3])
    VTK_SIZEHINT(direction, 3);

  /**
   * Position of the polygons of a user's mesh relative to the plane, in four numbers: their mean
   * height; the largest accepted absolute value of that height; their mean angle to the plane in
   * degrees; the largest accepted angle. A mesh beyond these limits is drawn, with a warning.
   * Returns false, and four NaN, for the built-in sheet and for a mapper whose polygons are not
   * known.
   */
  bool GetMeshPlacement(double placement[4]) VTK_SIZEHINT(placement, 4);

  /**
   * The pass that renders this water's reflection. It is the actor's own pass until a pass that the
   * user added to the renderer's chain has rendered this water. Never null.
   */
  vtkWaterReflectionPass* GetReflectionPass();

  /**
   * Text of the ErrorEvent for the first problem in the last frame: in the scene, otherwise in a
   * hull, otherwise in the current, the matter or the foam from data. Empty without a problem.
   * Values that setters have rejected are not included.
   */
  const char* GetLastError() const;

  ///@{
  /**
   * vtkProp, vtkProp3D and vtkActor interface; called by the renderer.
   */
  void SetAllocatedRenderTime(double seconds, vtkViewport* viewport) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;
  int RenderOverlay(vtkViewport* viewport) override;
  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;
  vtkTypeBool HasOpaqueGeometry() override;
  vtkTypeBool HasTranslucentPolygonalGeometry() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  using Superclass::GetBounds;
  double* GetBounds() VTK_SIZEHINT(6) override;
  void SetMapper(vtkMapper* mapper) override;
  void ShallowCopy(vtkProp* prop) override;
  vtkMTimeType GetMTime() override;
  ///@}

  /**
   * The value of SetPickable; 0 while the sheet reaches to the horizon, because pickers need
   * bounds, which it does not have. During a selection of pixels, which needs none, the value of
   * SetPickable again.
   */
  vtkTypeBool GetPickable() override;

  /**
   * Internal handle of the module; not for use.
   */
  VTK_WRAPEXCLUDE vtkWaterSource* GetSource();

protected:
  vtkWaterActor();
  ~vtkWaterActor() override;

private:
  vtkWaterActor(const vtkWaterActor&) = delete;
  void operator=(const vtkWaterActor&) = delete;

  struct Internals; // the source

  bool UsesOwnSheet();
  bool ShowsOpaqueData();
  void SetMatter(const char* name, double (&member)[3], const std::array<double, 3>& given);
  // Does the built-in sheet reach to the horizon?
  bool IsEndless() { return this->SheetToHorizon && this->UsesOwnSheet(); }
  // What GetBounds returns between frames.
  double* FindBounds();
  // Decides whether an automatic sheet reaches to the horizon.
  void ChooseSheet(const std::vector<vtkRenderer*>& scene);
  // Fits the built-in sheet to the scene and the plane; does nothing with a user's mapper.
  void UpdateSheet();
  // Draws the surface in the mirrored view of another water.
  void RenderSecondary(vtkRenderer* renderer, vtkMapper* mapper);
  // Prepares the water before its geometry is drawn.
  //
  // Returns whether it is completely invisible.
  bool Prepare(vtkViewport* viewport, bool isDrawn);

  std::unique_ptr<Internals> Internal;
  vtkSmartPointer<vtkPlane> Plane;
  vtkSmartPointer<vtkWaterProperty> WaterProperty;
  vtkSmartPointer<vtkWaterReflectionPass> OwnPass;
  vtkWeakPointer<vtkWaterReflectionPass> ComposedPass;
  double SheetBounds[4] = { 0.0, 0.0, 0.0, 0.0 };
  bool UseSheetBounds = false;
  bool SheetToHorizon = false;
  bool SheetIsAutomatic = false;
  double DisplacedBounds[6] = {};
  double Time = 0.0;
  bool SceneReflection = true;
  bool MeshSlopes = true;
  std::string FlowArrayName;
  double FlowPeriod = 4.0;
  std::string MatterArrayName;
  double MatterAbsorption[3]; // that of sediment
  double MatterScattering[3];
  std::string FoamArrayName;
  int FoamMeasure = COVER;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif
