# SPDX-License-Identifier: BSD-3-Clause
"""Settings of a water's look that add_water and the command share: preset, wind, refraction, foam, ...

    set_look(water.GetWaterProperty(), preset="lake", wind=(6.0, 30.0), foam=True, caustics=0.5)

A wrong type raises a TypeError, a wrong value a ValueError. Both name the argument, the value and what is accepted.
"""
import math
import warnings
from collections.abc import Sequence
from numbers import Integral, Real

from .errors import raising

__all__ = ["QUALITIES", "set_look"]

QUALITIES = ("fast", "default", "high", "reference")
FOAM_DEPTH = 0.25  # m, of foam=True
CAUSTICS = 0.8  # strength, of caustics=True
SUN_PLACE = (150.0, 35.0)  # azimuth and elevation, degrees, of sun=True
SUN_COLOR = (1.0, 0.95, 0.87)
TURBIDITY = 2.0  # of the air of a clear sky
LEAST_TURBIDITY, MOST_TURBIDITY = 2.0, 10.0
LEAST_WIND, MOST_WIND = 0.1, 100.0  # m/s
MOST_LIFE_TIME = 10.0  # s, of whitecaps
MOST_NUMBERS_OF_A_WAVE = 5
STEEPEST = 0.142  # height by length at which a wave in deep water breaks (Michell 1893)


def set_look(look, *, preset=None, waves=None, wind=None, whitecaps=None, color=None, opacity=None, refraction=None,
             own_view=None, foam=None, caustics=None, light_shafts=None, shadows=None, dome_port=None, matter=None,
             quality=None, units=None):
    """Apply these settings to a new vtkWaterProperty.

    Parameters
    ----------
    look : vtkwater.vtkWaterProperty
    preset : str
        One of the property's presets; the other arguments override it.
    waves : float | sequence[sequence[float]]
        Replaces the preset's waves: a wind speed, m/s in [0.1, 100], or 0 for calm water; or waves of 2 to 5
        numbers as in ``AddWave``.
    wind : float | sequence[float]
        Replaces the preset's waves with a wind sea: the wind speed, m/s in [0.1, 100], 0 for calm water; or the speed
        and the direction in which the wind blows (degrees from the plane's first axis towards the second). Not
        together with waves.
    whitecaps : float | bool
        Whether a wind sea has foam where its crests break; a number is the time in seconds, 0 to 10, after which 1/e
        of such foam is left (0: it vanishes with the crest), and True means 3.5. Whitecaps need a wind sea.
    color : sequence[float]
        Colour of deep water: red, green, blue in [0, 1].
    opacity : float
        Opacity of the surface, in [0, 1].
    refraction : bool
        Whether the scene is visible through the surface. By default the preset decides. Without a preset the default
        is True, unless color or opacity is given.
    own_view : bool
        Whether the refracted colours come from an additional view of what lies below the water, wider than the
        picture. It needs refraction and turns it on. By default the look's RefractionSource does not change.
    foam : float | bool
        A depth in metres, finite and not negative: the shore foams where the water is shallower than this. True means
        0.25, and with automatic units at least 1/400 of the scene's diagonal. Foam needs refraction and turns it on.
    caustics : float | bool
        Strength of the light that waves focus under the surface, in [0, 1]; True means 0.8. Caustics need waves, and
        refraction, which they turn on.
    light_shafts : float | bool
        Light shafts for a camera under water: the share, 0 to 1, of the light there that varies; True means 1. Needs
        waves, and refraction, which it turns on.
    shadows : bool
        Whether objects cast shadows on the water's glitter and foam.
    dome_port : float
        Radius in metres of a dome port, the glass dome around an underwater camera, finite and not negative; 0 means
        no port. A port needs refraction and turns it on.
    matter : str
        Name of an array with the concentration of matter that the water carries. It needs refraction and turns it on.
    quality : str
        Quality of reflections on waves: 'fast', 'default', 'high' or 'reference'.
    units : str | float
        Length unit of the scene: a name such as 'mm', 'm', 'km' or 'ft', metres per unit in [1e-9, 1e9], or
        'automatic', which follows the size of the scene. The default is 'automatic', or 'm' with individual waves.

    Raises
    ------
    TypeError, ValueError
        For a wrong argument, and for two that contradict each other. The look may already have changed then.
    """
    if waves is not None and wind is not None:
        raise ValueError(
            f"waves and wind are both given (wind is {wind!r}); use only one of them"
        )
    speed, blows_to = (None, None) if wind is None else wind_of(wind)
    white, life_time = (None, None) if whitecaps is None else whitecaps_of(whitecaps)
    foam_depth = None if foam is None else depth_of(foam)
    strength = None if caustics is None else share_of("caustics", caustics, CAUSTICS)
    shafts = None if light_shafts is None else share_of("light_shafts", light_shafts, 1.0)
    port = None if dome_port is None else radius_of(dome_port)
    if refraction is not None:
        refraction = flag("refraction", refraction)
    if own_view is not None:
        own_view = flag("own_view", own_view)
    if shadows is not None:
        shadows = flag("shadows", shadows)
    if quality is not None and of_type("quality", quality, str) not in QUALITIES:
        raise ValueError(f"quality is {quality!r}; it must be one of {', '.join(QUALITIES)}")
    share = None if opacity is None else number("opacity", opacity)
    with raising(look, Preset="preset", WindSpeed="wind" if waves is None else "waves", Opacity="opacity"):
        if preset is not None:
            look.SetPreset(of_type("preset", preset, str))
        if waves is not None:
            set_waves(look, waves)
        if speed is not None:
            set_sea(look, speed, blows_to)
        if white is not None:
            look.SetWhitecaps(white)
        if life_time is not None:
            look.SetWhitecapLifeTime(life_time)
        if color is not None:
            look.SetDeepColor(numbers("color", color, 3))
        if share is not None:
            look.SetOpacity(share)
    if white and not look.GetSea():
        raise ValueError(f"whitecaps is {whitecaps!r}, but there is no wind sea: add wind")
    through = {"refraction": bool(refraction), "foam": bool(foam_depth), "caustics": bool(strength),
               "light_shafts": bool(shafts), "dome_port": bool(port), "own_view": bool(own_view),
               "matter": bool(matter)}
    given = {"foam": foam, "caustics": caustics, "light_shafts": light_shafts, "dome_port": dome_port,
             "own_view": own_view, "matter": matter}
    check_through(look, preset, refraction, share, through, given)
    for name in ("caustics", "light_shafts"):
        if through[name] and not has_waves(look):
            raise ValueError(
                f"{name} is {given[name]!r}, but the water is calm: add wind, waves or a preset with waves"
            )
    if refraction is None and preset is None and color is None and share is None:
        refraction = True
    with raising(look, Units="units", MetresPerUnit="units"):
        set_units(look, units, waves is None or isinstance(waves, Real))
        if refraction is not None or any(through[word] for word in given):
            look.SetRefraction(refraction is not False)
        if own_view is not None:
            look.SetRefractionSource(look.OWN_VIEW if own_view else look.PICTURE)
        if foam_depth is not None:
            look.SetFoamDepth(foam_depth)
            look.SetFoamFitsScene(plain(foam) is True)
        if strength is not None:
            look.SetCaustics(strength)
        if shafts is not None:
            look.SetLightShafts(shafts)
        if shadows is not None:
            look.SetShadows(flag("shadows", shadows))
        if port is not None:
            look.SetDomePortRadius(port)
        if quality is not None:
            look.SetRayTraceQuality(quality)


def whitecaps_of(whitecaps):
    """Whether there are any, and their lifetime in seconds; None: the default."""
    value = plain(whitecaps)
    return (value, None) if isinstance(value, bool) else (True, in_range("whitecaps", value, 0.0, MOST_LIFE_TIME))


def flag(word, value):
    """A bool, numpy's included; otherwise a TypeError that names the argument."""
    return of_type(word, plain(value), bool)


def set_units(look, units, is_automatic):
    """Units as in set_look; is_automatic: the default is automatic."""
    if units is None:
        look.SetUnits("automatic" if is_automatic else "m")
    elif isinstance(units, str):
        look.SetUnits(units)
    else:
        metres = number("units", units)
        if not 1e-9 <= metres <= 1e9:  # the property takes 0, too
            raise ValueError(f"units is {metres:g}; metres per unit must lie in [1e-09, 1e+09]")
        look.SetMetresPerUnit(metres)


def check_through(look, preset, refraction, opacity, through, given):
    """Raise an error if a see-through effect is combined with an opaque or blended surface."""
    for word, value in given.items():
        if through[word] and refraction is False:
            raise ValueError(f"{word} is {value!r}, but refraction is False: {word} needs refraction")
    asked = next((word for word in through if through[word]), None)
    if asked is None:
        return
    value = given.get(asked, refraction)
    if opacity is not None and opacity < 1.0:
        raise ValueError(
            f"{asked} is {value!r}, but opacity is {opacity}: water with an opacity below 1 is blended, "
            "not refracted"
        )
    if preset is not None and look.GetReflectanceMode() == look.CONSTANT and look.GetReflectance() == 1.0:
        raise ValueError(f"{asked} is {value!r}, but preset is {preset!r}: a perfect mirror hides what lies below")


def has_waves(look):
    variance = [0.0, 0.0, 0.0]
    look.GetSlopeVariance(variance)
    return bool(look.GetSea() or look.GetNumberOfWaves() or look.GetNumberOfNormalMaps() or any(variance[:2]))


def of_type(name, value, kind):
    if not isinstance(value, kind):
        raise TypeError(f"{name} must be {kind.__name__}, not {type(value).__name__}")
    return value


def plain(value):
    """A number or bool of numpy as Python's."""
    return value.item() if hasattr(value, "item") and getattr(value, "size", 0) == 1 else value


