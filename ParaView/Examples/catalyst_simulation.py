# SPDX-License-Identifier: BSD-3-Clause
"""A small simulation that hands its steps over to Catalyst: a basin that fills at a constant rate.

    script/paraview --run /usr/bin/python3 ParaView/Examples/catalyst_simulation.py [STEPS]
    script/paraview --run mpirun -np 2 /usr/bin/python3 ParaView/Examples/catalyst_simulation.py [STEPS]

It writes water_0000.png, water_0002.png and so on. On several ranks (with mpi4py) each has some rows of the basin.
"""
import os
import sys

import numpy
from paraview.catalyst import bridge
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

try:
    from mpi4py import MPI  # starts MPI, too

    RANK, RANKS = MPI.COMM_WORLD.Get_rank(), MPI.COMM_WORLD.Get_size()
except ImportError:
    RANK, RANKS = 0, 1

COUNT = 65  # points along an axis
RATE = 0.05  # height per step


def mesh():
    """This rank's part of the grid, and the bed's heights at its points; neighbours share a row of points."""
    first, last = ((COUNT - 1) * rank // RANKS for rank in (RANK, RANK + 1))
    image = vtkImageData()
    image.SetExtent(0, COUNT - 1, first, last, 0, 0)
    image.SetOrigin(-3.0, -3.0, 0.0)
    image.SetSpacing(6.0 / (COUNT - 1), 6.0 / (COUNT - 1), 1.0)
    along = numpy.linspace(-3.0, 3.0, COUNT)
    x, y = numpy.meshgrid(along, along[first:last + 1])
    return image, (0.12 * (x * x + y * y) - 0.8 + 1.5 * numpy.exp(-4.0 * ((x + 1.0) ** 2 + y * y))).ravel()


def set_array(image, name, values):
    array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
    array.SetName(name)
    image.GetPointData().AddArray(array)


def main():
    steps = int(sys.argv[1]) if len(sys.argv) > 1 else 10
    bridge.initialize()
    bridge.add_pipeline(os.path.join(os.path.dirname(os.path.abspath(__file__)), "catalyst_water.py"), 2)
    image, bed = mesh()
    extent = (0, COUNT - 1, 0, COUNT - 1, 0, 0)
    set_array(image, "bed", bed)
    for step in range(steps):
        set_array(image, "depth", numpy.maximum(-0.4 + RATE * step - bed, 0.0))
        bridge.coprocess(0.5 * step, step, image, name="input", wholeExtent=extent)
    bridge.finalize()
    print("the end")


if __name__ == "__main__":
    main()
