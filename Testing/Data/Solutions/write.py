# SPDX-License-Identifier: BSD-3-Clause
"""write: makes the NetCDF files in this folder, with the package netCDF4: grid.nc, lonlat.nc, mesh.nc.

All hold a slope, its bed zb from -1 to 1 along x, and water of the levels -0.5, 0 and 0.5 at the times 0, 10 and 30.
"""
import pathlib

import netCDF4
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
TIMES, LEVELS = (0.0, 10.0, 30.0), (-0.5, 0.0, 0.5)
COLUMNS, ROWS = 21, 11


def write_grid(name, rows, columns, x, y, units):
    """A grid after the CF conventions: http://cfconventions.org, version 1.8. What is dry is missing."""
    with netCDF4.Dataset(HERE / name, "w", format="NETCDF3_CLASSIC") as file:
        file.Conventions = "CF-1.8"
        for dimension, size in (("time", None), (rows, ROWS), (columns, COLUMNS)):
            file.createDimension(dimension, size)
        time = file.createVariable("time", "f8", ("time",))
        time.units = "seconds since 2020-01-01"
        time[:] = TIMES
        for dimension, places, unit, axis in ((rows, y, units[0], "Y"), (columns, x, units[1], "X")):
            place = file.createVariable(dimension, "f8", (dimension,))
            place.units, place.axis = unit, axis
            place[:] = places
        bed = np.tile(np.linspace(-1.0, 1.0, COLUMNS), (ROWS, 1))
        file.createVariable("zb", "f4", (rows, columns))[:] = bed
        depth = file.createVariable("h", "f4", ("time", rows, columns), fill_value=-999.0)
        for i, level in enumerate(LEVELS):
            depth[i] = np.ma.masked_less(level - bed, 0.0)


def write_mesh(name):
    """The same as triangles, after the UGRID conventions: https://ugrid-conventions.github.io, version 1.0."""
    with netCDF4.Dataset(HERE / name, "w", format="NETCDF3_CLASSIC") as file:
        file.Conventions = "CF-1.8 UGRID-1.0"
        i, j = np.meshgrid(np.arange(COLUMNS), np.arange(ROWS))
        first = (i + COLUMNS * j)[:-1, :-1].ravel()
        triangles = np.concatenate([np.stack([first, first + 1, first + COLUMNS], axis=1),
                                    np.stack([first + 1, first + COLUMNS + 1, first + COLUMNS], axis=1)])
        for dimension, size in (("time", None), ("node", i.size), ("face", len(triangles)), ("three", 3)):
            file.createDimension(dimension, size)
        mesh = file.createVariable("mesh", "i4")
        mesh.cf_role, mesh.topology_dimension = "mesh_topology", np.int32(2)
        mesh.node_coordinates, mesh.face_node_connectivity = "node_x node_y", "face_nodes"
        for axis, places in (("x", 10.0 * i), ("y", 10.0 * j)):
            place = file.createVariable(f"node_{axis}", "f8", ("node",))
            place.units, place.standard_name = "m", f"projection_{axis}_coordinate"
            place[:] = places.ravel()
        faces = file.createVariable("face_nodes", "i4", ("face", "three"))
        faces.cf_role, faces.start_index = "face_node_connectivity", np.int32(0)
        faces[:] = triangles
        time = file.createVariable("time", "f8", ("time",))
        time.units = "seconds since 2020-01-01"
        time[:] = TIMES
        bed = (-1.0 + 0.1 * i).ravel()
        for variable, location, dimensions, values in (
                ("zb", "node", ("node",), bed),
                ("h", "node", ("time", "node"), np.maximum(np.array(LEVELS)[:, None] - bed, 0.0)),
                ("speed", "face", ("time", "face"), np.array(TIMES)[:, None] + np.zeros(len(triangles)))):
            data = file.createVariable(variable, "f4", dimensions)
            data.mesh, data.location = "mesh", location
            data[:] = values


if __name__ == "__main__":
    write_grid("grid.nc", "y", "x", np.linspace(0.0, 200.0, COLUMNS), np.linspace(0.0, 100.0, ROWS), ("m", "m"))
    write_grid("lonlat.nc", "lat", "lon", np.linspace(-3.0, -2.8, COLUMNS), np.linspace(59.95, 60.05, ROWS),
               ("degrees_north", "degrees_east"))
    write_mesh("mesh.nc")
