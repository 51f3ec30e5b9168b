// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterLakes
 * @brief   the waters of one mesh in several planes: lakes, locks, terraces, pools
 *
 * A vtkWaterActor has one plane. This class creates one actor for each plane of the parts of a mesh
 * (vtkWaterPlanesFilter), and keeps them in the renderers to which it was added.
 *
 *     mapper.SetInputConnection(surface.GetOutputPort())
 *     lakes.SetMapper(mapper)
 *     lakes.GetWater().GetWaterProperty().SetPreset("lake")
 *     lakes.AddTo(renderer)
 *
 * The water of a solver's mesh, from its arrays of level, depth and bed, takes one call:
 *
 *     lakes.SetData(reader.GetOutputPort(), "zeta", "h", "")
 *
 * The first water, which GetWater returns, is that of the largest part. The others copy its
 * settings in the next frame: look, time, transformation, visibility, SceneReflection, vtkActor's
 * property, and the settings of the reflection pass. Setting the plane of the first water moves
 * only this water. The planes of all waters are set again when the mesh, the mapper's settings or
 * the first water's transformation change. If the first water is removed from a renderer, the
 * others are removed too, in the next frame.
 *
 * If the mesh changes, waters and planes are updated before the next frame. A water out of view has
 * no mirrored view. Of those in view, at most MaximumNumberOfMirrors have one; the others reflect
 * only the sky. The smallest parts, beyond MaximumNumberOfPlanes, reflect only the sky, too.
 *
 * @sa vtkWaterActor vtkWaterPlanesFilter vtkWaterSurfaceFilter
 */
#ifndef vtkWaterLakes_h
#define vtkWaterLakes_h

#include "vtkObject.h"
#include "vtkRenderingWaterModule.h" // for the export macro

#include <memory> // for std::unique_ptr
#include <string>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkAlgorithmOutput;
class vtkMapper;
class vtkPolyData;
class vtkRenderer;
class vtkWaterActor;
class vtkWaterSurfaceFilter;

