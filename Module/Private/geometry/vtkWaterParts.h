// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterParts: the parts of a mesh that do not hang together (water_regions.h), and the planes
// that they lie in (water_fit.h).
#ifndef vtkWaterParts_h
#define vtkWaterParts_h

#include "vtkType.h"
#include "vtkWaterShoreCells.h"
#include "water_fit.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

class vtkPolyData;
struct vtkWaterCellLists;

class vtkWaterParts
{
public:
  struct Plane
  {
    water_fit_plane Fit; // of its largest part
    double Area = 0.0;   // of all of its parts, seen along up
    bool IsFlat = true;  // none of them leaves it by more than its coordinates are rounded by
    bool IsRest = false; // that of the parts that have none (water_fit_rest)
    double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 }; // of all of its parts
    std::vector<std::array<double, 6>> PartBounds;          // of each of them
  };

  // mesh   of polygons alone
  // up     unit length
  // most   planes
  // shore  the parts are those of its water alone; nullptr: all is water
  void Find(
    vtkPolyData* mesh, const double up[3], size_t most, const vtkWaterShoreCells* shore = nullptr);

  // That of the rest is the last one.
  const std::vector<Plane>& GetPlanes() const { return this->Planes; }

  // Are all polygons in a plane, and the mesh's bounds theirs?
  bool HasAll(size_t plane) const;

  // Cells with water of two parts, and cells of a part with a coordinate that is no number.
  size_t GetSharedCount() const { return this->SharedCount; }
  size_t GetUnplacedCount() const { return this->UnplacedCount; }
  // The plane that a cell is in; below 0: none.
  int64_t PlaneOf(vtkIdType cell) const;
  const std::vector<vtkIdType>& GetCells(size_t plane) const { return this->Cells[plane]; }

  // Adds what is known of a plane to the field data of its polygons.
  void Describe(size_t plane, vtkPolyData* polygons) const;

  // The polygons in a plane, with their points and all arrays of both.
  void Extract(vtkPolyData* mesh, size_t plane, vtkPolyData* extracted);

private:
  void Join(vtkPolyData* mesh);
  void JoinCells(vtkPolyData* mesh, vtkIdType begin, vtkIdType end);
  // Of a cell that the shore cuts: the corners that are under water, or on the shore.
  void JoinCut(const vtkIdType* points, vtkIdType count);
  // Of the mesh, if it comes again; else 0.
  size_t CountChunks() const;
  // The part of a cell's water.
  int64_t RegionOf(vtkIdType cell, const vtkIdType* points, vtkIdType count);
  // Is all of a cell in a part?
  bool IsWhole(vtkIdType cell) const
  {
    return !this->Shore || this->Shore->Kinds[static_cast<size_t>(cell)] == vtkWaterShoreCells::Wet;
  }
  // What is under water of the cells that the shore cuts.
  void FitCut(vtkPolyData* mesh);
  void Number(vtkPolyData* mesh);
  void NumberCells(vtkPolyData* mesh, vtkIdType begin, vtkIdType end);
  int32_t NumberOf(int64_t region);
  void Fit(vtkPolyData* mesh, vtkIdType begin, vtkIdType end, std::vector<water_fit>& fits);
  // The same for runs of cells of one part, without copies of their corners.
  void FitRuns(const double* points, const vtkWaterCellLists& lists, vtkIdType begin, vtkIdType end,
    std::vector<water_fit>& fits);
  void Fit(vtkPolyData* mesh, const double up[3]);
  void Share(vtkPolyData* mesh, const double up[3], size_t most);

  const vtkWaterShoreCells* Shore = nullptr; // while parts are found
  size_t SharedCount = 0;
  std::atomic<size_t> UnplacedCount{ 0 };
  std::vector<int64_t> Joined;     // corners of one cell
  std::vector<int64_t> Parents;    // of points and, after them, of chunks
  std::vector<int32_t> PartOfCell; // none: it has less than three points, or one that is not finite
  std::vector<int32_t> PartOfPoint; // of those that stand for a region, and of chunks
  size_t PartCount = 0;
  std::vector<water_fit> Fits;      // of the parts
  std::vector<int64_t> PlaneOfPart; // none: it has no area
  bool IsTight = false;             // no point beside the polygons' widens the mesh's bounds
  bool HasOne = false;              // plane, of all polygons
  std::vector<Plane> Planes;
  std::vector<std::vector<vtkIdType>> Cells; // of the planes
  std::vector<vtkIdType> Extracted;          // of each point: where it is in the part; else none
};

#endif
