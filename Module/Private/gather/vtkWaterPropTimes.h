// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPropTimes: what the picture of a prop depends on, besides the camera, as a list of
// modification times: equal lists, equal pictures.
//
// No pipeline is executed: what is upstream of a mapper is asked when it changed last, and what
// lies at its input when that changed last. Kinds of props, mappers and textures whose changes
// cannot be seen that way count as changed.
//
// A list that was read can be asked again without finding everything anew. It is in an order in
// which an object is touched only after the one that holds it is known to be unchanged: whatever
// was replaced, and is gone, is never touched. The prop itself must be there.
#ifndef vtkWaterPropTimes_h
#define vtkWaterPropTimes_h

#include "vtkType.h"

#include <vector>

class vtkAbstractMapper;
class vtkAlgorithm;
class vtkDataObject;
class vtkObject;
class vtkProp;
class vtkProperty;
class vtkRenderer;
class vtkShaderProperty;
class vtkTexture;
struct vtkWaterSnapshot;

class vtkWaterPropTimes
{
public:
  void Clear();
  void Read(vtkRenderer* renderer, vtkProp* prop);
  // Adds a texture.
  void AddTexture(vtkTexture* texture);

  // Is it certain that nothing has changed since it was read? Asks again.
  bool AreUnchanged() const;
  // May it be reused? Some objects must always be read again.
  bool CanBeAsked() const { return this->IsComplete && this->IsAskable; }
  // Is it certain that nothing has changed between the two?
  bool AreSameAs(const vtkWaterPropTimes& other) const;

private:
  enum Question
  {
    NUMBER, // of no object: not asked again
    TIME,
    SHADERS,
    MAPPER, // whose shaders must have no observer
    PIPELINE,
    // of what holds the next ones, and changes without a change of the picture, too:
    HOLDER,
    EXECUTIVE // an algorithm's, which holds its connections
  };
  struct Entry
  {
    vtkObject* Of;
    vtkMTimeType Last;
    Question Asked;
  };

  static vtkMTimeType Ask(const Entry& entry);
  void Add(vtkMTimeType number) { this->Entries.push_back({ nullptr, number, NUMBER }); }
  void Add(vtkObject* object, Question question = TIME);
  void AddNumber(double value);
  void AddProp(vtkRenderer* renderer, vtkProp* prop);
  void AddParts(vtkRenderer* renderer, vtkProp* prop);
  void AddWater(const vtkWaterSnapshot& water);
  void AddShaders(vtkProp* prop, vtkAbstractMapper* mapper);
  void AddMapper(vtkAbstractMapper* mapper);
  void AddInputs(vtkAlgorithm* algorithm);
  void AddData(vtkDataObject* data);
  void AddTexturesOf(vtkProperty* property);

  std::vector<Entry> Entries;
  bool IsComplete = true; // false: it changes without a trace
  bool IsAskable = true;
};

#endif
