// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSignature: what a mirrored view was drawn from, besides camera and plane, as a list of
// modification times: equal lists, equal pictures.
//
// No pipeline is executed: what is upstream of a mapper is asked when it changed last, and what
// lies at its input when that changed last. Kinds of props, mappers and textures whose changes
// cannot be seen that way count as changed.
#ifndef vtkWaterSignature_h
#define vtkWaterSignature_h

#include "vtkType.h"

#include <utility>
#include <vector>

class vtkAbstractMapper;
class vtkAlgorithm;
class vtkProp;
class vtkProperty;
class vtkRenderer;
class vtkShadowMapPass;
class vtkTexture;
struct vtkWaterSnapshot;

class vtkWaterSignature
{
public:
  // Reads all that the renderer's picture of some props depends on, but for the camera.
  void Read(vtkRenderer* renderer, const std::vector<vtkProp*>& props);

  // Adds what shadows depend on: all that can throw one, in the mirrored view or not.
  void AddShadows(vtkRenderer* renderer, vtkShadowMapPass* pass);

  // Adds a number to it.
  void Add(vtkMTimeType value) { this->Values.emplace_back(nullptr, value); }

  // Is it certain that nothing has changed between the two?
  bool IsSameAs(const vtkWaterSignature& other) const;

private:
  void AddNumber(double value);
  void AddRenderer(vtkRenderer* renderer);
  void AddProp(vtkRenderer* renderer, vtkProp* prop);
  void AddWater(const vtkWaterSnapshot& water);
  void AddShaders(vtkProp* prop, vtkAbstractMapper* mapper);
  void AddMapper(vtkAbstractMapper* mapper);
  void AddAlgorithm(vtkAlgorithm* algorithm);
  void AddProperty(vtkProperty* property);
  void AddTexture(vtkTexture* texture);

  std::vector<std::pair<const void*, vtkMTimeType>> Values;
  bool IsComplete = false;
};

#endif
