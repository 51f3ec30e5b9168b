# SPDX-License-Identifier: BSD-3-Clause
"""compare_pictures: tells whether a picture shows what a kept one shows.

usage: compare_pictures.py PICTURE KEPT

Both are PNG or JPEG files. They are averaged over square blocks, so that the noise of a JPEG file, and text and edges
that another version of VTK smooths otherwise, do not count. Two figures have limits: the mean difference of all blocks,
and that of the blocks that differ most. Needs VTK and numpy.
"""
import pathlib
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkJPEGReader, vtkPNGReader

BLOCK_PX = 16
MEAN_LIMIT = 0.8  # of 255
WORST_SHARE = 0.01  # of the blocks
WORST_LIMIT = 10.0  # of 255


def read(name):
    """The picture as floats, rows x columns x 3, in [0, 255]."""
    if not pathlib.Path(name).is_file():
        raise ValueError(f"{name}: no such file")
    reader = vtkPNGReader() if pathlib.Path(name).suffix == ".png" else vtkJPEGReader()
    reader.SetFileName(str(name))
    reader.Update()
    image = reader.GetOutput()
    if image.GetPointData().GetScalars() is None:
        raise ValueError(f"{name}: not a picture")
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3].astype(float)


def blocks(picture):
    """Means over the blocks; what is left over at the right and at the top counts as blocks, too."""
    rows = np.arange(0, picture.shape[0], BLOCK_PX)
    columns = np.arange(0, picture.shape[1], BLOCK_PX)
    sums = np.add.reduceat(np.add.reduceat(picture, rows, axis=0), columns, axis=1)
    heights = np.diff(np.append(rows, picture.shape[0]))
    widths = np.diff(np.append(columns, picture.shape[1]))
    return sums / (heights[:, None] * widths)[:, :, None]


def difference(picture, kept):
    """Mean difference of all blocks, and of the hundredth that differs most, of 255; two infinities: other sizes."""
    if picture.shape[:2] != kept.shape[:2]:
        return np.inf, np.inf
    apart = np.sort(np.abs(blocks(picture) - blocks(kept)).mean(axis=2), axis=None)
    worst = apart[-max(1, int(WORST_SHARE * apart.size)):]
    return float(apart.mean()), float(worst.mean())


def check(picture, kept):
    """Print the figures, and return whether they are within their limits."""
    mean, worst = difference(read(picture), read(kept))
    is_same = mean <= MEAN_LIMIT and worst <= WORST_LIMIT
    print(f"{picture} and {kept}: {'same' if is_same else 'DIFFERENT'}: mean difference {mean:.2f} "
          f"(at most {MEAN_LIMIT:g}), of the worst blocks {worst:.2f} (at most {WORST_LIMIT:g}) of 255")
    return is_same


def main(arguments):
    if len(arguments) != 2:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    try:
        return 0 if check(*arguments) else 1
    except ValueError as error:
        print(f"compare_pictures: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
