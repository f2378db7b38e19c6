# SPDX-License-Identifier: GPL-3.0-or-later
"""Places that an eye sees and its skyline: the numbers of the command, from arrays to arrays."""

import csv
import inspect
import os
import re
import signal
import threading
import time

import numpy as np
import orograph
import pytest
from conftest import CRS, DATA, TRANSFORM, hills, run_command

ALPS = DATA / "fractal_alps.tif"
# All over it, and one beside.
LONLAT = [(3.02 + 0.027 * i, 0.87 + 0.011 * (7 * i % 11)) for i in range(11)] + [(2.0, 0.9)]
# The command's words and Python's keywords for eyes of every kind.
EYES = [
    ("--eye 515000,104000", {"eye": (515000, 104000)}),
    (
        "--eye-lonlat 3.08,0.95 --eye-summit 500 --target-height 12.5",
        {"eye_lonlat": (3.08, 0.95), "eye_summit": 500, "target_height": 12.5},
    ),
    (
        "--eye 508000,104500,3300 --curvature off --exaggeration 1.5 -j 1",
        {"eye": (508000, 104500, 3300), "curvature": "off", "exaggeration": 1.5, "jobs": 1},
    ),
    (
        "--eye 508000,104500 --eye-height 120 --refraction 0.2",
        {"eye": (508000, 104500), "eye_height": 120, "refraction": 0.2},
    ),
]


def rows_of(text):
    return list(csv.DictReader(text.splitlines()))


def numbers(rows, name):
    return np.array([float(row[name]) if row[name] else np.nan for row in rows])


@pytest.fixture(scope="module")
def alps():
    return orograph.read(ALPS).session()


@pytest.mark.parametrize("words, options", EYES)
def test_numbers_of_the_command(words, options, alps, tmp_path):
    table = ["--horizon-table", "h.csv", "--horizon-step", "7.5"]
    points = "\n".join(["lon,lat", *(f"{lon!r},{lat!r}" for lon, lat in LONLAT)])
    (tmp_path / "points.csv").write_text(points + "\n")
    run = run_command("visible", str(ALPS), "points.csv", *words.split(), *table, folder=tmp_path)
    rows = rows_of(run.stdout)
    seen = alps.visible(LONLAT, lonlat=True, **options)
    assert len(seen) == len(rows) == len(LONLAT)
    assert seen.state.tolist() == [row["state"] for row in rows]
    assert set(seen.state) == {"seen", "hidden", "outside"}
    # The command rounds to 1 mm and 1e-9 degrees.
    for name, unit in (("hidden_m", 1e-3), ("distance_m", 1e-3), ("height", 1e-3), ("hidden_deg", 1e-9), ("azimuth_deg", 1e-9), ("altitude_deg", 1e-9)):
        told = getattr(seen, name)
        assert told.dtype == np.float64 and told is seen.attributes[name]
        assert np.allclose(told, numbers(rows, name), rtol=0, atol=0.501 * unit, equal_nan=True), name

    of_map = np.column_stack([numbers(rows, "x"), numbers(rows, "y")])
    again = alps.visible(of_map, **options)
    assert again.state.tolist() == seen.state.tolist()
    assert np.allclose(again.distance_m, seen.distance_m, rtol=0, atol=2e-3)

    options = {name: of for name, of in options.items() if name != "target_height"}
    horizon = alps.horizon(horizon_step=7.5, **options)
    rows = rows_of((tmp_path / "h.csv").read_text())
    assert len(horizon) == len(rows) == 48
    for name, unit in (("azimuth_deg", 1e-9), ("altitude_deg", 1e-9), ("distance_m", 1e-3), ("longitude", 1e-8), ("latitude", 1e-8)):
        assert np.allclose(getattr(horizon, name), numbers(rows, name), rtol=0, atol=0.501 * unit, equal_nan=True), name


def test_the_most_distant_ground_is_the_reports(alps, tmp_path):
    words = ["--eye", "515000,104000", "--horizon-table", "h.csv", "--report", "r.json", "--quiet"]
    run_command("render", str(ALPS), "map.svg", *words, folder=tmp_path)
    import json

    report = json.loads((tmp_path / "r.json").read_text())["skyline"]
    horizon = alps.horizon(eye=(515000, 104000))
    far, told = horizon.most_distant, report["most_distant"]
    assert [far["x"], far["y"], far["height"]] == pytest.approx(told["map"])
    assert far["distance_m"] == pytest.approx(told["distance_m"], abs=1)
    assert far["distance_m"] >= np.nanmax(horizon.distance_m)
    assert horizon.at_border.dtype == bool and horizon.at_border.sum() == report["at_border"]


