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
 * Without a mapper the actor makes its own sheet over the bounds of the scene. With a mapper of the
 * user's (a lake polygon, a terrain-clipped sheet) that is the surface; SetMapper(nullptr) brings
 * the own sheet back. The mirror is always the plane: move that and not the actor, whose position
 * moves the surface alone; a user's mesh should lie in the plane.
 *
 * What is wrong with a scene (a zero normal, a camera exactly on the plane, ...) is reported once
 * per change by an ErrorEvent of this object; the surface then shows its plain colour.
 *
 * @sa vtkWaterProperty vtkWaterReflectionPass
 */
#ifndef vtkWaterActor_h
#define vtkWaterActor_h

#include "vtkNew.h" // for members
#include "vtkOpenGLActor.h"
#include "vtkRenderingWaterModule.h" // for the export macro
#include "vtkSmartPointer.h"         // for members
#include "vtkWeakPointer.h"          // for members

#include <memory> // for std::unique_ptr
#include <string> // for std::string
#include <vector> // for std::vector

class vtkWaterGrid;
class vtkWaterSea;
class vtkWaterSecondarySurface;
class vtkWaterSheet;
class vtkWaterSurfaceShader;
struct vtkWaterError;
struct vtkWaterGather;
struct water_grid_view;
struct water_wave_term;

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkOpenGLRenderer;
class vtkPlane;
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
   * Default: none, the sheet covers the bounds of the scene (ResetSheetBounds).
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
   * How the water looks. Never null: nullptr means a new default one. Not to be confused with
   * vtkActor's own property: of that, representation and culling keep their meaning, its opacity
   * multiplies the water's, and its colours, edges and lighting are not used.
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

protected:
  vtkWaterActor();
  ~vtkWaterActor() override;

private:
  vtkWaterActor(const vtkWaterActor&) = delete;
  void operator=(const vtkWaterActor&) = delete;

  friend class vtkWaterReflectionPass;
  friend class vtkWaterSurfaceShader;
  friend struct vtkWaterGather;

  struct SourcedError
  {
    std::string Kind; // the same for the same error with another value
    std::string Text;
    vtkWeakPointer<vtkRenderer> Renderer;
    bool IsOfSheet = false; // and of no renderer
  };

  bool UsesOwnSheet();
  // Fits the own sheet to the scene and the plane; does nothing with a mapper of the user's.
  void UpdateSheet();
  // Says an error once until it changes or goes away (empty).
  //
  // renderer  of the plan that failed; nullptr: it is the sheet
  void ReportError(vtkRenderer* renderer, const vtkWaterError& error);
  bool HasSheetError() const;
  // Do waves move the surface itself?
  bool IsDisplaced() const;
  // The own sheet as this eye sees it; a user's mapper is drawn as it is.
  vtkMapper* LayGrid(const water_grid_view& view, vtkMapper* mapper);
  // The waves at the actor's time.
  std::vector<water_wave_term> GetWaveTerms();
  // The wind sea at the actor's time; nullptr when it is off.
  vtkWaterSea* GetSeaAtTime();
  // Puts the water behind all other props in the order of this frame: what hides it, and what is
  // seen through it, is there before it.
  void DrawLast(vtkRenderer* renderer);
  // Milliseconds that the sheets may take in this frame; 0: theirs is no budget.
  double FindBudget(vtkOpenGLRenderer* renderer, const std::vector<vtkWaterActor*>& sheets);
  // Is it likely that the picture before the water says what need not be drawn in its mirrored
  // view?
  bool IsWorthWaiting(vtkOpenGLRenderer* renderer, const std::vector<vtkWaterActor*>& sheets);
  // May the mirrored view be drawn in the middle of the main one, just before the water?
  bool CanBeLate(vtkOpenGLRenderer* renderer);
  // Could one mirrored view serve both, and look the same?
  bool CanShareWith(vtkOpenGLRenderer* renderer, vtkWaterActor* other);
  // Finds the sheets that share a mirrored view in this frame, and when it is drawn; for all of
  // them when the first is asked.
  void FindSheets(vtkOpenGLRenderer* renderer);
  // The pass that has the mirrored view of this frame.
  vtkWaterReflectionPass* GetPassInCharge(vtkRenderer* renderer);
  // isLate  drawn just before the water, else before the frame
  void RenderSharedReflection(vtkOpenGLRenderer* renderer, const int viewport_px[2], bool isLate);
  // Is all of them hidden by what has been drawn so far?
  bool AreSheetsHidden(vtkOpenGLRenderer* renderer, const std::vector<vtkWaterActor*>& sheets);
  // Draws the surface with its shader, or with the plain one when the driver refuses that.
  void DrawSurface(vtkWaterSurfaceShader* surface, vtkRenderer* renderer, vtkMapper* mapper);
  // Draws the surface in the mirrored view of another water.
  void RenderSecondary(vtkRenderer* renderer, vtkMapper* mapper);
  // Draws the props again that this frame has lost because their shaders were refused with the
  // mirror's lines, and says so.
  void MendRefusals(vtkOpenGLRenderer* renderer);
  // A nested mirror for a draw whose camera was not the one mirrored before the frame.
  void RenderReflectionIfStale(vtkViewport* viewport);

  vtkSmartPointer<vtkPlane> Plane;
  vtkSmartPointer<vtkWaterProperty> WaterProperty;
  vtkSmartPointer<vtkWaterReflectionPass> OwnPass;
  vtkWeakPointer<vtkWaterReflectionPass> ComposedPass;
  std::unique_ptr<vtkWaterSheet> Sheet;
  std::unique_ptr<vtkWaterGrid> Grid; // the sheet when it is displaced
  std::unique_ptr<vtkWaterSurfaceShader> Surface;
  std::unique_ptr<vtkWaterSecondarySurface> Secondary;
  std::unique_ptr<vtkWaterSea> Sea;
  double SheetBounds[4] = { 0.0, 0.0, 0.0, 0.0 };
  bool UseSheetBounds = false;
  double DisplacedBounds[6] = {};
  bool IsUpdatingSheet = false;
  vtkMTimeType FittedFrame = 0; // of which the sheet is
  double Time = 0.0;
  std::vector<SourcedError> Errors;
  vtkWeakPointer<vtkWaterActor>
    Leader; // of the sheets that share a view; all of this for one frame
  std::vector<vtkWeakPointer<vtkWaterActor>> Sheets; // the leader's
  vtkMTimeType SheetsFrame = 0;
  bool IsLate = false;
  bool IsProbing = false; // is drawn only to be counted
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif
