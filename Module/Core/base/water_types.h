// SPDX-License-Identifier: BSD-3-Clause
// water_types.h: the data that flows through a plan: water_scene in, water_plan out.
//
// Conventions of the whole core: double precision; matrices are 16 doubles, row-major, for column
// vectors (as vtkMatrix4x4); a_to_b names the space a matrix maps from and to; lengths are in the
// scene's unit unless a suffix says otherwise (_px pixels).
// Flow: gather fills water_scene -> water_plan_make -> draw and shade read water_plan.
#ifndef water_types_h
#define water_types_h

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

// dot(normal, x) + offset = 0. The normal points out of the water.
typedef struct water_plane
{
  double normal[3]; // any finite length but 0; unit length after water_plane_normalise
  double offset;    // signed; -level for normal (0,0,1)
} water_plane;

typedef struct water_camera
{
  double world_to_view[16]; // rigid: rotation and translation only; looks along -z
  double view_to_clip[16];  // of any projection; clip z/w of what is drawn is in [-1, 1]
  bool parallel;            // parallel projection
} water_camera;

enum // water_prop.flags, a bit each
{
  WATER_PROP_VISIBLE = 1 << 0,
  WATER_PROP_IS_WATER = 1 << 1,      // this water, another one in its plane, or it holds water
  WATER_PROP_NO_BOUNDS = 1 << 2,     // fills the view, whatever its bounds: a skybox
  WATER_PROP_NOT_REFLECTED = 1 << 3, // the user's key requests it
  WATER_PROP_OVERLAY = 1 << 4,       // lives on the screen, not in the scene: 2D actors
  WATER_PROP_LABEL = 1 << 5,         // no object of the scene: billboards, rulers, axes
  WATER_PROP_REFUSED = 1 << 6,       // its shader cannot be cut at the water
  WATER_PROP_IS_SKY = 1 << 7,        // it shows the sky that water_scene.sky describes
  WATER_PROP_OWN_OTHER = 1 << 8,     // own views draw the prop itself, mirrored views its stand-in
                                     // or nothing
  WATER_PROP_OWN_VISIBLE = 1 << 9,   // the prop itself is visible
  WATER_PROP_RULER = 1 << 10         // a label that own views draw, the same in views of any size
};

typedef struct water_prop
{
  double bounds[6]; // xmin, xmax, ymin, ymax, zmin, zmax in world; min > max: the prop is empty
  uint32_t flags;
  float width_px; // of its points and lines, at any distance; 0: it has none
} water_prop;

// What happens to a prop in the mirrored view, and why. One list, so enum and text cannot drift.
#define WATER_CULL_REASON_LIST(X)                                                                  \
  X(WATER_CULL_NONE, "drawn")                                                                      \
  X(WATER_CULL_INVISIBLE, "invisible")                                                             \
  X(WATER_CULL_WATER, "water itself")                                                              \
  X(WATER_CULL_NOT_REFLECTED, "marked as not reflected")                                           \
  X(WATER_CULL_OVERLAY, "overlay")                                                                 \
  X(WATER_CULL_LABEL, "label, ruler or axes")                                                      \
  X(WATER_CULL_EMPTY, "empty")                                                                     \
  X(WATER_CULL_BEHIND_PLANE, "behind the water plane")                                             \
  X(WATER_CULL_OUT_OF_VIEW, "out of the mirrored view")                                            \
  X(WATER_CULL_OUT_OF_WATER, "outside what the visible water reflects")                            \
  X(WATER_CULL_TOO_SMALL, "too small in the mirrored view")                                        \
  X(WATER_CULL_REFUSED, "rejected by the driver with the lines that reflections need")

typedef enum water_cull_reason
{
#define WATER_CULL_REASON_VALUE(name, text) name,
  WATER_CULL_REASON_LIST(WATER_CULL_REASON_VALUE)
#undef WATER_CULL_REASON_VALUE
    WATER_CULL_REASON_COUNT
} water_cull_reason;

enum // water_settings.skips, a bit each: invisible work that may be skipped
{
  WATER_MAY_SKIP_UNSEEN = 1 << 0,    // the reflection texture of water out of view or facing away
  WATER_MAY_SKIP_HIDDEN = 1 << 1,    // the reflection texture of hidden water
  WATER_MAY_SKIP_FAINT = 1 << 2,     // the reflection texture of water that reflects almost nothing
  WATER_MAY_SKIP_UNCHANGED = 1 << 3, // a reflection texture equal to the last one
  WATER_MAY_SKIP_SHARED = 1 << 4,   // a reflection texture that another water in the same plane has
  WATER_MAY_SKIP_PROPS = 1 << 5,    // props that no visible water reflects
  WATER_MAY_SKIP_CLUSTERS = 1 << 6, // parts of large meshes and blocks of data, likewise
  WATER_MAY_SKIP_PIXELS = 1 << 7,   // pixels of the reflection texture, likewise
  WATER_MAY_SKIP_ALL = (1 << 8) - 1
};

