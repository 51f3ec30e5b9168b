// SPDX-License-Identifier: BSD-3-Clause
// water_foam_measure.h: what data say of foam, as the share of the surface that it covers.
//
// A measure has two values: up to the first there is no foam, from the last one on foam covers the
// whole surface, and between them the share is linear (waterFoamOfMeasure). That it is linear was
// chosen.
#ifndef water_foam_measure_h
#define water_foam_measure_h

#ifdef __cplusplus
extern "C"
{
#endif

// X(name, first, last, text)
//
// COVER           The share itself, such as the fraction of air at the surface.
// FROUDE_NUMBER   Velocity over sqrt(g depth). Water flows faster than its waves above 1, and the
//                 jump behind such a flow has a breaking roller from 1.7 on; below, it is a train
//                 of waves (undular). Source: Chow 1959, "Open-Channel Hydraulics", section 15-1.
// BREAKING_INDEX  Height of the waves over the depth. On a level bed they break at 0.78. Source:
//                 McCowan 1894, "On the Highest Wave of Permanent Type". On a bed that rises 1 in
//                 20 they break at 1.56 / (1 + exp(-19.5 / 20)) = 1.13 at the latest. Source:
//                 Weggel 1972, "Maximum Breaker Height".
#define WATER_FOAM_MEASURE_LIST(X)                                                                 \
  X(COVER, 0.0, 1.0, "cover")                                                                      \
  X(FROUDE_NUMBER, 1.0, 1.7, "froude")                                                             \
  X(BREAKING_INDEX, 0.78, 1.13, "breaking")

typedef enum water_foam_measure
{
#define WATER_FOAM_MEASURE_VALUE(name, first, last, text) WATER_FOAM_##name,
  WATER_FOAM_MEASURE_LIST(WATER_FOAM_MEASURE_VALUE)
#undef WATER_FOAM_MEASURE_VALUE
    WATER_FOAM_MEASURE_COUNT
} water_foam_measure;

// Name of a measure, never NULL; static storage.
const char* water_foam_measure_text(water_foam_measure measure);

// The measure of a name; WATER_FOAM_MEASURE_COUNT: there is none.
water_foam_measure water_foam_measure_of(const char* text);

// First and last value of a measure; another number counts as COVER.
void water_foam_measure_ends(water_foam_measure measure, double ends[2]);

// A value as it is used: 0 if it is negative or not finite; a cover is at most 1. Covers up to
// 1e-6 above 1 are roundings, and are kept.
double water_foam_measure_value(water_foam_measure measure, double value);

#ifdef __cplusplus
}
#endif
#endif