def number(name, value):
    if isinstance(value, bool) or not isinstance(value, Real):
        raise TypeError(f"{name} must be a number, not {type(value).__name__}")
    try:
        return float(value)
    except OverflowError:
        raise ValueError(f"{name} is too large; it must lie in [-1e308, 1e308]") from None


def in_range(name, value, least, most):
    value = number(name, value)
    if not least <= value <= most:  # also NaN
        raise ValueError(f"{name} is {value:g}; it must lie in [{least:g}, {most:g}]")
    return value


def whole_in_range(name, value, least, most):
    if isinstance(value, bool) or not isinstance(value, Integral):
        raise TypeError(f"{name} must be int, not {type(value).__name__}")
    if not least <= value <= most:
        raise ValueError(f"{name} is {value}; it must lie in [{least}, {most}]")
    return int(value)


def counted(count, noun):
    """A count and its noun: 1 component, 2 components."""
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"


def finite(name, value):
    value = number(name, value)
    if not math.isfinite(value):
        raise ValueError(f"{name} is {value:g}; it must be finite")
    return value


def numbers(name, values, least, most=None):
    """A sequence of numbers (a list, a tuple, an array) as a list; its length in [least, most]."""
    most = most or least
    is_array = getattr(values, "ndim", 0) > 0 and hasattr(values, "__array__")
    if isinstance(values, str) or not (isinstance(values, Sequence) or is_array):
        raise TypeError(f"{name} must be a sequence of numbers, not {type(values).__name__}")
    if not least <= len(values) <= most:
        wanted = f"{least}" if least == most else f"{least} to {most}"
        raise ValueError(f"{name} is {tuple(values)!r}; it must have {wanted} numbers, not {len(values)}")
    return [number(f"{name}[{i}]", value) for i, value in enumerate(values)]


def wind_of(wind):
    """Speed and direction; the direction is None when it is not given."""
    if isinstance(wind, Real) and not isinstance(wind, bool):
        speed, blows_to = number("wind", wind), None
    elif isinstance(wind, (str, bool)) or not hasattr(wind, "__len__"):
        raise TypeError(f"wind must be a number, or a speed and a direction, not {type(wind).__name__}")
    else:
        speed, blows_to = numbers("wind", wind, 2)
        finite("wind[1]", blows_to)
    if speed != 0.0 and not LEAST_WIND <= speed <= MOST_WIND:
        raise ValueError(f"wind is {speed:g}; it must lie in [{LEAST_WIND:g}, {MOST_WIND:g}] m/s, or be 0")
    return speed, blows_to


def depth_of(foam):
    foam = plain(foam)
    if isinstance(foam, bool):
        return FOAM_DEPTH if foam else 0.0
    depth = number("foam", foam)
    if not 0.0 <= depth < math.inf:
        raise ValueError(
            f"foam is {depth:g}; it must be finite and not negative (m of depth), or True for {FOAM_DEPTH}"
        )
    return depth


def share_of(name, share, on):
    """The share of an effect, 0 to 1; on is that of True."""
    share = plain(share)
    if isinstance(share, bool):
        return on if share else 0.0
    return in_range(name, share, 0.0, 1.0)


def radius_of(dome_port):
    radius = number("dome_port", dome_port)
    if not 0.0 <= radius < math.inf:
        raise ValueError(f"dome_port is {radius:g}; it must be finite and not negative (m, the radius)")
    return radius


def set_sea(look, speed, blows_to=None):
    """Replace all waves with a wind sea; without a wind the water is calm."""
    look.RemoveAllWaves()
    look.SeaOff()
    if speed != 0.0:
        look.SetWindSpeed(speed)
        if blows_to is not None:
            look.SetWindDirection(blows_to)
        look.SeaOn()


def set_waves(look, waves):
    if isinstance(waves, Real) and not isinstance(waves, bool):
        set_sea(look, float(waves))
        return
    look.RemoveAllWaves()
    look.SeaOff()
    if isinstance(waves, str) or not hasattr(waves, "__len__"):
        raise TypeError(f"waves must be a number or a sequence of waves, not {type(waves).__name__}")
    if len(waves) and all(isinstance(part, Real) for part in waves):
        raise ValueError(f"waves is {waves!r}; a single wave must be in a list, too: waves=[{tuple(waves)!r}], with 2 "
                         f"to {MOST_NUMBERS_OF_A_WAVE} numbers each")
    for i, wave in enumerate(waves):
        amplitude, wavelength, *others = numbers(f"waves[{i}]", wave, 2, MOST_NUMBERS_OF_A_WAVE)
        with raising(look, Wave=f"waves[{i}]"):
            look.AddWave(amplitude, wavelength, *others)
        if 2.0 * amplitude > STEEPEST * wavelength:
            warnings.warn(f"waves[{i}] has the amplitude {amplitude:g} and the wavelength {wavelength:g}; water waves "
                          f"break if the amplitude exceeds {0.5 * STEEPEST * wavelength:.3g} ({0.5 * STEEPEST:g} of the "
                          f"wavelength)", stacklevel=4)