def test_every_state():
    z = hills()
    z[20:26, 30:37] = np.nan
    terrain = orograph.terrain(z, TRANSFORM, CRS)
    x, size, _, y, _, _ = TRANSFORM
    cells = np.array([[3, 5], [33, 23], [20, 9], [500, 5]])
    places = np.column_stack([x + size * (cells[:, 0] + 0.5), y - size * (cells[:, 1] + 0.5)])
    seen = terrain.visible(places, eye=(x + 100, y - 100), eye_height=400)
    assert seen.state.tolist() == ["seen", "gap", "seen", "outside"]
    assert seen.height[0] == pytest.approx(z[5, 3], abs=1e-3)
    known = np.array([True, False, True, False])
    for name in ("hidden_m", "hidden_deg", "altitude_deg", "height"):
        assert np.array_equal(~np.isnan(seen.attributes[name]), known)
    assert np.isfinite(seen.distance_m).all() and np.isfinite(seen.azimuth_deg).all()
    assert "4 places: 1 gap, 1 outside, 2 seen" in repr(seen)
    low = terrain.visible(places[2], eye=(x + 100, y - 100), eye_height=1)
    assert low.state[0] == "hidden" and low.hidden_m[0] > 0
    for more_m, state in ((0.01, "seen"), (-0.01, "hidden")):
        height = low.hidden_m[0] + more_m
        higher = terrain.visible(places[2], eye=(x + 100, y - 100), eye_height=1, target_height=height)
        assert higher.state.tolist() == [state]
    assert len(terrain.visible(np.zeros((0, 2)), eye=(x + 100, y - 100))) == 0
    lonlat = [(np.inf, 46.9), (9.0, 46.8)]  # the first is in no place that the CRS has
    beyond = terrain.visible(lonlat, lonlat=True, eye=(x + 100, y - 100))
    assert beyond.state.tolist() == ["outside", "outside"]
    assert np.isnan(beyond.distance_m).tolist() == [True, False]
    with pytest.raises(orograph.Error, match="points have 95 for a latitude: give longitude first"):
        terrain.visible([(9.0, 95.0)], lonlat=True, eye=(x + 100, y - 100))


def test_a_terrain_of_no_place_on_earth():
    terrain = orograph.terrain(hills(), TRANSFORM)
    horizon = terrain.horizon(eye=(501000, 5199000), horizon_step=30)
    assert np.isnan(horizon.longitude).all() and np.isfinite(horizon.altitude_deg).all()
    with pytest.raises(orograph.Error, match="isn't on the earth"):
        terrain.visible([(7, 46)], lonlat=True, eye=(501000, 5199000))


@pytest.mark.parametrize("kind", [np.float32, np.int64, ">f8", "fortran", "list"])
def test_points_of_other_kinds(kind, alps):
    places = np.array([[512000, 104500], [501000, 101000], [509000, 99000]])
    wanted = alps.visible(places, eye=(515000, 104000))
    others = {"fortran": np.asfortranarray, "list": lambda of: of.tolist()}
    other = others.get(kind, lambda of: of.astype(kind))(places)
    got = alps.visible(other, eye=(515000, 104000))
    for name, values in wanted.attributes.items():
        np.testing.assert_array_equal(got.attributes[name], values, err_msg=name)


def refused(call, *arguments, **options):
    with pytest.raises(orograph.Error) as caught:
        call(*arguments, **options)
    error = caught.value
    assert str(error) == f"{error.wrong}: {error.right}"
    assert "--" not in str(error) and "`" not in str(error).replace("`.centroid`", "")
    return str(error)


@pytest.mark.parametrize(
    "points, wrong",
    [
        ([1, 2, 3], "points are 3 of int64"),
        (np.zeros((2, 3)), "points are 2 x 3 of float64: give a row of x and y"),
        ([["a", "b"]], "<U1"),
        (5, "a single value"),
        ([], "points are 0 of float64"),
        ([(np.nan, 3)], "finite numbers"),
    ],
)
def test_what_are_no_points(points, wrong, alps):
    assert wrong in refused(alps.visible, points, eye=(515000, 104000))


@pytest.mark.parametrize(
    "options, told",
    [
        ({}, "there is no eye to look from: give eye X,Y[,Z] or eye_lonlat LON,LAT[,H]"),
        ({"eye": (1, 2)}, "outside of the terrain"),
        ({"eye": (515000, 104000, -50)}, "under the ground"),
        ({"eye": (515000, 104000), "eye_lonlat": (3, 1)}, "exclude each other"),
        ({"eye_lonlat": (0.95, 95)}, "is no latitude"),
        ({"eye": (515000, 104000), "eye_hight": 3}, "did you mean eye_height?"),
        ({"eye": (515000, 104000), "fov": 3}, "help(orograph.Terrain."),
        ({"eye": (515000, 104000), "bbox": (1, 2, 3, 4)}, "give it to orograph.read"),
        ({"eye": (515000, 104000), "refraction": 3}, "-1 to 1"),
    ],
)
def test_wrong_options(options, told, alps):
    assert told in refused(alps.visible, [(512000, 104500)], **options)
    assert told in refused(alps.horizon, **options)


def test_options_of_one_of_the_two(alps):
    assert "0.001 to 90" in refused(alps.horizon, eye=(515000, 104000), horizon_step=0)
    assert "did you mean horizon_step" in refused(alps.horizon, eye=(515000, 104000), horizon_stp=1)
    assert "unknown option" in refused(alps.horizon, eye=(515000, 104000), target_height=1)
    assert "unknown option" in refused(alps.visible, [(1, 2)], eye=(515000, 104000), horizon_step=1)
    assert "at least 0" in refused(alps.visible, [(1, 2)], eye=(515000, 104000), target_height=-1)


