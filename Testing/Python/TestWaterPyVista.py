# SPDX-License-Identifier: BSD-3-Clause
"""add_water puts water into every kind of PyVista's pictures: a box shows where its mirror image lies.

Where that is says the camera: a point of the box's mirror image is projected to the screen. Without the
water the background is there. What is wrong raises, names its argument, and adds nothing.
"""

import itertools
import logging
import re
import warnings

import numpy as np
import pytest
import water_test as wt

try:
    import pyvista as pv
except ImportError as error:
    reason = f"{error}; Testing/Python/requirements.txt says what to install"
    print(f"skipped: {reason}")
    pytest.skip(reason, allow_module_level=True)
import vtkwater.pyvista  # noqa: F401
from vtkmodules.vtkRenderingCore import vtkActor, vtkBillboardTextActor3D
from vtkwater import vtkWaterActor

SIZE = (320, 240)
LEVEL = -0.1
RED, CENTER = (1.0, 0.0, 0.0), (0.0, 0.0, 0.6)


@pytest.fixture
def plotter():
    made = pv.Plotter(off_screen=True, window_size=SIZE)
    yield made
    made.close()


def picture_of(plotter):
    return plotter.screenshot(None, return_img=True)


def waters_of(plotter):
    return [actor for actor in plotter.actors.values() if isinstance(actor, vtkWaterActor)]


def fill(plotter, **water):
    """A red box over a mirror; the box's front is lit from the camera."""
    plotter.set_background("lightblue")
    plotter.add_mesh(pv.Cube(center=CENTER), color=RED, ambient=0.4)
    plotter.camera_position = [(0.0, -5.0, 1.5), (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)]
    return plotter.add_water(**{"level": LEVEL, "preset": "mirror floor", "bounds": (-4, 4, -4, 4), **water})


def redness(picture, renderer):
    """Of the pixel in which the middle of the mirrored box's front lies: red less green."""
    renderer.SetWorldPoint(CENTER[0], CENTER[1] - 0.5, 2.0 * LEVEL - CENTER[2], 1.0)
    renderer.WorldToDisplay()
    x, y, _ = renderer.GetDisplayPoint()
    red, green, _ = picture[picture.shape[0] - 1 - round(y), round(x)][:3].astype(int)
    return int(red - green)


def check_mirrored(name, picture, renderer):
    wt.check_at_least(f"{name}: redness where the box is mirrored", redness(picture, renderer), 60)


def scene_light(plotter):
    plotter.remove_all_lights()
    plotter.add_light(pv.Light(position=(1, -6, 4), light_type="scene light", positional=True, cone_angle=60))
    plotter.enable_shadows()


FEATURES = {
    "plain": lambda plotter: None,
    "ssaa": lambda plotter: plotter.enable_anti_aliasing("ssaa"),
    "fxaa": lambda plotter: plotter.enable_anti_aliasing("fxaa"),
    "msaa": lambda plotter: plotter.enable_anti_aliasing("msaa"),
    "ssao": lambda plotter: plotter.enable_ssao(radius=0.5),
    "shadows": scene_light,
    "depth peeling": lambda plotter: plotter.enable_depth_peeling(4),
    "parallel projection": lambda plotter: plotter.enable_parallel_projection(),
    "eye dome lighting": lambda plotter: plotter.enable_eye_dome_lighting(),
}


@pytest.mark.parametrize("name", FEATURES, ids=lambda name: name.replace(" ", "_"))
def test_the_box_is_mirrored_with_every_feature(name, plotter):
    """With each of PyVista's features the box is mirrored in the water, and no longer when the water is removed."""
    water = fill(plotter)
    FEATURES[name](plotter)
    picture = picture_of(plotter)
    wt.save(picture[::-1, :, :3], wt.output_folder() / f"PyVista-{name.replace(' ', '-')}.png")
    check_mirrored(name, picture, plotter.renderer)
    wt.check_equal(f"{name}: error", water.GetLastError(), "")
    plotter.remove_actor(water)
    wt.check_at_most(f"{name}, without water: redness there", redness(picture_of(plotter), plotter.renderer), 0)


