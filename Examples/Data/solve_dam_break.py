# SPDX-License-Identifier: BSD-3-Clause
"""solve_dam_break: makes dam_break.npz, a column of water that falls on a box in a tank, by OpenFOAM's interFoam.

usage: solve_dam_break.py [FOLDER]    where the case is kept; default: a temporary one

The tank is that of the experiment of Kleefsman et al. 2005, "A Volume-of-Fluid based simulation method for wave impact
problems", J. Comput. Phys. 206. It takes some minutes, Debian's package openfoam, and a Python with VTK.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader

TARGET = pathlib.Path(__file__).resolve().parent / "dam_break.npz"
# m, and the cells between; the box stands in the middle of x and y, on the bottom
BREAKS = (0.0, 2.3955, 2.5565, 3.22), (0.0, 0.2985, 0.7015, 1.0), (0.0, 0.161, 1.0)
CELLS = (60, 4, 16), (7, 10, 7), (4, 20)
COLUMN = 1.228, 1.0, 0.55  # m of water, from the corner on
END, EVERY = 2.4, 0.04  # s

HEADER = "FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n"
WALLS = "{{ walls {{ {walls} }} atmosphere {{ {top} }} }}"
FILES = {
    "constant/g": ("uniformDimensionedVectorField", "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);"),
    "constant/turbulenceProperties": ("dictionary", "simulationType laminar;"),
    "constant/transportProperties": ("dictionary", """
phases (water air);
water { transportModel Newtonian; nu 1e-06; rho 1000; }
air { transportModel Newtonian; nu 1.48e-05; rho 1; }
sigma 0.07;"""),
    "system/controlDict": ("dictionary", f"""
application interFoam; startFrom startTime; startTime 0; stopAt endTime; endTime {END}; deltaT 0.001;
writeControl adjustableRunTime; writeInterval {EVERY}; writeFormat ascii; writePrecision 6; timePrecision 6;
adjustTimeStep yes; maxCo 0.8; maxAlphaCo 0.8; maxDeltaT 0.01;"""),
    "system/fvSchemes": ("dictionary", """
ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes
{
    div(rhoPhi,U) Gauss linearUpwind grad(U);
    div(phi,alpha) Gauss vanLeer;
    div(phirb,alpha) Gauss linear;
    div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear;
}
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }"""),
    "system/fvSolution": ("dictionary", """
solvers
{
    "alpha.water.*" { nAlphaCorr 1; nAlphaSubCycles 2; cAlpha 1; MULESCorr yes; nLimiterIter 3;
        solver smoothSolver; smoother symGaussSeidel; tolerance 1e-8; relTol 0; }
    "pcorr.*" { solver PCG; preconditioner DIC; tolerance 1e-5; relTol 0; }
    p_rgh { solver GAMG; smoother DIC; tolerance 1e-06; relTol 0.05; }
    p_rghFinal { $p_rgh; tolerance 1e-06; relTol 0; }
    "U.*" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-06; relTol 0; }
}
PIMPLE { momentumPredictor no; nOuterCorrectors 1; nCorrectors 2; nNonOrthogonalCorrectors 0; }"""),
    "system/setFieldsDict": ("dictionary", f"""
