// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterAccessBlocks.h: vtkWaterAccess for what mappers of composite data draw with; on its own,
// since VTK 9.1 wants GL's names for it.
#ifndef vtkWaterAccessBlocks_h
#define vtkWaterAccessBlocks_h

#include "vtkWaterGL.h"

#if __has_include("vtkOpenGLBatchedPolyDataMapper.h") // from VTK 9.3 on
#include "vtkCompositePolyDataMapper.h"
#include "vtkOpenGLBatchedPolyDataMapper.h"
#define VTK_WATER_HAS_BATCHES
#else
// clang-format off
#include "vtkCompositePolyDataMapper2.h" // before the other, which does not include its colours
#include "vtkCompositeMapperHelper2.h"
// clang-format on
#endif

namespace vtkWaterAccess
{
// What a mapper of composite data draws blocks of one kind with.
#ifdef VTK_WATER_HAS_BATCHES
struct BlocksMapper : public vtkOpenGLBatchedPolyDataMapper
{
  static const char* ClassName() { return "vtkOpenGLBatchedPolyDataMapper"; }
  static vtkMapper* ParentOf(vtkOpenGLPolyDataMapper* mapper)
  {
    return static_cast<vtkOpenGLBatchedPolyDataMapper*>(mapper)->*(&BlocksMapper::Parent);
  }
  // Calls back with the mesh of each block, whether it is drawn, and whether it has a texture of
  // its own, which stays bound for the next blocks.
  template <typename Function>
  static void ForEach(vtkOpenGLPolyDataMapper* mapper, const Function& function)
  {
    for (auto& named : static_cast<vtkOpenGLBatchedPolyDataMapper*>(mapper)
                         ->*(&BlocksMapper::VTKPolyDataToGLBatchElement))
    {
      auto& block = named.second->Parent;
      function(block.PolyData, block.Visibility, HasTexture(block, 0));
    }
  }

private:
  template <typename Block>
  static auto HasTexture(const Block& block, int) -> decltype(block.Texture != nullptr)
  {
    return block.Texture != nullptr;
  }
  template <typename Block>
  static bool HasTexture(const Block&, long) // before VTK 9.6
  {
    return false;
  }
};
#else
struct BlocksMapper : public vtkCompositeMapperHelper2
{
  static const char* ClassName() { return "vtkCompositeMapperHelper2"; }
  static vtkMapper* ParentOf(vtkOpenGLPolyDataMapper* mapper)
  {
    return static_cast<vtkCompositeMapperHelper2*>(mapper)->*(&BlocksMapper::Parent);
  }
  template <typename Function>
  static void ForEach(vtkOpenGLPolyDataMapper* mapper, const Function& function)
  {
    for (auto& named : static_cast<vtkCompositeMapperHelper2*>(mapper)->*(&BlocksMapper::Data))
    {
      function(named.first, named.second->Visibility, false);
    }
  }
};
#endif
}
#endif
