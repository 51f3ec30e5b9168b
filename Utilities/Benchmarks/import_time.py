# SPDX-License-Identifier: BSD-3-Clause
"""import_time: what `import vtkwater` costs beyond the imports of VTK that it stands on.

usage: import_time.py [RUNS]    each is a new process of this Python; default 20

Prints medians in ms. Exit status 1: vtkwater took 50 ms or more.
"""
import statistics
import subprocess
import sys

LIMIT_MS = 50.0
# What a script imports before it can render anything with VTK.
VTK = "import vtkmodules.vtkRenderingOpenGL2, vtkmodules.vtkRenderingCore"
CODE = """
import time
{before}
start = time.perf_counter()
{measured}
print(1000 * (time.perf_counter() - start))
"""


def median_ms(measured, before, runs):
    code = CODE.format(before=before, measured=measured)
    return statistics.median(float(subprocess.check_output([sys.executable, "-c", code])) for _ in range(runs))


def main():
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    median_ms("import vtkwater", VTK, 1)  # the files into memory
    vtk = median_ms(VTK, "", runs)
    water = median_ms("import vtkwater", VTK, runs)
    print(f"VTK's rendering classes: {vtk:.1f} ms\nvtkwater beyond them: {water:.1f} ms (limit {LIMIT_MS:.0f})")
    return 0 if water < LIMIT_MS else 1


if __name__ == "__main__":
    sys.exit(main())
