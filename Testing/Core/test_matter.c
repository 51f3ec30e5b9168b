// SPDX-License-Identifier: BSD-3-Clause
// test_matter.c: matter that the water carries.
#include "test_main.h"

#include "water_daylight.h"
#include "water_matter.h"
#include "water_medium.h"
#include "water_shared.h"

// What the light loses grows with the concentration: twice as much matter is as good as twice the
// way through it, and none is as good as clear water.
TEST(twice_the_matter_is_as_good_as_twice_the_way)
{
  for (double concentration = 0.01; concentration < 1000.0; concentration *= 3.0)
  {
    for (double way = 0.1; way < 20.0; way *= 2.0)
    {
      const double one = water_shared_with_matter(0.0, 0.02, concentration);
      const double two = water_shared_with_matter(0.0, 0.02, 2.0 * concentration);
      ASSERT_CLOSE(
        water_shared_transmittance(two, way), water_shared_transmittance(one, 2.0 * way), 1e-15);
      const double mixed = water_shared_with_matter(0.3, 0.02, concentration);
      const double apart =
        water_shared_transmittance(0.3, way) * water_shared_transmittance(one, way);
      ASSERT_CLOSE(water_shared_transmittance(mixed, way), apart, 1e-14);
    }
  }
  ASSERT_CLOSE(water_shared_with_matter(0.37, 0.02, 0.0), 0.37, 0.0);
}

// Water with much sediment has the sediment's own color, and with none that of clear water: both as
// the core knows the color of a medium.
TEST(deep_water_goes_from_its_own_color_to_the_matters)
{
  const water_medium clear = { { 0.36, 0.06, 0.02 }, { 0.0006, 0.0012, 0.003 } };
  water_medium sediment;
  water_matter_sediment(sediment.absorption, sediment.scattering);
  double own[3];
  double matter[3];
  water_medium_reflectance(&clear, own);
  water_medium_reflectance(&sediment, matter);
  for (int i = 0; i < 3; ++i)
  {
    double before = own[i];
    for (double concentration = 0.0; concentration < 1e9;
         concentration = concentration * 4.0 + 0.01)
    {
      const double b =
        water_shared_with_matter(clear.scattering[i], sediment.scattering[i], concentration);
      const double a =
        water_shared_with_matter(clear.absorption[i], sediment.absorption[i], concentration);
      const double sent_back = water_shared_sent_back(b, a + b);
      assert_true((sent_back - before) * (matter[i] - own[i]) >= -1e-15);
      before = sent_back;
    }
    ASSERT_CLOSE(before, matter[i], 1e-7);
    ASSERT_CLOSE(
      water_shared_sent_back(clear.scattering[i], clear.absorption[i] + clear.scattering[i]),
      own[i], 1e-15);
  }
  assert_true(matter[0] > matter[1] && matter[1] > matter[2]); // sediment is brown
}

// The numbers of the sources, by hand: Babin et al. 2003 at 443 nm, Neukermans et al. 2012.
TEST(sediment_is_that_of_the_sources)
{
  double absorption[3];
  double scattering[3];
  water_matter_sediment(absorption, scattering);
  const double wanted[3] = { 0.00321386, 0.01099535, 0.03761760 };
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(absorption[i], wanted[i], 1e-8);
    ASSERT_CLOSE(scattering[i], 0.012, 0.0);
  }
}

// What no concentration can be counts as none.
TEST(values_that_are_no_concentration_count_as_0)
{
  ASSERT_CLOSE(water_matter_concentration(2.5), 2.5, 0.0);
  ASSERT_CLOSE(water_matter_concentration(0.0), 0.0, 0.0);
  ASSERT_CLOSE(water_matter_concentration(-1e-9), 0.0, 0.0);
  ASSERT_CLOSE(water_matter_concentration(NAN), 0.0, 0.0);
  ASSERT_CLOSE(water_matter_concentration(INFINITY), 0.0, 0.0);
  ASSERT_CLOSE(water_matter_concentration(-INFINITY), 0.0, 0.0);
  ASSERT_CLOSE(water_matter_concentration(1e300), WATER_MATTER_MOST, 0.0);
}

TESTS(twice_the_matter_is_as_good_as_twice_the_way,
  deep_water_goes_from_its_own_color_to_the_matters, sediment_is_that_of_the_sources,
  values_that_are_no_concentration_count_as_0)
