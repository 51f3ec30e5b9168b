// SPDX-License-Identifier: BSD-3-Clause
// WaterBlocks.h: composite data for the C++ tests, and the mapper that this VTK draws it
// with.
#ifndef WaterBlocks_h
#define WaterBlocks_h

#include "vtkCubeSource.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper.h"
using WaterBlocksMapper = vtkCompositePolyDataMapper;
#else
#include "vtkCompositePolyDataMapper2.h"
using WaterBlocksMapper = vtkCompositePolyDataMapper2;
#endif

// Columns in a row, every other one under the water.
inline vtkSmartPointer<WaterBlocksMapper> WaterMakeBlocks(unsigned int count)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < count; ++i)
  {
    vtkNew<vtkCubeSource> column;
    column->SetCenter(20.0 * (i + 0.5) / count - 10.0, 3.0, i % 2 == 0 ? 0.5 : -2.0);
    column->SetXLength(12.0 / count);
    column->SetZLength(3.0);
    column->Update();
    blocks->SetBlock(i, column->GetOutput());
  }
  auto mapper = vtkSmartPointer<WaterBlocksMapper>::New();
  mapper->SetInputDataObject(blocks);
  return mapper;
}

#endif
