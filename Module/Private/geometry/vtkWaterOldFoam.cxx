// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterOldFoam.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

//------------------------------------------------------------------------------
void vtkWaterOldFoam::FillTexels(const water_sea& sea, double newest)
{
  const size_t places = this->Foam.tile.size * this->Foam.tile.size;
  const double end = newest - static_cast<double>(this->Foam.count);
  this->Shares.erase(this->Shares.begin(), this->Shares.upper_bound(end));
  this->Shares.erase(this->Shares.upper_bound(newest), this->Shares.end());
  std::vector<const unsigned char*> all;
  for (size_t i = 0; i < this->Foam.count; ++i)
  {
    const double number = newest - static_cast<double>(i);
    auto found = this->Shares.find(number);
    if (found == this->Shares.end())
    {
      this->Tile.Update(this->Foam.tile, sea, water_old_foam_time(&this->Foam, number));
      std::vector<unsigned char> shares(places);
      water_old_foam_shares(&this->Foam, this->Tile.GetFirst(WATER_PAIR_STRETCH),
        this->Tile.GetSecond(WATER_PAIR_STRETCH), shares.data());
      found = this->Shares.emplace(number, std::move(shares)).first;
    }
    all.push_back(found->second.data());
  }
  this->Texels.resize(4 * places);
  water_old_foam_join(&this->Foam, all.data(), this->Texels.data());
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkWaterOldFoam::Upload(
  vtkOpenGLRenderWindow* window, const water_old_foam& foam, const water_sea& sea, double time)
{
  if (foam.count == 0)
  {
    if (!this->None.Get(window))
    {
      this->None.Upload(window, 1, 1, 1, std::vector<float>(4, 0.0f));
    }
    return this->None.Get(window);
  }
  if (!water_old_foam_is_same(&foam, &this->Foam) || !water_sea_is_same(&sea, &this->Sea))
  {
    this->Shares.clear();
    this->IsUploaded = false;
    this->Foam = foam;
    this->Sea = sea;
  }
  double newest;
  double weights[3];
  water_old_foam_at(&foam, time, &newest, weights);
  if (this->IsUploaded && newest == this->Uploaded && this->Texture.Get(window))
  {
    return this->Texture.Get(window);
  }
  this->IsUploaded = false;
  this->FillTexels(sea, newest);
  const auto size = static_cast<unsigned int>(foam.tile.size);
  this->Texture.Upload(window, size, size, 1, this->Texels);
  this->Uploaded = newest;
  this->IsUploaded = true;
  return this->Texture.Get(window);
}

//------------------------------------------------------------------------------
void vtkWaterOldFoam::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture.ReleaseGraphicsResources(window);
  this->None.ReleaseGraphicsResources(window);
}
