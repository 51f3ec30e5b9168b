#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""convert_jacksboro: makes jacksboro.vti out of matplotlib's jacksboro_fault_dem.npz.

    python convert_jacksboro.py .../matplotlib/mpl-data/sample_data/jacksboro_fault_dem.npz jacksboro.vti

Needs numpy and VTK. README.md says what the numbers are.
"""

import argparse
import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

# WGS 84: equatorial radius in metres and square of the first eccentricity.
RADIUS = 6378137.0
ECCENTRICITY_SQUARED = 0.00669437999014


def metres_per_degree(latitude_deg):
    """Lengths in metres of one degree of longitude and of one degree of latitude.

    Source: Snyder 1987, "Map Projections: A Working Manual", USGS PP 1395.
    """
    latitude = math.radians(latitude_deg)
    w = 1.0 - ECCENTRICITY_SQUARED * math.sin(latitude) ** 2
    east = RADIUS / math.sqrt(w) * math.cos(latitude)
    north = RADIUS * (1.0 - ECCENTRICITY_SQUARED) / w**1.5
    return math.radians(east), math.radians(north)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("npz", help="jacksboro_fault_dem.npz")
    parser.add_argument("vti", help="file to write")
    arguments = parser.parse_args()

    with np.load(arguments.npz) as dem:
        # Row 0 is the northernmost one: ymin is the latitude of the upper edge, ymax of the lower.
        elevation = dem["elevation"][::-1]
        latitude_deg = 0.5 * (float(dem["ymin"]) + float(dem["ymax"]))
        steps_deg = float(dem["dx"]), float(dem["dy"])

    east, north = metres_per_degree(latitude_deg)
    spacing = round(steps_deg[0] * east, 3), round(steps_deg[1] * north, 3)

    image = vtkImageData()
    image.SetDimensions(elevation.shape[1], elevation.shape[0], 1)
    image.SetSpacing(spacing[0], spacing[1], 1.0)
    scalars = numpy_to_vtk(np.ascontiguousarray(elevation).ravel(), deep=True)
    scalars.SetName("elevation")
    image.GetPointData().SetScalars(scalars)

    writer = vtkXMLImageDataWriter()
    writer.SetFileName(arguments.vti)
    writer.SetInputData(image)
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOn()  # base64: the file stays text, and git leaves it alone
    writer.SetCompressorTypeToZLib()
    writer.SetCompressionLevel(9)
    writer.SetHeaderTypeToUInt32()
    writer.SetByteOrderToLittleEndian()
    if not writer.Write():
        raise SystemExit(f"{arguments.vti}: cannot write")
    print(f"{arguments.vti}: {elevation.shape[1]} x {elevation.shape[0]} points, "
          f"{spacing[0]} x {spacing[1]} m, {elevation.min()} to {elevation.max()} m "
          f"(latitude {latitude_deg:.4f})")


if __name__ == "__main__":
    main()
