// SPDX-License-Identifier: BSD-3-Clause
// water_random.h: random numbers by their number: no state, and the same bits on every machine.
//
// The bits are the same because only + - * / and sqrt are used, whose rounding IEEE 754 defines.
// The logarithm and the sine differ in the last bit between C libraries.
#ifndef water_random_h
#define water_random_h

#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

// Number counter (from 0) of the sequence that splitmix64 gives for the seed.
// Source: Steele, Lea and Flood 2014, "Fast Splittable Pseudorandom Number Generators".
uint64_t water_random_bits(uint64_t seed, uint64_t counter);

// Number counter of the seed's sequence of numbers spread evenly in [0, 1).
double water_random_uniform(uint64_t seed, uint64_t counter);

// Two independent normal numbers (mean 0, variance 1, none beyond 8.6), number counter of the
// seed's pairs. Box and Muller's formula within 4e-15.
// Source: Box and Muller 1958, "A Note on the Generation of Random Normal Deviates".
void water_random_normal(uint64_t seed, uint64_t counter, double pair[2]);

#ifdef __cplusplus
}
#endif
#endif
