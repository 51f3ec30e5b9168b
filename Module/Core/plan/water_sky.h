// SPDX-License-Identifier: BSD-3-Clause
// water_sky.h: in addition to the plan: the sky behind all props in a direction: pictures of the
// surroundings as vtkSkybox shows them, and their floor.
//
// Sources of the conventions: the fragment shaders of vtkOpenGLSkybox (VTK 9.1.0 and 9.6.2), which
// TestWaterSky.py compares with what VTK draws.
#ifndef water_sky_h
#define water_sky_h

#include "water_features.h"
#include "water_lookup.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

// A sky without a map: that of the screen.
void water_sky_map_none(water_sky_map* map);

// A picture in longitude and latitude, with the projection Sphere of vtkSkybox.
//
// rotation  world -> (right, up, back) of the picture, 3 rows
void water_sky_map_sphere(const double rotation[9], water_sky_map* map);

// Two of them, one above the other, for two eyes, with the projection StereoSphere.
void water_sky_map_stereo(const double rotation[9], bool is_left_eye, water_sky_map* map);

// A cube map.
//
// rotation  world -> (right, up, back)
// is_turned  as later VTKs have it, whose cube's sixth face is at the back; VTK 9.1: at the front
void water_sky_map_cube(const double rotation[9], bool is_turned, water_sky_map* map);

// The rotation of a picture that lies on a floor, as VTK 9.1 has it: up is the floor's normal, and
// the picture's middle is at up x right. A normal without a length stays as it is.
void water_sky_rotation_on_floor(const double plane[4], const double right[3], double rotation[9]);

// A floor, as the projection Floor has it.
//
// plane  n, d: dot(n, point) + d = 0
// right  direction of u
// scale  lengths that the texture has in u and v, not 0
void water_sky_floor_make(
  const double plane[4], const double right[3], const double scale[2], water_sky_floor* floor);

// A map of world directions for directions in a plane's axes.
void water_sky_map_local(const water_sky_map* world, const water_axes* axes, water_sky_map* local);

// The water's own picture of its surroundings, likewise.
//
// up, right  of the picture, in world; water_lookup_environment
void water_sky_environment(
  const double up[3], const double right[3], const water_axes* axes, water_sky_map* local);

// A floor of world points for points in a plane's axes.
//
// origin_xy  of these, in the plane's own axes
void water_sky_floor_local(const water_sky_floor* world, const water_axes* axes,
  const double origin_xy[2], water_sky_floor* local);

// The map of a water's sky: its own picture, otherwise that of the scene.
const water_sky_map* water_sky_of(const water_plan* plan, bool has_environment);

// Has that sky one colour in all directions?
bool water_sky_is_one_color(const water_plan* plan, bool has_environment);

// Adds the WATER_FEATURE_SKY_* of a shader that looks a sky up to the features.
//
// has_environment  the water has a picture of its own
// is_below         the eye is under it
// sky              of the scene
water_feature_set water_sky_features(
  water_feature_set features, bool has_environment, bool is_below, const water_sky* sky);

#ifdef __cplusplus
}
#endif
#endif
