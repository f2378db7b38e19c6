# SPDX-License-Identifier: GPL-3.0-or-later
"""What all tests of the Python package share. OROGRAPH_PROGRAM names the command."""

import os
import pathlib
import signal
import subprocess

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = ROOT / "data_samples"


def run_command(*words, folder, check=True):
    program = os.environ["OROGRAPH_PROGRAM"]
    run = subprocess.run([program, *words], cwd=folder, capture_output=True, text=True)
    assert run.returncode == 0 or not check, run.stderr
    return run


def hills(rows=60, columns=80, dtype=np.float32):
    """Heights that are nowhere level, the same each time."""
    y, x = np.mgrid[0:rows, 0:columns] / 12.0
    return (300 + 100 * np.sin(x) * np.cos(1.3 * y) + 40 * np.sin(3 * x + y)).astype(dtype)


TRANSFORM = (500000.0, 25.0, 0.0, 5200000.0, 0.0, -25.0)
CRS = "EPSG:32632"


@pytest.fixture(scope="session")
def ground():
    import orograph

    return orograph.terrain(hills(), TRANSFORM, CRS)


@pytest.fixture
def ctrl_c():
    """Python's own handler, also where the tests run in the background, which ignores Ctrl-C."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)
