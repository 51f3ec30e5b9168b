# SPDX-License-Identifier: BSD-3-Clause
"""A wind sea has its spectrum's heights and slopes, travels by its dispersion, and is drawn as it is."""

import math

import numpy as np
import pytest
import ray_caster
import water_test as wt
from vtkwater import vtkWaterActor, vtkWaterProperty

G = 9.80665
INF = math.inf
SIZE = (300, 200)
WIND_SEA = {"WindSpeed": 7.0, "Fetch": 20000.0, "WindDirection": 30.0}
PLACES = [(1.5, 2.0), (-40.0, 13.0), (3.25, -7.5)]


def sea_water(**settings):
    water = vtkWaterActor()
    water.GetWaterProperty().SetSea(True)
    water.GetWaterProperty().SetSeaCascades(1)
    for name, value in settings.items():
        getattr(water.GetWaterProperty(), f"Set{name}")(value)
    return water


def heights(water):
    """The heights at the tile's points: rows x columns."""
    look = water.GetWaterProperty()
    steps = np.arange(look.GetSeaTileSize()) * (look.GetUsedSeaTileLength() / look.GetSeaTileSize())
    return np.array([[water.GetWaveHeight(x, y) for x in steps] for y in steps])


def slope_at(water, x, y):
    normal = [0.0, 0.0, 0.0]
    water.GetWaveNormal(x, y, normal)
    return -normal[0] / normal[2], -normal[1] / normal[2]


def wave_numbers(water):
    look = water.GetWaterProperty()
    k = 2 * np.pi * np.fft.fftfreq(look.GetSeaTileSize(), look.GetUsedSeaTileLength() / look.GetSeaTileSize())
    return k[np.newaxis, :], k[:, np.newaxis]


def jonswap_moments(wind, fetch, gamma, k_end):
    """Variances of height and slope up to a wave number, deep water: the report's formulas."""
    omega = np.linspace(0.02, math.sqrt(G * k_end), 400001)[1:]
    peak = 22 * (G * G / (wind * fetch)) ** (1 / 3)
    alpha = 0.076 * (wind * wind / (fetch * G)) ** 0.22
    width = np.where(omega <= peak, 0.07, 0.09)
    density = alpha * G * G * omega**-5.0 * np.exp(-1.25 * (peak / omega) ** 4)
    density = density * gamma ** np.exp(-0.5 * ((omega - peak) / (width * peak)) ** 2)
    step = omega[1] - omega[0]
    return density.sum() * step, ((omega**2 / G) ** 2 * density).sum() * step, peak


def test_the_automatic_tile_is_ten_wavelengths_of_the_peak():
    """The automatic tile is as long as ten wavelengths of the spectrum's peak."""
    water = sea_water(**WIND_SEA, SeaTileSize=64)
    look = water.GetWaterProperty()
    _, _, peak = jonswap_moments(7.0, 20000.0, 3.3, math.pi * 64 / look.GetUsedSeaTileLength())
    wt.check_at_most("automatic tile: 10 wavelengths of the peak, relative error",
                     abs(look.GetUsedSeaTileLength() / (20 * math.pi * G / peak**2) - 1), 1e-9)


def test_the_height_is_the_spectrums():
    """The significant wave height over many seeds is that of the spectrum's integral."""
    water = sea_water(**WIND_SEA, SeaTileSize=64)
    look = water.GetWaterProperty()
    variance, _, _ = jonswap_moments(7.0, 20000.0, 3.3, math.pi * 64 / look.GetUsedSeaTileLength())
    measured = []
    for seed in range(40):
        look.SetSeed(seed)
        measured.append(float((heights(water) ** 2).mean()))
    wt.check_at_most(f"Hs of 40 seas ({4 * math.sqrt(np.mean(measured)):.3f} m) against the formula "
                     f"({4 * math.sqrt(variance):.3f} m), relative",
                     abs(math.sqrt(np.mean(measured) / variance) - 1), 0.03)


def test_the_slope_is_the_spectrums():
    """The mean square slope over seeds, and the rms slope that the look says, are that of the spectrum's integral."""
    water = sea_water(**WIND_SEA, SeaTileSize=256)
    look = water.GetWaterProperty()
    length = look.GetUsedSeaTileLength()
    _, slopes, _ = jonswap_moments(7.0, 20000.0, 3.3, math.pi * 256 / length)
    random = np.random.default_rng(5)
    squares = []
    for seed in range(6):
        look.SetSeed(seed)
        places = random.integers(0, 256, (3000, 2)) * (length / 256)
        squares += [sum(s * s for s in slope_at(water, x, y)) for x, y in places]
    wt.check_at_most(f"mean square slope of 6 seas ({np.mean(squares):.5f}) against the formula "
                     f"({slopes:.5f}), relative", abs(np.mean(squares) / slopes - 1), 0.08)
    wt.check_at_most("GetSlopeRMS against the formula, relative",
                     abs(look.GetSlopeRMS() / math.sqrt(slopes) - 1), 0.002)