class VTKRENDERINGWATER_EXPORT vtkWaterLakes : public vtkObject
{
public:
  static vtkWaterLakes* New();
  vtkTypeMacro(vtkWaterLakes, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The mapper of the whole surface. It is not drawn itself: each water has a mapper of the same
   * class for its part, with the same lookup table and settings. Its input must have
   * two-dimensional cells. Its scalars are shown as in a vtkWaterActor. nullptr, the default, means
   * no water. A mapper of composite data, such as vtkCompositePolyDataMapper, is rejected with an
   * error.
   *
   * After its Update, its input is the surface of all waters, to export or to filter. The mesh of
   * the mapper of one water (GetWater) is only the part in its plane.
   */
  void SetMapper(vtkMapper* mapper);
  vtkMapper* GetMapper() const;
  ///@}

  /**
   * Shows the water of a solver's mesh: a vtkWaterSurfaceFilter of the mesh, with these names of
   * its arrays of level, depth and bed, and a vtkPolyDataMapper of the filter's output as the
   * mapper. Two of the names are enough; leave the third empty. The mesh may change from frame to
   * frame. To choose the time step of a reader, call the filter's UpdateTimeStep. To colour the
   * water, use SelectColorArray and the other settings of GetMapper().
   *
   * Returns the filter, for its other settings, or nullptr if the mesh is nullptr, which means no
   * water. The filter reports wrong arrays when it is updated. Default is no mesh.
   */
  vtkWaterSurfaceFilter* SetData(vtkAlgorithmOutput* mesh, const std::string& level,
    const std::string& depth, const std::string& bed);

  ///@{
  /**
   * Direction out of the water (UpDirection), in the mesh's own coordinates: finite and not zero,
   * of any length; others are rejected with an error. Default is (0, 0, 1).
   */
  void SetUpDirection(double x, double y, double z);
  void GetUpDirection(double direction[3]) const;
  ///@}

  ///@{
  /**
   * Maximum number of waters in view that have a mirrored view, in [0, 4096]. These are the waters
   * whose bounds cover the largest share of the picture; each part has its own bounds. The others
   * reflect only the sky. Default is 8.
   */
  void SetMaximumNumberOfMirrors(int mirrors);
  vtkGetMacro(MaximumNumberOfMirrors, int);
  ///@}

  ///@{
  /**
   * Maximum number of planes, in [1, 4096]; there is one water for each. If the parts have more
   * planes, the smallest parts form one more water, the last one. It reflects only the sky, because
   * the mirrored view of one height is wrong at another. In software, every clear water in view
   * takes some milliseconds per frame, mirrored or not. Default is 16.
   */
  void SetMaximumNumberOfPlanes(int planes);
  int GetMaximumNumberOfPlanes() const;
  ///@}

  enum ShoreCuts
  {
    CUT_AUTOMATIC = 0,
    CUT_IN_FILTER = 1,
    CUT_WHILE_DRAWN = 2
  };

  ///@{
  /**
   * What cuts the water of a vtkWaterSurfaceFilter at the shore (SetData, or a mapper of that
   * filter's output). CUT_IN_FILTER: the filter, in each step. CUT_WHILE_DRAWN: the renderer, which
   * draws the filter's whole input and cuts it where the depth is 0. A step of a large mesh then
   * takes less CPU time, because no cell is cut and none is uploaded again. The line is the same in
   * triangles; in a quad it has a bend on the diagonal where VTK splits it. CUT_AUTOMATIC:
   * CUT_WHILE_DRAWN on a GPU, CUT_IN_FILTER with software rendering.
   *
   * The filter cuts even with CUT_WHILE_DRAWN if the picture would otherwise differ, or if the cut
   * is impossible while drawing. This applies before the first frame; if only a level is given; if
   * the mapper is not a vtkPolyDataMapper, or shows edges, vertices or a wireframe, or has shader
   * code of the user; and if the driver's clip distances are wrong. It also applies if a cell next
   * to water is completely dry (as behind a dyke), if the shore crosses a polygon of five or more
   * corners twice, if a cell has water of two lakes, if a dry point is next to two lakes at
   * different levels, or if a displayed array is NaN at a dry point next to water.
   *
   * Pickers, exporters and filters that use a water's mapper, or the vtkWaterSurfaceFilter, get the
   * cut mesh, which is made on request. Other numbers are rejected with an error. Default is
   * CUT_AUTOMATIC.
   */
  void SetShoreCut(int cut);
  vtkGetMacro(ShoreCut, int);
  void SetShoreCutToAutomatic() { this->SetShoreCut(CUT_AUTOMATIC); }
  void SetShoreCutToInFilter() { this->SetShoreCut(CUT_IN_FILTER); }
  void SetShoreCutToWhileDrawn() { this->SetShoreCut(CUT_WHILE_DRAWN); }
  const char* GetShoreCutAsString() const;
  ///@}

  /**
   * Whether the shore is cut while it is drawn, as the last Update decided.
   */
  bool GetIsShoreCutWhileDrawn() const;

  ///@{
  /**
   * The waters after the last Update. The first one always exists, so their number is at least 1.
   * GetWater returns nullptr beyond it.
   */
  int GetNumberOfWaters() const;
  vtkWaterActor* GetWater(int number = 0) const;
  ///@}

  /**
   * Adds the waters to a renderer. The renderer keeps this object alive until they are removed.
   * Waters that are already in the renderer stay there.
   */
  void AddTo(vtkRenderer* renderer);

  /**
   * Removes the waters from a renderer.
   */
  void RemoveFrom(vtkRenderer* renderer);

  /**
   * Updates the waters from the mesh and from the first water. Each frame of a renderer with these
   * waters begins with it.
   */
  void Update();

protected:
  vtkWaterLakes();
  ~vtkWaterLakes() override;

private:
  vtkWaterLakes(const vtkWaterLakes&) = delete;
  void operator=(const vtkWaterLakes&) = delete;

  struct Internals;

  // What a frame of a renderer begins with, and ends with.
  void BeginFrame(vtkRenderer* renderer);
  void EndFrame();
  // Finds out whether this renderer is a software renderer, and whether its clip distances work.
  void ReadRenderer(vtkRenderer* renderer);
  // Reads a step for meshes that are cut while they are drawn. false: the filter is to cut.
  bool ReadUncut(vtkAlgorithmOutput* input);
  // The arrays of points that the picture shows.
  std::vector<std::string> FindShownNames() const;
  // The mapper that draws a water in place of its own; nullptr: none does.
  vtkMapper* FindDrawnMapper(size_t number) const;
  // The parts of the surface, one for each plane, and when they were made.
  std::vector<vtkPolyData*> FindParts(vtkMTimeType* time) const;
  // Makes as many waters as there are planes.
  void Rebuild();
  void Resize(size_t count);
  void ShowPart(size_t number, vtkPolyData* part);
  // The same of a mesh that is cut while it is drawn, whose mapper for all others is given.
  void ShowUncut(size_t number, vtkPolyData* part, vtkMapper* mapper);
  // Gives the others what the first one has.
  void Follow();
  // All waters may have a mirrored view, except that of the parts without a plane.
  void AllowMirrors();
  // Chooses the waters that have a mirrored view.
  void ChooseMirrors(vtkRenderer* renderer);

  std::unique_ptr<Internals> Internal;
  int MaximumNumberOfMirrors = 8;
  int ShoreCut = CUT_AUTOMATIC;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif
