// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterRuns.h"

#include "vtkOpenGLIndexBufferObject.h"
#include "vtkWaterClipDistance.h"
#include "vtkWaterGL.h"

#include <algorithm>
#include <cstdint>

namespace
{
constexpr size_t kTrianglesAtOnce = 1u << 18; // that are read back: 3 MB
}

//------------------------------------------------------------------------------
void vtkWaterRuns::Read(
  vtkOpenGLIndexBufferObject* buffer, const water_points& points, size_t pointCount)
{
  const size_t count = buffer->IndexCount / 3;
  this->Boxes.clear();
  this->Boxes.resize(buffer->IndexCount % 3 == 0 ? water_runs_shape(count, &this->Mesh) : 0);
  if (this->Boxes.empty())
  {
    return;
  }
  this->Mesh.boxes = reinterpret_cast<double(*)[6]>(this->Boxes.data()); // of std::array<double, 6>
  this->Places.resize(this->Mesh.leaf_count);
  this->Runs.resize(this->Mesh.leaf_count);
  water_runs_begin(&this->Mesh);
  std::vector<uint32_t> indices(3 * std::min(count, kTrianglesAtOnce)); // before GL's state changes
  GLint bound = 0;
  glGetIntegerv(GL_COPY_READ_BUFFER, &bound); // the binding's name is also that of its query
  glBindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(buffer->GetHandle()));
  bool isOfPoints = true;
  for (size_t first = 0; first < count && isOfPoints; first += kTrianglesAtOnce)
  {
    const size_t part = std::min(count - first, kTrianglesAtOnce);
    glGetBufferSubData(GL_COPY_READ_BUFFER, static_cast<GLintptr>(3 * first * sizeof(uint32_t)),
      static_cast<GLsizeiptr>(3 * part * sizeof(uint32_t)), indices.data());
    isOfPoints = water_runs_add(&this->Mesh, first, indices.data(), part, &points, pointCount);
  }
  glBindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(bound));
  water_runs_end(&this->Mesh);
  if (!isOfPoints)
  {
    this->Boxes.clear();
  }
}

//------------------------------------------------------------------------------
bool vtkWaterRuns::Select(const water_clusters_view& view)
{
  this->RunCount = water_runs_select(&view, &this->Mesh, this->Places.data(), this->Runs.data());
  if (this->RunCount == 1 && this->Runs[0].count == this->Mesh.triangle_count)
  {
    return false;
  }
  this->Counts.clear();
  this->Offsets.clear();
  for (size_t i = 0; i < this->RunCount; ++i)
  {
    this->Counts.push_back(static_cast<int>(3 * this->Runs[i].count));
    this->Offsets.push_back(
      reinterpret_cast<const void*>(3 * this->Runs[i].first * sizeof(uint32_t)));
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterRuns::Draw(
  vtkOpenGLIndexBufferObject* buffer, vtkWaterClipDistance& clipDistance) const
{
  const bool isOn = clipDistance.GetIsOn();
  buffer->Bind();
  for (size_t first = 0; first < this->RunCount;)
  {
    const bool isCut = this->Runs[first].is_cut;
    size_t end = first + 1;
    while (end < this->RunCount && this->Runs[end].is_cut == isCut)
    {
      ++end;
    }
    clipDistance.Set(isOn && isCut);
    glMultiDrawElements(GL_TRIANGLES, this->Counts.data() + first, GL_UNSIGNED_INT,
      this->Offsets.data() + first, static_cast<GLsizei>(end - first));
    first = end;
  }
  clipDistance.Set(isOn);
}
