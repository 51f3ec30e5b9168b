# SPDX-License-Identifier: BSD-3-Clause
"""Water in PyVista: importing this module gives every plotter add_water, add_water_level_slider and add_clear_sky.

    import pyvista as pv
    import vtkwater.pyvista

    plotter = pv.Plotter()
    plotter.add_mesh(terrain)
    water = plotter.add_water(level=355, preset="lake")
    plotter.show()
"""
import math
import warnings
from numbers import Real

import pyvista as pv
from vtkmodules.vtkCommonCore import vtkMath

from . import vtkWaterActor
from .advice import check_has_effect, heights_along, tell_distance, tell_level
from .errors import raising
from .hulls import hulls_of
from .measure import WHOLE
from .skies import Sun, add_clear_sky, has_scene_light, shine, sun_of
from .sliders import add_water_level_slider
from .surfaces import (check_has_water, check_level, color_surface, exaggeration_of, lakes_of, level_and_surface,
                       plane_of, surface_of)
from .vertex_data import VertexData
from .words import finite, flag, in_range, number, numbers, of_type, plain, set_look, whole_in_range

__all__ = ["Sun", "add_clear_sky", "add_water", "add_water_level_slider"]

DRAWN_BY_VTK_JS = ("client", "html")  # of PyVista's backends for notebooks


