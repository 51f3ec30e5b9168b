// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterLakes
 * @brief   the waters of one mesh that lie in several planes: lakes, locks, terraces, pools
 *
 * A vtkWaterActor has one plane. This makes one for each plane that the parts of a mesh lie in
 * (vtkWaterPlanesFilter), and keeps them in the renderers that it was added to.
 *
 *     mapper.SetInputConnection(surface.GetOutputPort())
 *     lakes.SetMapper(mapper)
 *     lakes.GetWater().GetWaterProperty().SetPreset("lake")
 *     lakes.AddTo(renderer)
 *
 * GetWater, the first, is that of the largest part. What is set of it the others have from the next
 * frame on: its look, time, transformation and visibility, vtkActor's property, and the settings of
 * its reflection pass. Its plane moves it alone, until the mesh changes. Taken out of a renderer
 * it takes the others along, in the next frame.
 *
 * When the mesh changes, so do waters and planes before the next frame. A water out of view has no
 * mirrored view; of those in view MaximumNumberOfMirrors have one, the others reflect the sky
 * alone.
 *
 * @sa vtkWaterActor vtkWaterPlanesFilter vtkWaterSurfaceFilter
 */
#ifndef vtkWaterLakes_h
#define vtkWaterLakes_h

#include "vtkObject.h"
#include "vtkRenderingWaterModule.h" // for the export macro

#include <memory> // for std::unique_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkMapper;
class vtkPolyData;
class vtkRenderer;
class vtkWaterActor;

class VTKRENDERINGWATER_EXPORT vtkWaterLakes : public vtkObject
{
public:
  static vtkWaterLakes* New();
  vtkTypeMacro(vtkWaterLakes, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The mapper of the whole surface. It is not drawn itself: each water has one of its class for
   * its part, with the same look-up table and settings. Its input has two-dimensional cells. Its
   * own scalars show as in a vtkWaterActor. nullptr, the default: there is no water.
   */
  void SetMapper(vtkMapper* mapper);
  vtkMapper* GetMapper() const;
  ///@}

  ///@{
  /**
   * Where up is, out of the water, in the mesh's own coordinates: finite and not zero, of any
   * length; others are refused with an error. Default is (0, 0, 1).
   */
  void SetUpDirection(double x, double y, double z);
  void GetUpDirection(double direction[3]) const;
  ///@}

  ///@{
  /**
   * The most waters in view that have a mirrored view, by the share of the picture that their
   * bounds cover; the others reflect the sky alone. In [0, 4096]. Default is 8.
   */
  void SetMaximumNumberOfMirrors(int mirrors);
  vtkGetMacro(MaximumNumberOfMirrors, int);
  ///@}

  ///@{
  /**
   * The waters as they are since the last Update. The first one is always there; others are
   * nullptr beyond their number, which is at least 1.
   */
  int GetNumberOfWaters() const;
  vtkWaterActor* GetWater(int number = 0) const;
  ///@}

  /**
   * Puts the waters into a renderer, which keeps this object alive until they are taken out.
   */
  void AddTo(vtkRenderer* renderer);

  /**
   * Takes the waters out of a renderer.
   */
  void RemoveFrom(vtkRenderer* renderer);

  /**
   * Brings the waters up to date with the mesh and with the first of them. Each frame of a renderer
   * that they are in begins with it.
   */
  void Update();

protected:
  vtkWaterLakes();
  ~vtkWaterLakes() override;

private:
  vtkWaterLakes(const vtkWaterLakes&) = delete;
  void operator=(const vtkWaterLakes&) = delete;

  struct Internals;

  // What a frame of a renderer begins with.
  void BeginFrame(vtkRenderer* renderer);
  // Makes as many waters as there are planes.
  void Rebuild();
  void Resize(size_t count);
  void ShowPart(size_t number, vtkPolyData* part);
  // Gives the others what the first one has.
  void Follow();
  // Chooses the waters that have a mirrored view.
  void ChooseMirrors(vtkRenderer* renderer);

  std::unique_ptr<Internals> Internal;
  int MaximumNumberOfMirrors = 8;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif
