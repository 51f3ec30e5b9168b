// SPDX-License-Identifier: BSD-3-Clause
// water_matter.c: matter that the water carries.
#include "water_matter.h"

#include "water_math.h"

double water_matter_concentration(double value)
{
  return isfinite(value) && value > 0.0 ? fmin(value, WATER_MATTER_MOST) : 0.0;
}

void water_matter_sediment(double absorption[3], double scattering[3])
{
  static const double wavelength_nm[3] = { 650.0, 550.0, 450.0 };
  for (int i = 0; i < 3; ++i)
  {
    absorption[i] = 0.041 * exp(-0.0123 * (wavelength_nm[i] - 443.0));
    scattering[i] = 0.012;
  }
}
