# SPDX-License-Identifier: BSD-3-Clause
"""A picture of a wind sea is not like itself some waves aside; the truth is a sum of random sines of the same spectrum,
which never repeats."""

import functools
import math

import numpy as np
import pytest
import water_test as wt

G = 9.80665
WIND = 10.0  # m/s
PEAK = 2 * math.pi * G / (2 * math.pi * 0.13 * G / WIND) ** 2  # wavelength, m
SIDE = 500  # pixels
COSINE = 0.6  # of the view ray to the vertical
SINES = 5_000
INDEX = 1.333


def sea_picture(cascades, wide):
    """Reflectances of a sea in a picture so many wavelengths of the peak wide."""
    made = wt.View((SIDE, SIDE), (0.3, 0.4, 0.5))
    water = wt.add_water(made.renderer, None, (-4000, 4000, -4000, 4000), None)
    look = water.GetWaterProperty()
    look.SetPreset("ocean wind 10")
    look.SetMetresPerUnit(1.0)
    look.RefractionOff()
    look.GlitterOff()
    look.SetOutputToReflectance()
    look.SetSeaCascades(cascades)
    camera = wt.place_camera(made.renderer, (-8000, 0, 6000), (0, 0, 0), (1000, 20000))
    camera.ParallelProjectionOn()
    camera.SetParallelScale(0.5 * wide * PEAK)
    return made.picture().astype(float)[:, :, :2] @ (256, 1)


def repetition(shares, wide):
    """The largest autocorrelation from 3 wavelengths to 20, and how many wavelengths aside that is."""
    shares = shares - shares.mean()

    def correlated(field):
        return np.fft.ifft2(np.abs(np.fft.fft2(field, (2 * SIDE, 2 * SIDE))) ** 2).real

    shared = correlated(np.ones((SIDE, SIDE)))
    mean = correlated(shares) / np.maximum(shared, 1)
    lags = np.fft.fftfreq(2 * SIDE) * 2 * wide
    way = np.hypot(lags[np.newaxis, :], lags[:, np.newaxis] / COSINE)
    counts = (way > 3) & (way < 20) & (shared > 0.3 * SIDE**2)
    found = np.where(counts, mean / mean[0, 0], -1)
    place = np.unravel_index(found.argmax(), found.shape)
    return float(found[place]), float(way[place])


def slope_density(k):
    """Of JONSWAP's fully developed sea without enhancement, per logarithm of the wave number."""
    omega, peak = np.sqrt(G * k), math.sqrt(G * 2 * math.pi / PEAK)
    alpha = 0.076 * (22.0 / (2 * math.pi * 0.13)) ** (-3 * 0.22)
    height = alpha * G**2 * omega**-5 * np.exp(-1.25 * (peak / omega) ** 4) * 0.5 * np.sqrt(G / k)
    return height * k**3


@functools.lru_cache(None)  # both numbers of cascades are judged by it, and it takes seconds
def random_sines(wide, seed):
    """The same picture of sines whose wave vectors are drawn from the spectrum: cos^2 spread, no two with one period."""
    random = np.random.default_rng(seed)
    pixel = wide * PEAK / SIDE
    ks = np.exp(np.linspace(math.log(2 * math.pi / PEAK / 36), math.log(math.pi / pixel), 4001))
    share = np.concatenate([[0], np.cumsum(slope_density(ks[1:]) * np.diff(np.log(ks)))])
    k = np.exp(np.interp(random.random(SINES) * share[-1], share, np.log(ks)))
    angle = np.interp(random.random(SINES), np.linspace(0, 1, 181), _of_cos_squared())
    kx, ky = k * np.cos(angle), k * np.sin(angle)
    at = (np.arange(SIDE) + 0.5 - 0.5 * SIDE) * pixel
    kept = np.sinc(kx * pixel / COSINE / (2 * math.pi)) * np.sinc(ky * pixel / (2 * math.pi))  # the mean of a pixel
    size = math.sqrt(2 * share[-1] / SINES) * kept * np.exp(1j * random.uniform(0, 2 * math.pi, SINES))
    rows, columns = np.exp(1j * np.outer(at / COSINE, kx)), np.exp(1j * np.outer(ky, at))
    slope_x, slope_y = (((rows * (size * part)) @ columns).real for part in (np.cos(angle), np.sin(angle)))
    cosine = np.abs(COSINE + 0.8 * slope_x) / np.sqrt(1 + slope_x**2 + slope_y**2)
    inside = np.sqrt(1 - (1 - cosine**2) / INDEX**2)
    s = (cosine - INDEX * inside) / (cosine + INDEX * inside)
    p = (INDEX * cosine - inside) / (INDEX * cosine + inside)
    return 0.5 * (s**2 + p**2)


def _of_cos_squared():
    """Angles at even shares of a cos^2 distribution."""
    angles = np.linspace(-math.pi / 2, math.pi / 2, 2001)
    shares = (angles + 0.5 * np.sin(2 * angles)) / math.pi + 0.5
    return np.interp(np.linspace(0, 1, 181), shares, angles)


def test_a_sea_of_three_tiles_does_not_repeat():
    """A picture 40 waves wide is not like itself some waves aside; with one tile it is, ten waves aside."""
    wt.check_at_most("three tiles: largest autocorrelation beyond 3 wavelengths", repetition(sea_picture(3, 40), 40)[0],
                     0.2)
    wt.check_at_least("one tile: the same", repetition(sea_picture(1, 40), 40)[0], 0.9)


@pytest.mark.parametrize("wide, cascades", ((40, 3), (20, 3), (16, 2), (16, 3), (8, 2), (8, 3)))
def test_the_short_tiles_do_not_repeat(wide, cascades):
    """Nearer, the waves of the second tile are seen, which is 1.25 wavelengths of the peak long: its places are warped.
    Random sines have less than a tenth in pictures of all widths, so that no more is noise."""
    truth = repetition(random_sines(wide, 1), wide)[0]
    found, way = repetition(sea_picture(cascades, wide), wide)
    print(f"{wide} wavelengths wide: {found:.2f}, {way:.1f} wavelengths aside; random sines {truth:.2f}")
    wt.check_at_most(f"{wide} wavelengths wide: random sines", truth, 0.1)
    wt.check_at_most(f"{wide} wavelengths wide: {cascades} tiles", found, 0.2)
