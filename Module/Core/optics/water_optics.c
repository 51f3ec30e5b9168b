// SPDX-License-Identifier: BSD-3-Clause
// water_optics.c: how much the surface reflects.
#include "water_optics.h"

#include "water_math.h"
#include "water_shared.h"

static double clamp_unit(double value)
{
  return fmin(fmax(value, 0.0), 1.0);
}

water_status water_optics_check(const water_look* look)
{
  if (!isfinite(look->index_of_refraction) || look->index_of_refraction < 1.0)
  {
    return WATER_BAD_INDEX;
  }
  if (!(look->reflectance >= 0.0 && look->reflectance <= 1.0))
  {
    return WATER_BAD_REFLECTANCE;
  }
  return WATER_OK;
}

void water_optics_join(const water_look* look, water_look* all)
{
  if (look->constant_reflectance && all->constant_reflectance)
  {
    all->reflectance = fmax(all->reflectance, look->reflectance);
  }
  else if (look->constant_reflectance != all->constant_reflectance ||
    look->index_of_refraction != all->index_of_refraction)
  {
    // which reflects more depends on the angle
    all->constant_reflectance = true;
    all->reflectance = 1.0;
  }
}

double water_optics_eta(const water_look* look, water_side side)
{
  return side == WATER_BELOW ? 1.0 / look->index_of_refraction : look->index_of_refraction;
}

double water_optics_fresnel(double cosine, double eta)
{
  return water_shared_fresnel(cosine, eta);
}

double water_optics_schlick(double cosine, double eta)
{
  return water_shared_schlick(cosine, eta);
}

double water_optics_reflectance_max(const water_look* look, double eta, const double ndc_to_ray[9],
  const double box[4], double slope_max)
{
  if (look->constant_reflectance)
  {
    return look->reflectance;
  }
  // The angle to the normal is largest in a corner: the box is a spherical polygon of directions.
  double most = 0.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const double x = corner & 1 ? box[2] : box[0];
    const double y = corner & 2 ? box[3] : box[1];
    double ray[3];
    for (int i = 0; i < 3; ++i)
    {
      ray[i] = ndc_to_ray[3 * i] * x + ndc_to_ray[3 * i + 1] * y + ndc_to_ray[3 * i + 2];
    }
    const double angle = atan2(hypot(ray[0], ray[1]), -ray[2]) + atan(slope_max);
    most = fmax(most, angle);
  }
  return water_optics_fresnel(cos(most), eta);
}

double water_optics_critical_rad(double eta)
{
  return asin(clamp_unit(eta));
}