def model_sea(model, depth):
    return sea_water(WindSpeed=6.0, SeaTileSize=64, SeaModel=model, Depth=depth)


MODELS = pytest.mark.parametrize("model, depth", [
    (vtkWaterProperty.JONSWAP, 4.0), (vtkWaterProperty.JONSWAP, INF), (vtkWaterProperty.PHILLIPS, INF),
], ids=["JONSWAP_4_m_deep", "JONSWAP", "PHILLIPS"])


@MODELS
def test_every_wave_vector_swings_with_its_frequency(model, depth):
    """Every wave vector of the sea swings with its own frequency, which is the dispersion's of the depth."""
    water = model_sea(model, depth)
    spectra = []
    for time in (99.0, 99.4, 99.8):
        water.SetTime(time)
        spectra.append(np.fft.fft2(heights(water)))
    k = np.hypot(*wave_numbers(water))
    omega = np.sqrt(G * k * np.tanh(np.where(k > 0, k, 1) * depth))
    miss = spectra[0] + spectra[2] - 2 * np.cos(0.4 * omega) * spectra[1]
    wt.check_at_most(f"model {model}, depth {depth}: swing of each wave vector, relative miss",
                     float(np.abs(miss).max() / np.abs(spectra[1]).max()), 1e-11)


@MODELS
def test_slopes_are_those_of_the_heights(model, depth):
    """The slopes at the tile's points are the derivatives of its heights."""
    water = model_sea(model, depth)
    spectrum = np.fft.fft2(heights(water))
    slope = [np.fft.ifft2(1j * axis * spectrum).real for axis in wave_numbers(water)]
    step = water.GetWaterProperty().GetUsedSeaTileLength() / 64
    worst = 0.0
    for i, j in np.random.default_rng(5).integers(0, 64, (300, 2)):
        found = slope_at(water, i * step, j * step)
        worst = max(worst, abs(found[0] - slope[0][j, i]), abs(found[1] - slope[1][j, i]))
    wt.check_at_most(f"model {model}, depth {depth}: slopes against those of the heights", worst, 1e-12)


@MODELS
def test_between_the_tiles_points_the_surface_is_bilinear(model, depth):
    """Between the tile's points the surface is bilinear, and it repeats with the tile."""
    water = model_sea(model, depth)
    length = water.GetWaterProperty().GetUsedSeaTileLength()
    step = length / 64
    field = heights(water)
    x, y = 17.3 * step - 5 * length, 63.6 * step + 2e4 * length
    bilinear = (0.4 * (0.7 * field[63, 17] + 0.3 * field[63, 18]) + 0.6 * (0.7 * field[0, 17] + 0.3 * field[0, 18]))
    wt.check_at_most(f"model {model}, depth {depth}: bilinear between points, and repeating",
                     abs(water.GetWaveHeight(x, y) - bilinear), 1e-8)


def test_the_waves_travel_with_the_wind():
    """The waves travel with the wind: the phase of a wave vector along it falls with time."""
    water = sea_water(WindSpeed=6.0, SeaTileSize=64, WindDirection=90.0)
    first = np.fft.fft2(heights(water))
    water.SetTime(0.05)
    turn = np.angle(np.fft.fft2(heights(water)) / np.where(first == 0, 1, first))
    kx, ky = wave_numbers(water)
    omega = np.sqrt(G * np.hypot(kx, ky))
    power = np.abs(first) ** 2 * (ky > 2 * np.abs(kx))
    wt.check_at_most("waves along the wind: mean turn against -omega t, rad",
                     abs(float((power * (turn + 0.05 * omega)).sum() / power.sum())), 0.01)


def at_places(time=0.0, **settings):
    water = sea_water(**settings)
    water.SetTime(time)
    return [water.GetWaveHeight(*place) for place in PLACES]


def test_the_seed_makes_the_sea():
    """The same seed makes the same sea and another seed another one; negative seeds are seeds, too."""
    wt.check_equal("same seed, same sea", at_places(Seed=7) == at_places(Seed=7), True)
    wt.check_equal("other seed, other sea", at_places(Seed=7) != at_places(Seed=8), True)
    wt.check_equal("negative seeds are seeds", at_places(Seed=-7) != at_places(Seed=7), True)