def test_show_returns_the_picture_with_water():
    """show() returns the picture it has shown, with water that was added before there was a camera."""
    plotter = pv.Plotter(off_screen=True, window_size=SIZE)
    plotter.add_mesh(pv.Cube(center=CENTER), color=RED)
    water = plotter.add_water(LEVEL, bounds=(-4, 4, -4, 4))
    picture = plotter.show(screenshot=True, return_img=True)
    wt.check_equal("show: shape of the picture", picture.shape, (SIZE[1], SIZE[0], 3))
    wt.check_equal("show: mirrored views", water.GetReflectionPass().GetNumberOfReflectionRenders() > 0, True)


def test_every_subplot_has_its_own_water():
    """Each subplot has its own water, and removing one leaves the other's."""
    plotter = pv.Plotter(off_screen=True, shape=(1, 2), window_size=(2 * SIZE[0], SIZE[1]))
    waters = []
    for column in range(2):
        plotter.subplot(0, column)
        waters.append(fill(plotter))
    picture = picture_of(plotter)
    for column in range(2):
        check_mirrored(f"subplot {column}", picture, plotter.renderers[column])
    plotter.subplot(0, 0)
    plotter.remove_actor(waters[0])
    picture = picture_of(plotter)
    wt.check_at_most("subplot 0, its water removed: redness", redness(picture, plotter.renderers[0]), 0)
    check_mirrored("subplot 1, the other's water removed", picture, plotter.renderers[1])
    plotter.close()


@pytest.mark.parametrize("name, opened", [("waves.gif", pv.Plotter.open_gif), ("waves.mp4", pv.Plotter.open_movie)],
                         ids=["gif", "mp4"])
def test_a_movies_frames_differ_by_the_waves_time(name, opened, plotter, tmp_path):
    """Frames of a movie differ by the waves' time, and the same time gives the same frame."""
    path = tmp_path / name
    water = fill(plotter, waves=[(0.02, 0.7, 20)])
    opened(plotter, str(path))
    frames = []
    for time in (0.0, 0.4, 0.0):
        water.SetTime(time)
        plotter.write_frame()
        frames.append(plotter.image.astype(int))
    plotter.close()  # writes the rest
    wt.check_at_least(f"{name}: bytes", path.stat().st_size, 1000)
    wt.check_at_least(f"{name}: largest change between frames", int(np.abs(frames[1] - frames[0]).max()), 50)
    wt.check_equal(f"{name}: largest change of the same time", int(np.abs(frames[2] - frames[0]).max()), 0)


def test_water_is_an_actor_that_the_plotter_knows(plotter):
    """Water is an actor of VTK's, and the plotter knows it by its name, which another water takes over."""
    water = fill(plotter, name="lake")
    wt.check_equal("an actor of VTK's", isinstance(water, vtkWaterActor) and isinstance(water, vtkActor), True)
    wt.check_equal("known to the plotter by its name", plotter.actors["lake"] is water, True)
    again = plotter.add_water(1.0, name="lake", preset="lake")
    wt.check_equal("the same name takes its place", waters_of(plotter), [again])


def test_color_opacity_time_and_waves_arrive(plotter):
    """Colour, opacity, time and waves arrive where they belong."""
    water = fill(plotter, color="navy", opacity=0.5, time=3.0, waves=[(0.1, 3.0), (0.05, 2.0, 30, 10, 0.5)])
    look = water.GetWaterProperty()
    wt.check_equal("color", np.round(np.multiply(255, look.GetDeepColor())).tolist(), [0, 0, 128])
    wt.check_equal("opacity, time, waves", (look.GetOpacity(), water.GetTime(), look.GetNumberOfWaves()),
                   (0.5, 3.0, 2))
    wave = [0.0] * 5
    look.GetWave(1, wave)
    wt.check_equal("the second wave", np.round(wave, 9).tolist(), [0.05, 2.0, 30.0, 10.0, 0.5])


