# SPDX-License-Identifier: BSD-3-Clause
"""Water in PyVista: importing this module gives every plotter a method add_water.

    import pyvista as pv
    import vtkwater.pyvista

    plotter = pv.Plotter()
    plotter.add_mesh(terrain)
    water = plotter.add_water(level=355, preset="lake")
    plotter.show()
"""
import warnings
from collections.abc import Sequence
from numbers import Real

import pyvista as pv

from . import vtkWaterActor
from .errors import raising

__all__ = ["add_water"]

MOST_NUMBERS_OF_A_WAVE = 5
DRAWN_BY_VTK_JS = ("client", "html")  # of PyVista's backends for notebooks


def add_water(
    self,
    level=0.0,
    preset=None,
    waves=None,
    *,
    normal="z",
    origin=(0.0, 0.0, 0.0),
    surface=None,
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
    level : float, default: 0.0
        Height of the water over ``origin`` along ``normal``, in the scene's unit: its z by default.

    preset : str, optional
        A water with its optics and waves: ``'pool'``, ``'lake'``, ``'clear tropical'``, ``'ocean wind 5'``,
        ``'ocean wind 10'``, ``'ocean wind 15'``, ``'turbid river'`` or ``'mirror floor'``. By default a calm,
        deep lake. Metres count: the scene's unit is taken for one.

    waves : float | sequence[sequence[float]], optional
        In place of the preset's waves: the speed of the wind whose sea it shall be, m/s in [0.1, 100], 0 for
        calm water; or any number of waves, each of 2 to 5 numbers: amplitude (m), wavelength (m), direction it
        travels to (degrees from x towards y, default 0), phase (degrees, default 0) and steepness ([0, 1], default 0).

    normal : str | sequence[float], default: 'z'
        Where up is, out of the water: ``'x'``, ``'-x'``, ``'y'``, ``'-y'``, ``'z'``, ``'-z'``, or three numbers.

    origin : sequence[float], default: (0.0, 0.0, 0.0)
        The point that ``level`` counts from.

    surface : pyvista.DataSet, optional
        The water's surface, such as a lake's polygon or a free surface: its points should lie in the plane. By
        default a sheet over the bounds of the scene.

    bounds : sequence[float], optional
        Of that sheet: ``(xmin, xmax, ymin, ymax)``, along x and y of level water, and otherwise along the
        plane's own axes (:vtk:`vtkWaterActor`'s ``SetSheetBounds``). Not together with ``surface``.

    color : ColorLike, optional
        Colour of the water itself, where it does not reflect.

    opacity : float, optional
        In [0, 1]; below 1 the water is blended with what lies behind it. Clear water wants ``preset`` instead.

    time : float, default: 0.0
        Of the waves, s. Set ``actor.time`` (``SetTime``) before each frame of an animation.

    name : str, optional
        Of the actor in the plotter; an earlier actor of that name is removed.

    pickable : bool, default: False
        Whether pickers find the surface.

    reset_camera : bool, optional
        As for ``add_actor``: by default the camera is reset unless it was set.

    render : bool, default: True
        Render after adding, when the window is shown.

    Returns
    -------
    vtkwater.vtkWaterActor
        The water. ``actor.water_property`` (``GetWaterProperty()``) has the look in full, and
        ``actor.reflection_pass`` (``GetReflectionPass()``) what the reflection costs.

    Raises
    ------
    TypeError
        When an argument is not of its type.

    ValueError
        When a value is out of its range, or has another number of parts; the text names both.

    Warns
    -----
    UserWarning
        When PyVista's backend for notebooks is ``'client'`` or ``'html'``: vtk.js draws there, which has no water.

    Notes
    -----
    The server must render: ``pyvista.set_jupyter_backend('server')`` or ``'static'``, trame's ``VtkRemoteView``.

    Of ``Plotter.set_scale`` it takes what is set before. The brightest scene light glitters on waves;
    PyVista's default lights move with the camera and are none: ``plotter.add_light(pyvista.Light(light_type='scene light'))``.

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
    scale = self.renderer.scale
    plane_origin, plane_normal = plane_of(number("level", level), normal, origin, scale)
    if pv.global_theme.jupyter_backend in DRAWN_BY_VTK_JS:
        warnings.warn(f"the backend {pv.global_theme.jupyter_backend!r} draws with vtk.js, which does not know the water and "
                      "leaves it out; say pyvista.set_jupyter_backend('server')", stacklevel=2)
    if surface is not None and bounds is not None:
        raise ValueError("bounds are of the water's own sheet; there is none with a surface")

    actor = vtkWaterActor()
    look = actor.GetWaterProperty()
    with raising(actor, look):
        plane = actor.GetPlane()
        plane.SetOrigin(plane_origin)
        plane.SetNormal(plane_normal)
        if preset is not None:
            look.SetPreset(of_type("preset", preset, str))
        if waves is not None:
            set_waves(look, waves)
        if bounds is not None:
            actor.SetSheetBounds(numbers("bounds", bounds, 4))
        if color is not None:
            look.SetDeepColor(pv.Color(color).float_rgb)
        if opacity is not None:
            look.SetOpacity(number("opacity", opacity))
        actor.SetTime(number("time", time))
    if surface is not None:
        actor.SetMapper(mapper_of(surface))

    self.renderer.add_actor(
        actor, name=name, pickable=pickable, reset_camera=reset_camera, render=False)
    if surface is None:
        actor.SetScale(1.0, 1.0, 1.0)  # the plane has it
    if self.renderer.camera_set:
        widen_clipping_range(self.renderer)
    if render:
        self.render()
    return actor