def test_the_sea_repeats_after_its_period():
    """A sea with a period is the same after any number of them."""
    wt.check_equal("the sea repeats after its period",
                   at_places(3.0, SeaPeriod=20.0), at_places(20003.0, SeaPeriod=20.0))


def test_a_sine_adds_to_the_sea():
    """A sine wave adds to the sea's height and slope, and its square to the mean square slope."""
    water = sea_water()
    height, slope = water.GetWaveHeight(1.5, 2.0), slope_at(water, 1.5, 2.0)
    slope_rms = water.GetWaterProperty().GetSlopeRMS()
    water.GetWaterProperty().AddWave(0.3, 5.0, 0.0, 0.0)
    angle, steep = 2 * math.pi * 1.5 / 5, 0.3 * 2 * math.pi / 5
    wt.check_at_most("a sine adds to the sea's height",
                     abs(water.GetWaveHeight(1.5, 2.0) - height - 0.3 * math.sin(angle)), 1e-12)
    wt.check_at_most("a sine adds to the sea's slope",
                     abs(slope_at(water, 1.5, 2.0)[0] - slope[0] - steep * math.cos(angle)), 1e-12)
    wt.check_at_most("a sine adds to the rms slope",
                     abs(water.GetWaterProperty().GetSlopeRMS() - math.hypot(slope_rms, steep / math.sqrt(2))), 1e-12)


def test_a_place_that_is_not_finite_has_no_height():
    """At a place that is not finite the height is no number."""
    wt.check_equal("height at a place that is not finite", math.isnan(sea_water().GetWaveHeight(INF, 0)), True)


def test_presets_bring_their_sea_or_none():
    """The ocean's preset brings its sea, and the pool's none, also after the ocean's."""
    look = vtkWaterProperty()
    look.SetPreset("ocean wind 10")
    wt.check_equal("ocean: sea, wind, fetch, gamma",
                   (look.GetSea(), look.GetWindSpeed(), look.GetFetch(), look.GetPeakEnhancement()),
                   (True, 10.0, INF, 1.0))
    look.SetPreset("pool")
    wt.check_equal("pool: sea", look.GetSea(), False)


@pytest.mark.parametrize("name, bad, part", [
    ("WindSpeed", 0.0, "WindSpeed must lie in [0.1, 100] m/s"), ("WindSpeed", math.nan, "[0.1, 100]"),
    ("WindDirection", INF, "must be finite"), ("Fetch", 0.5, "at least 1 m"), ("PeakEnhancement", 0.9, "[1, 20]"),
    ("SeaTileSize", 100, "a power of two in [32, 1024]"), ("SeaTileSize", 16, "[32, 1024]"),
    ("SeaTileSize", 2048, "[32, 1024]"), ("SeaTileLength", -1.0, "[0.001, 1e9] m"),
    ("SeaPeriod", -1.0, "not negative"), ("SeaModel", 2, "[0, 1]"),
])
def test_bad_input_is_refused(name, bad, part):
    """Bad input gives an error that names value and range, and the last good value stays."""
    look = vtkWaterProperty()
    errors = wt.errors_of(look)
    good = getattr(look, f"Get{name}")()
    getattr(look, f"Set{name}")(bad)
    wt.check_equal(f"{name} {bad}: errors", len(errors), 1)
    text = errors[0] if errors else ""
    wt.check_equal(f"{name} {bad}: '{text.strip()}' names value and range",
                   part in text and f"{name} is" in text, True)
    wt.check_equal(f"{name} {bad}: it stays", getattr(look, f"Get{name}")(), good)


def view_of(water, position, focus, size, angle=30, clipping=(0.01, 50), sheet=30):
    made = wt.View(size, (0.5, 0.6, 0.7))
    made.renderer.GradientBackgroundOn()
    made.renderer.SetBackground2(0.2, 0.4, 0.8)
    made.renderer.AddActor(water)
    x, y = position[:2]
    water.SetSheetBounds(x - sheet, x + sheet, y - sheet, y + sheet)
    camera = made.renderer.GetActiveCamera()
    camera.SetPosition(position)
    camera.SetFocalPoint(focus)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(angle)
    camera.SetClippingRange(*clipping)
    return made


# who makes the picture's slopes: values of VTK_WATER_SOFTWARE
WAYS = pytest.mark.parametrize("software", ["1", "0"], ids=["processor", "GPU"])


