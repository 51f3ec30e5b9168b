// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterActor
 * @brief   a water surface that reflects its scene
 *
 * Add it to a renderer, and that is all: the actor has the mirrored scene rendered into a texture
 * before each frame in which it can be seen, and looks its reflection up there. Everything else
 * that the renderer has on (FXAA, SSAO, depth peeling, multisampling, stereo, selection, the user's
 * own passes) stays as it was.
 *
 * @code
 * vtkNew<vtkWaterActor> water;
 * water->SetLevel(355.0);
 * renderer->AddActor(water);
 * @endcode
 *
 * Without a mapper the actor makes its own sheet over the bounds of the scene, or to the horizon
 * (SetSheetToHorizon). With a mapper of the user's (a lake polygon, a terrain-clipped sheet) that
 * is the surface; SetMapper(nullptr) brings the own sheet back. The mirror is always the plane:
 * move that and not the actor, whose position moves the surface alone; a user's mesh should lie in
 * the plane.
 *
 * What is wrong with a scene (a zero normal, an empty scene, ...) is reported once per change by an
 * ErrorEvent of this object; the surface then shows its plain colour. A camera exactly on the plane
 * sees what it would from above it, at a ten thousandth of its near plane's distance.
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

#include <memory> // for std::unique_ptr
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
   * Make the water level: a horizontal plane at height z with +z up, in the scene's unit. Any
   * finite value; another is refused with an error and the last good level stays. It replaces the
   * plane by a new one. GetLevel returns the z of the plane's origin. Default is 0.
   */
  void SetLevel(double z);
  double GetLevel();
  ///@}

  ///@{
  /**
   * The plane of the water, of any orientation; its normal points out of the water. It is kept by
   * reference: changing it moves the water. It never is null: nullptr means level 0, the default.
   */
  void SetPlane(vtkPlane* plane);
  vtkPlane* GetPlane();
  ///@}

  ///@{
  /**
   * Bounds of the own sheet: xmin, xmax, ymin, ymax in the plane's own axes, in the scene's unit.
   * The axes: origin at the plane's origin; the first is the world's x projected onto the plane
   * (y when the normal is within 45 degrees of x), the second is normal x first. For a level sheet
   * they are the world's x and y. Finite, with min < max; else they are refused with an error.
   * Default: none, the sheet covers the bounds of the scene (ResetSheetBounds). They replace
   * SetSheetToHorizon.
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
   * Let the own sheet fill whatever the camera sees of the plane, up to the horizon; any plane has
   * one, and a parallel camera sees none. The sheet is no part of the scene's bounds (GetBounds
   * returns nullptr), is never culled, and is not cut at the camera's near and far planes, which
   * ResetCamera and ResetCameraClippingRange set for the rest of the scene. The actor's own
   * position does not move it. SetSheetBounds and ResetSheetBounds replace it; a mapper of the
   * user's takes its place as long as there is one. Default is off.
   */
  void SetSheetToHorizon();
  vtkGetMacro(SheetToHorizon, bool);
  ///@}

  ///@{
  /**
   * Let the scene say how wide the own sheet is: as wide as the scene where that has ground under
   * all of its water, as a terrain or a basin with a floor has; to the horizon where things stand
   * or float in open water. Looked at again when the scene changes; whether it reaches to the
   * horizon then, GetSheetToHorizon tells. SetSheetBounds, ResetSheetBounds and SetSheetToHorizon
   * replace it, and it must be set again after them. Default is off.
   */
  void SetSheetToAutomatic();
  vtkGetMacro(SheetIsAutomatic, bool);
  ///@}

  ///@{
  /**
   * How the water looks. Never null: nullptr means a new default one. ShallowCopy shares it; for
   * one of its own a copy wants vtkWaterProperty::DeepCopy. Not to be confused with vtkActor's own
   * property: of that, representation and culling keep their meaning, its opacity multiplies the
   * water's, its diffuse colour (SetColor) is the water's own unless it is white, VTK's default, or
   * vtkWaterProperty::SetDeepColor was called; edges and lighting are not used.
   */
  void SetWaterProperty(vtkWaterProperty* property);
  vtkWaterProperty* GetWaterProperty();
  ///@}

  ///@{
  /**
   * Time of the waves, s: in [-1e15, 1e15]; another is refused with an error. The picture depends
   * on this number alone, not on the frames before. Default is 0.
   */
  void SetTime(double seconds);
  vtkGetMacro(Time, double);
  ///@}

  ///@{
  /**
   * The waves at a place, at the actor's time: for buoys and picks. x and y, and the normal, are in
   * the plane's own axes (SetSheetBounds), the third along the plane's normal; the height is over
   * the plane, m. A wind sea is included, bilinear between the points of its tile. Without waves 0
   * and (0, 0, 1). NaN when the place is not finite.
   */
  double GetWaveHeight(double x, double y);
  void GetWaveNormal(double x, double y, double normal[3]) VTK_SIZEHINT(normal, 3);
  ///@}

  /**
   * Unit vector from the water to a place in its sky, such as the sun's: azimuth in degrees from
   * the plane's second axis over the first (from north over east for a level plane), elevation in
   * degrees over the plane, both finite. NaN when they are not, or when the plane has no normal.
   */
  void GetSkyDirection(double azimuth, double elevation, double direction[3])
    VTK_SIZEHINT(direction, 3);

  /**
   * How the polygons of a mesh of the user's lie over the plane: their mean height, which is
   * accepted as far as plus or minus the second number, and their mean angle to the plane, degrees,
   * accepted up to the fourth. What is not accepted is drawn, with a warning. Returns false, and
   * four NaN, for the own sheet and for a mapper whose polygons are not known.
   */
  bool GetMeshPlacement(double placement[4]) VTK_SIZEHINT(placement, 4);

  /**
   * The pass in charge of this water: one composed by hand into the renderer's chain once that has
   * rendered, else the actor's own. Never null.
   */
  vtkWaterReflectionPass* GetReflectionPass();

  /**
   * What the last plan found wrong, as said in the ErrorEvent; empty when all was right.
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
   * 0 while the sheet reaches to the horizon, as it has no bounds for pickers; but while pixels are
   * selected, and else, as SetPickable says.
   */
  vtkTypeBool GetPickable() override;

  /**
   * What the module itself knows the water by; not for use.
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
  // Does the own sheet reach to the horizon?
  bool IsEndless() { return this->SheetToHorizon && this->UsesOwnSheet(); }
  // Of an automatic sheet: does it reach to the horizon?
  void ChooseSheet(const std::vector<vtkRenderer*>& scene);
  // Fits the own sheet to the scene and the plane; does nothing with a mapper of the user's.
  void UpdateSheet();
  // Draws the surface in the mirrored view of another water.
  void RenderSecondary(vtkRenderer* renderer, vtkMapper* mapper);
  // What a water does in a frame before its geometry is drawn.
  //
  // Returns whether nothing of it is seen.
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
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif
