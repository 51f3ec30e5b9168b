# SPDX-License-Identifier: BSD-3-Clause
"""The sun and the clear sky of a PyVista plotter: what ``add_water(sun=...)`` and ``add_clear_sky`` add."""
import pyvista as pv
from vtkmodules.vtkRenderingCore import vtkSkybox

from . import vtkWaterClearSkySource
from .errors import raising
from .words import LEAST_TURBIDITY, MOST_TURBIDITY, SUN_COLOR, SUN_PLACE, TURBIDITY, in_range, number, numbers, plain

__all__ = ["Sun", "add_clear_sky", "has_scene_light", "shine", "sun_of"]


def has_scene_light(renderer):
    return any(light.LightTypeIsSceneLight() and light.GetSwitch() for light in renderer.GetLights())


class Sun(pv.Light):
    """The scene light that ``add_water(sun=...)`` and ``add_clear_sky`` add; a renderer has one."""


def sun_of(sun):
    """Azimuth and elevation in degrees."""
    if isinstance(plain(sun), bool):
        return SUN_PLACE
    if isinstance(sun, str) or not hasattr(sun, "__len__"):
        raise TypeError(f"sun must be a bool, or an azimuth and an elevation, not {type(sun).__name__}")
    azimuth, elevation = numbers("sun", sun, 2)
    in_range("sun[0], the azimuth,", azimuth, -360.0, 360.0)
    in_range("sun[1], the elevation,", elevation, 0.0, 90.0)  # a sun under the horizon lights nothing
    return azimuth, elevation


def shine(renderer, water, azimuth, elevation):
    """Moves the renderer's sun to this direction."""
    direction = [0.0, 0.0, 0.0]
    water.GetSkyDirection(azimuth, elevation, direction)
    place_sun(renderer, direction)


def place_sun(renderer, direction, color=None):
    """Moves the renderer's sun, creating it if necessary; keeps its colour unless one is given."""
    light = next((light for light in renderer.lights if isinstance(light, Sun)), None)
    if light is None:
        light = Sun(light_type="scene light", color=SUN_COLOR)
        light.positional = False
        renderer.add_light(light)
    if color is not None:
        light.diffuse_color = light.specular_color = color
    light.focal_point = (0.0, 0.0, 0.0)
    light.position = direction


def add_clear_sky(self, sun=True, turbidity=TURBIDITY, *, resolution=1024, render=True):
    """Add a clear daytime sky to the active subplot, and the sun that lights the scene.

    Up is z, north is y and east is x. Water reflects the sky automatically. The model is that of Preetham, Shirley and
    Smits (1999, "A Practical Analytic Model for Daylight"). The picture does not contain the sun's disc: waves glitter
    in the sun's light instead.

    Parameters
    ----------
    sun : bool | sequence[float], default: True
        Position of the sun: azimuth (degrees from north towards east, in [-360, 360]) and elevation (degrees above
        the horizon, in [0, 90]); True means (150, 35).

    turbidity : float, default: 2.0
        Turbidity of the air, in [2, 10]: 2 is very clear, 6 warm and moist, 10 hazy.

    resolution : int, default: 1024
        Width of the sky's picture in pixels, in [16, 8192].

    render : bool, default: True
        Whether to render after adding, if the window is shown.

    Returns
    -------
    vtkmodules.vtkRenderingCore.vtkSkybox
        The skybox that shows the sky; ``plotter.remove_actor`` removes it. Another ``add_clear_sky`` in the same
        subplot replaces it. The light has the class ``vtkwater.pyvista.Sun``; ``add_water(sun=...)`` shares it.
        The background, which the sky hides, gets the sky's mean colour: it lights the water.

    Raises
    ------
    TypeError
        If an argument has the wrong type.

    ValueError
        If a value is out of its range.

    Examples
    --------
    >>> import pyvista as pv
    >>> import vtkwater.pyvista
    >>> plotter = pv.Plotter(off_screen=True, lighting="none")
    >>> sky = plotter.add_clear_sky(sun=(120, 20), turbidity=3)
    >>> water = plotter.add_water(preset="ocean wind 5", bounds="horizon")
    """
    if sun is False or sun is None:
        raise ValueError(f"sun is {sun!r}; a clear sky needs one: True, or an azimuth and an elevation")
    azimuth, elevation = sun_of(sun)
    turbidity = number("turbidity", turbidity)
    in_range("turbidity", turbidity, LEAST_TURBIDITY, MOST_TURBIDITY)
    if isinstance(resolution, bool) or not hasattr(resolution, "__index__"):
        raise TypeError(f"resolution must be int, not {type(resolution).__name__}")
    sky = vtkWaterClearSkySource()
    with raising(sky):
        sky.SetAzimuth(azimuth)
        sky.SetElevation(elevation)
        sky.SetTurbidity(turbidity)
        sky.SetWidth(min(max(resolution.__index__(), -1), 2**31 - 1))
    skybox = vtkSkybox()
    sky.ConfigureSkybox(skybox, self.renderer)
    self.renderer.SetBackground(sky.GetMeanColor())
    self.renderer.GradientBackgroundOff()
    self.renderer.TexturedBackgroundOff()
    self.renderer.add_actor(skybox, name="clear sky", pickable=False, reset_camera=False, render=False)
    place_sun(self.renderer, sky.GetSunDirection(), sky.GetSunColor())
    if render:
        self.render()
    return skybox