// What the plan decided for the frame, and why. WATER_REFLECT is the only one that draws.
#define WATER_DECISION_LIST(X)                                                                     \
  X(WATER_NOT_PLANNED, "nothing has been planned yet")                                             \
  X(WATER_REFLECT, "rendered")                                                                     \
  X(WATER_NO_REFLECT_FAILED, "not rendered: the last plan failed")                                 \
  X(WATER_NO_REFLECT_SELECTING, "not rendered: hardware selection")                                \
  X(WATER_NO_REFLECT_EDGE_ON, "not rendered: the water is seen edge-on")                           \
  X(WATER_NO_REFLECT_OUT_OF_VIEW, "not rendered: the water is out of view")                        \
  X(WATER_NO_REFLECT_NO_REFLECTANCE, "not rendered: the water reflects nothing")                   \
  X(WATER_NO_REFLECT_ENVIRONMENT, "not rendered: a static environment is reflected")               \
  X(WATER_REUSE, "used again: nothing has changed")                                                \
  X(WATER_NO_REFLECT_FACING_AWAY, "not rendered: the water faces away")                            \
  X(WATER_NO_REFLECT_HIDDEN, "not rendered: the water is hidden behind the scene")                 \
  X(WATER_NO_REFLECT_FAINT, "not rendered: the water reflects too little to be seen")              \
  X(WATER_NO_REFLECT_SHARED, "not rendered: another water in the same plane has the reflection")

typedef enum water_decision
{
#define WATER_DECISION_VALUE(name, text) name,
  WATER_DECISION_LIST(WATER_DECISION_VALUE)
#undef WATER_DECISION_VALUE
    WATER_DECISION_COUNT
} water_decision;

typedef enum water_side // where the eye is
{
  WATER_ABOVE,  // on the side the normal points to: the scene above the water is mirrored
  WATER_BELOW,  // under water: the scene below is mirrored in the surface's underside
  WATER_EDGE_ON // parallel projection along the surface: there is nothing to see
} water_side;

typedef struct water_look
{
  double index_of_refraction; // of the water against what lies above it, >= 1; 1.333 for water
  double reflectance;         // used when constant_reflectance, in [0, 1]
  bool constant_reflectance;  // false: exact Fresnel
} water_look;

typedef enum water_quality_mode // how the texture's scale and the steps of rays are chosen
{
  WATER_QUALITY_FIXED,
  WATER_QUALITY_TARGET_ERROR,
  WATER_QUALITY_TIME_BUDGET,
  WATER_QUALITY_UPDATE_RATE
} water_quality_mode;

typedef enum water_color_precision // of the reflection texture
{
  WATER_COLOR_AUTOMATIC, // half floats where the picture may be tone mapped
  WATER_COLOR_EIGHT_BIT,
  WATER_COLOR_HALF_FLOAT
} water_color_precision;

// The user's settings of a mirrored view.
typedef struct water_settings
{
  double texture_scale;     // texture pixels per viewport pixel, > 0
  double guard_band;        // size of a wavy water's mirrored frustum over the eye's, >= 1; 0: by
                            // slope_rms
  double clip_margin;       // how far behind the plane geometry is kept, >= 0
  double prop_px_min;       // props that are smaller in the mirrored view, both ways, are left out,
                            // >= 0
  double reflectance_error; // share of the light that may be neglected, in [0, 1]
  unsigned skips;           // WATER_MAY_SKIP_*
  int multi_samples;        // per pixel; -1: as many as the window has
  water_color_precision color_precision;
  water_quality_mode quality;
  double target_error_px;
  double time_budget_ms;
  bool secondary_reflections; // other waters in the mirrored view reflect the scene, not the sky
                              // alone
} water_settings;

// What is painted on the main view's screen before everything else: VTK's gradient modes, or a
// picture.
typedef enum water_screen
{
  WATER_SCREEN_COLOR,
  WATER_SCREEN_VERTICAL,   // from bottom to top
  WATER_SCREEN_HORIZONTAL, // from left to right
  WATER_SCREEN_SIDE,       // from the middle to an ellipse that touches the screen's sides
  WATER_SCREEN_CORNER,     // from the middle to an ellipse through its corners
  WATER_SCREEN_PICTURE     // a texture over all of it
} water_screen;

typedef enum water_sky_kind // where the sky in a direction is looked up
{
  WATER_SKY_SCREEN, // the screen of the main view
  WATER_SKY_MAP,    // a picture in longitude and latitude
  WATER_SKY_CUBE    // a cube map
} water_sky_kind;

