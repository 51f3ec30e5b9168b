// SPDX-License-Identifier: BSD-3-Clause
// water_medium.c: light in the water: refraction, what the way through it takes, what it scatters
// back.
#include "water_medium.h"

#include "water_math.h"
#include "water_shared.h"

static double clamp_unit(double value)
{
  return fmin(fmax(value, 0.0), 1.0);
}

const char* water_type_text(water_type type)
{
  static const char* const texts[] = {
#define WATER_TYPE_TEXT(name, text) text,
    WATER_TYPE_LIST(WATER_TYPE_TEXT)
#undef WATER_TYPE_TEXT
  };
  const size_t number = (size_t)type; // a negative value becomes a large one
  return number < WATER_TYPE_COUNT ? texts[number] : "unknown type";
}

water_status water_medium_check(const water_medium* medium)
{
  for (int i = 0; i < 3; ++i)
  {
    if (!(medium->absorption[i] >= 0.0 && medium->absorption[i] <= WATER_COEFFICIENT_MAX))
    {
      return WATER_BAD_ABSORPTION;
    }
    if (!(medium->scattering[i] >= 0.0 && medium->scattering[i] <= WATER_COEFFICIENT_MAX))
    {
      return WATER_BAD_SCATTERING;
    }
  }
  return WATER_OK;
}

static bool is_unit(const double dir[3])
{
  return fabs(water_vec3_length(dir) - 1.0) <= 1e-6; // false for NaN
}

water_status water_medium_refract(
  const double dir[3], const double normal[3], double eta, double refracted[3])
{
  if (!is_unit(dir) || !is_unit(normal))
  {
    return WATER_BAD_DIRECTION;
  }
  if (!isfinite(eta) || !(eta > 0.0))
  {
    return WATER_BAD_INDEX_RATIO;
  }
  const double along = water_vec3_dot(dir, normal);
  // the part of the ray along the surface shrinks by eta; made by two cross products, as the
  // difference dir - along * normal loses its digits near the normal
  double across[3];
  double tangent[3];
  water_vec3_cross(normal, dir, across);
  water_vec3_cross(across, normal, tangent);
  for (int i = 0; i < 3; ++i)
  {
    tangent[i] /= eta; // first, as the square of eta, or of a short tangent, may vanish
  }
  const double squared = 1.0 - water_vec3_dot(tangent, tangent);
  if (squared < 0.0)
  {
    return WATER_TOTAL_REFLECTION;
  }
  const double onward = copysign(sqrt(squared), along);
  for (int i = 0; i < 3; ++i)
  {
    refracted[i] = tangent[i] + onward * normal[i];
  }
  return WATER_OK;
}

double water_medium_cosine(double cosine, double eta)
{
  const double c = clamp_unit(cosine);
  // (eta - 1)(eta + 1) keeps its digits for an eta near 1
  return sqrt(fmax((eta - 1.0) * (eta + 1.0) + c * c, 0.0)) / eta;
}

double water_medium_path(double depth, double cosine, double eta)
{
  return depth / water_medium_cosine(cosine, eta);
}

double water_medium_apparent_depth(double depth, double cosine, double eta)
{
  // both rays cross the same width: depth tan(refracted) = apparent tan(incident)
  return depth * clamp_unit(cosine) / (eta * water_medium_cosine(cosine, eta));
}

void water_medium_extinction(const water_medium* medium, double extinction[3])
{
  for (int channel = 0; channel < 3; ++channel)
  {
    extinction[channel] = medium->absorption[channel] + medium->scattering[channel];
  }
}

void water_medium_reflectance(const water_medium* medium, double reflectance[3])
{
  double extinction[3];
  water_medium_extinction(medium, extinction);
  for (int channel = 0; channel < 3; ++channel)
  {
    reflectance[channel] = water_shared_sent_back(medium->scattering[channel], extinction[channel]);
  }
}

void water_medium_transmittance(const water_medium* medium, double path, double transmittance[3])
{
  for (int i = 0; i < 3; ++i)
  {
    transmittance[i] =
      water_shared_transmittance(medium->absorption[i] + medium->scattering[i], path);
  }
}

void water_medium_inscatter(const water_medium* medium, double depth, double cosine_sun,
  double cosine_eye, double phase, double inscatter[3])
{
  const double both_ways = 1.0 / cosine_sun + 1.0 / cosine_eye;
  for (int i = 0; i < 3; ++i)
  {
    const double lost = medium->absorption[i] + medium->scattering[i];
    // 0 * infinity: water that takes nothing scatters nothing, however deep
    const double part = lost > 0.0 ? -expm1(-lost * depth * both_ways) / lost : 0.0;
    inscatter[i] = medium->scattering[i] * phase / (cosine_sun + cosine_eye) * part;
  }
}

water_status water_type_attenuation(water_type type, double kd[3])
{
  static const double table[WATER_TYPE_COUNT][3] = {
    // 1/m at 650, 550, 450 nm
    { 0.360, 0.063, 0.019 }, // I
    { 0.370, 0.067, 0.026 }, // IA
    { 0.375, 0.072, 0.036 }, // IB
    { 0.400, 0.089, 0.068 }, // II
    { 0.445, 0.120, 0.135 }, // III
    { 0.450, 0.120, 0.250 }, // 1C
    { 0.460, 0.190, 0.390 }, // 3C
    { 0.540, 0.300, 0.560 }, // 5C
    { 0.630, 0.460, 0.890 }, // 7C
    { 0.760, 0.630, 1.600 }  // 9C
  };
  const size_t number = (size_t)type;
  if (number >= WATER_TYPE_COUNT)
  {
    return WATER_BAD_WATER_TYPE;
  }
  memcpy(kd, table[number], sizeof table[number]);
  return WATER_OK;
}

water_status water_type_medium(water_type type, water_medium* medium)
{
  static const double wavelength_nm[3] = { 650.0, 550.0, 450.0 };
  double kd[3];
  const water_status status = water_type_attenuation(type, kd);
  if (status != WATER_OK)
  {
    return status;
  }
  for (int i = 0; i < 3; ++i)
  {
    const double backward = 0.5 * 16.06 * 4.72e-4 * pow(400.0 / wavelength_nm[i], 4.32);
    medium->scattering[i] = backward;
    medium->absorption[i] = kd[i] / 1.0395 - backward;
  }
  return WATER_OK;
}
