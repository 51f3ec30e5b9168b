// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterTransform.h"

#include "vtkSMPTools.h"
#include "vtk_kissfft.h"

#include VTK_KISSFFT_HEADER(kiss_fft.h)

#include <algorithm>
#include <atomic>
#include <new>

namespace
{
// What a thread transforms at a time, so that transposing writes whole cache lines.
constexpr size_t kRows = 4; // and as many mirrored ones
constexpr size_t kColumns = 8;
constexpr size_t kSmallest = 64; // that threads are worth their start for

static_assert(sizeof(kiss_fft_cpx) == 2 * sizeof(double), "VTK's kissfft is one of doubles");

kiss_fft_cfg GetState(const std::vector<char>& state)
{
  return reinterpret_cast<kiss_fft_cfg>(const_cast<char*>(state.data())); // it does not change it
}

kiss_fft_cpx* AsComplex(double* numbers)
{
  return reinterpret_cast<kiss_fft_cpx*>(numbers);
}

// Calls work(first, end) for parts of [0, count), in threads when the square is worth it. What a
// thread has no memory for is thrown here: from there it would end the program.
template <typename Work>
void ForBlocks(size_t size, size_t count, size_t block, const Work& work)
{
  const auto blocks = static_cast<vtkIdType>((count + block - 1) / block);
  std::atomic<bool> isShort(false);
  const auto some = [count, block, &work, &isShort](vtkIdType begin, vtkIdType end) {
    try
    {
      work(static_cast<size_t>(begin) * block, std::min(static_cast<size_t>(end) * block, count));
    }
    catch (const std::bad_alloc&)
    {
      isShort = true;
    }
  };
  vtkSMPTools::For(0, blocks, size < kSmallest ? blocks : 0, some);
  if (isShort)
  {
    throw std::bad_alloc();
  }
}
}

//------------------------------------------------------------------------------
void vtkWaterTransform::Plan(size_t size)
{
  if (size == this->Size)
  {
    return;
  }
  this->Size = 0; // until there is memory for all
  size_t bytes = 0;
  kiss_fft_alloc(static_cast<int>(size), 0, nullptr, &bytes); // only says how many
  this->State.resize(bytes);
  kiss_fft_alloc(static_cast<int>(size), 0, this->State.data(), &bytes);
  this->Middle.assign(2 * size * size, 0.0); // row size / 2 stays 0
  this->Size = size;
}

//------------------------------------------------------------------------------
void vtkWaterTransform::TransformRows(const RowMaker& makeRow, size_t first, size_t end)
{
  const size_t line = 2 * this->Size;
  std::vector<double> spectra(2 * kRows * line);
  std::vector<double> rows(2 * kRows * line);
  for (size_t begin = first; begin < end; begin += kRows)
  {
    const size_t count = std::min(kRows, end - begin);
    for (size_t i = 0; i < count; ++i)
    {
      double* own = spectra.data() + 2 * i * line;
      makeRow(begin + i, own, own + line);
      for (double* spectrum : { own, own + line })
      {
        kiss_fft(GetState(this->State), AsComplex(spectrum),
          AsComplex(rows.data() + (spectrum - spectra.data())));
      }
    }
    for (size_t column = 0; column < this->Size; ++column)
    {
      double* to = this->Middle.data() + column * line;
      for (size_t i = 0; i < count; ++i)
      {
        const size_t row = begin + i;
        const double* own = rows.data() + 2 * i * line + 2 * column;
        std::copy_n(own, 2, to + 2 * row);
        if (row > 0)
        {
          std::copy_n(own + line, 2, to + 2 * (this->Size - row));
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterTransform::TransformColumns(
  size_t first, size_t end, double* real, double* imaginary) const
{
  const size_t line = 2 * this->Size;
  std::vector<double> columns(kColumns * line);
  for (size_t begin = first; begin < end; begin += kColumns)
  {
    const size_t count = std::min(kColumns, end - begin);
    for (size_t i = 0; i < count; ++i)
    {
      auto* from = const_cast<double*>(this->Middle.data()) + (begin + i) * line; // read only
      kiss_fft(GetState(this->State), AsComplex(from), AsComplex(columns.data() + i * line));
    }
    for (size_t row = 0; row < this->Size; ++row)
    {
      for (size_t i = 0; i < count; ++i)
      {
        const double* value = columns.data() + i * line + 2 * row;
        real[row * this->Size + begin + i] = value[0];
        if (imaginary)
        {
          imaginary[row * this->Size + begin + i] = value[1];
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterTransform::Run(size_t size, const RowMaker& makeRow, double* real, double* imaginary)
{
  this->Plan(size);
  ForBlocks(size, size / 2, kRows,
    [&](size_t first, size_t end) { this->TransformRows(makeRow, first, end); });
  ForBlocks(size, size, kColumns,
    [&](size_t first, size_t end) { this->TransformColumns(first, end, real, imaginary); });
}
