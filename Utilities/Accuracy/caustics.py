# SPDX-License-Identifier: BSD-3-Clause
"""caustics: light on level beds under waves against photons that are counted; the section "caustics".

The photons are those of Testing/Python/caustics_truth.py, which the tests use with fewer of them.
"""

import caustics_truth as truth
import numpy as np
from report import Report, table

DEPTHS = (1.0, 3.0, 8.0)  # m
SUNS = (90.0, 50.0, 25.0)  # degrees over the horizon
PHOTONS = 64_000_000
MOST_MEAN = 2.0  # % of the mean
MOST_RMSE = 10.0
SHOWN = (3.0, 50.0)
TEXT = """
Five sines (amplitudes of 3 to 35 mm, wavelengths of 0.5 to 5 m) over a horizontal bed; $width x $height pixels of 17
mm, seen from straight above. The truth refracts $photons million photons at the exact slopes, each from a point of
the sun's disc, counts them on the bed, and renders its picture with 4 x 4 refracted rays per pixel. Errors are
relative to the mean light. The photons are divided into two halves, which give two
independent estimates of the truth. The squared RMSE is the mean of the product of two differences: the picture minus
the first estimate, and the picture minus the second. The noise of the estimates cancels in this mean.

$errors

The module, the photons, and their difference (bed at 3 m, sun at 50 degrees):

$picture
"""


def measure(scene):
    """The module's light, the truth, the root mean square error without the truth's noise, and that noise."""
    view, look = truth.view_of(scene)
    light = truth.shown(view, look)
    halves = [truth.truth(scene, view, PHOTONS // 2, seed=seed) for seed in (1, 2)]
    good = np.maximum(*halves) < truth.MOST
    good &= light < truth.MOST
    noise = float((halves[0] - halves[1])[good].std()) / 2
    square = float(((light - halves[0]) * (light - halves[1]))[good].mean())
    return light, 0.5 * (halves[0] + halves[1]), np.sqrt(max(square, 0.0)), noise


def run(report):
    rows = []
    picture = ""
    for depth in DEPTHS:
        for sun in SUNS:
            scene = truth.Scene(truth.COVE, depth, sun)
            light, expected, rmse, noise = measure(scene)
            mean, _ = truth.errors(light, expected)
            rmse, noise = rmse / expected.mean(), noise / expected.mean()
            name = f"caustics, bed at {depth:g} m, sun at {sun:g} degrees"
            report.check_at_most(f"{name}: error of the mean, %", 100 * abs(mean), MOST_MEAN, 2)
            report.check_at_most(f"{name}: RMSE, % of the mean", 100 * rmse, MOST_RMSE, 1)
            rows.append((f"{depth:g} m", f"{sun:g}", f"{expected.std():.2f}", f"{100 * mean:+.2f} %",
                         f"{100 * rmse:.1f} %", f"{100 * noise:.1f} %"))
            if (depth, sun) == SHOWN:
                shown = [np.clip(image / 3, 0, 1) for image in (light, expected, np.abs(light - expected))]
                figure = Report.rows_of([np.repeat(image[:, :, None], 3, 2) for image in shown],
                                        ("module", "photons", "difference"), (4, 3))
                picture = report.save(figure, "caustics", "caustics and photons", True)
    report.add("Caustics", TEXT, width=scene.size[0], height=scene.size[1], photons=PHOTONS // 10**6,
               errors=table(("bed", "sun, degrees", "contrast", "error of the mean", "RMSE", "noise of the truth"), rows),
               picture=picture)