def test_progress_ctrl_c_and_a_callback_that_raises(ctrl_c):
    size = 1200
    session = orograph.terrain(hills(size, size), TRANSFORM, CRS).session()
    eye = {"eye": (500000 + 12.5 * size, 5200000 - 12.5 * size), "jobs": 1}
    places = np.random.default_rng(1).uniform(0, 25 * (size - 1), (40_000, 2)) * [1, -1] + [500000, 5200000]
    few = session.visible(places[:50], **eye)
    told = []
    session.visible(places[:20_000], progress=told.append, **eye)
    assert told == sorted(told) and told[-1] == 1 and 0 < told[0] < 1
    told.clear()
    session.horizon(progress=told.append, **eye)
    assert told == sorted(told) and told[-1] == 1

    def enough(share):
        raise ZeroDivisionError

    for call in (lambda **more: session.visible(places, **more), session.horizon):
        with pytest.raises(ZeroDivisionError):
            call(progress=enough, **eye)

    pressed = []

    def press():
        pressed.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.2, press)
    timer.start()
    deadline = time.monotonic() + 20
    with pytest.raises(KeyboardInterrupt):
        while time.monotonic() < deadline:
            session.visible(places, **eye)
    assert time.monotonic() - pressed[0] < 0.1 + 0.2  # a tenth of a second, and a busy machine
    timer.join()
    again = session.visible(places[:50], **eye)
    assert np.array_equal(again.hidden_m, few.hidden_m) and np.array_equal(again.state, few.state)


def test_two_threads_at_once(alps):
    eyes = [(515000, 104000), (508000, 104500)]
    wanted = [(alps.visible(LONLAT, lonlat=True, eye=eye), alps.horizon(eye=eye)) for eye in eyes]
    got = [[], []]

    def look(mine, eye):
        for _ in range(5):
            mine.append((alps.visible(LONLAT, lonlat=True, eye=eye), alps.horizon(eye=eye)))

    threads = [threading.Thread(target=look, args=pair) for pair in zip(got, eyes)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for (sights, horizon), mine in zip(wanted, got):
        assert len(mine) == 5
        for other_sights, other_horizon in mine:
            np.testing.assert_array_equal(other_sights.hidden_m, sights.hidden_m)
            np.testing.assert_array_equal(other_horizon.altitude_deg, horizon.altitude_deg)


def test_docstrings_and_stubs_have_every_option():
    from orograph.options import table

    folder = DATA.parent / "python/orograph"
    stub = (folder / "terrain.pyi").read_text()
    for function, of in (("visible", "VisibleOptions"), ("horizon", "HorizonOptions")):
        text = inspect.getdoc(getattr(orograph.Terrain, function))
        typed = set(re.findall(r"^    (\w+):", stub.split(f"class {of}(")[1].split("\nclass ")[0].split("\ndef ")[0], re.M))
        names = {name.replace("-", "_") for name in table(function)}
        assert len(names) == 10 and typed == names
        assert names <= set(re.findall(r"^ +(\w+)(?: = .*)?$", text, re.M))


def test_stubs_and_docstrings_have_every_array(alps):
    stub = (DATA.parent / "python/orograph/sights.pyi").read_text()
    sights = alps.visible([(512000, 104500)], eye=(515000, 104000))
    horizon = alps.horizon(eye=(515000, 104000), horizon_step=90)
    for table in (sights, horizon):
        name = type(table).__name__
        typed = set(re.findall(r"^    (\w+):", stub.split(f"class {name}:")[1].split("\nclass ")[0], re.M))
        there = {field for field in vars(table) if not field.startswith("_")}
        assert typed == there
        text = re.sub(r", ", ": \n", inspect.getdoc(type(table)))
        assert there <= set(re.findall(r"^ *(\w+):", text, re.M))


def test_geopandas(alps):
    geopandas = pytest.importorskip("geopandas")
    places = np.array([[512000, 104500], [501000, 101000]])
    wanted = alps.visible(places, eye=(515000, 104000))
    frame = wanted.to_geopandas()
    assert frame.crs == geopandas.GeoSeries([], crs=alps.terrain.crs_wkt).crs
    assert frame["state"].tolist() == wanted.state.tolist() and frame.geometry.x.tolist() == places[:, 0].tolist()
    for points in (frame, frame.geometry, frame.to_crs("EPSG:4326")):
        got = alps.visible(points, eye=(515000, 104000))
        assert got.state.tolist() == wanted.state.tolist()
        assert np.allclose(got.distance_m, wanted.distance_m, atol=1e-3)
    lonlat = alps.visible(frame, lonlat=True, eye=(515000, 104000))
    assert lonlat.to_geopandas().crs.to_epsg() == 4326 and abs(lonlat.y).max() < 90
    with pytest.raises(orograph.Error, match="other geometries"):
        alps.visible(frame.buffer(10), eye=(515000, 104000))
    assert len(alps.horizon(eye=(515000, 104000), horizon_step=30).to_geopandas()) == 12