def test_waves_may_be_a_preset_or_a_wind(plotter):
    """A preset brings its sea, unless waves are 0; a number is the speed of the wind of a sea."""
    fill(plotter)
    wt.check_equal("a preset's sea", plotter.add_water(1.0, preset="lake").GetWaterProperty().GetSea(), True)
    calm = plotter.add_water(preset="lake", waves=0).GetWaterProperty()
    wt.check_equal("waves=0 calms a preset", calm.GetSea(), False)
    windy = plotter.add_water(waves=7.5).GetWaterProperty()
    wt.check_equal("a wind", (windy.GetSea(), windy.GetWindSpeed()), (True, 7.5))


def test_a_plane_or_a_surface_may_be_given(plotter):
    """The water lies in the plane of a normal, an origin and a level, or has the shape of a surface."""
    fill(plotter)
    up = plotter.add_water(2.0, normal="y", origin=(1, 1, 1)).GetPlane()
    wt.check_equal("a plane", (up.GetOrigin(), up.GetNormal()), ((1.0, 3.0, 1.0), (0.0, 1.0, 0.0)))
    mesh = plotter.add_water(surface=pv.Disc(outer=3.0))
    wt.check_equal("bounds of a surface", np.round(mesh.GetBounds()[:2], 6).tolist(), [-3.0, 3.0])


@pytest.mark.parametrize("given, expected", (({}, False), ({"secondary_reflections": np.True_}, True)))
def test_secondary_reflections_arrive_at_every_water(given, expected, plotter):
    """Those of a surface in two planes have the setting, too."""
    surface = pv.Plane(center=(0, 0, 0)).merge(pv.Plane(center=(3, 0, 1)))
    plotter.add_water(surface, **given)
    plotter.render()
    props = plotter.renderer.GetViewProps()
    every = [props.GetItemAsObject(i) for i in range(props.GetNumberOfItems())]
    waters = [prop for prop in every if isinstance(prop, vtkWaterActor)]
    wt.check_equal("settings", [water.GetReflectionPass().GetSecondaryReflections() for water in waters],
                   [expected, expected])


def test_in_a_scaled_scene_the_level_is_one_of_the_data(plotter):
    """In a scaled scene the level is one of the data, drawn where the data's height is."""
    plotter.set_scale(zscale=2.0)
    wt.check_equal("height in a scene scaled by 2", fill(plotter).GetBounds()[4:], (2 * LEVEL, 2 * LEVEL))


CAMERA = [(-2, -4, 0.8), (0, 0, 0.1), (0, 0, 1)]


@pytest.mark.parametrize("bounds", ["horizon", (-9, 9, -9, 9)], ids=["horizon", "bounds"])
@pytest.mark.parametrize("refraction", [False, True], ids=["opaque", "refracted"])
def test_every_order_of_calls_gives_the_same_picture(refraction, bounds):
    """Camera, water and meshes may be set in any order: but for pixels on edges, as PyVista's clipping ranges differ.
    More of them are at the edges of a bed, so that this one is seen with the same range."""
    pictures = []
    for order in itertools.permutations(("camera", "water", "mesh")):
        made = pv.Plotter(off_screen=True, window_size=SIZE)
        for step in order:
            if step == "camera":
                made.camera_position = CAMERA
            elif step == "water":
                made.add_water(LEVEL, bounds=bounds, refraction=refraction)
            else:
                made.add_mesh(pv.Cone(direction=(0, 0, 1)), color=RED)
        if refraction:
            made.camera.clipping_range = (1.0, 20.0)
        pictures.append(picture_of(made).astype(int))
        made.close()
        differs = np.abs(pictures[-1] - pictures[0]).max(axis=2) > 0
        wt.check_at_most(f"{bounds}, {', '.join(order)}: pixels that differ", int(differs.sum()), 0 if refraction else 8)