@WAYS
@pytest.mark.parametrize("name, x0, y0", [("near the origin", 0.0, 0.0), ("2000 km away", 1e6 + 0.1, -2e6)],
                         ids=["near_the_origin", "2000_km_away"])
def test_a_pixel_is_drawn_with_the_normal_there(name, x0, y0, software, monkeypatch):
    """The reflectance of each pixel is Fresnel's with the normal that GetWaveNormal says."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", software)
    # a tile so fine that it leaves no waves out, and pixels so near that they average nothing
    water = sea_water(WindSpeed=2.0, SeaTileLength=1.0)
    water.GetWaterProperty().SetOutputToReflectance()
    water.SetTime(12.5)
    eye = np.array((x0, y0, 0.15))
    made = view_of(water, eye, eye + (0.1, 0.25, -0.2), SIZE, angle=8)
    picture = made.picture()
    shown = (256 * picture[:, :, 0] + picture[:, :, 1]) / 65535
    forward = wt.unit((0.1, 0.25, -0.2))
    right = wt.unit(np.cross(forward, (0, 0, 1)))
    up = np.cross(right, forward)
    tangent = math.tan(math.radians(4))
    random = np.random.default_rng(5)
    worst = []
    for i, j in zip(random.integers(0, SIZE[0], 2000), random.integers(0, SIZE[1], 2000)):
        u = (2 * (i + 0.5) / SIZE[0] - 1) * tangent * SIZE[0] / SIZE[1]
        v = (2 * (j + 0.5) / SIZE[1] - 1) * tangent
        ray = wt.unit(forward + u * right + v * up)
        place = eye - ray * (eye[2] / ray[2])
        normal = [0.0, 0.0, 0.0]
        water.GetWaveNormal(place[0], place[1], normal)
        worst.append(abs(shown[j, i] - ray_caster.fresnel(-np.dot(ray, normal), 1.333)))
    wt.check_at_most(f"{name}: reflectance against the twin's normal, worst of 2000 pixels", max(worst), 2e-3)
    wt.check_at_least(f"{name}: and it varies, standard deviation", float(shown.std()), 0.005)


def frames(times):
    water = sea_water()
    made = view_of(water, (0, -10, 2), (0, 0, 1), SIZE, clipping=(0.5, 3000), sheet=2000)
    wt.add_actor(made.renderer, wt.box((0, 6, 1), (2, 2, 4)), (0.9, 0.3, 0.1))
    pictures = []
    for time in times:
        water.SetTime(time)
        pictures.append(made.picture())
    return pictures


@WAYS
def test_the_picture_depends_on_the_time_alone(software, monkeypatch):
    """The picture of a moving sea depends on its time alone, not on the frames before."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", software)
    several = frames((0.0, 0.5, 1e6, 0.5))
    direct = frames((1e6,))[0]
    wt.check_equal("time 1e6 after other frames and at once: difference", int(np.abs(several[2] - direct).max()), 0)
    wt.check_equal("time 0.5 again: difference", int(np.abs(several[1] - several[3]).max()), 0)
    wt.check_at_least("the sea moves", float(np.abs(several[0] - several[1]).mean()), 1.0)


def mean_of(picture, factor):
    rows, columns = picture.shape[0] // factor, picture.shape[1] // factor
    return picture.reshape(rows, factor, columns, factor, 3).mean(axis=(1, 3))


class Distant:
    """A distant sea: the picture, the mean of 64 samples of each pixel, one of them, and the water's pixels."""

    def __init__(self, shift=0.0):
        self.once, self.mask = self.draw(1, shift)
        often, _ = self.draw(8, shift)
        self.truth, self.point = mean_of(often, 8), often[4::8, 4::8]

    @staticmethod
    def draw(factor, shift):
        water = sea_water(WindSpeed=8.0, Fetch=3000.0, WindDirection=110.0)
        made = view_of(water, (3, -14, 12), (shift, 200, -20), (200 * factor, 150 * factor),
                       clipping=(1, 9000), sheet=8000)
        return made.picture().astype(float), wt.water_mask(made, water)

    def rmse(self, difference):
        return float(np.sqrt((difference[self.mask] ** 2).mean()))


@pytest.fixture(scope="module")
def distant():
    return Distant()


