// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSeaTile.h"

#include "vtkSMPTools.h"

//------------------------------------------------------------------------------
bool vtkWaterSeaTile::Update(const water_tile& tile, const water_sea& sea, double time)
{
  const bool isOther = this->Amplitudes.empty() || !water_tile_is_same(&tile, &this->Tile) ||
    !water_sea_is_same(&sea, &this->Sea);
  if (!isOther && time == this->Time)
  {
    return false;
  }
  this->Time = time;
  this->HasPhasors = false;
  for (Pair& pair : this->Pairs)
  {
    pair.IsMade = false;
  }
  if (isOther)
  {
    this->Tile = tile;
    this->Sea = sea;
    this->Amplitudes.clear(); // and last: there are none unless there is memory for all
    this->Frequencies.resize(tile.size / 2 * (tile.size / 2));
    water_tile_frequencies(&tile, &sea, this->Frequencies.data());
    this->Amplitudes.resize(2 * tile.size * tile.size);
    water_tile_amplitudes(&tile, &sea, this->Amplitudes.data());
  }
  return isOther;
}

//------------------------------------------------------------------------------
void vtkWaterSeaTile::UpdatePhasors()
{
  if (this->HasPhasors)
  {
    return;
  }
  this->Phasors.resize(2 * this->Frequencies.size());
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(this->Tile.size / 2), [this](vtkIdType first, vtkIdType end) {
      water_tile_phasors(&this->Tile, this->Frequencies.data(), this->Time,
        static_cast<size_t>(first), static_cast<size_t>(end), this->Phasors.data());
    });
  this->HasPhasors = true;
}

//------------------------------------------------------------------------------
const vtkWaterSeaTile::Pair& vtkWaterSeaTile::Make(water_tile_pair pair)
{
  Pair& made = this->Pairs[pair];
  if (made.IsMade)
  {
    return made;
  }
  this->UpdatePhasors();
  const bool isOne = pair == WATER_PAIR_HEIGHT || pair == WATER_PAIR_SHEAR;
  made.First.resize(this->Tile.size * this->Tile.size);
  made.Second.resize(isOne ? 0 : made.First.size());
  this->Transform.Run(
    this->Tile.size,
    [this, pair](size_t row, double* own, double* mirror) {
      water_tile_pair_row(
        &this->Tile, this->Amplitudes.data(), this->Phasors.data(), pair, row, own, mirror);
    },
    made.First.data(), isOne ? nullptr : made.Second.data());
  made.IsMade = true;
  return made;
}

//------------------------------------------------------------------------------
const double* vtkWaterSeaTile::GetHeight()
{
  return this->GetFirst(
    this->Pairs[WATER_PAIR_HEIGHT_SHEAR].IsMade ? WATER_PAIR_HEIGHT_SHEAR : WATER_PAIR_HEIGHT);
}