def test_water_to_the_horizon_fills_the_picture_and_no_bounds(plotter):
    """Without a camera the picture is taken from where PyVista's usual camera is, and bounds and rulers are the meshes'."""
    other = pv.Plotter(off_screen=True, window_size=SIZE)
    for one in (plotter, other):
        one.add_mesh(pv.Cone(direction=(0, 0, 1)), color=RED)
        one.set_background("lightblue")
    water = plotter.add_water(LEVEL, bounds="horizon", color="lime")
    water.GetWaterProperty().SetReflectanceModeToConstant()
    water.GetWaterProperty().SetReflectance(0)
    rulers = [one.show_bounds().bounds for one in (plotter, other)]
    picture = picture_of(plotter)
    picture_of(other)
    wt.check_equal("camera", plotter.camera_position, other.camera_position)
    wt.check_equal("clipping range", plotter.camera.clipping_range, other.camera.clipping_range)
    wt.check_equal("bounds", tuple(plotter.bounds), tuple(other.bounds))
    wt.check_equal("rulers", *rulers)
    border = np.concatenate([picture[0], picture[-1], picture[:, 0], picture[:, -1]])[:, :3]
    wt.check_equal("pixels at the border that show no water", int((border != (0, 255, 0)).any(axis=1).sum()), 0)
    other.close()


def test_a_grid_is_no_object_of_the_scene(plotter):
    """The rulers of show_grid are not in the water."""
    water = fill(plotter)
    plotter.show_grid()
    picture_of(plotter)
    wt.check_equal("labels", water.reflection_pass.GetFateCount(water.reflection_pass.LABEL), 1)
    wt.check_equal("props reflected", water.reflection_pass.GetNumberOfPropsReflected(), 1)


def test_a_normal_may_have_any_length(plotter):
    """A normal of 1e-200 or 1e200 gives the picture and the plane of a normal of 1, and no warning."""
    water = fill(plotter, bounds=None)
    wanted = picture_of(plotter)
    for length in (1e-200, 1e200):
        plotter.remove_actor(water)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            water = plotter.add_water(level=LEVEL, preset="mirror floor", normal=(0.0, 0.0, length))
        wt.check_equal(f"length {length:g}: largest difference",
                       int(np.abs(picture_of(plotter).astype(int) - wanted).max()), 0)
        wt.check_at_most(f"length {length:g}: height of the plane off by", abs(water.plane.origin[2] - LEVEL), 1e-15)


