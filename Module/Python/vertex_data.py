# SPDX-License-Identifier: BSD-3-Clause
"""Arrays of a surface that change the look of the water itself: a current, matter in the water, foam.

    data = VertexData(matter="sediment", matter_absorption=(0.1, 0.3, 0.9), foam_by="froude", foam_measure="froude")
    data.check(surface)
    data.give(water)
"""
from .words import counted, has_waves, numbers, of_type

__all__ = ["FOAM_MEASURES", "VertexData"]

FOAM_MEASURES = ("cover", "froude", "breaking")  # in the order of vtkWaterActor's FoamMeasures
COMPONENTS = {"flow": (2, 3), "matter": (1,), "foam_by": (1,)}
MOST_COEFFICIENT = 1e9  # as WATER_COEFFICIENT_MAX
WHAT = {"matter_absorption": "matter", "matter_scattering": "matter", "foam_measure": "foam_by"}  # needs what


class VertexData:
    """The names of these arrays, and what their values mean.

    Parameters
    ----------
    flow : str, optional
        Velocity of a current, m/s, 2 or 3 components, that carries the small waves.
    matter : str, optional
        Concentration of matter that the water carries.
    matter_absorption, matter_scattering : sequence[float], optional
        What it absorbs and scatters, 1/m per unit of concentration at 650, 550 and 450 nm. Default: sediment, in g/m^3.
    foam_by : str, optional
        How much foam there is.
    foam_measure : str, optional
        What the values of foam_by are: 'cover' (the default), 'froude' or 'breaking'.

    Raises
    ------
    TypeError, ValueError
    """

    def __init__(self, *, flow=None, matter=None, matter_absorption=None, matter_scattering=None, foam_by=None,
                 foam_measure=None):
        self.names = {"flow": flow, "matter": matter, "foam_by": foam_by}
        for word, name in self.names.items():
            if name is not None:
                of_type(word, name, str)
        given = {"matter_absorption": matter_absorption, "matter_scattering": matter_scattering,
                 "foam_measure": foam_measure}
        for word, value in given.items():
            if value is not None and self.names[WHAT[word]] is None:
                raise ValueError(f"{word} is {value!r}, but {WHAT[word]} is not given: {word} says what the values of "
                                 "its array mean")
        if foam_measure is not None and of_type("foam_measure", foam_measure, str) not in FOAM_MEASURES:
            raise ValueError(f"foam_measure is {foam_measure!r}; it must be one of {', '.join(FOAM_MEASURES)}")
        self.foam_measure = foam_measure
        self.absorption = coefficients("matter_absorption", matter_absorption)
        self.scattering = coefficients("matter_scattering", matter_scattering)

    def given(self):
        """Words and names of the arrays that are given."""
        return {word: name for word, name in self.names.items() if name is not None}

    def check(self, surface):
        """Raise a ValueError unless a surface (None: there is none) has these arrays with the right components."""
        for word, name in self.given().items():
            if surface is None:
                raise ValueError(f"{word} is {name!r}; it needs a surface with this array")
            arrays = [*surface.point_data, *surface.cell_data]
            if name not in arrays:
                known = ", ".join(arrays) or "(there is none)"
                raise ValueError(f"{word} is {name!r}; it must be one of the arrays {known}")
            values = surface.point_data[name] if name in surface.point_data else surface.cell_data[name]
            wrong = wrong_components(word, 1 if values.ndim == 1 else values.shape[1])
            if wrong:
                raise ValueError(f"{word} is {name!r}, which has {wrong}")
            if values.dtype.kind not in "buif":
                raise ValueError(f"{word} is {name!r}, an array of {values.dtype}; it must hold real numbers")

    def check_look(self, look):
        """Raise a ValueError if the water has nothing that an array could change."""
        flow = self.names["flow"]
        if flow is not None and not has_waves(look):
            raise ValueError(f"flow is {flow!r}, but the water is calm: add wind, waves or a preset with waves")

    def check_colors(self, color_by, data_opacity):
        """Raise a ValueError if opaque colours of the surface hide what the water carries."""
        matter = self.names["matter"]
        if matter is not None and color_by is not None and data_opacity in (None, 1):
            raise ValueError(f"matter is {matter!r}, but color_by is {color_by!r}: the colours hide the matter; set "
                             "data_opacity below 1, or leave one of them out")

    def give(self, water):
        """Name the arrays to a vtkWaterActor."""
        if self.names["flow"] is not None:
            water.SetFlowArrayName(self.names["flow"])
        if self.names["matter"] is not None:
            water.SetMatterArrayName(self.names["matter"])
            if self.absorption is not None:
                water.SetMatterAbsorption(self.absorption)
            if self.scattering is not None:
                water.SetMatterScattering(self.scattering)
        if self.names["foam_by"] is not None:
            water.SetFoamArrayName(self.names["foam_by"])
            water.SetFoamMeasure(FOAM_MEASURES.index(self.foam_measure or FOAM_MEASURES[0]))


def wrong_components(word, components):
    """What is wrong with an array's number of components; an empty string if nothing is."""
    wanted = COMPONENTS[word]
    if components in wanted:
        return ""
    return f"{counted(components, 'component')}; it must have {' or '.join(map(str, wanted))}"


def coefficients(word, values):
    """Three numbers in [0, 1e9]; None: not given."""
    if values is None:
        return None
    values = numbers(word, values, 3)
    if not all(0.0 <= value <= MOST_COEFFICIENT for value in values):
        raise ValueError(f"{word} is {tuple(values)}; all must be finite, not negative and at most 1e9 (1/m per unit)")
    return values
