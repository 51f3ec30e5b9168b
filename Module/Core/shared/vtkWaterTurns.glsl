// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterTurns.glsl: phases in whole numbers: a turn has 2^32 parts (water_turns.h says how far they
// are right); for shaders and, by water_shared.c, for C.

// The upper half of a product of 64 bits.
uint waterUpperHalf(uint a, uint b)
{
  uint lower = (a & 0xFFFFu) * (b & 0xFFFFu);
  uint first = (a >> 16u) * (b & 0xFFFFu) + (lower >> 16u);
  uint second = (a & 0xFFFFu) * (b >> 16u) + (first & 0xFFFFu);
  return (a >> 16u) * (b >> 16u) + (first >> 16u) + (second >> 16u);
}

// The phase after a time, in parts of a turn.
//
// f0, f1, f2  the frequency (water_turns_frequency)
// t0, t1      the time (water_turns_time)
uint waterPhase(uint f0, uint f1, uint f2, uint t0, uint t1)
{
  return f0 * t0 + f1 * t1 + waterUpperHalf(f1, t0) + waterUpperHalf(f2, t1);
}

// Within 1e-7, which a driver's own sine does not promise: series of Taylor in an eighth of a turn.
//
// phase  in parts of a turn
float waterCosine(uint phase)
{
  uint shifted = phase + 0x20000000u;
  uint quarter = shifted >> 30u;
  float part = shifted & 0x3FFFFFFFu;
  float angle = 6.283185307179586 * (part * 2.3283064365386963e-10 - 0.125);
  float square = angle * angle;
  float cosine = 1.0 -
    square * (0.5 - square * (1.0 / 24.0 - square * (1.0 / 720.0 - square * (1.0 / 40320.0))));
  float sine = angle *
    (1.0 -
      square *
        (1.0 / 6.0 -
          square * (1.0 / 120.0 - square * (1.0 / 5040.0 - square * (1.0 / 362880.0)))));
  float value = (quarter & 1u) == 0u ? cosine : -sine;
  return (quarter & 2u) == 0u ? value : -value;
}

float waterSine(uint phase)
{
  return waterCosine(phase - 0x40000000u);
}
