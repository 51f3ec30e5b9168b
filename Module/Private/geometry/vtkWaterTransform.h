// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterTransform: the FFT of a square on the CPU, by VTK's kissfft and vtkSMPTools. Its
// plan is made once for a size.
#ifndef vtkWaterTransform_h
#define vtkWaterTransform_h

#include <cstddef>
#include <functional>
#include <vector>

class vtkWaterTransform
{
public:
  // Writes two rows of a spectrum, row and size - row, as water_tile_slope_row does. Called from
  // several threads at once, for rows from 0 to size / 2 - 1; row size / 2 is 0.
  using RowMaker = std::function<void(size_t row, double* own, double* mirror)>;

  // Transforms a square, with exp(-i k . x) and without scale. std::bad_alloc when there is no
  // memory for it, in any of the threads.
  //
  // real, imaginary  size * size numbers, written, the column fastest; imaginary may be nullptr
  void Run(size_t size, const RowMaker& makeRow, double* real, double* imaginary);

private:
  void Plan(size_t size);
  void TransformRows(const RowMaker& makeRow, size_t first, size_t end);
  void TransformColumns(size_t first, size_t end, double* real, double* imaginary) const;

  size_t Size = 0;
  std::vector<char> State;    // kissfft's
  std::vector<double> Middle; // after the rows: a row of it is a column, complex
};

#endif
