# SPDX-License-Identifier: BSD-3-Clause
"""conftest: what pytest, which runs the Python tests, must know of them.

    python3 -m pytest -s Testing/Python/TestWaterHidden.py                  one file
    python3 -m pytest -s Testing/Python/TestWaterHidden.py -k behind_a_wall one claim of it

A test is a function that makes one claim. It prints its figures by water_test.check and fails when one of
them does not hold; the others are still printed.
"""

import pytest
import water_test


@pytest.fixture
def in_software(monkeypatch):
    """The module skips what pays where the processor draws, whatever draws."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", "1")


@pytest.fixture
def on_a_gpu(monkeypatch):
    """The module skips what pays where a GPU draws, whatever draws."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", "0")


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item):
    water_test.failures.clear()


@pytest.hookimpl(trylast=True)
def pytest_runtest_call(item):
    assert not water_test.failures, "figures out of their limits: " + ", ".join(water_test.failures)
