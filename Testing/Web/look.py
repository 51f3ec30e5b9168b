# SPDX-License-Identifier: BSD-3-Clause
"""look: a trame page and a Jupyter notebook with water in a real browser, as pictures to look at.

usage: look.py FOLDER    writes trame.png, trame_higher.png and notebook.png

Checks that red of the cone is to be seen in each, and that the page's slider moves the water.
"""
import io
import pathlib
import socket
import subprocess
import sys
import time
import urllib.request

import nbformat
import numpy as np
from browser import Browser
from nbclient import NotebookClient
from nbconvert import HTMLExporter
from PIL import Image

HERE = pathlib.Path(__file__).parent
LOAD_S, START_S = 6.0, 60.0
CELL = """
import pyvista as pv
import vtkwater.pyvista

plotter = pv.Plotter(notebook=True)
plotter.set_background("white", top="lightskyblue")
plotter.add_mesh(pv.Cone(direction=(0.3, 0, 1), resolution=64), color="tomato")
water = plotter.add_water(level=-0.2, waves=[(0.008, 0.6, 30), (0.005, 0.35, 75)], bounds=(-4, 4, -4, 4))
plotter.camera_position = [(0, -3.5, 0.6), (0, 0, 0), (0, 0, 1)]
plotter.show(jupyter_backend="static")
"""


def check(name, value, least):
    print(f"{name}: {value} (limit >= {least}) {'ok' if value >= least else 'FAILED'}", flush=True)
    return value >= least


def pixels(png):
    return np.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(int)


def red_pixels(png):
    red, green, blue = np.moveaxis(pixels(png), 2, 0)
    return int(((red > 150) & (red > 2 * blue)).sum())


def free_port():
    with socket.socket() as any_socket:
        any_socket.bind(("127.0.0.1", 0))
        return any_socket.getsockname()[1]


def look_at_trame(browser, folder):
    port = free_port()
    with open(folder / "trame.log", "w") as log:
        server = subprocess.Popen([sys.executable, HERE / "trame_app.py", "--port", str(port), "--server"],
                                  stdout=log, stderr=subprocess.STDOUT)
    address = f"http://localhost:{port}/"
    try:
        end = time.monotonic() + START_S
        while True:
            try:
                urllib.request.urlopen(address).close()
                break
            except OSError:
                if time.monotonic() > end or server.poll() is not None:
                    raise RuntimeError(f"the server does not answer: {folder / 'trame.log'}") from None
                time.sleep(0.3)
        first = browser.picture(address, LOAD_S)
        higher = browser.picture(address, LOAD_S, "window.trame.state.set('level', 0.2)")
    finally:
        server.terminate()
        server.wait()
    (folder / "trame.png").write_bytes(first)
    (folder / "trame_higher.png").write_bytes(higher)
    return [check("trame: pixels of the cone", red_pixels(first), 500),
            check("trame: pixels that the slider changes",
                  int((np.abs(pixels(higher) - pixels(first)).max(axis=2)[80:] > 40).sum()), 5000)]


def look_at_notebook(browser, folder):
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(CELL)])
    NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    page = folder / "notebook.html"
    page.write_text(HTMLExporter().from_notebook_node(notebook)[0])
    picture = browser.picture(page.resolve().as_uri(), LOAD_S)
    (folder / "notebook.png").write_bytes(picture)
    return [check("notebook: pixels of the cone", red_pixels(picture), 500)]


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    with Browser(folder) as browser:
        results = look_at_trame(browser, folder) + look_at_notebook(browser, folder)
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