def add_water(
    self,
    water=None,
    /,
    preset=None,
    waves=None,
    *,
    level=None,
    depth=None,
    bed=None,
    flow=None,
    matter=None,
    matter_absorption=None,
    matter_scattering=None,
    foam_by=None,
    foam_measure=None,
    color_by=None,
    cmap=None,
    clim=None,
    log_scale=False,
    data_opacity=None,
    scalar_bar=True,
    wind=None,
    whitecaps=None,
    refraction=None,
    own_view=None,
    foam=None,
    caustics=None,
    light_shafts=None,
    shadows=None,
    dome_port=None,
    sun=None,
    quality=None,
    units=None,
    normal="z",
    origin=(0.0, 0.0, 0.0),
    surface=None,
    secondary_reflections=None,
    max_mirrors=None,
    hulls=None,
    bounds=None,
    color=None,
    opacity=None,
    time=0.0,
    name=None,
    pickable=False,
    reset_camera=None,
    render=True,
):
    """Add water that reflects the scene to the active subplot.

    Parameters
    ----------
    water : float | pyvista.DataSet, optional
        The ``level``, or the ``surface``: ``add_water(2.0)`` is ``add_water(level=2.0)``.

    preset : str, optional
        A preset with optics and waves: ``'pool'``, ``'lake'``, ``'clear tropical'``, ``'ocean wind 5'``,
        ``'ocean wind 10'``, ``'ocean wind 15'``, ``'turbid river'`` or ``'mirror floor'``. The default is a
        calm, clear lake.

    waves : float | sequence[sequence[float]], optional
        Replaces the preset's waves: a wind speed, m/s in [0.1, 100], 0 for calm water; or any number of waves, each
        with 2 to 5 numbers: amplitude (m), wavelength (m), direction of travel (degrees from x towards y),
        phase (degrees) and steepness ([0, 1]); the last three are 0 if they are left out.

    level : float | str, optional
        Height of the water above ``origin`` along ``normal``, in the scene's unit; with the default normal, its z. The
        default is 0, or the mean height of the ``surface``. A string names an array of the surface; see ``depth``.

    depth, bed : str, optional
        With a solver's mesh as the ``surface``: the names of its arrays of the water's depth and of the bed's height,
        of points or cells. Two of ``level``, ``depth`` and ``bed`` define the water. With only ``depth`` the bed is the
        mesh's own z; with only ``level`` the whole mesh is wet. The water ends where the bed reaches its level,
        between the points, and follows the arrays when they change (:vtk:`vtkWaterSurfaceFilter`). If the level
        belongs to cells and the bed to points, give the ``depth`` instead of one of them: in dry cells, solvers write
        the height of the bed as the level, and some of these cells would be shown as water.

    flow : str, optional
        An array of the surface's points or cells with the velocity of a current, m/s, 2 or 3 components. It carries
        small waves: give the water such waves with ``preset``, ``wind`` or ``waves``, and set ``actor.time`` before each
        frame (:vtk:`vtkWaterActor`'s ``FlowArrayName``).

    matter : str, optional
        An array of the surface's points or cells with the concentration of matter that the water carries, such as
        sediment or a dye, finite and not negative. It absorbs and scatters light on the way through the water, and
        colours deep water (:vtk:`vtkWaterActor`'s ``MatterArrayName``). Turns refraction on.

    matter_absorption, matter_scattering : sequence[float], optional
        What the ``matter`` absorbs, and what it scatters back, at 650, 550 and 450 nm, in 1/m per unit of its
        concentration. The default is mineral sediment with concentrations in g/m^3 (mg/l):
        ``(0.0032, 0.0110, 0.0376)`` and ``(0.012, 0.012, 0.012)``.

    foam_by : str, optional
        An array of the surface's points or cells that says how much foam there is (``FoamArrayName``).

    foam_measure : str, default: 'cover'
        What the values of ``foam_by`` are. ``'cover'``: the share of the surface that foam covers, in [0, 1], such as
        the fraction of air at the surface. ``'froude'``: Froude numbers; foam begins at 1 and covers everything from
        1.7 on. ``'breaking'``: heights of the waves over the depth; foam begins at 0.78 and covers everything from
        1.13 on.

    color_by : str, optional
        An array of the surface's points or cells that colours the water, through ``cmap`` (default: the theme's) and
        ``clim`` (two values), as in ``add_mesh``. The default of ``clim`` is the array's range when the water is added,
        which is that of the first step: for an animation, pass ``clim``. ``cmap`` may also be a lookup table
        (:vtk:`vtkScalarsToColors`) with its own categories, scale, range and colour of NaN.

    log_scale : bool, default: False
        Whether these colours have a logarithmic scale. The default of ``clim`` then begins with the smallest value
        above 0. Values of 0 or less have the first colour.

    data_opacity : float, optional
        Opacity of these colours over the refracted scene, in [0, 1]. At the default, 1, they hide the bed.

    scalar_bar : bool, default: True
        Whether to show a scalar bar for ``color_by``.

    wind : float | sequence[float], optional
        Replaces the preset's waves with a wind sea: the wind speed, m/s in [0.1, 100], 0 for calm water; or the speed
        and the direction in which the wind blows, in degrees from the plane's first axis (x) towards the second (y).
        The water keeps the preset's colour, that of a lake by default; ``preset="ocean wind 10"`` is a blue ocean with
        such waves. Not together with ``waves``.

    whitecaps : float | bool, optional
        Whether a wind sea has foam where its crests break; a number is the time in seconds, 0 to 10, after which 1/e
        of such foam is left (0: it vanishes with the crest), and True means 3.5. Whitecaps need a wind sea. The default
        is False.

    refraction : bool, optional
        Whether the scene is visible through the surface, refracted and attenuated. By default the preset
        decides; without a preset the default is True, unless ``color`` or ``opacity`` is given. With
        ``color_by`` the default is False, because opaque colours hide the bed, unless ``data_opacity`` is
        below 1 or another argument turns refraction on.

    own_view : bool, optional
        Whether the refracted colours come from an additional view of what lies below the water, twice as wide and
        high as the picture: objects outside the picture or behind objects above the water, and translucent objects, are
        then visible through the water. Turns refraction on. False: they come from the picture. By default, the view is
        rendered for water that reaches to the horizon, if the camera is above the water and looks down by less than
        30 degrees.

    foam : float | bool, optional
        A depth in metres, finite and not negative: the shore foams where the water is shallower than this. True means
        0.25, and with automatic units at least 1/400 of the scene's diagonal. Turns refraction on.

    caustics : float | bool, optional
        Strength of the light that waves focus on what lies under them, in [0, 1]; True means 0.8. Caustics need waves,
        turn refraction on, and add the default ``sun`` to a subplot without a scene light.

    light_shafts : float | bool, optional
        Light shafts for a camera under water: the share, in [0, 1], of the light there that varies because the waves
        above focus it; True means 1. Light shafts need waves, turn refraction on, and add the default ``sun`` to a
        subplot without a scene light.

    shadows : bool, optional
        Whether objects cast shadows on the water's glitter and foam. True adds the default ``sun`` to a subplot
        without a scene light.

    dome_port : float, optional
        Radius in metres of a dome port, the glass dome around an underwater camera, finite and not negative; 0 means
        no port. If the camera is less than this radius above the water, the picture is half above and half under
        water. Turns refraction on.

    sun : bool | sequence[float], optional
        Adds a scene light, the sun, for glitter, shadows, caustics and light shafts: azimuth (degrees from north
        towards east, in [-360, 360]) and elevation (degrees above the water, in [0, 90]). True means (150, 35),
        which is also the default if ``caustics``, ``light_shafts`` or ``shadows`` need a light. A sun below the
        horizon lights nothing and is an error: at night, leave ``sun`` out. North is y and east is x; for tilted
        water they are the second and the first of the plane's own axes. The light is in
        ``plotter.renderer.lights``, has the class ``vtkwater.pyvista.Sun``, and stays when the water is removed.
        Another ``sun`` in the same subplot replaces it. PyVista's own lights stay, and together with the sun they
        overexpose bright meshes: create the plotter with ``pyvista.Plotter(lighting='none')``. The sun is then the
        only light, and faces away from it are black; a weak headlight,
        ``plotter.add_light(pyvista.Light(light_type='headlight', intensity=0.4))``, shows them.

    quality : str, optional
        Quality of reflections on waves: ``'fast'``, ``'default'``, ``'high'`` or ``'reference'``.

    units : str | float, optional
        Length unit of the scene: ``'um'``, ``'mm'``, ``'cm'``, ``'m'``, ``'km'``, ``'in'``, ``'ft'``, ``'mi'``, a
        number of metres, or ``'automatic'``. The default is ``'automatic'``, or ``'m'`` with individual ``waves``.
        ``'automatic'`` treats a scene that is 256 to 1024 units across as one in metres, a smaller scene as 200 to
        400 m across, and a larger one as 1000 to 2000 m across; presets may have other ranges (a pool: 4 to 32
        units are metres). Waves too short to be visible are left out.
        ``print(actor)`` shows the unit in use.

    normal : str | sequence[float], default: 'z'
        Direction out of the water: ``'x'``, ``'-x'``, ``'y'``, ``'-y'``, ``'z'``, ``'-z'``, or three numbers.

    origin : sequence[float], default: (0.0, 0.0, 0.0)
        The point from which ``level`` is measured.

    surface : pyvista.DataSet, optional
        The water's surface, such as a lake's polygon or a free surface. For each unconnected part, such as one of
        several lakes, the plane that fits it best is found. There is one water per plane (:vtk:`vtkWaterLakes`). With a
        number as ``level`` there is one water, and all of the surface must lie in its plane, apart from waves. The
        default is a built-in sheet.

    secondary_reflections : bool, optional
        Whether other waters, in other planes, reflect the scene where this water's reflection shows them. The default
        is False: they reflect only the sky there. With a ``surface`` of several planes, this applies to all of them.

    max_mirrors : int, optional
        With a ``surface`` of several planes: the maximum number of waters in view that reflect the scene, in
        [0, 4096]; the default is 8. The other waters, which cover less of the picture, reflect only the sky.

    hulls : sequence[pyvista.DataSet | pyvista.Actor], optional
        Boats, caissons and other floating bodies that have no water inside (:vtk:`vtkWaterActor`'s
        ``AddHull``): actors, as ``add_mesh`` returns them, whose movements the water follows; or meshes, which do not
        move. Each must be closed where the water cuts it; an open boat is closed there if its rim lies above the
        waves. The hulls are not added to the plotter.

    bounds : sequence[float] | str, optional
        Extent of the built-in sheet. ``(xmin, xmax, ymin, ymax)``: along x and y for horizontal water, otherwise along
        the plane's own axes (:vtk:`vtkWaterActor`'s ``SetSheetBounds``). ``'horizon'``: it fills the visible part of
        the plane and is not part of the plotter's bounds (``SetSheetToHorizon``). ``'scene'``: it is as wide as the
        scene, including what is added later. By default it is as wide as the scene if the scene has ground under all
        of its water, such as a terrain; otherwise it reaches to the horizon (``SetSheetToAutomatic``). Not together
        with ``surface``.

    color : ColorLike, optional
        Colour of deep water, visible where it does not reflect.

    opacity : float, optional
        Opacity in [0, 1]; below 1 the water is blended with what lies behind it. For clear water use ``preset``.

    time : float, default: 0.0
        Time of the waves, s. Set ``actor.time`` (``SetTime``) before each frame of an animation.

    name : str, optional
        Name of the actor in the plotter; an earlier actor of that name is removed.

    pickable : bool, default: False
        Whether pickers find the surface.

    reset_camera : bool, optional
        As for ``add_actor``: by default the camera is reset unless you have set it.

    render : bool, default: True
        Whether to render after adding, if the window is shown.

    Returns
    -------
    vtkwater.vtkWaterActor
        The water. If the ``surface`` has several planes, it is the water of the largest part; the others copy its
        look, time and visibility in the next frame, and are removed with it. ``vtkwater.measure.surface(actor)`` is the
        mesh of all of them, to export. ``actor.water_property`` (``GetWaterProperty()``) holds all settings of the
        look, ``actor.reflection_pass`` (``GetReflectionPass()``) those of the reflection and its cost.

    Raises
    ------
    TypeError
        If an argument has the wrong type.

    ValueError
        If a value is out of its range or has the wrong number of elements, if two arguments contradict each other, if
        the surface has no polygon that could be water, or if its mean height differs from ``level`` by more than 1 %
        of its diagonal. The text names the values, and what is accepted or which arguments contradict each other.

    Warns
    -----
    UserWarning
        If PyVista's notebook backend is ``'client'`` or ``'html'``, because vtk.js does not draw water; if the water's
        level is below the whole terrain, which hides the water; if it is above the whole scene by more than the
        scene's diagonal; if the gap between the surface and the scene is larger than the sum of their diagonals; if
        arrays of heights make nothing wet, contradict each other or seem to have different units; or if one of the
        ``waves`` is steeper than water waves can be, which break at a height of 0.142 of their length. The text names
        the heights of the scene, the positions of surface and scene, the arrays and their ranges, or the wave.

    Notes
    -----
    In a notebook, rendering must happen on the server: call ``pyvista.set_jupyter_backend('server')`` or
    ``('static')``. With trame, use ``VtkRemoteView``.

    Call ``Plotter.set_scale`` before ``add_water``, which also divides the water's depths by the vertical
    exaggeration: with ``units='m'`` the water is as clear as without it. The brightest scene light glitters on waves:
    ``sun``, or one of yours. PyVista's default lights are camera lights, not scene lights, and do not glitter.

    Examples
    --------
    >>> import pyvista as pv
    >>> import vtkwater.pyvista
    >>> plotter = pv.Plotter(off_screen=True)
    >>> _ = plotter.add_mesh(pv.Cone(direction=(0, 0, 1)))
    >>> water = plotter.add_water(level=-0.2, waves=[(0.01, 0.8, 30)])
    >>> water.GetLevel()
    -0.2
    """
    level, surface = level_and_surface(water, level, surface)
    if name is not None and not of_type("name", name, str):
        raise ValueError("name is ''; it must have a letter, or be None")
    render = flag("render", render)
    if shadows is not None:
        shadows = flag("shadows", shadows)
    for word, value in (("caustics", caustics), ("light_shafts", light_shafts)):
        if value is not None and not isinstance(plain(value), (bool, Real)):
            raise TypeError(f"{word} must be a number, not {type(value).__name__}")
    scalar_bar = flag("scalar_bar", scalar_bar)
    log_scale = flag("log_scale", log_scale)
    scale = self.renderer.scale
    if not all(0.0 < factor < float("inf") for factor in scale):
        raise ValueError(
            f"the plotter's scale is {tuple(scale)}; its factors (set_scale) must be finite and more than 0")
    if pv.global_theme.jupyter_backend in DRAWN_BY_VTK_JS:
        warnings.warn(f"the backend {pv.global_theme.jupyter_backend!r} draws with vtk.js, which cannot "
                      "draw water and leaves it out; call pyvista.set_jupyter_backend('server')", stacklevel=2)
    if surface is not None and bounds is not None:
        raise ValueError("bounds and surface are both given; bounds apply only to the built-in sheet")
    if max_mirrors is not None:
        max_mirrors = whole_in_range("max_mirrors", max_mirrors, 0, 4096)
    if secondary_reflections is not None:
        secondary_reflections = flag("secondary_reflections", secondary_reflections)
    if data_opacity is not None:
        data_opacity = in_range("data_opacity", data_opacity, 0.0, 1.0)
    mapper, data = surface_of(surface, level, depth, bed, normal, origin)
    check_has_effect(surface, data is None and level is not None, color_by, max_mirrors, cmap=cmap, clim=clim,
                     log_scale=log_scale or None, data_opacity=data_opacity)
    vertex_data = VertexData(flow=flow, matter=matter, matter_absorption=matter_absorption,
                             matter_scattering=matter_scattering, foam_by=foam_by, foam_measure=foam_measure)
    vertex_data.check(surface)
    vertex_data.check_colors(color_by, data_opacity)
    if color_by is not None:
        color_surface(mapper, surface, color_by, cmap, clim, log_scale)
        through = own_view, foam, caustics, light_shafts, dome_port, matter
        if refraction is None and not any(through) and data_opacity in (None, 1):
            refraction = False  # the data hide what it would show
    has_level = data is None and level is not None
    plane_origin, plane_normal = plane_of(finite("level", level) if has_level else 0.0, normal, origin, scale)
    lakes = None if mapper is None or has_level else lakes_of(mapper, normal)
    if mapper is not None and data is None:
        check_has_water(mapper, lakes, normal)
    if has_level and mapper is not None:
        check_level(mapper, level, normal, origin)
    if sun is None:
        sun = bool(caustics or light_shafts or shadows) and not has_scene_light(self.renderer)
    light = None if sun is False else sun_of(sun)
    heights = heights_along(self.renderer, plane_normal, normal, origin)
    afloat = hulls_of(hulls, scale)

    actor = vtkWaterActor() if lakes is None else lakes.GetWater()
    look = actor.GetWaterProperty()
    if lakes is None:
        actor.GetPlane().SetOrigin(plane_origin)
        actor.GetPlane().SetNormal(plane_normal)
    set_look(look, preset=preset, waves=waves, wind=wind, whitecaps=whitecaps,
             color=None if color is None else color_of(color),
             opacity=opacity, refraction=refraction, own_view=own_view, foam=foam, caustics=caustics,
             light_shafts=light_shafts, shadows=shadows, dome_port=dome_port, matter=matter, quality=quality, units=units)
    look.SetVerticalExaggeration(exaggeration_of(normal, scale))
    vertex_data.check_look(look)
    with raising(actor, SheetBounds="bounds", Time="time"):
        if bounds is not None:
            set_bounds(actor, bounds)
        else:
            actor.SetSheetToAutomatic()
        if own_view is None:
            actor.GetWaterProperty().SetRefractionSourceToAutomatic()
        actor.SetTime(number("time", time))
    if data_opacity is not None:
        look.SetDataOpacity(data_opacity)
    vertex_data.give(actor)
    if max_mirrors is not None and lakes is not None:
        lakes.SetMaximumNumberOfMirrors(max_mirrors)
    if secondary_reflections is not None:
        actor.GetReflectionPass().SetSecondaryReflections(secondary_reflections)
    if has_level and mapper is not None:
        actor.SetMapper(mapper)
    for hull in afloat:
        actor.AddHull(hull)

    self.renderer.add_actor(
        actor, name=name, pickable=pickable, reset_camera=reset_camera, render=False)
    if surface is None:
        actor.SetScale(1.0, 1.0, 1.0)  # the plane has it
    if lakes is not None:
        lakes.AddTo(self.renderer)
        setattr(actor, WHOLE, mapper)  # not the lakes, which hold the actor
    if light is not None:
        shine(self.renderer, actor, *light)
    if color_by is not None and scalar_bar:
        try:
            self.add_scalar_bar(color_by, mapper=mapper, render=False)
        except RuntimeError as error:  # PyVista has so many
            reason = str(error).rstrip(".")
            warnings.warn(f"{color_by!r} has no scalar bar: {reason}. Pass scalar_bar=False", stacklevel=2)
    bounds_known = vtkMath.AreBoundsInitialized(actor.GetBounds() or (1, -1, 1, -1, 1, -1))  # also chooses the sheet
    if surface is None and heights is not None:
        is_sheet = bounds is None and not actor.GetSheetToHorizon()
        tell_level(level or 0.0, heights, is_sheet)
    if surface is not None and bounds_known:
        tell_distance(mapper.GetBounds() if lakes is not None else actor.GetBounds(), self.renderer)
    if self.renderer.camera_set and not actor.GetSheetToHorizon():
        widen_clipping_range(self.renderer, actor)
    if render and (actor.GetSheetToHorizon() or bounds_known):
        self.render()  # without bounds there is nothing yet to see
    return actor


