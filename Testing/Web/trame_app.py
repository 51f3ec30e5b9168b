# SPDX-License-Identifier: BSD-3-Clause
"""trame_app: a PyVista scene with water, rendered on this machine and shown in a browser, by trame.

usage: trame_app.py --port PORT --server    trame's own options: --help
"""
import pyvista as pv
from trame.app import get_server
from trame.ui.vuetify3 import SinglePageLayout
from trame.widgets import vuetify3
from trame_pyvista.ui import plotter_ui

import vtkwater.pyvista  # noqa: F401


def make_scene():
    plotter = pv.Plotter(off_screen=True)
    plotter.set_background("white", top="lightskyblue")
    plotter.add_mesh(pv.Cone(direction=(0.3, 0.0, 1.0), resolution=64), color="tomato")
    plotter.add_water(level=-0.2, waves=[(0.008, 0.6, 30.0), (0.005, 0.35, 75.0)], bounds=(-2, 2, -2, 2), name="water")
    plotter.camera_position = [(0.0, -3.5, 0.6), (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)]
    return plotter


def main():
    server = get_server()
    server.client_type = "vue3"
    state, controller = server.state, server.controller
    plotter = make_scene()

    @state.change("level")
    def move_water(level, **_):
        plotter.actors["water"].SetLevel(float(level))
        controller.view_update()

    with SinglePageLayout(server) as layout:
        layout.title.set_text("Water by trame")
        with layout.toolbar:
            vuetify3.VSlider(v_model=("level", -0.2), min=-0.5, max=0.4, step=0.02, hide_details=True)
        with layout.content:
            view = plotter_ui(plotter, mode="server", default_server_rendering=True)
            controller.view_update = view.update
    server.start()


if __name__ == "__main__":
    main()
