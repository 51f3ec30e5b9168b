// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHulls: the hulls that float in a water, and the table of their waterlines
// (water_waterline.h), made anew when a hull, the water or the waves have moved.
#ifndef vtkWaterHulls_h
#define vtkWaterHulls_h

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "water_types.h"
#include "water_waterline.h"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkActor;

struct vtkWaterHullTable
{
  water_waterline_rows Rows;
  std::vector<float> Texels;
};

using vtkWaterHullTablePointer = std::shared_ptr<const vtkWaterHullTable>;

class vtkWaterHulls
{
public:
  // Where the water is.
  struct Surface
  {
    water_plane Unit = water_plane(); // normalised
    double Origin[3] = {};            // of the plane's own axes
    double HeightMax = 0.0;           // of waves that move the surface; 0: it lies in the plane
    // Takes heights over the plane to heights over the waves: count of x, y, height. false: the
    // waves are not known.
    std::function<bool(double* places, size_t count)> Lower;
  };

  // Returns whether it was not there yet.
  bool Add(vtkActor* hull);
  bool Remove(vtkActor* hull);
  void Clear() { this->Hulls.clear(); }
  std::vector<vtkSmartPointer<vtkActor>> List() const;
  bool IsEmpty() const { return this->Hulls.empty(); }
  // Of the last change of the hulls' actors; and of their meshes, too.
  vtkMTimeType GetMTime() const;
  vtkMTimeType GetMeshTime() const;

  // The table; nullptr: the water meets no hull. A hull is cut again if it or the water has moved;
  // waves that displace the water count as moved.
  //
  // wrong  what is wrong with the hulls; empty: nothing
  vtkWaterHullTablePointer Cut(const Surface& surface, std::string& wrong);

private:
  struct Hull
  {
    vtkSmartPointer<vtkActor> Actor;
    vtkMTimeType DataTime = 0; // of the data set that the next two are of
    std::vector<double> Points;
    std::vector<std::array<size_t, 3>> Triangles;
    bool IsCut = false; // what follows holds
    vtkMTimeType CutDataTime = 0;
    std::array<double, 16> CutMatrix;
    std::vector<water_waterline_piece> Pieces; // of its waterline; none if something is wrong
    std::string Wrong;
  };

  // Returns what is wrong with the hull's mesh, or nothing.
  static std::string Read(Hull& hull);
  static std::string CutOne(Hull& hull, const Surface& surface);
  // Cuts the hull unless it is cut as it is now. Returns as Read.
  static std::string Update(Hull& hull, const Surface& surface);

  std::vector<Hull> Hulls;
  Surface Water; // that they are cut by
};

#endif
