# SPDX-License-Identifier: GPL-3.0-or-later
"""The zip, installed into an empty profile of QGIS and run by qgis_process; where there is none, skipped."""

import json
import os
import re
import shutil
import subprocess
import sys
import zipfile

import pytest
from conftest import DATA, NAME, PROGRAM, ROOT

# Debian's wrapper hands the program an option that only QGIS itself knows.
QGIS = shutil.which("qgis_process.bin") or shutil.which("qgis_process")
if not QGIS:
    pytest.skip("QGIS isn't installed", allow_module_level=True)


@pytest.fixture(scope="module")
def qgis(tmp_path_factory):
    """Runs qgis_process with the plugin enabled."""
    folder = tmp_path_factory.mktemp("qgis")
    told = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True).stdout.split()[1]
    subprocess.run([sys.executable, "-B", ROOT / "qgis" / "make_zip.py", told, folder / "plugin.zip"], check=True)
    zipfile.ZipFile(folder / "plugin.zip").extractall(folder / "plugins")
    (folder / "bin").mkdir()
    (folder / "bin" / "orograph").symlink_to(PROGRAM)
    (folder / "runtime").mkdir(mode=0o700)
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "QGIS_PLUGINPATH": str(folder / "plugins"),
                   "QGIS_CUSTOM_CONFIG_PATH": str(folder / "profile"), "XDG_RUNTIME_DIR": str(folder / "runtime"),
                   "PATH": f"{folder / 'bin'}{os.pathsep}{os.environ['PATH']}"}

    def run(*words, check=True):
        made = subprocess.run([QGIS, *words], capture_output=True, text=True, env=environment, cwd=folder)
        assert made.returncode == 0 or not check, made.stdout + made.stderr
        return made

    run("plugins", "enable", NAME)
    return run


@pytest.fixture(scope="module")
def alps(tmp_path_factory):
    """A copy, since QGIS writes what it finds out of a raster into a file beside it."""
    return shutil.copy(DATA / "fractal_alps.tif", tmp_path_factory.mktemp("dem"))


def test_a_map_from_a_point_in_another_crs(qgis, alps, tmp_path):
    out = tmp_path / "map.svg"
    run = qgis("run", "orograph:perspectivemap", "--", f"INPUT={alps}", "EYE=3.08,0.95 [EPSG:4326]",
               "EYE_HEIGHT=300", "LOOK_AZIMUTH=30", "LAYERS=contours,skyline", "CONTOURS=200m", "PALETTE=map",
               f"DRAPE={DATA / 'fractal_alps_ways.geojson'}|subset=class = 'river'", f"OUTPUT={out}")
    assert "--eye=508900.78" in run.stdout and "--layers=contours,skyline" in run.stdout
    assert "#9c6233" in out.read_text()
    (drape,) = re.findall(r"--drape=(\S+)", run.stdout)
    assert drape.endswith("fractal_alps_ways.gpkg")  # the rivers alone, exported


def test_lines_have_heights_and_places(qgis, alps, tmp_path):
    out = tmp_path / "lines.geojson"
    qgis("run", "orograph:lines", "--", f"INPUT={alps}", "VIEW_FROM=SW/20", "CONTOURS=200m",
         "BBOX=503000,515000,103000,113000 [EPSG:32631]", f"OUTPUT={out}")
    features = json.loads(out.read_text())["features"]
    assert {"contours", "skyline"} <= {feature["properties"]["layer"] for feature in features}
    x, y, z = features[0]["geometry"]["coordinates"][0]
    assert 503000 <= x <= 515000 and 103000 <= y <= 113000 and 0 < z < 5000


def test_points_that_are_seen(qgis, alps, tmp_path):
    places = tmp_path / "places.geojson"
    places.write_text(json.dumps({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"name": name}, "geometry": {"type": "Point", "coordinates": place}}
        for name, place in (("beside the eye", [3.081, 0.95]), ("far outside", [9, 45]))]}))
    out = tmp_path / "seen.geojson"
    qgis("run", "orograph:visible", "--", f"INPUT={alps}", f"POINTS={places}",
         "EYE=3.08,0.95 [EPSG:4326]", "EYE_HEIGHT=50", f"OUTPUT={out}")
    told = {f["properties"]["name"]: f["properties"] for f in json.loads(out.read_text())["features"]}
    assert told["beside the eye"]["state"] == "seen" and told["far outside"]["state"] == "outside"
    assert 110 < told["beside the eye"]["distance_m"] < 113  # 0.001 degrees at the equator


def test_an_error_is_told_in_one_line(qgis, alps, tmp_path):
    run = qgis("run", "orograph:panorama", "--", f"INPUT={alps}", "EYE=1,1 [EPSG:32631]",
               f"OUTPUT={tmp_path / 'x.svg'}", check=False)
    assert run.returncode != 0 and "Traceback" not in run.stdout + run.stderr
    assert not (tmp_path / "x.svg").exists()


def test_lines_are_loaded_as_layers_with_styles(qgis, tmp_path):
    environment = {**os.environ, "XDG_RUNTIME_DIR": str(tmp_path)}
    out = tmp_path / "map.png"
    run = subprocess.run([ROOT / "scripts" / "draw-in-qgis", PROGRAM, out], capture_output=True, text=True,
                         env=environment)
    assert run.returncode == 0, run.stderr
    assert out.read_bytes().startswith(b"\x89PNG") and out.stat().st_size > 50_000