WRONG = [  # the exception, a part of its text, the argument
    (ValueError, "level is 'high', an array's name; it needs a surface with this array", {"level": "high"}),
    (TypeError, "level must be a number, not bool", {"level": True}),
    (ValueError, "level is nan; it must be finite", {"level": float("nan")}),
    (ValueError, "origin is (inf, 0.0, 0.0) and level is -0.1; the plane's place must be finite",
     {"origin": (float("inf"), 0.0, 0.0)}),
    (ValueError, "waves is (0.1, 3, 20); a single wave must be in a list, too: waves=[(0.1, 3, 20)]",
     {"waves": (0.1, 3, 20)}),
    (ValueError, "color is 'bluee'; it must be a colour's name, '#rrggbb'", {"color": "bluee"}),
    (TypeError, "preset must be str, not int", {"preset": 3}),
    (ValueError, "'swamp'; it must be one of pool, lake", {"preset": "swamp"}),
    (TypeError, "waves must be a number or a sequence", {"waves": "high"}),
    (TypeError, r"waves[1] must be a sequence of numbers, not float", {"waves": [(0.1, 1.0), 2.0]}),
    (ValueError, "waves[0] is (0.1,); it must have 2 to 5 numbers, not 1", {"waves": [(0.1,)]}),
    (TypeError, "waves[0][1] must be a number, not str", {"waves": [(0.1, "long")]}),
    (ValueError, "waves[0] of Amplitude -0.1, Wavelength 1, Direction 0, Phase 0, Steepness 0: Amplitude of a wave must be finite", {"waves": [(-0.1, 1.0)]}),
    (ValueError, "waves is -3", {"waves": -3}),
    (ValueError, "bounds is (0, 1, 0, 1, 0, 1); it must have 4 numbers, not 6", {"bounds": (0, 1, 0, 1, 0, 1)}),
    (ValueError, "bounds are (1, 0, 0, 1); they must be finite with xmin < xmax", {"bounds": (1, 0, 0, 1)}),
    (ValueError, "bounds is 'horizont'; it must be 'horizon', 'scene' or four numbers", {"bounds": "horizont"}),
    (ValueError, "normal is 'up'", {"normal": "up"}),
    (ValueError, "normal is (0.0, 0.0, 0.0)", {"normal": (0, 0, 0)}),
    (ValueError, "origin is (0, 0); it must have 3 numbers, not 2", {"origin": (0, 0)}),
    (ValueError, "opacity is 1.5; it must lie in [0, 1]", {"opacity": 1.5}),
    (ValueError, "time is", {"time": float("inf")}),
    (TypeError, "surface must be a pyvista.DataSet, not list", {"surface": [1], "bounds": None}),
    (ValueError, "surface has no cells", {"surface": pv.PolyData(), "bounds": None}),
    (ValueError, "bounds apply only to the built-in sheet", {"surface": pv.Plane()}),
    (ValueError, "surface has no polygons, only 3 vertices and 0 lines",
     {"surface": pv.PolyData(np.eye(3)), "bounds": None}),
    (ValueError, "surface has no polygons, only 0 vertices and 1 lines",
     {"surface": pv.Line(), "level": 0.0, "bounds": None}),
    (ValueError, "surface has no point with finite coordinates",
     {"surface": pv.PolyData(np.full((3, 3), np.nan), faces=[3, 0, 1, 2]), "bounds": None}),
    (ValueError, "surface has no finite polygon with an area along the normal (0, 0, 1)",
     {"surface": pv.Plane(direction=(1, 0, 0)), "bounds": None, "level": None}),
    (ValueError, "surface is not valid: cell 0 has 3 points; cells of its type (8) have 4",
     {"surface": pv.UnstructuredGrid(np.array([3, 0, 1, 2]), np.array([8], np.uint8), np.eye(3)), "bounds": None}),
    (ValueError, "surface is not valid: cell 0 refers to point 99; there are 3, from 0",
     {"surface": pv.PolyData(np.eye(3), faces=[3, 0, 1, 99]), "bounds": None}),
    (TypeError, "name must be str, not list", {"name": []}),
    (ValueError, "name is ''", {"name": ""}),
    (ValueError, "units is -1; metres per unit must lie in [1e-09, 1e+09]", {"units": -1}),
    (ValueError, "level is too large; it must lie in [-1e308, 1e308]", {"level": 10**400}),
    (TypeError, "bounds must be a sequence of numbers, not float64", {"bounds": np.float64(3)}),
    (TypeError, "shadows must be bool, not ndarray", {"shadows": np.array([1, 2])}),
    (TypeError, "scalar_bar must be bool, not ndarray", {"scalar_bar": np.array([1, 2])}),
    (ValueError, "preset is 'Opacity'", {"preset": "Opacity"}),
    (TypeError, "max_mirrors must be int, not str", {"max_mirrors": "x"}),
    (TypeError, "max_mirrors must be int, not bool", {"max_mirrors": True, "surface": pv.Plane(), "bounds": None}),
    (ValueError, "max_mirrors is -7; it must lie in [0, 4096]",
     {"max_mirrors": -7, "surface": pv.Plane(), "level": 0.0, "bounds": None}),
    (TypeError, "data_opacity must be a number, not str", {"data_opacity": "x"}),
    (TypeError, "secondary_reflections must be bool, not str", {"secondary_reflections": "x"}),
    (ValueError, "data_opacity is 2; it must lie in [0, 1]", {"data_opacity": 2}),
]


def raised_by(plotter, argument):
    try:
        fill(plotter, **argument)
    except (TypeError, ValueError) as error:
        return error
    return None


