// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSignature: what a mirrored view was drawn from, besides camera and plane, as a list of
// modification times, and of stamps for the props: equal lists, equal pictures.
#ifndef vtkWaterSignature_h
#define vtkWaterSignature_h

#include "vtkType.h"
#include "vtkWaterPropTimes.h"
#include "vtkWaterSkyReader.h"
#include "water_types.h"

#include <utility>
#include <vector>

class vtkProp;
class vtkRenderer;
class vtkShadowMapPass;
class vtkWaterPropRecords;

class vtkWaterSignature
{
public:
  // Reads all that the renderer's picture depends on, but for the camera and the props.
  void Read(vtkRenderer* renderer);

  // Adds a prop that is drawn.
  //
  // stamp  vtkWaterPropRecords::GetStamp
  void AddProp(vtkProp* prop, vtkMTimeType stamp) { this->Values.emplace_back(prop, stamp); }

  // Adds what shadows depend on: all that can throw one, in the mirrored view or not.
  void AddShadows(vtkRenderer* renderer, vtkShadowMapPass* pass, vtkWaterPropRecords& records);

  // Adds what the sky of a plan is looked up by.
  void AddSky(const water_sky& sky, const vtkWaterSkyTextures& textures);

  // Adds a number to it.
  void Add(vtkMTimeType value) { this->Values.emplace_back(nullptr, value); }
  void AddNumber(double value);

  // Is it certain that nothing has changed between the two?
  bool IsSameAs(const vtkWaterSignature& other) const;

private:
  void AddRenderer(vtkRenderer* renderer);
  std::vector<std::pair<const void*, vtkMTimeType>> Values;
  vtkWaterPropTimes Textures; // of the surroundings
};

#endif
