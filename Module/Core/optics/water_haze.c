// SPDX-License-Identifier: BSD-3-Clause
// water_haze.c: light that the water scatters towards an eye in it.
#include "water_haze.h"

#include "water_math.h"
#include "water_shared.h"

enum
{
  ZENITHS = 12,
  AZIMUTHS = 32,
  NODES = 4
};

static const double nodes[NODES] = { WATER_HAZE_FALL_MIN, 0.0, 0.5, 1.0 };
static const double pi = 3.14159265358979323846;
static const double sky_way = 1.197; // per depth, of the light of an even sky

// Mean of waterHazeParticles over the light of an even sky, which is refracted into a cone.
static double sky_particles(double fall, double index)
{
  const double narrow = sqrt(fmax(1.0 - 1.0 / (index * index), 0.0)); // cosine of its edge
  const double across = sqrt(fmax(1.0 - fall * fall, 0.0));
  double sum = 0.0;
  for (int i = 0; i < ZENITHS; ++i)
  {
    const double cosine = narrow + (1.0 - narrow) * (i + 0.5) / ZENITHS;
    const double sine = sqrt(1.0 - cosine * cosine);
    for (int j = 0; j < AZIMUTHS; ++j)
    {
      const double turn = 2.0 * pi * (j + 0.5) / AZIMUTHS;
      sum += water_shared_haze_particles(across * sine * cos(turn) - fall * cosine);
    }
  }
  return sum / (ZENITHS * AZIMUTHS);
}

static double sky_molecules(double fall, double index)
{
  const double narrow = sqrt(fmax(1.0 - 1.0 / (index * index), 0.0));
  const double squared = (1.0 + narrow + narrow * narrow) / 3.0; // mean of the cosine's square
  const double mean = fall * fall * squared + (1.0 - fall * fall) * (1.0 - squared) / 2.0;
  return 0.75 * (1.0 + mean);
}

// Coefficients of the cubic through the values at the nodes.
static void fit(const double values[NODES], double cubic[NODES])
{
  for (int i = 0; i < NODES; ++i)
  {
    cubic[i] = 0.0;
  }
  for (int i = 0; i < NODES; ++i) // Lagrange's polynomials
  {
    double product[NODES] = { values[i], 0.0, 0.0, 0.0 };
    for (int j = 0; j < NODES; ++j)
    {
      if (j == i)
      {
        continue;
      }
      for (int k = NODES - 1; k >= 0; --k)
      {
        const double shifted = k > 0 ? product[k - 1] : 0.0;
        product[k] = (shifted - nodes[j] * product[k]) / (nodes[i] - nodes[j]);
      }
    }
    for (int k = 0; k < NODES; ++k)
    {
      cubic[k] += product[k];
    }
  }
}

static double cubic_at(const double cubic[NODES], double fall)
{
  const double x = fmax(fall, WATER_HAZE_FALL_MIN);
  return cubic[0] + x * (cubic[1] + x * (cubic[2] + x * cubic[3]));
}

// Part of the backward scattering that is by molecules.
static double molecular_part(const water_medium* medium, const water_medium* pure, int channel)
{
  const double all = medium->scattering[channel];
  return all > 0.0 ? fmin(pure->scattering[channel] / all, 1.0) : 0.0;
}

static double mixed(double particles, double molecules, double part)
{
  return particles + part * (molecules - particles);
}

void water_haze_find(const water_haze_input* input, water_haze* haze)
{
  water_medium pure;
  (void)water_type_medium(WATER_TYPE_I, &pure); // its scattering is that of molecules
  const double height = fmin(input->sun_dir[2], 1.0);
  for (int i = 0; i < 2; ++i)
  {
    haze->sun_dir[i] = input->sun_dir[i] / input->index;
  }
  haze->sun_dir[2] = water_medium_cosine(height, input->index);
  double of_particles[NODES];
  double of_molecules[NODES];
  for (int i = 0; i < NODES; ++i)
  {
    of_particles[i] = sky_particles(nodes[i], input->index);
    of_molecules[i] = sky_molecules(nodes[i], input->index);
  }
  const double down = -haze->sun_dir[2]; // cosine of the angle for a look straight down
  for (int i = 0; i < 3; ++i)
  {
    const double all = input->daylight[i];
    const double sun =
      height > 0.0 && all > 0.0 ? fmin(height * input->sun_color[i] / all, 1.0) : 0.0;
    const double sun_way = sun / haze->sun_dir[2];
    const double ways = sun_way + (1.0 - sun) * sky_way;
    const double per_beam = 1.0395 * ways;
    haze->diffuse[i] = per_beam * input->extinction[i];
    const double part = molecular_part(&input->medium, &pure, i);
    const double share = sun_way / ways; // of the light in all directions
    double of_sky[NODES];
    for (int j = 0; j < NODES; ++j)
    {
      of_sky[j] = (1.0 - share) * mixed(of_particles[j], of_molecules[j], part);
    }
    const double straight =
      share * mixed(water_shared_haze_particles(down), water_shared_haze_molecules(down), part) +
      of_sky[NODES - 1];
    // without an end, straight down: 1 / (c + Kd), where a level way has 1 / c
    const double scale = input->deep[i] * (1.0 + per_beam) / straight;
    haze->particles[i] = scale * share * (1.0 - part);
    haze->molecules[i] = scale * share * part;
    fit(of_sky, haze->sky[i]);
    for (int j = 0; j < NODES; ++j)
    {
      haze->sky[i][j] *= scale;
    }
  }
}

double water_haze_share(double extinction, double depth)
{
  static const double all = 0.1; // optical depth
  const double x = fmin(fmax(extinction * depth / all, 0.0), 1.0);
  return x * x * (3.0 - 2.0 * x);
}

void water_haze_color(const water_haze* haze, const double extinction[3], const double dir[3],
  double depth, double way, double color[3])
{
  const double cosine = water_vec3_dot(dir, haze->sun_dir);
  for (int i = 0; i < 3; ++i)
  {
    const double source = cubic_at(haze->sky[i], -dir[2]) +
      haze->particles[i] * water_shared_haze_particles(cosine) +
      haze->molecules[i] * water_shared_haze_molecules(cosine);
    color[i] =
      source * water_shared_haze_over(extinction[i], haze->diffuse[i], -dir[2], depth, way);
  }
}