// A picture that has a colour for every direction.
typedef struct water_sky_map
{
  water_sky_kind kind;
  double to_map[9];   // direction -> axes of the map: of a picture right, up, back; rows
  double latitude[2]; // of a picture: v of its texture is latitude / pi * [0] + [1]
  double exponent;    // of its colours, as they are shown
  double level;       // of detail that it is shown with, >= 0
} water_sky_map;

// An infinite plane over which a texture repeats.
typedef struct water_sky_floor
{
  bool is_there;
  double height[4]; // point (x, y, z, 1) -> distance, on the side that it is seen from positive
  double u[4];      // the same -> place in the texture
  double v[4];
  double exponent;
} water_sky_floor;

// What lies behind all props: the renderer's background, and skyboxes in front of it.
typedef struct water_sky
{
  double bottom[3]; // red, green, blue of the background
  double top[3];    // the same as bottom without a gradient; the second colour of any gradient
  double alpha;
  water_screen screen;
  water_sky_map map;     // of world directions
  water_sky_floor floor; // of world points
} water_sky;

// Everything the plan depends on; filled by the caller.
typedef struct water_scene
{
  water_camera eye;
  const water_camera* picture_eye; // camera of the user's picture, if eye is a mirrored camera:
                                   // backgrounds fixed to the screen and lights fixed to the camera
                                   // follow it; NULL: eye is that camera
  int viewport_px[2];              // size of the picture the water is drawn into, >= 1
  int tile_scale[2]; // size of the picture that this one is a tile of, over the size of the tile;
                     // 0, 1: it is none. What is looked up beside a tile is as wide as beside the
                     // whole picture.
  const int* viewport_rect_px; // x, y, width, height of the part of it that counts; NULL: all of it
  water_plane plane;
  double plane_origin[3]; // of the plane's own axes, in world
  bool has_waves;         // the surface is not calm: its reflection is looked up along rays
  double slope_rms;       // of the waves, >= 0
  double slope_max;       // no slope that a reflection is looked up with is steeper; infinity: none
                          // is known, or the reflection texture is read elsewhere, too
  double wave_height_max; // how far waves move the surface itself up or down; 0: a flat sheet
  double surface_height; // of a surface that waves move, over the plane where the eye is, along the
                         // plane's normal; 0: a flat sheet
  bool has_environment;  // a static picture of the surroundings is reflected
  double environment_up[3]; // of that picture, in world; water_lookup.h
  double environment_right[3];
  bool has_sun;
  double sun_dir[3];     // towards the sun, in world, any length but 0
  double sun_diffuse[3]; // colour of its light
  double sun_intensity;
  water_sky sky;
  double light[3];          // light of the lights on the plane; water_daylight.h
  double surface_bounds[6]; // of the water surface in world; min > max: there is no surface
  bool is_endless;          // the surface reaches to the horizon, whatever these bounds
  bool hides_above;         // the surface is not drawn for an eye above it, or below
  bool hides_below;
  bool is_hidden;          // other objects hide all of it
  bool is_flat;            // all of it lies in the plane, and is drawn no nearer than that
  bool has_scene_depth;    // there is a depth per pixel of what hides the surface from the eye
  bool is_software;        // there is no GPU: pixels and triangles are expensive, draws are not
  bool is_beyond;          // the own view is planned, water_beyond.h, and not the mirrored view
  bool is_from_sun;        // the sun view is planned, water_sun_view.h
  bool is_of_sky;          // the sky view is planned, water_sky_view.h
  const water_prop* props; // prop_count of them: all props, not only those the eye sees
  size_t prop_count;
  water_look look;
  water_settings settings;
  int window_samples;   // per pixel of the window
  int calm_samples_min; // of a calm reflection, per pixel, if the user sets none
  int max_samples;      // per pixel, that the GPU has; 0: none
  bool may_tone_map;    // a later pass may map tones
  int max_texture_px;   // the GPU's limit for a side of a texture, >= 1
} water_scene;

