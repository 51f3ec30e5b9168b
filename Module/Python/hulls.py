# SPDX-License-Identifier: BSD-3-Clause
"""Hulls for add_water: bodies that float in the water and have no water inside."""
from collections.abc import Sequence

import pyvista as pv
from vtkmodules.vtkRenderingCore import vtkActor

__all__ = ["hulls_of"]


def hulls_of(hulls, scale):
    """Return the actors of hulls; a mesh gets an actor of its own, with the plotter's scale.

    Raises
    ------
    TypeError
        If hulls is not a sequence, an item is neither an actor nor a data set, or an actor shows several blocks.

    ValueError
        If a data set has no cells.
    """
    if hulls is None:
        return []
    if isinstance(hulls, (pv.DataObject, vtkActor, str)) or not isinstance(hulls, Sequence):
        raise TypeError(f"hulls must be a sequence of meshes and actors, not {type(hulls).__name__}")
    return [hull_of(f"hulls[{i}]", hull, scale) for i, hull in enumerate(hulls)]


def hull_of(name, hull, scale):
    if isinstance(hull, vtkActor):
        mapper = hull.GetMapper()
        has_data = mapper is not None and mapper.GetNumberOfInputConnections(0) > 0
        data = mapper.GetInputDataObject(0, 0) if has_data else None
        if data is not None and data.IsA("vtkCompositeDataSet"):
            raise TypeError(f"{name} is an actor of a {type(data).__name__}; it must show a single mesh. "
                            "Combine its blocks, or pass each block as a hull of its own")
        return hull
    if not isinstance(hull, pv.DataSet):
        raise TypeError(f"{name} must be a pyvista.DataSet or an actor, not {type(hull).__name__}")
    if hull.n_cells == 0:
        raise ValueError(f"{name} has no cells; it must be a mesh with polygons or cells")
    actor = vtkActor()
    actor.SetMapper(pv.DataSetMapper(hull))
    actor.SetScale(scale)
    return actor
