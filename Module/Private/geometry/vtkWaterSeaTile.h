// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSeaTile: a tile of a wind sea at one time on the CPU.
//
// What somebody asks for is computed then, once for a time. What has no memory throws
// std::bad_alloc, and is tried anew when it is asked for again.
#ifndef vtkWaterSeaTile_h
#define vtkWaterSeaTile_h

#include "vtkWaterTransform.h"
#include "water_tile_time.h"

#include <vector>

class vtkWaterSeaTile
{
public:
  // Brings the tile to a time; does nothing when it is there. All have been checked.
  //
  // Returns whether tile or sea are others than before.
  bool Update(const water_tile& tile, const water_sea& sea, double time);

  // size * size numbers, the column fastest; of a pair of one field the second is nothing.
  const double* GetFirst(water_tile_pair pair) { return this->Make(pair).First.data(); }
  const double* GetSecond(water_tile_pair pair) { return this->Make(pair).Second.data(); }

  // The height alone, which is less to make; that of WATER_PAIR_HEIGHT_SHEAR if it is there.
  const double* GetHeight();

  const water_tile& GetTile() const { return this->Tile; }
  const std::vector<double>& GetAmplitudes() const { return this->Amplitudes; }
  const std::vector<double>& GetFrequencies() const { return this->Frequencies; }

private:
  struct Pair
  {
    std::vector<double> First;
    std::vector<double> Second;
    bool IsMade = false; // for the time
  };

  const Pair& Make(water_tile_pair pair);
  void UpdatePhasors();

  water_tile Tile = water_tile();
  water_sea Sea = water_sea();
  double Time = 0.0;
  std::vector<double> Amplitudes; // empty: never updated
  std::vector<double> Frequencies;
  std::vector<double> Phasors;
  bool HasPhasors = false;
  Pair Pairs[WATER_PAIR_COUNT];
  vtkWaterTransform Transform;
};

#endif
