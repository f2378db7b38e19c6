# SPDX-License-Identifier: GPL-3.0-or-later
"""Styles have the command's colours; the zip is whole, and the same each time."""

import configparser
import json
import os
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml
import zipfile

import pytest
from conftest import DATA, PLUGIN, PROGRAM, ROOT

STYLES = sorted((PLUGIN / "styles").glob("*.qml"))


def colours_in(style):
    """Of each rule by the value of `visible`, as #rrggbb."""
    tree = xml.parse(style)
    colours = {}
    for symbol in tree.iter("symbol"):
        told = {option.get("name"): option.get("value") for option in symbol.iter("Option")}
        colours[symbol.get("name")] = "#%02x%02x%02x" % tuple(map(int, told["line_color"].split(",")[:3]))
    rules = {rule.get("filter"): colours[rule.get("symbol")] for rule in tree.iter("rule")}
    return {seen: rules[f'"visible" = {seen}'] for seen in (1, 0) if f'"visible" = {seen}' in rules}


@pytest.fixture(scope="session")
def strokes(tmp_path_factory, usages):
    """Colours that the command draws by layer: of all layers that a terrain has, hidden ones too."""
    folder = tmp_path_factory.mktemp("strokes")
    out, line = folder / "islands.geojson", folder / "line.geojson"
    line.write_text('{"type": "LineString", "coordinates": [[3.01, 0.91], [3.2, 1.07]]}')
    all_layers = usages["render"].arguments["layers"].choices
    below = [name for name in all_layers if name.startswith("underside")]  # which go with no block
    layers = [name for name in all_layers if name not in ("pen-up", "solids", *below)]
    hidden = [name for name in usages["render"].arguments["hidden-layers"].choices if name != "solids"]
    subprocess.run([PROGRAM, "render", DATA / "islands.tif", out, "--quiet", "--palette=map", "--contours=auto",
                    "--mesh=20", "--graticule=auto", "--grid=auto", "--flat=waterlines", f"--drape={line}",
                    f"--layers={','.join(layers)}", f"--hidden-layers={','.join(hidden)}", "--exaggeration=4",
                    "--view-from=200/10", "--bbox=503000,104000,511000,110000"], check=True)
    from_below = folder / "from-below.geojson"
    subprocess.run([PROGRAM, "render", DATA / "islands.tif", from_below, "--quiet", "--palette=map", "--underside=draw",
                    f"--layers=profiles,{','.join(below)}", "--exaggeration=4", "--view-from=200/-20"], check=True)
    found = {}
    for drawing in (out, from_below):
        for feature in json.loads(drawing.read_text())["features"]:
            found[feature["properties"]["layer"]] = feature["properties"]["stroke"]
    return found


def test_there_is_a_style_for_every_kind(usages):
    wanted = {name for name in usages["render"].arguments["layers"].choices if name != "pen-up"}
    assert {style.stem for style in STYLES} == wanted


def test_colours_are_the_palettes(strokes):
    compared = 0
    for style in STYLES:
        colours = colours_in(style)
        for name, seen in ((style.stem, 1), (f"hidden-{style.stem}", 0)):
            if name in strokes:
                assert colours[seen] == strokes[name], name
                compared += 1
    assert compared >= 20


def test_the_zip_is_the_same_each_time(tmp_path):
    copy = tmp_path / "copy"
    shutil.copytree(ROOT / "qgis", copy / "qgis", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "LICENSE", copy)
    for path in copy.rglob("*"):
        os.utime(path, (1e9, 1e9))
        path.chmod(0o700)
    (copy / "qgis" / "orograph" / "__pycache__").mkdir()
    (copy / "qgis" / "orograph" / "__pycache__" / "usage.pyc").write_text("stale")
    version = configparser.ConfigParser()
    version.read(PLUGIN / "metadata.txt")
    for root in (ROOT, copy):
        subprocess.run([sys.executable, "-B", root / "qgis" / "make_zip.py", version["general"]["version"],
                        tmp_path / f"{root.name}.zip"], check=True)
    made = tmp_path / "copy.zip"
    assert made.read_bytes() == (tmp_path / f"{ROOT.name}.zip").read_bytes()
    names = zipfile.ZipFile(made).namelist()
    assert {f"orograph_processing/{name}" for name in ("__init__.py", "metadata.txt", "LICENSE", "icon.svg",
                                                       "styles/contours.qml")} <= set(names)
    assert not [name for name in names if "pycache" in name or not name.startswith("orograph_processing/")]


def test_the_zip_has_the_projects_version(tmp_path):
    run = subprocess.run([sys.executable, "-B", ROOT / "qgis" / "make_zip.py", "9.9.9", tmp_path / "x.zip"],
                         capture_output=True, text=True)
    assert run.returncode == 1 and "has to be 9.9.9" in run.stderr
    told = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True).stdout.split()[1]
    subprocess.run([sys.executable, "-B", ROOT / "qgis" / "make_zip.py", told, tmp_path / "x.zip"], check=True)


def test_metadata_says_what_qgis_needs():
    metadata = configparser.ConfigParser(interpolation=None)
    metadata.read(PLUGIN / "metadata.txt")
    general = metadata["general"]
    assert general["hasProcessingProvider"] == "yes" and general["qgisMinimumVersion"] == "3.22"
    assert (PLUGIN / general["icon"]).exists()