def widen_clipping_range(renderer):
    """Water reaches nearer to the eye, and farther, than what the camera was set for."""
    near, far = renderer.camera.clipping_range
    renderer.reset_camera_clipping_range()
    new_near, new_far = renderer.camera.clipping_range
    renderer.camera.clipping_range = (min(near, new_near), max(far, new_far))


def of_type(name, value, kind):
    if not isinstance(value, kind):
        raise TypeError(f"{name} must be {kind.__name__}, not {type(value).__name__}")
    return value


def number(name, value):
    if isinstance(value, bool) or not isinstance(value, Real):
        raise TypeError(f"{name} must be a number, not {type(value).__name__}")
    return float(value)


def numbers(name, values, least, most=None):
    """A sequence of numbers (a list, a tuple, an array) as a list; its length in [least, most]."""
    most = most or least
    if isinstance(values, str) or not (isinstance(values, Sequence) or hasattr(values, "__array__")):
        raise TypeError(f"{name} must be a sequence of numbers, not {type(values).__name__}")
    if not least <= len(values) <= most:
        wanted = f"{least}" if least == most else f"{least} to {most}"
        raise ValueError(f"{name} must have {wanted} numbers, not {len(values)}")
    return [number(f"{name}[{i}]", value) for i, value in enumerate(values)]


def plane_of(level, normal, origin, scale):
    """Origin and normal of the water's plane in the renderer's own coordinates, which are scaled."""
    axes = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1), "-x": (-1, 0, 0), "-y": (0, -1, 0), "-z": (0, 0, -1)}
    if isinstance(normal, str):
        if normal.lower() not in axes:
            raise ValueError(f"normal is {normal!r}; it must be one of {', '.join(axes)}, or three numbers")
        normal = axes[normal.lower()]
    normal = numbers("normal", normal, 3)
    length = sum(part * part for part in normal) ** 0.5
    if not 0.0 < length < float("inf"):
        raise ValueError(f"normal is {tuple(normal)}; it must be finite and not zero")
    origin = numbers("origin", origin, 3)
    point = [at + level * part / length for at, part in zip(origin, normal)]
    if not all(abs(part) < float("inf") for part in point):
        raise ValueError(f"level {level} over {tuple(origin)}: both must be finite")
    return [at * factor for at, factor in zip(point, scale)], [part / factor for part, factor in zip(normal, scale)]


def set_waves(look, waves):
    look.RemoveAllWaves()
    look.SeaOff()
    if isinstance(waves, Real) and not isinstance(waves, bool):
        if waves != 0:
            look.SetWindSpeed(float(waves))
            look.SeaOn()
        return
    if isinstance(waves, str) or not hasattr(waves, "__len__"):
        raise TypeError(f"waves must be a number or a sequence of waves, not {type(waves).__name__}")
    for i, wave in enumerate(waves):
        look.AddWave(*numbers(f"waves[{i}]", wave, 2, MOST_NUMBERS_OF_A_WAVE))


def mapper_of(surface):
    if not isinstance(surface, pv.DataSet):
        raise TypeError(f"surface must be a pyvista.DataSet, not {type(surface).__name__}")
    mesh = surface if isinstance(surface, pv.PolyData) else surface.extract_surface()
    if mesh.n_cells == 0:
        raise ValueError("surface has no cells")
    mapper = pv.DataSetMapper(dataset=mesh)
    mapper.ScalarVisibilityOff()
    return mapper


pv.BasePlotter.add_water = add_water