@pytest.mark.parametrize("kind, text, argument", WRONG, ids=[re.sub(r"\W+", "_", text) for _, text, _ in WRONG])
def test_a_wrong_argument_raises(kind, text, argument, plotter):
    """A wrong argument raises an error that names it."""
    raised = raised_by(plotter, argument)
    wt.check_equal(f"{list(argument)}: {raised}", type(raised) is kind and text in str(raised), True)


@pytest.mark.parametrize("water", ("flood.vtu", np.zeros((3, 3)), True))
def test_a_wrong_first_argument_names_what_it_may_be(water, plotter):
    """A file's name or an array is neither a level nor a mesh."""
    with pytest.raises(TypeError) as raised:
        plotter.add_water(water)
    wt.check_equal("the error", str(raised.value),
                   f"water must be a number or a pyvista.DataSet, not {type(water).__name__}")


def test_a_wrong_argument_adds_no_water(plotter):
    """No wrong argument leaves water in the plotter."""
    for _, _, argument in WRONG:
        raised_by(plotter, argument)
    wt.check_equal("waters added by them", len(waters_of(plotter)), 0)


@pytest.mark.parametrize("backend", [None, "static", "server", "client", "html"])
def test_add_water_warns_where_vtk_js_draws(backend, plotter, monkeypatch):
    """add_water says that vtk.js gets no water, and says nothing where VTK itself draws."""
    monkeypatch.setattr(pv.global_theme, "_jupyter_backend", backend)
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        fill(plotter)
    texts = [str(warning.message) for warning in said if "vtk.js" in str(warning.message)]
    wt.check_equal(f"backend {backend}: warnings", len(texts), int(backend in ("client", "html")))


def test_vtk_js_is_sent_no_water(plotter):
    """What is sent to vtk.js has the actors, but no water."""
    from vtkmodules.web import render_window_serializer as serializer

    fill(plotter)
    plotter.render()
    logging.disable(logging.ERROR)  # it says that it cannot
    try:
        serializer.initializeSerializers()
        sent = str(serializer.serializeInstance(
            None, plotter.render_window, "1", serializer.SynchronizationContext(), 0))
    finally:
        logging.disable(logging.NOTSET)
    wt.check_equal("sent to vtk.js: actors, waters", ("vtkOpenGLActor" in sent, "vtkWaterActor" in sent),
                   (True, False))


@pytest.mark.parametrize("add", (
    lambda plotter: plotter.add_slider_widget(lambda value: None, (0, 1)),
    lambda plotter: plotter.add_checkbox_button_widget(lambda value: None),
    lambda plotter: plotter.add_logo_widget(),
    lambda plotter: plotter.add_legend_scale()), ids=("slider", "button", "logo", "scale"))
def test_widgets_over_the_picture_are_no_part_of_the_scene(add, plotter):
    """They leave the reflection in waves as it is, and it is used again in the next frame."""
    water = fill(plotter, wind=3, bounds="horizon")
    before = picture_of(plotter).astype(int)
    add(plotter)
    plotter.render()
    plotter.render()
    reflection = water.reflection_pass
    wt.check_equal("props over the picture", reflection.GetFateCount(reflection.OVERLAY), 1)
    wt.check_equal("decision", reflection.GetDecisionAsString(), "used again: nothing has changed")
    upper = np.abs(picture_of(plotter).astype(int) - before)[60:170, 130:190].max()  # about the box and its reflection
    wt.check_at_most("largest difference beside the widget", upper, 1)


@pytest.mark.parametrize("scale", ((1, 1, 0), (1, 1, -1)))
def test_a_wrong_scale_of_the_plotter_is_named(scale, plotter):
    plotter.set_scale(*scale)
    with pytest.raises(ValueError) as raised:
        plotter.add_water(0)
    wt.check_equal("the error", "the plotter's scale is" in str(raised.value), True)