def test_a_distant_sea_is_near_its_mean(distant):
    """A distant sea does not turn into a mirror: a pixel is nearer to the mean of 64 samples than one of them is."""
    wt.save(distant.once, wt.output_folder() / "TestWaterSea-distant.png")
    wt.save(distant.truth, wt.output_folder() / "TestWaterSea-distant-truth.png")
    error, worse = distant.rmse(distant.once - distant.truth), distant.rmse(distant.point - distant.truth)
    wt.check_at_least(f"distant sea: RMSE of a point sample ({worse:.2f}) / of the picture ({error:.2f})",
                      worse / error, 1.5)


def test_a_distant_sea_does_not_shimmer(distant):
    """A distant sea does not shimmer: half a pixel on it changes more like the mean of 64 samples than one does."""
    half = 0.5 * 214 * 2 * math.tan(math.radians(15)) / 150  # half a pixel at the focus
    moved = Distant(half)
    truth = moved.truth - distant.truth
    shimmer = distant.rmse((moved.once - distant.once) - truth)
    worse = distant.rmse((moved.point - distant.point) - truth)
    wt.check_at_least(f"half a pixel on: RMSE of the change, point sample ({worse:.2f}) / picture ({shimmer:.2f})",
                      worse / shimmer, 1.5)


def glitter_from(distance, random, intensity=0.6, view=(0, -1, 0.5), **settings):
    """Mean of 255 over pictures that are as high as 30 degrees of view, at random places and times."""
    made = wt.View((160, 120), (0, 0, 0))
    wt.add_scene_light(made.renderer, (0.1, 0.8, 0.55))
    made.renderer.GetLights().GetItemAsObject(0).SetIntensity(intensity)  # no pixel is white
    water = wt.add_water(made.renderer, None, (-2e5, 2e5, -2e5, 2e5), 0.0)
    look = water.GetWaterProperty()
    look.SetDeepColor(0, 0, 0)
    look.SetFetch(2000.0)
    look.SetMetresPerUnit(1.0)
    look.SeaOn()
    for name, value in settings.items():
        getattr(look, f"Set{name}")(value)
    camera = made.renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(distance * math.tan(math.radians(15)))
    away = max(distance, 50.0)
    means, brightest = [], 0
    for _ in range(40 if distance < 2000 and not settings.get("WaveGeometry") else 4):
        place = np.append(random.uniform(-500, 500, 2), 0)
        camera.SetPosition(place + 2 * away * wt.unit(view))
        camera.SetFocalPoint(place)
        camera.SetViewUp(0, 0, 1)
        camera.SetClippingRange(0.5 * away, 4 * away)
        water.SetTime(float(random.uniform(0, 1000)))
        picture = made.picture()[:, :, 0]
        means.append(picture.mean())
        brightest = max(brightest, picture.max())
    print(f"glitter from {distance:g} m: mean {np.mean(means):.2f} of 255, brightest pixel {brightest}", flush=True)
    return float(np.mean(means))


def test_a_glittering_sea_is_as_bright_from_near_and_far():
    """A glittering sea is as bright from 10 m as from 100 km, seen along the same direction under the same sun."""
    # Slopes that a pixel does not resolve shine as those that it does.
    random = np.random.default_rng(5)
    shine = [glitter_from(distance, random) for distance in (10, 100, 1e3, 1e4, 1e5)]
    wt.check_at_most("glitter from 10 m to 100 km: largest deviation from the mean, %",
                     100 * float(np.abs(np.array(shine) / np.mean(shine) - 1).max()), 2.0)


@pytest.mark.parametrize("direction, distance", ((45.0, 100), (135.0, 10)))
def test_glitter_knows_where_an_oblique_wind_blows(direction, distance):
    """Slopes that a pixel does not resolve are steeper along the wind than across it, whichever way that blows."""
    seen = {"WindDirection": direction, "view": (0.1, -1, 0.45)}
    near = glitter_from(distance, np.random.default_rng(5), 0.15, **seen) / 0.15
    far = glitter_from(10000, np.random.default_rng(5), 0.8, **seen) / 0.8
    wt.check_at_most(f"wind towards {direction:g} degrees: near glitter against far, relative", abs(near / far - 1), 0.03)


@pytest.mark.parametrize("height", (0.3, 0.45))
def test_displaced_waves_glitter_as_brightly(height):
    """Displaced crests, which hide what is behind them, glitter as brightly as the same waves on a flat sheet."""
    seen = {"Fetch": 20000.0, "WindSpeed": 12.0, "view": (0.1, -1, height)}
    flat, displaced = (glitter_from(100, np.random.default_rng(7), 0.1, WaveGeometry=geometry, **seen) for geometry in (False, True))
    wt.check_at_most(f"seen at a slope of {height:g}: displaced against flat, relative", abs(displaced / flat - 1), 0.05)
