// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterKept: arrays whose memory is used again in later steps of a solver's data.
//
// The system clears memory that it hands out: for the arrays of a million points, this takes as
// long as a fifth of all that is done to them. Steps take turns, because the last one is still
// drawn while the next one is made. An array that anybody else has, or whose memory another array
// shares, is left alone.
#ifndef vtkWaterKept_h
#define vtkWaterKept_h

#include "vtkBuffer.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <vector>

template <typename ArrayT>
class vtkWaterKept
{
public:
  // An array of so many rows that nobody else has. Its values are any.
  vtkSmartPointer<ArrayT> Take(const char* name, int components, vtkIdType rows)
  {
    const auto found = std::find_if(this->Arrays.begin(), this->Arrays.end(),
      [](const vtkSmartPointer<Array>& array) { return array->IsFree(); });
    vtkSmartPointer<Array> taken;
    if (found != this->Arrays.end())
    {
      taken = *found;
      this->Arrays.erase(found);
    }
    const vtkIdType values = components * rows;
    if (!taken || taken->GetSize() < values || taken->GetSize() / 2 > values)
    {
      taken = vtkSmartPointer<Array>::New(); // growing would copy what is not needed
    }
    taken->SetName(name);
    taken->SetNumberOfComponents(components);
    taken->SetNumberOfTuples(rows);
    taken->Memory = taken->GetPointer(0);
    taken->DataChanged();
    taken->Modified();             // or it would be drawn as it was
    this->Arrays.push_back(taken); // the oldest are first
    if (this->Arrays.size() > kTurns)
    {
      this->Arrays.erase(this->Arrays.begin());
    }
    return taken;
  }

  void Forget() { this->Arrays.clear(); }

private:
  static constexpr size_t kTurns = 3; // that is drawn, that is made, and one that somebody has

  // Still of VTK's class, for those who ask.
  class Array : public ArrayT
  {
  public:
    static Array* New() { VTK_STANDARD_NEW_BODY(Array); }
    // An array's ShallowCopy shares memory without holding the array, and who had the array may
    // have given it other memory.
    bool IsFree()
    {
      return this->GetReferenceCount() == 1 && this->Buffer->GetReferenceCount() == 1 &&
        this->GetPointer(0) == this->Memory;
    }
    const void* Memory = nullptr;
  };

  std::vector<vtkSmartPointer<Array>> Arrays;
};

#endif
