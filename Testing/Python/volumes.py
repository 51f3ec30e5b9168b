# SPDX-License-Identifier: BSD-3-Clause
"""volumes: what tests of ray-cast volumes share."""

import numpy as np
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401  factories
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction, vtkSphere
from vtkmodules.vtkImagingCore import vtkImageShiftScale
from vtkmodules.vtkImagingHybrid import vtkSampleFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolume
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper


def ball(center, radius, samples, shift, scale):
    """A cube of bytes about a ball, with as many samples along each side.

    They are scale * (distance^2 - radius^2 + shift), distance from the center, as far as bytes go.
    """
    sphere = vtkSphere()
    sphere.SetRadius(radius)
    sphere.SetCenter(center)
    sample = vtkSampleFunction()
    sample.SetImplicitFunction(sphere)
    reach = radius + 0.2
    sample.SetModelBounds([middle + side * reach for middle in center for side in (-1, 1)])
    sample.SetSampleDimensions(samples, samples, samples)
    to_bytes = vtkImageShiftScale()
    to_bytes.SetInputConnection(sample.GetOutputPort())
    to_bytes.SetShift(shift)
    to_bytes.SetScale(scale)
    to_bytes.SetOutputScalarTypeToUnsignedChar()
    to_bytes.ClampOverflowOn()
    to_bytes.Update()
    return to_bytes.GetOutput()


def block(low, high, samples=8):
    """A box of bytes that are all 100."""
    image = vtkImageData()
    image.SetDimensions(samples, samples, samples)
    image.SetOrigin(low)
    image.SetSpacing((np.asarray(high) - low) / (samples - 1))
    image.GetPointData().SetScalars(numpy_to_vtk(np.full(samples**3, 100, np.uint8), deep=True))
    return image


def ray_cast(data, sample_distance, colors, opacities, mapper_class=vtkGPUVolumeRayCastMapper):
    """A volume whose samples lie evenly: colors are (value, r, g, b), opacities (value, opacity)."""
    mapper = mapper_class()
    mapper.SetInputData(data)
    if mapper_class is vtkGPUVolumeRayCastMapper:
        mapper.UseJitteringOff()
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetSampleDistance(sample_distance)
    color = vtkColorTransferFunction()
    for point in colors:
        color.AddRGBPoint(*point)
    opacity = vtkPiecewiseFunction()
    for point in opacities:
        opacity.AddPoint(*point)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.GetProperty().SetColor(color)
    volume.GetProperty().SetScalarOpacity(opacity)
    return volume
