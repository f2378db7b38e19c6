# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples run as they stand, and make what they say."""

import os
import subprocess
import sys

import numpy as np
import orograph
import pytest
from conftest import DATA, ROOT

VOLCANO = str(DATA / "volcano.tif")


def run_example(name, *words, folder):
    example = ROOT / "examples/python" / name
    environment = {**os.environ, "MPLCONFIGDIR": str(folder)}
    run = subprocess.run(
        [sys.executable, "-B", example, *map(str, words)],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stderr
    return run.stdout


def test_array_to_picture(tmp_path):
    run_example("array_to_picture.py", folder=tmp_path)
    svg = (tmp_path / "picture.svg").read_text()
    assert svg.count("contours") > 0 and len(svg) > 100_000


def test_turntable(tmp_path):
    said = run_example("turntable.py", VOLCANO, tmp_path / "views", folder=tmp_path)
    views = sorted((tmp_path / "views").glob("view-*.svg"))
    assert len(views) == len(said.splitlines()) == 36
    alone = orograph.read(VOLCANO).render(view_from=(250, 25), page="a5")
    assert views[25].read_text() == alone.to_svg()


def test_colours_by_depth(tmp_path):
    pytest.importorskip("rasterio")
    image = pytest.importorskip("matplotlib.image")
    run_example("colours_by_depth.py", VOLCANO, tmp_path / "x.png", folder=tmp_path)
    pixels = image.imread(tmp_path / "x.png")[..., :3]
    is_coloured = pixels.max(axis=2) - pixels.min(axis=2) > 0.3
    assert is_coloured.mean() > 0.005  # lines are some 2 pixels wide
    rows = np.flatnonzero(is_coloured.any(axis=1))
    far, near = pixels[rows[:50]][is_coloured[rows[:50]]], pixels[rows[-50:]][is_coloured[rows[-50:]]]
    assert far[:, 1].mean() > near[:, 1].mean() + 0.3  # viridis goes from violet to yellow


def test_horizon(tmp_path):
    image = pytest.importorskip("matplotlib.image")
    alps = DATA / "fractal_alps.tif"
    names = [tmp_path / "horizon.png", tmp_path / "horizon.csv"]
    said = run_example("horizon.py", alps, 3.08, 0.95, *names, folder=tmp_path)
    rows = np.genfromtxt(names[1], delimiter=",", names=True)
    horizon = orograph.read(alps).horizon(eye_lonlat=(3.08, 0.95), horizon_step=0.5)
    assert rows.dtype.names == ("azimuth_deg", "altitude_deg", "distance_m") and len(rows) == 720
    assert np.allclose(rows["altitude_deg"], horizon.altitude_deg, rtol=0, atol=5.01e-4)
    assert f"{horizon.altitude_deg.max():.1f} degrees" in said
    pixels = image.imread(names[0])[..., 0]
    is_ground = abs(pixels - 0.8) < 0.01
    # The skyline is higher in the south-east than in the north-west.
    assert 0.05 < is_ground.mean() < 0.5
    half = len(pixels) // 2
    assert is_ground[half:, half:].mean() > 2 * is_ground[:half, :half].mean()


@pytest.mark.parametrize("page", ["docs/python.md", "README.md"])
def test_pages_code_runs(page, tmp_path, monkeypatch):
    """Each ```python block of a page, one after the other, as a reader would run them."""
    blocks = (ROOT / page).read_text().split("```python\n")[1:]
    assert blocks
    for needed in ("rasterio", "geopandas", "matplotlib", "xarray"):
        if any(needed in block.split("```")[0] for block in blocks):
            pytest.importorskip(needed)
    (tmp_path / "dem.tif").write_bytes((DATA / "jacksboro.tif").read_bytes())
    monkeypatch.chdir(tmp_path)
    scope = {}
    for block in blocks:
        exec(block.split("```")[0], scope)