defaultFieldValues (volScalarFieldValue alpha.water 0);
regions (boxToCell {{ box (-1 -1 -1) ({COLUMN[0]} 2 {COLUMN[2]}); fieldValues (volScalarFieldValue alpha.water 1); }});"""),
    "0/alpha.water": ("volScalarField", "dimensions [0 0 0 0 0 0 0]; internalField uniform 0; boundaryField "
                      + WALLS.format(walls="type zeroGradient;",
                                     top="type inletOutlet; inletValue uniform 0; value uniform 0;")),
    "0/U": ("volVectorField", "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField "
            + WALLS.format(walls="type noSlip;", top="type pressureInletOutletVelocity; value uniform (0 0 0);")),
    "0/p_rgh": ("volScalarField", "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0; boundaryField "
                + WALLS.format(walls="type fixedFluxPressure; value uniform 0;", top="type totalPressure; p0 uniform 0;")),
}


def block_mesh():
    """The tank as blocks, but for the one of the box."""
    nx, ny = len(BREAKS[0]), len(BREAKS[1])

    def corner(i, j, k):
        return i + nx * (j + ny * k)

    vertices = "".join(f"({x} {y} {z})" for z in BREAKS[2] for y in BREAKS[1] for x in BREAKS[0])
    blocks, top = "", ""
    for k, depth in enumerate(CELLS[2]):
        for j, wide in enumerate(CELLS[1]):
            for i, long in enumerate(CELLS[0]):
                if (i, j, k) == (1, 1, 0):
                    continue
                ring = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                ends = " ".join(str(corner(*at, k + up)) for up in (0, 1) for at in ring)
                blocks += f"hex ({ends}) ({long} {wide} {depth}) simpleGrading (1 1 1)\n"
                if k == len(CELLS[2]) - 1:
                    top += "(" + " ".join(str(corner(*at, k + 1)) for at in ring) + ")"
    return (f"convertToMeters 1; vertices ({vertices}); blocks ({blocks}); edges ();\n"
            f"defaultPatch {{ name walls; type wall; }}\nboundary (atmosphere {{ type patch; faces ({top}); }});")


def coordinates(axis):
    """Of the cells' borders along an axis."""
    parts = [np.linspace(low, high, count + 1)[:-1]
             for low, high, count in zip(BREAKS[axis], BREAKS[axis][1:], CELLS[axis])]
    return np.concatenate([*parts, [BREAKS[axis][-1]]])


def solve(case):
    files = {**FILES, "system/blockMeshDict": ("dictionary", block_mesh())}
    for name, (kind, text) in files.items():
        path = case / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(HEADER.format(kind=kind, name=path.name) + text + "\n")
    (case / "case.foam").touch()
    places = {"WM_PROJECT_DIR": "/usr/share/openfoam", **os.environ}  # where Debian has its settings
    for program in ("blockMesh", "setFields", "interFoam"):
        with open(case / f"{program}.log", "w") as log:
            subprocess.run([program], cwd=case, check=True, env=places, stdout=log, stderr=subprocess.STDOUT)


def fractions(case):
    """Volume fractions of water in [0, 255]: steps x layers x rows x columns; in the box 0. And their times, s."""
    reader = vtkOpenFOAMReader()
    reader.SetFileName(str(case / "case.foam"))
    reader.CreateCellToPointOff()
    reader.SkipZeroTimeOff()
    reader.UpdateInformation()
    times = vtk_to_numpy(reader.GetTimeValues()).copy()
    shape = [sum(count) for count in reversed(CELLS)]
    found = []
    for time in times:
        reader.UpdateTimeStep(float(time))
        mesh = reader.GetOutput().GetBlock(0)
        corners = vtk_to_numpy(mesh.GetCells().GetConnectivityArray()).reshape(-1, 8)
        middles = vtk_to_numpy(mesh.GetPoints().GetData())[corners].mean(axis=1)
        at = [np.searchsorted(coordinates(axis), middles[:, axis]) - 1 for axis in (2, 1, 0)]
        step = np.zeros(shape, dtype=np.uint8)
        alpha = vtk_to_numpy(mesh.GetCellData().GetArray("alpha.water"))
        step[tuple(at)] = np.round(255.0 * np.clip(alpha, 0.0, 1.0))
        found.append(step)
    return np.array(found), times


def main():
    with tempfile.TemporaryDirectory() as folder:
        case = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else folder)
        solve(case)
        alpha, times = fractions(case)
    x, y, z = (coordinates(axis).astype(np.float32) for axis in range(3))
    np.savez_compressed(TARGET, alpha=alpha, times=times, x=x, y=y, z=z)
    print(f"{TARGET.name}: {len(times)} steps up to {times[-1]:g} s, {TARGET.stat().st_size} bytes")


if __name__ == "__main__":
    main()