def test_water_without_a_scalar_bar_is_still_returned(plotter):
    """PyVista has ten scalar bars: the eleventh water has none, and a warning says so."""
    mesh = pv.Plane(i_resolution=2, j_resolution=2)
    for i in range(11):
        mesh[f"a{i}"] = np.arange(9.0)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        waters = [plotter.add_water(mesh, color_by=f"a{i}") for i in range(11)]
    wt.check_equal("waters, warnings of scalar bars", (len(waters), sum("no scalar bar" in str(one.message) for one in told)),
                   (11, 1))


def test_foam_is_bright_in_the_default_light(plotter):
    """PyVista's lights are no suns: foam is lit by them and by the background, and is brighter than the water."""
    pictures = []
    for foam in (False, True):
        made = pv.Plotter(off_screen=True, window_size=SIZE)
        made.add_mesh(pv.Sphere(radius=2, center=(0, 0, -1.6)), color="tan")  # a flat island
        made.add_water(level=0, foam=foam)
        pictures.append(picture_of(made).astype(int).sum(axis=2))
        made.close()
    changed = np.abs(pictures[1] - pictures[0]) > 30
    wt.check_at_least("pixels of foam", int(changed.sum()), 50)
    wt.check_at_least("mean rise, of 765", float((pictures[1] - pictures[0])[changed].mean()), 30)


def test_a_grid_is_seen_through_the_water():
    """The axes under clear water with a view of its own are not lost."""
    pictures = []
    for has_grid in (False, True):
        made = pv.Plotter(off_screen=True, window_size=SIZE)
        made.add_mesh(pv.Cone(direction=(0, 0, 1)), color=RED)
        if has_grid:
            made.show_grid()
        made.add_water(level=-0.2, own_view=True)
        made.camera.elevation = -20
        pictures.append(picture_of(made).astype(int))
        made.close()
    below = np.abs(pictures[1] - pictures[0]).max(axis=2)[SIZE[1] * 6 // 10:]
    wt.check_at_least("pixels of the axes under water", int((below > 20).sum()), 100)


def test_texts_that_turn_to_the_eye_keep_their_size():
    """A view of its own of clear water does not draw them: VTK would keep the size that they have there."""
    counts = []
    for own_view in (False, True):
        made = pv.Plotter(off_screen=True, window_size=SIZE)
        made.add_mesh(pv.Cone(direction=(0, 0, 1)), color=RED)
        text = vtkBillboardTextActor3D()
        text.SetInput("above")
        text.SetPosition(0.6, 0.0, 0.5)
        text.GetTextProperty().SetColor(0, 0, 1)
        text.GetTextProperty().SetFontSize(24)
        made.add_actor(text)
        made.add_water(level=-0.2, own_view=own_view)
        made.camera.elevation = -20
        made.render()
        picture = picture_of(made).astype(int)
        counts.append(int((picture[..., 2] - picture[..., 0] > 120).sum()))
        made.close()
    wt.check_at_least("pixels of the text", counts[0], 50)
    wt.check_at_most("with an own view, of those without, less 1", abs(counts[1] / counts[0] - 1), 0.1)


@pytest.mark.parametrize("mesh_x, bounds, least, most", (
    (0.0, (-1e4, 1e4, -1e4, 1e4), 0.05, 0.9), (5000.0, (4500, 5500, -500, 500), 1000.0, 4500.0)), ids=("wide", "far"))
def test_the_near_plane_lies_before_the_nearest_water(mesh_x, bounds, least, most, plotter):
    """With a camera that was set: VTK keeps it at a thousandth of the far plane, which a wide sheet moves away."""
    plotter.add_mesh(pv.Sphere(center=(mesh_x, 0, 0)))
    plotter.camera_position = [(-3.0, 0.0, 1.5 if mesh_x == 0.0 else -0.19), (mesh_x, 0.0, 0.0), (0.0, 0.0, 1.0)]
    plotter.add_water(level=-0.2, bounds=bounds, units="m", render=False)
    near = plotter.camera.clipping_range[0]
    wt.check_at_least("near plane", near, least)
    wt.check_at_most("near plane", near, most)
