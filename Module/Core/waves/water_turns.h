// SPDX-License-Identifier: BSD-3-Clause
// water_turns.h: the phases of many waves as integers of 32 bits, which GPUs multiply exactly.
// Their floats would not be precise enough: after a day, float32 cannot represent a wave's phase.
//
// A unit of time is 2^-exponent s (or periods: whatever the clock counts). A frequency is a
// fraction of 96 bits, in turns a unit, and a time a whole number of units. The fraction of their
// product, of which a shader needs the upper 32 bits (vtkWaterTurns.glsl), is the phase: whole
// turns fall off its upper end by themselves.
//
// Proof: a frequency is below 2^-26 turns a unit. The time is rounded to half a unit: 2^-27 turns
// at most. The frequency is cut after 96 bits, and there are fewer than 2^63 units: 2^-33 turns.
// The product's lower parts that are left out are less than 3 * 2^-32 turns. Together less than
// 2^-26 turns: 1e-7 rad.
#ifndef water_turns_h
#define water_turns_h

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

// The exponent of the unit for frequencies from 0 up to a largest one, in turns a second.
int water_turns_exponent(double largest);

// A frequency, from 0 up to the largest one, as a fraction of 96 bits; the first word is the upper
// one.
void water_turns_frequency(double frequency, int exponent, uint32_t words[3]);

// A time as a whole number of units; the first word is the lower one. Phases of times before 0 are
// those of -time, negative.
//
// Returns false for 2^63 units and more, where phases would be wrong. Then words are unchanged.
// That is |time| >= 2^37 / largest, up to a factor of 2.
bool water_turns_time(double time, int exponent, uint32_t words[2]);

#ifdef __cplusplus
}
#endif
#endif
