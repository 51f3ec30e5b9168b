// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPropKeys: the keys by which users say how a prop is reflected. They belong to
// vtkWaterReflectionPass, which defines these functions: nothing here knows that class.
#ifndef vtkWaterPropKeys_h
#define vtkWaterPropKeys_h

class vtkInformationIntegerKey;
class vtkInformationObjectBaseKey;

namespace vtkWaterPropKeys
{
vtkInformationIntegerKey* NotReflected();
vtkInformationObjectBaseKey* StandIn();
}

#endif