typedef struct water_plan
{
  water_decision decision; // unless WATER_REFLECT, the reasons and the mirrored view are not set
  bool has_view;           // the fields of the view are set; false: show the plain colour
  water_side side;
  size_t bad_index; // index of the first prop a WATER_BAD_PROP_BOUNDS is about

  // view: where the eye is and what its pixels look at
  double normal_clip[4];  // view_to_clip * world_to_view * (n, 0) of the eye; n towards the eye
  double plane_view[4];   // plane in the eye's view space, normal towards the eye
  double plane_clip[4];   // the same on clip space of the eye: dot(plane_clip, clip) is the
                          // height of the point, clip not divided by w
  double surface_clip[4]; // the same as plane_clip for the surface's level where the eye is
  double clip_w[4];       // the same -> w of the point in view space
  double ndc_to_ray[9];   // (x, y, 1) in NDC of the eye -> direction of the view ray in the
                          // plane's axes (third: n towards the eye), any length
  double pixel_depth[4];  // (x, y, 1) in NDC of the eye, 1 / w -> z in NDC of the surface there,
                          // which may lie before the near plane or beyond the far one
  bool is_endless;        // the scene's
  double dir_to_eye[12];  // direction in the plane's axes -> clip of the eye; 4 rows of 3
  double origin_xy[2];    // of the point under the eye, in the plane's own axes
  double ndc_to_plane[9]; // (x, y, 1) in NDC of the eye -> (x, y, w) on the plane, from origin_xy
  double bed_depth;       // how far the scene reaches under the plane, >= 0
  bool is_submerged;      // the eye is under this water
  bool is_awash;          // it is over it, and the near plane cuts through the surface
  bool has_sun;           // it shines on the surface from the normal's side
  double sun_dir[3];      // towards the sun, in the plane's axes, unit length
  double sun_color[3];    // of its light: a white card facing it shows this; 0 without a sun
  double daylight[3];     // that sky and lights bring to the plane; water_daylight.h
  water_sky sky;
  water_sky_map sky_map;         // the same for directions in the plane's axes
  water_sky_map environment_map; // the water's own picture, likewise
  water_sky_floor sky_floor;     // for points in the plane's axes, from origin_xy
  // the sky is known in every direction; false: a dome or a prop without bounds hides it, and how
  // that looks is known only where the mirrored view shows it
  bool is_sky_known;
  // a drawn mesh may be the sky: the reflection texture's alpha is 0 where nothing was drawn
  bool is_enclosed;
  // with a sky view: the greatest height over the plane, and the largest window depth, of all that
  // is in the reflection texture, except what may be the sky
  double rest_top;
  double rest_depth;
  double eta; // index beyond the surface / index on the eye's side

  // draw: the mirrored camera, twice: as matrices and in vtkCamera's terms; of the own view the
  // eye itself, with a wider frustum
  water_camera mirrored;
  double mirrored_position[3];
  double mirrored_focal_point[3]; // at distance 1
  double mirrored_view_up[3];
  double clip_plane_view[4];    // plane in mirrored view space; kept side >= 0 (margin included)
  double clip_plane_clip[4];    // same in clip space of the mirrored view, clip not divided by w
  double clip_plane_window[4];  // same in the reflection texture's window space (x_px, y_px, depth
                                // in [0,1], 1)
  double clip_plane_world[4];   // same in the world, unit normal: for what OpenGL does not cut
  double headlight_dir[3];      // the eye's view direction in mirrored view space, unit length
  double headlight_position[3]; // the eye in mirrored view space
  int texture_px[2];
  int samples;        // per pixel of the mirrored view; 0: none
  bool is_half_float; // colours are half floats, or bytes
  bool rolls_off;     // light brighter than white rolls off, because no pass maps tones afterwards
  int texture_rect_px[4]; // x, y, width, height of the part the water can look up
  double height_rounding; // of dot(plane_clip, NDC) in single precision
  double visible_px_max;  // if the eye's picture shows less of the water, it pays to wait for it
  bool has_visibility;    // the picture is known: what only hidden pixels of water would look up is
                          // left out
  bool is_software;       // the scene's

  // of a sun view, water_sun_view.h: window depth 1 - depth * (height + bottom) / w
  double sun_view_depth;
  double sun_view_bottom;

  // of a sky view, water_sky_view.h
  double sky_view_at[3];   // where it is from, in the plane's axes, from origin_xy
  double sky_view_dirs[9]; // direction in the plane's axes -> x, y and w of its clip space
  double sky_view_near[2]; // 1 / w is depth [0] + [1], for a depth of its window

  // shade: where the reflection texture shows what
  double reflection_ndc_to_eye[9]; // (x, y, 1) in NDC of the reflection texture -> (x, y, w) in
                                   // clip of the eye, of the direction that the reflection texture
                                   // sees there: where the sky is found
  double depth_scale;  // reflection texture depth of a point on the water: its depth in the eye's
                       // picture times this,
  double depth_offset; // and this more
  double reflection_scale[2]; // part of the reflection texture, or of the own view, that the eye's
                              // own frustum takes, per axis, in (0, 1]
  double reflection_top; // height over the plane of all that is drawn in the reflection texture;
                         // may be infinite
  double reflection_z_infinity; // water_lookup.h
  double reflection_tolerance[2];
  double reflection_height[4]; // point in NDC of the reflection texture -> height over the plane,
                               // times 1 / w
  double reflection_w[4];      // the same -> 1 / w
  double reflection_waterline[4]; // water_lookup_waterline
  double reflection_texel;        // height that a texel of the reflection texture spans, over its w
  double dir_to_reflection[12]; // direction in the plane's axes -> clip of the reflection texture;
                                // 4 rows of 3
} water_plan;

#ifdef __cplusplus
}
#endif
#endif
