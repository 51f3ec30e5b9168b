// SPDX-License-Identifier: BSD-3-Clause
// Arrays of the steps of a solver's data are used again if nobody else has them, nor their memory.
#include "WaterTestScene.h"

#include "vtkWaterKept.h"

#include "vtkPoints.h"

#include <cstdlib>

namespace
{
using Kept = vtkWaterKept<vtkDoubleArray>;

// Gives an array to somebody, lets go of it, and says whether one of the next three is the same, or
// has its memory.
template <typename Hold>
bool ComesAgain(Hold hold)
{
  Kept kept;
  vtkSmartPointer<vtkDoubleArray> first = kept.Take("x", 3, 1000);
  [[maybe_unused]] auto held = hold(first);
  const double* memory = first->GetPointer(0);
  const vtkDoubleArray* array = first;
  first = nullptr;
  bool comes = false;
  for (int i = 0; i < 3; ++i)
  {
    const vtkSmartPointer<vtkDoubleArray> next = kept.Take("x", 3, 1000);
    comes = comes || next == array || next->GetPointer(0) == memory;
  }
  return comes;
}
}

int TestWaterKeptArrays(int, char*[])
{
  bool ok = WaterCheck("nobody has it", ComesAgain([](vtkDoubleArray*) { return 0; }), true);
  ok &= WaterCheck("somebody has it",
    ComesAgain([](vtkDoubleArray* array) { return vtkSmartPointer<vtkDoubleArray>(array); }),
    false);
  ok &= WaterCheck("points have it", ComesAgain([](vtkDoubleArray* array) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetData(array);
    return points;
  }),
    false);
  ok &= WaterCheck("an array shares its memory", ComesAgain([](vtkDoubleArray* array) {
    auto copy = vtkSmartPointer<vtkDoubleArray>::New();
    copy->ShallowCopy(array);
    return copy;
  }),
    false);
  ok &= WaterCheck("a copy does not", ComesAgain([](vtkDoubleArray* array) {
    auto copy = vtkSmartPointer<vtkDoubleArray>::New();
    copy->DeepCopy(array);
    return copy;
  }),
    true);
  double others[3000];
  others[0] = 7.0;
  ok &= WaterCheck("it was given other memory", ComesAgain([&others](vtkDoubleArray* array) {
    array->SetArray(others, 3000, 1);
    return 0;
  }),
    false);

  Kept kept;
  vtkDoubleArray* last = nullptr;
  vtkMTimeType time = 0;
  {
    const vtkSmartPointer<vtkDoubleArray> first = kept.Take("first", 1, 3000);
    last = first;
    first->FillValue(5.0);
    ok &= WaterCheck("a range", first->GetRange()[1], 5.0);
    time = first->GetMTime();
  }
  const vtkSmartPointer<vtkDoubleArray> second = kept.Take("second", 3, 900);
  ok &= WaterCheck("the same array", second.Get(), last);
  ok &= WaterCheck("has another name", std::string(second->GetName()), std::string("second"));
  ok &= WaterCheck("and other rows", second->GetNumberOfTuples(), vtkIdType(900));
  ok &= WaterCheck("is newer", second->GetMTime() > time, true);
  second->FillValue(6.0);
  ok &= WaterCheck("and has another range", second->GetRange(0)[1], 6.0);
  ok &= WaterCheck(
    "is of VTK's class", std::string(second->GetClassName()), std::string("vtkDoubleArray"));
  last = second;
  const vtkSmartPointer<vtkDoubleArray> third = kept.Take("third", 3, 1000);
  ok &= WaterCheck("two steps have arrays of their own", third.Get() != last, true);
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
