# SPDX-License-Identifier: BSD-3-Clause
"""tracer: Embree on the triangles that VTK draws.

Embree works in single precision. It only decides which triangle a ray meets; the distance is then
computed again in double precision, from that triangle's plane.
"""

import numpy as np
from embreex.mesh_construction import TriangleMesh
from embreex.rtcore_scene import EmbreeScene
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

FLOAT_TOLERANCE = 1e-4  # relative; a hit that is farther from its triangle's plane is not believed


class Tracer:
    """The unlit actors of a renderer, without its water: of one colour, or of the points' RGB bytes.

    origin: what rays count their places from; single precision wants one among the things.
    """

    def __init__(self, renderer, origin=(0.0, 0.0, 0.0)):
        self._scene = EmbreeScene(robust=True)
        self._corners, self._first, colors = [], [], []
        self._corner_colors = {}  # by actor, of those that have colours at their points
        count = 0
        for actor in renderer.GetActors():
            if actor.IsA("vtkWaterActor"):
                continue
            assert actor.GetIsIdentity(), "the mesh would not be where the actor is"
            triangles = vtkTriangleFilter()
            triangles.SetInputData(actor.GetMapper().GetInput())
            triangles.PassVertsOff()
            triangles.PassLinesOff()
            triangles.Update()
            data = triangles.GetOutput()
            points = vtk_to_numpy(data.GetPoints().GetData()).astype(float) - origin
            ids = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
            corners = points[ids]
            TriangleMesh(self._scene, np.ascontiguousarray(corners, dtype=np.float32))
            if actor.GetMapper().GetScalarVisibility() and data.GetPointData().GetScalars():
                rgb = vtk_to_numpy(data.GetPointData().GetScalars())
                self._corner_colors[len(self._first)] = (rgb, ids)
            self._first.append(count)
            count += len(corners)
            self._corners.append(corners)
            colors.append(actor.GetProperty().GetColor())
        self._corners = np.concatenate(self._corners)
        self._first = np.array(self._first)
        self._colors = np.array([*colors, renderer.GetBackground()])
        self.top = float(self._corners[..., 2].max())
        self.triangle_count = len(self._corners)
        self.hit_count = 0
        self.doubtful_count = 0  # hits that are not where their triangle's plane is

    def cast(self, start, ray):
        """Colours (n x 3) that rays of unit length see, and the distances to them (inf: background)."""
        found = self._scene.run(
            np.ascontiguousarray(start, dtype=np.float32), np.ascontiguousarray(ray, dtype=np.float32),
            query="INTERSECT", output=True)
        thing = found["geomID"].astype(int)
        is_hit = thing >= 0
        corners = self._corners[self._first[thing[is_hit]] + found["primID"][is_hit]]
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        along = (ray[is_hit] * normal).sum(axis=1)
        coarse = found["tfar"][is_hit].astype(float)
        with np.errstate(divide="ignore", invalid="ignore"):
            fine = ((corners[:, 0] - start[is_hit]) * normal).sum(axis=1) / along
        gap = np.abs(fine - coarse) / np.maximum(coarse, 1.0)
        is_fine = gap <= FLOAT_TOLERANCE  # not so where a ray runs along its triangle
        self.hit_count += int(is_hit.sum())
        self.doubtful_count += int((~is_fine).sum())
        distance = np.full(len(ray), np.inf)
        distance[is_hit] = np.where(is_fine, fine, coarse)
        return self._seen(thing, found), distance

    def _seen(self, thing, found):
        colors = self._colors[thing]
        for number, (rgb, ids) in self._corner_colors.items():
            chosen = np.flatnonzero(thing == number)
            second, third = (found[name][chosen].astype(float)[:, None] for name in "uv")
            first, *others = (rgb[ids[found["primID"][chosen], i]] for i in range(3))
            colors[chosen] = ((1 - second - third) * first + second * others[0] + third * others[1]) / 255
        return colors
