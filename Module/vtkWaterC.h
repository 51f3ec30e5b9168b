/* SPDX-License-Identifier: BSD-3-Clause */
/**
 * @file
 * vtkWaterC.h: water, its pass and a small scene for C programs and foreign-function callers.
 *
 *   vtk_water_scene* scene;
 *   vtk_water_actor* water;
 *   vtk_water_scene_new(640, 400, &scene);
 *   vtk_water_scene_add_mesh(scene, points, point_count, triangles, triangle_count, color);
 *   vtk_water_actor_new(&water);
 *   vtk_water_actor_set_level(water, -0.2);
 *   vtk_water_scene_add_water(scene, water);
 *   vtk_water_scene_render(scene, pixels, sizeof pixels);
 *
 * Conventions. Handles are opaque. Delete each handle made by _new with _delete, in any order; NULL
 * may be deleted. Every function that can fail returns a status; vtk_water_status_text returns its
 * text. vtk_water_last_error describes the last failure in this thread, with the value and its
 * accepted range. A failed call changes nothing, except that vtk_water_scene_render still draws the
 * rest of the scene if a water cannot be drawn. No exception leaves a function. Output parameters
 * come last. Positions, levels and heights are in the scene's unit, which is a metre unless
 * vtk_water_actor_set_units sets another. Lengths marked with m are in metres. As in VTK, only one
 * thread at a time may use a scene and its contents.
 *
 * The symbols have the version VTK_WATER_C_1 (ELF). Within this version functions are added and
 * never changed.
 */
#ifndef vtkWaterC_h
#define vtkWaterC_h

#include <stddef.h> /* for size_t */
#include <stdint.h> /* for int64_t */

#include "vtkRenderingWaterModule.h" /* for the export macro */

