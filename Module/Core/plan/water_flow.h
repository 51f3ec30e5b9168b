// SPDX-License-Identifier: BSD-3-Clause
// water_flow.h: a current that carries the small waves, by a two-phase flow map.
//
// A current that carries a pattern for a long time tears it apart, because each place has a
// different velocity. Therefore two layers of the same waves are each carried for one period, half
// a period apart, and then start again undisturbed. A layer starts with the weight 0, and has the
// full weight in the middle of its period. Source: Vlachos 2010, "Water flow in Portal 2" (SIGGRAPH
// 2010, Advances in Real-Time Rendering in 3D Graphics and Games).
#ifndef water_flow_h
#define water_flow_h

#include "water_lookup.h"

#ifdef __cplusplus
extern "C"
{
#endif

#define WATER_FLOW_PERIOD_MIN 1e-3 // s
#define WATER_FLOW_PERIOD_MAX 1e6
#define WATER_FLOW_SPEED_MAX 1e4 // m/s, of a component: what solvers fill dry places with is faster

typedef struct water_flow
{
  double gone[2]; // share of its period that each layer has been carried, in [0, 1)
  double weight;  // of the first layer, in [0, 1]; the second one has the rest
} water_flow;

// A component of a velocity, as it is used: 0 if it is not finite or faster than
// WATER_FLOW_SPEED_MAX.
double water_flow_component(double velocity);

// The layers at a time. They depend on the time alone.
//
// time    s, finite
// period  s, in [WATER_FLOW_PERIOD_MIN, WATER_FLOW_PERIOD_MAX]
water_flow water_flow_at(double time, double period);

// The two rows that turn a current into its path in a period, along the plane's axes and in the
// scene's unit: the path is (across . current, down . current). The current is in m/s, along the
// axes of the mesh. The mesh's matrix rotates it, but does not scale its speed as a whole, whatever
// the matrix does to heights.
//
// metres_per_unit  > 0
// across           3 numbers; 0: the matrix has no inverse
// down             the same
void water_flow_ways(const water_axes* axes, const double mesh_to_world[16], double period,
  double metres_per_unit, double across[3], double down[3]);

// The distance over which the slopes of waves decorrelate. Layers that are further apart add like
// independent waves, nearer ones like one wave. An eighth of the longest wave was chosen, because
// shorter waves, which contribute as much to the slopes, decorrelate sooner.
//
// This does not apply to a wind sea: waterFlowBandGain keeps the variance of each of its tiles.
//
// longest  wave; 0: there is none, and the distance has no limit (1e30)
double water_flow_likeness(double longest);

#ifdef __cplusplus
}
#endif
#endif
