// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterShaderFailures: which props go without the mirror's
// lines in their shaders, because the driver refused them with those.
//
// VTK tells nobody that a shader was refused: the mapper just does not come to set its parameters.
// So a shader that was written is awaited until they are set; whoever comes before that tells that
// it was refused. From then on the prop's shaders are VTK's own and no water reflects it, until its
// mapper or properties change.
#ifndef vtkWaterShaderFailures_h
#define vtkWaterShaderFailures_h

#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

class vtkAbstractMapper;
class vtkOpenGLRenderWindow;
class vtkProp;

class vtkWaterShaderFailures
{
public:
  // Is it certain that no prop is one of them?
  bool AreNone() const { return this->Refused.empty(); }
  // Are shaders awaited whose parameters nobody has set yet?
  bool AreAwaited() const { return this->IsAwaiting; }
  // Do the shaders of a prop go without the lines?
  bool Has(vtkProp* prop);
  // How often they were refused. VTK keeps programs by their text, and compiles one that was
  // refused once never again: the next attempt needs another text.
  int GetCount(vtkProp* prop) const;

  // A mapper's shaders are being built, perhaps again in vain. VTK before 9.3 then reads the
  // program that it had before (vtkOpenGLPolyDataMapper::UpdateShaders), and crashes where there
  // was none.
  static void Prepare(vtkAbstractMapper* mapper);

  // Shaders with the lines were written for a part of a prop, or for all of it.
  //
  // isMirrored  for the mirrored view
  void Await(vtkProp* part, vtkAbstractMapper* mapper, vtkOpenGLRenderWindow* window,
    bool isMirrored, const std::string& vertexShader, const std::string& geometryShader,
    const std::string& fragmentShader);
  // They are in use.
  void Arrive(vtkProp* part, vtkAbstractMapper* mapper);
  // What is still awaited was refused.
  void Judge();

  // Was anything refused in the mirrored view since this was asked last?
  bool TakeMirrored();
  // Was this prop lost in the eye's view since this was asked last?
  bool TakeLost(vtkProp* prop);
  bool HaveLost() const;
  // What has not been said yet, for an error; empty: nothing.
  std::string TakeText();

  // When a prop was added or taken out last: all shaders are written anew then.
  vtkMTimeType GetTime() const { return this->Changed.GetMTime(); }

private:
  struct Written
  {
    vtkWeakPointer<vtkProp> Part;
    vtkWeakPointer<vtkAbstractMapper> Mapper;
    vtkWeakPointer<vtkOpenGLRenderWindow> Window;
    std::string Vertex;
    std::string Geometry;
    std::string Fragment;
    bool IsMirrored = false;
  };
  struct Refusal
  {
    vtkWeakPointer<vtkProp> Part;
    vtkWeakPointer<vtkAbstractMapper> Mapper;
    vtkWeakPointer<vtkAbstractMapper> ActorMapper; // another one where a helper draws for it
    vtkMTimeType Time = 0;
    int Count = 0;
    bool IsOver = false;
    bool IsLost = false;
  };

  static vtkMTimeType GetTimeOf(vtkProp* part, vtkAbstractMapper* mapper);
  static std::string Describe(const Written& written);

  Written Awaited; // no part: nothing is
  bool IsAwaiting = false;
  std::vector<Refusal> Refused;
  bool IsMirroredNew = false;
  std::vector<std::string> Texts; // that are still to be said
  vtkTimeStamp Changed;
};

#endif
