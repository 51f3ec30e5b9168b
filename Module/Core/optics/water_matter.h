// SPDX-License-Identifier: BSD-3-Clause
// water_matter.h: matter that the water carries: sediment, algae, a dye.
//
// Its absorption and its scattering are added to the water's own (waterWithMatter). Both are in 1/m
// per unit of concentration, at 650, 550 and 450 nm. A ray sees the concentration of the point of
// the surface where it enters the water, along all of its path.
#ifndef water_matter_h
#define water_matter_h

#ifdef __cplusplus
extern "C"
{
#endif

#define WATER_MATTER_MOST 1e15 // a concentration: products with coefficients stay finite in floats

// A concentration as it is used: 0 if it is negative or not finite, at most WATER_MATTER_MOST.
double water_matter_concentration(double value);

// Suspended mineral sediment, per g/m^3 (equal to mg/l).
//
// absorption  0.041 m^2/g at 443 nm, falling as exp(-0.0123 (wavelength - 443 nm)). Source: Babin
//             et al. 2003, "Variations in the Light Absorption Coefficients of Phytoplankton,
//             Nonalgal Particles, and Dissolved Organic Matter in Coastal Waters around Europe".
// scattering  backward, 0.012 m^2/g at all wavelengths. Source: Neukermans et al. 2012, "In Situ
//             Variability of Mass-specific Beam Attenuation and Backscattering of Marine Particles"
//             (inorganic particles).
void water_matter_sediment(double absorption[3], double scattering[3]);

#ifdef __cplusplus
}
#endif
#endif