#ifdef __cplusplus
extern "C"
{
#endif

typedef struct vtk_water_actor vtk_water_actor; /* a vtkWaterActor and its look */
typedef struct vtk_water_pass vtk_water_pass;   /* a vtkWaterReflectionPass; belongs to its water */
typedef struct vtk_water_scene vtk_water_scene; /* an off-screen window with one renderer */

typedef enum vtk_water_status
{
  VTK_WATER_OK = 0,
  VTK_WATER_NULL_ARGUMENT, /* a handle or pointer is NULL */
  VTK_WATER_BAD_VALUE,     /* out of range; vtk_water_last_error names it */
  VTK_WATER_NO_OPENGL,     /* nothing can render here */
  VTK_WATER_NO_MEMORY,
  VTK_WATER_FAILED, /* anything else */
  VTK_WATER_STATUS_COUNT
} vtk_water_status;

/* What a status means, in a few words; never NULL. */
VTKRENDERINGWATER_EXPORT const char* vtk_water_status_text(vtk_water_status status);

/* Text of the last failure in this thread; "" if there was none. Valid until the next call. */
VTKRENDERINGWATER_EXPORT const char* vtk_water_last_error(void);

/* Version of this interface: 1. */
VTKRENDERINGWATER_EXPORT int vtk_water_interface_version(void);

/* Version of the module, such as "0.2.0"; never NULL. */
VTKRENDERINGWATER_EXPORT const char* vtk_water_version(void);

/* The water ---------------------------------------------------------------------------------- */

VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_new(vtk_water_actor** actor);
VTKRENDERINGWATER_EXPORT void vtk_water_actor_delete(vtk_water_actor* actor);

/* Makes the water a horizontal plane at height z, +z up; finite. Default 0. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_level(
  vtk_water_actor* actor, double z);

/* Sets the plane by a point and its normal, which points out of the water and has any length except
 * 0. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_plane(
  vtk_water_actor* actor, const double origin[3], const double normal[3]);

/* Sets the bounds of the sheet in the plane's own axes: xmin, xmax, ymin, ymax. Default: as wide as
 * the scene. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_sheet_bounds(
  vtk_water_actor* actor, const double bounds[4]);

/* Chooses the extent of the sheet: as wide as the scene if the scene has ground under all of its
 * water, such as a terrain; otherwise to the horizon. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_sheet_to_automatic(
  vtk_water_actor* actor);

/* Extends the sheet to the horizon: it fills the visible part of the plane and is not part of the
 * scene's bounds. vtk_water_actor_set_sheet_bounds replaces this setting, and vice versa. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_sheet_to_horizon(
  vtk_water_actor* actor);

/* Sets a preset: "pool", "lake", "clear tropical", "ocean wind 5", "ocean wind 10", "ocean wind
 * 15", "turbid river" or "mirror floor". */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_preset(
  vtk_water_actor* actor, const char* name);

/* Adds a wave: amplitude and wavelength in m, direction and phase in degrees, steepness in [0, 1].
 */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_add_wave(vtk_water_actor* actor,
  double amplitude, double wavelength, double direction_deg, double phase_deg, double steepness);
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_remove_all_waves(vtk_water_actor* actor);

/* Sets a wind sea for this wind speed, m/s in [0.1, 100]; 0 removes the sea. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_wind(
  vtk_water_actor* actor, double speed);

/* Sets the direction in which the wind blows, in degrees from the plane's first axis towards the
 * second, finite. Default 0. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_wind_direction(
  vtk_water_actor* actor, double direction_deg);

/* Sets whitecaps. 1: a wind sea has foam where its crests break; 0: it has none. Default 0. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_whitecaps(
  vtk_water_actor* actor, int whitecaps);

/* Sets the time after which 1/e of a whitecap's foam is left, s in [0, 10]; 0: the foam vanishes as
 * soon as the crest does. Default 3.5. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_whitecap_life_time(
  vtk_water_actor* actor, double seconds);

/* Sets the colour of deep water: red, green and blue in [0, 1]. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_color(
  vtk_water_actor* actor, const double color[3]);

/* Sets the opacity, in [0, 1]; below 1 the water is blended with what lies behind it. Default 1. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_opacity(
  vtk_water_actor* actor, double opacity);

/* Sets refraction. 1: the scene is visible through the surface; 0: it is not. Default 0. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_refraction(
  vtk_water_actor* actor, int refraction);

/* Sets where refracted colours come from. 1: an additional view of what lies below the water, wider
 * than the picture; 0: the picture. Needs refraction. Default 0. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_own_view(
  vtk_water_actor* actor, int own_view);

/* Sets Jerlov's optical water type, which attenuates what is visible through the surface: "I",
 * "IA", "IB", "II", "III", "1C", "3C", "5C", "7C" or "9C". */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_water_type(
  vtk_water_actor* actor, const char* name);

/* Sets a depth, m, finite and not negative: there is foam at the shore where the water is
 * shallower. Needs refraction. Default 0: no foam. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_foam(
  vtk_water_actor* actor, double depth);

/* Sets the strength of caustics under the surface, in [0, 1]. Needs refraction, waves and a sun.
 * Default 0: no caustics. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_caustics(
  vtk_water_actor* actor, double strength);

/* Sets light shafts for a camera under water: the share of the light there, in [0, 1], that varies
 * because the waves above focus it. Needs refraction, waves and a sun. Default 0: no shafts. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_light_shafts(
  vtk_water_actor* actor, double share);

/* Sets shadows. 1: objects cast shadows on the water's glitter and foam; 0: they do not. Needs a
 * sun. Default 0. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_shadows(
  vtk_water_actor* actor, int shadows);

/* Sets the radius of a dome port, the glass dome around an underwater camera, m, finite and not
 * negative. Needs refraction. If the camera is less than this radius above the water, the picture
 * is half above and half under water. Default 0: no port. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_dome_port(
  vtk_water_actor* actor, double radius);

/* Sets the scene's unit: "um", "mm", "cm", "m", "km", "in", "ft", "mi" or "automatic", which
 * follows the scene's size. Default "m". */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_units(
  vtk_water_actor* actor, const char* name);

/* Sets the factor by which the scene's heights are drawn higher than they are, in [1e-6, 1e6].
 * Depths are divided by it before light is attenuated. Default 1. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_vertical_exaggeration(
  vtk_water_actor* actor, double factor);

/* Sets the quality of reflections on waves: "fast", "default", "high" or "reference". */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_quality(
  vtk_water_actor* actor, const char* name);

/* Sets a picture of the surroundings that is reflected instead of the scene, in longitude and
 * latitude. It has width x height x 3 bytes, red, green and blue, top row first, which are copied;
 * width and height are in [1, 16384]. In a scene of vtk_water_scene_new, up is +z, and +x is in the
 * middle of the picture. NULL, the default: the scene is reflected. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_environment(
  vtk_water_actor* actor, const unsigned char* pixels, int width, int height);

/* Sets a mesh as the water's surface, instead of the built-in sheet: point_count times x, y, z;
 * triangle_count times three point indices. The data are copied. It should lie in the water's
 * plane, apart from waves. NULL points, the default: the sheet. Each call, with points or with
 * NULL, removes the current, the matter and the foam from data. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_surface(vtk_water_actor* actor,
  const double* points, size_t point_count, const int64_t* triangles, size_t triangle_count);

/* Sets the current that carries the waves: point_count times the velocity along x, y and z, m/s, at
 * the points of vtk_water_actor_set_surface, of which there must be as many. The data are copied;
 * call it again for another time. Velocities that are not finite, or faster than 1e4 m/s, count as
 * 0. NULL, the default: no current. A current is visible only where there are waves. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_flow(
  vtk_water_actor* actor, const double* velocities, size_t point_count);

/* Sets how long the current carries a layer of waves before the layer begins again, s in [1e-3,
 * 1e6]: longer for slow water, shorter where the current changes from place to place. Default 4. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_flow_period(
  vtk_water_actor* actor, double seconds);

/* Sets the concentration of matter that the water carries, such as sediment or a dye, at the points
 * of vtk_water_actor_set_surface, of which there must be as many; finite and not negative, others
 * count as 0. The data are copied; call it again for another time. NULL, the default: no matter.
 * Matter is visible only with vtk_water_actor_set_refraction. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_matter(
  vtk_water_actor* actor, const double* concentrations, size_t point_count);

/* Sets what the matter absorbs and what it scatters back, each at 650, 550 and 450 nm in 1/m per
 * unit of its concentration, in [0, 1e9]. Default: mineral sediment in g/m^3, {0.0032, 0.0110,
 * 0.0376} and {0.012, 0.012, 0.012}. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_matter_optics(
  vtk_water_actor* actor, const double absorption[3], const double scattering[3]);

/* Sets how much foam there is at the points of vtk_water_actor_set_surface, of which there must be
 * as many. measure says what the values are: "cover", the share of the surface that foam covers, in
 * [0, 1]; "froude", Froude numbers, with foam from 1 on, which covers everything from 1.7 on;
 * "breaking", heights of the waves over the depth, with foam from 0.78 on, which covers everything
 * from 1.13 on. The data are copied. NULL values, the default: no foam from data. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_foam_data(
  vtk_water_actor* actor, const double* values, size_t point_count, const char* measure);

/* Sets the time of the waves, s in [-1e15, 1e15]. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_set_time(
  vtk_water_actor* actor, double seconds);

/* Returns the height of the waves above the plane at a point in the plane's own axes. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_get_wave_height(
  vtk_water_actor* actor, double x, double y, double* height);

/* Returns the vtkWaterActor, for programs that have VTK objects; it belongs to the handle. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_get_vtk_object(
  vtk_water_actor* actor, void** vtk_object);

/* The pass, which renders the reflection --------------------------------------------------- */

VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_actor_get_pass(
  vtk_water_actor* actor, vtk_water_pass** pass);

/* Sets the number of texels per pixel along each axis, in [1/64, 16]. Default 1. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_pass_set_texture_scale(
  vtk_water_pass* pass, double scale);

/* Sets the water's time budget in milliseconds per frame, in [1e-3, 1e6]; the reflection becomes
 * coarser while it takes longer. 0, the default: no budget. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_pass_set_time_budget(
  vtk_water_pass* pass, double milliseconds);

/* Sets secondary reflections. 1: other waters, in other planes, reflect the scene where this
 * water's reflection shows them; 0: they reflect only the sky there. Default 0. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_pass_set_secondary_reflections(
  vtk_water_pass* pass, int reflections);

/* Return the number of mirrored views rendered so far; the number of props in the last one; the
 * text of the last decision. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_pass_get_render_count(
  vtk_water_pass* pass, int64_t* count);
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_pass_get_prop_count(
  vtk_water_pass* pass, int64_t* count);
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_pass_get_decision(
  vtk_water_pass* pass, const char** text);

/* A scene, for programs that have no VTK objects --------------------------------------------- */

/* Creates an off-screen window of width x height pixels, each in [1, 16384]. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_scene_new(
  int width, int height, vtk_water_scene** scene);
VTKRENDERINGWATER_EXPORT void vtk_water_scene_delete(vtk_water_scene* scene);

/* Sets the sky's colours at the bottom and at the top of the picture, red, green and blue in [0,
 * 1]. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_scene_set_sky(
  vtk_water_scene* scene, const double bottom[3], const double top[3]);

/* Sets the sun, which glitters on waves: azimuth in degrees from +y towards +x, finite; elevation
 * in degrees above the horizon, in [0, 90]; red, green and blue in [0, 1], NULL for (1, 0.95,
 * 0.87). A scene has at most one sun; a new scene has none. A scene without any light is lit from
 * the eye. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_scene_set_sun(
  vtk_water_scene* scene, double azimuth_deg, double elevation_deg, const double color[3]);

/* Adds a light that shines from a point in all directions: finite position; red, green and blue in
 * [0, 1]; finite intensity, not negative. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_scene_add_light(
  vtk_water_scene* scene, const double position[3], const double color[3], double intensity);

/* Removes all lights, including the sun. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_scene_remove_all_lights(vtk_water_scene* scene);

/* Adds a mesh of one colour: point_count times x, y, z; triangle_count times three point indices.
 * The data are copied. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_scene_add_mesh(vtk_water_scene* scene,
  const double* points, size_t point_count, const int64_t* triangles, size_t triangle_count,
  const double color[3]);

/* Adds water. The scene keeps a reference to it: you may delete the handle, or continue to use
 * it. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_scene_add_water(
  vtk_water_scene* scene, vtk_water_actor* actor);

/* Sets the camera: the eye, the target, and an up vector that is not parallel to the line of sight.
 * The angle of view is vertical, in degrees in [1, 170]. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_scene_set_camera(vtk_water_scene* scene,
  const double eye[3], const double target[3], const double up[3], double angle_deg);

/* Renders. pixels: NULL, or a buffer of width x height x 3 bytes that receives red, green and blue,
 * top row first; byte_count: its size. If a water cannot be drawn, the picture
 * shows the rest of the scene. The first call that meets the problem returns VTK_WATER_BAD_VALUE;
 * later calls report it again only after a change. */
VTKRENDERINGWATER_EXPORT vtk_water_status vtk_water_scene_render(
  vtk_water_scene* scene, unsigned char* pixels, size_t byte_count);

#ifdef __cplusplus
}
#endif
#endif