NEAREST = 1e-5  # the near plane over the far one: a depth buffer tells no more apart


def widen_clipping_range(renderer, water):
    """Extend the clipping range: water reaches nearer to the eye, and farther, than the rest of the scene."""
    near, far = renderer.camera.clipping_range
    renderer.reset_camera_clipping_range()
    new_near, new_far = renderer.camera.clipping_range
    near, far = min(near, new_near), max(far, new_far)
    bounds = water.GetBounds()
    if bounds and not renderer.camera.parallel_projection:
        # VTK keeps the near plane at a thousandth of the far one, which may lie beyond the nearest water
        eye = renderer.camera.position
        beside = [max(bounds[2 * i] - eye[i], eye[i] - bounds[2 * i + 1], 0.0) for i in range(3)]
        near = max(min(near, 0.5 * math.hypot(*beside)), NEAREST * far)
    renderer.camera.clipping_range = near, far


def color_of(color):
    """Red, green and blue in [0, 1]."""
    try:
        return pv.Color(color).float_rgb
    except (TypeError, ValueError):
        raise ValueError(f"color is {color!r}; it must be a colour's name, '#rrggbb', or three numbers, all in [0, 1] "
                         "or all whole and in [0, 255]") from None


def set_bounds(actor, bounds):
    if not isinstance(bounds, str):
        actor.SetSheetBounds(numbers("bounds", bounds, 4))
    elif bounds == "horizon":
        actor.SetSheetToHorizon()
    elif bounds == "scene":
        actor.ResetSheetBounds()
    else:
        raise ValueError(f"bounds is {bounds!r}; it must be 'horizon', 'scene' or four numbers "
                         "(xmin, xmax, ymin, ymax)")


pv.BasePlotter.add_clear_sky = add_clear_sky
pv.BasePlotter.add_water = add_water
pv.BasePlotter.add_water_level_slider = add_water_level_slider
