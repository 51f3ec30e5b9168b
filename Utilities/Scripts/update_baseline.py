#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""update_baseline: shows what a new picture changes, and makes it the baseline if told to.

    update_baseline.py TEST PICTURE            compare; writes TEST-compare.png beside PICTURE:
                                               old | new | difference (four times as strong)
    update_baseline.py TEST PICTURE --accept   the same, then copies PICTURE to the baselines

PICTURE is what the failed test wrote: <build>/Testing/Temporary/TEST.png. Needs VTK's Python:
/usr/bin/python3, or that of build/sdk/venv. Look at the comparison before you accept, and let the
commit message say why the picture changed.
"""
import argparse
import shutil
import sys
from pathlib import Path

from vtkmodules.vtkFiltersCore import vtkImageAppend
from vtkmodules.vtkImagingCore import (
    vtkImageDifference,
    vtkImageExtractComponents,
    vtkImageShiftScale,
)
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

BASELINES = Path(__file__).resolve().parents[2] / "Testing" / "Data" / "Baseline"
DIFFERENCE_GAIN = 4  # a difference of 64 in 255 shows as white


def read(path):
    """The RGB picture in a PNG file."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    colors = vtkImageExtractComponents()
    colors.SetInputConnection(reader.GetOutputPort())
    colors.SetComponents(0, 1, 2)
    colors.Update()
    return colors.GetOutput()


def compare(old, new, path):
    """Writes old, new and difference side by side; returns VTK's error of the test."""
    difference = vtkImageDifference()  # as vtkRegressionTestImage uses it
    difference.SetInputData(new)
    difference.SetImageData(old)
    difference.Update()
    stronger = vtkImageShiftScale()
    stronger.SetInputConnection(difference.GetOutputPort())
    stronger.SetScale(DIFFERENCE_GAIN)
    stronger.SetOutputScalarTypeToUnsignedChar()
    stronger.ClampOverflowOn()
    stronger.Update()

    strip = vtkImageAppend()
    for picture in (old, new, stronger.GetOutput()):
        strip.AddInputData(picture)
    writer = vtkPNGWriter()
    writer.SetInputConnection(strip.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()
    return difference.GetThresholdedError()


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("test", metavar="TEST")
    parser.add_argument("picture", metavar="PICTURE", type=Path)
    parser.add_argument("--accept", action="store_true")
    arguments = parser.parse_args()
    baseline = BASELINES / (arguments.test + ".png")
    if not arguments.picture.is_file():
        sys.exit("no picture %s: run the test first" % arguments.picture)

    if baseline.is_file():
        old, new = read(baseline), read(arguments.picture)
        if old.GetDimensions() != new.GetDimensions():
            print("size: old %d x %d, new %d x %d" % (
                old.GetDimensions()[:2] + new.GetDimensions()[:2]))
        else:
            path = arguments.picture.with_name(arguments.test + "-compare.png")
            error = compare(old, new, path)
            print("error %.3f (a test allows 0.15 unless it says otherwise)" % error)
            print("old | new | difference:", path)
    else:
        print("no baseline yet; the new picture:", arguments.picture)

    if arguments.accept:
        BASELINES.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(arguments.picture, baseline)
        print("accepted as", baseline)


if __name__ == "__main__":
    main()
