# SPDX-License-Identifier: GPL-3.0-or-later
"""What Python draws and writes is, byte for byte, what the command writes."""

import json
import shlex
import subprocess
import sys

import orograph
import pytest
from conftest import DATA, run_command
from orograph.options import table

VOLCANO = str(DATA / "volcano.tif")
ALPS = str(DATA / "fractal_alps.tif")
WAYS = str(DATA / "fractal_alps_ways.geojson")
VILLAGE = DATA / "scenes/village.toml"

# What is asked of Python by keywords, those of reading apart, and of the command by words.
CASES = [
    ({}, ""),
    ({"view_from": (315, 25), "spacing": "0.6mm"}, "--view-from 315/25 --spacing 0.6mm"),
    ({"view_from": "SW"}, "--view-from SW"),
    ({"view_from": "auto", "profiles": 40}, "--view-from auto --profiles 40"),
    ({"fov": 60.5, "roll": -4}, "--fov 60.5 --roll=-4"),
    ({"projection": "orthographic", "scale": 5000}, "--projection orthographic --scale 5000"),
    ({"oblique": (0.5, 60)}, "--oblique 0.5,60"),
    ({"axonometric": "isometric", "crop": True}, "--axonometric isometric --crop"),
    ({"exaggeration": 2.5, "distance": 4000}, "--exaggeration 2.5 --distance 4000"),
    (
        {"eye": (2667500, 6478800), "eye_height": 40, "look_azimuth": 20, "pitch": -3},
        "--eye 2667500,6478800 --eye-height 40 --look-azimuth 20 --pitch=-3",
    ),
    (
        {"eye": (2667500.5, 6478800, 260), "look_at": (2667700, 6479200)},
        "--eye 2667500.5,6478800,260 --look-at 2667700,6479200",
    ),
    ({"layers": ["border", "skyline", "silhouettes"]}, "--layers border,skyline,silhouettes"),
    (
        {"contours": "20m", "contour_ticks": True, "index_every": 0},
        "--contours 20m --contour-ticks --index-every 0",
    ),
    ({"contours": [110, 150, 180], "palette": "map"}, "--contours 110,150,180 --palette map"),
    (
        {"colour": {"profiles": "navy", "skyline": "#ff0000"}},
        "--colour profiles=navy,skyline=\\#ff0000",
    ),
    (
        {"mesh": 30, "mesh_lines": "x", "layers": ["mesh", "skyline"]},
        "--mesh 30 --mesh-lines x --layers mesh,skyline",
    ),
    (
        {"graticule": "10''", "grid": "200m", "spread": "planes"},
        "--graticule \"10''\" --grid 200m --spread planes",
    ),
    (
        {"light": (90, 30), "light_contrast": 1.5, "haze": 0},
        "--light 90/30 --light-contrast 1.5 --haze 0",
    ),
    ({"light": False, "pen_width": 0.3}, "--light off --pen-width 0.3"),
    (
        {"pen_width": (0.1, 0.4), "page": (200, 120.5), "margin": 5},
        "--pen-width 0.1:0.4 --page 200x120.5 --margin 5",
    ),
    (
        {"page": "a5", "portrait": True, "title": "A – <b>"},
        "--page a5 --portrait --title 'A – <b>'",
    ),
    (
        {"hidden_layers": ["border", "profiles"], "view_from": (200, 12)},
        "--hidden-layers border,profiles --view-from 200/12",
    ),
    (
        {"scene": VILLAGE, "hidden": "dash", "exaggeration": 1},
        f"--scene {VILLAGE} --hidden dash --exaggeration 1",
    ),
    ({"settings": DATA / "settings/plain.toml"}, f"--settings {DATA}/settings/plain.toml"),
    (
        {"pens": DATA / "plotters/three-pens.toml", "clip_to": (200, 150)},
        f"--pens {DATA}/plotters/three-pens.toml --clip-to 200x150",
    ),
    (
        {"view": DATA / "views/three_point.toml", "of": "svg"},
        f"--view {DATA}/views/three_point.toml",
        str(DATA / "islands.tif"),
        {"bbox": (505000, 105000, 512000, 112000)},
        "--bbox 505000,105000,512000,112000",
    ),
    ({"pen_order": "best", "check": 300, "jobs": 1}, "--pen-order best --check 300 -j 1"),
    (
        {"curvature": "on"},
        "--curvature on",
        VOLCANO,
        {"bbox": (2667500, 6478800, 2667900, 6479300), "height_unit": "ft"},
        "--bbox 2667500,6478800,2667900,6479300 --height-unit ft",
    ),
    (
        {"drape": [WAYS], "drape_where": "class = 'river'", "drape_offset": 2},
        f"--drape {WAYS} --drape-where \"class = 'river'\" --drape-offset 2",
        ALPS,
        {"bbox": (502000, 106000, 505000, 110000)},
        "--bbox 502000,106000,505000,110000",
    ),
    (
        {"eye_lonlat": (2.45, 0.15), "look_azimuth": 30, "eye_height": 400},
        "--eye-lonlat 2.45,0.15 --look-azimuth 30 --eye-height 400",
        str(DATA / "archipelago.tif"),
        {"bbox_lonlat": (2.4, 0, 2.6, 0.2)},
        "--bbox-lonlat 2.4,0,2.6,0.2",
    ),
    (
        {"view_from": (205, 30)},
        "--view-from 205/30",
        str(DATA / "quarry_points.csv"),
        {"breaklines": DATA / "quarry_breaklines.geojson", "max_edge": 80},
        f"--breaklines {DATA}/quarry_breaklines.geojson --max-edge 80",
    ),
]

# Of other formats: drawn for SVG and saved, or drawn for them.
FORMATS = [
    ("pdf", {}, ""),
    ("png", {"page": "a6"}, "--page a6 --dpi 100"),
    ("geojson", {"contours": "20m"}, "--contours 20m"),
    ("hpgl", {"of": "hpgl", "device": "hp7475a", "margin": 14}, "--device hp7475a --margin 14"),
    ("gcode", {}, ""),
    ("dxf", {"of": "dxf"}, ""),
]


@pytest.mark.parametrize(
    "options, words, dem, reading, words_of_reading",
    [case if len(case) == 5 else (*case, VOLCANO, {}, "") for case in CASES],
)
def test_same_bytes(options, words, dem, reading, words_of_reading, tmp_path):
    more = shlex.split(words + " " + words_of_reading)
    run_command("render", dem, "map.svg", "--quiet", *more, folder=tmp_path)
    by_command = (tmp_path / "map.svg").read_bytes()
    drawing = orograph.read(dem, **reading).render(**options)
    drawing.save(tmp_path / "python.svg")
    assert len(by_command) > 400
    assert (tmp_path / "python.svg").read_bytes() == by_command
    assert drawing.to_svg().encode() == by_command
    assert drawing._repr_svg_().encode() == by_command


@pytest.mark.parametrize("name, options, words", FORMATS)
def test_other_formats(name, options, words, tmp_path):
    run_command("render", VOLCANO, f"map.{name}", "--quiet", *words.split(), folder=tmp_path)
    drawing = orograph.read(VOLCANO).render(**options)
    drawing.save(tmp_path / f"python.{name}", dpi=100 if name == "png" else None)
    by_command = (tmp_path / f"map.{name}").read_bytes()
    assert len(by_command) > 400
    assert (tmp_path / f"python.{name}").read_bytes() == by_command


def test_sheets(tmp_path):
    options = {"page": "a6", "sheets": (2, 1), "overlap": 5}
    words = ["--page", "a6", "--sheets", "2x1", "--overlap", "5", "--quiet"]
    run_command("render", VOLCANO, "map.svg", *words, folder=tmp_path)
    orograph.read(VOLCANO).render(**options).save(tmp_path / "python.svg")
    for part in ("1", "2", "overview"):
        by_python, by_command = tmp_path / f"python-{part}.svg", tmp_path / f"map-{part}.svg"
        assert by_python.read_bytes() == by_command.read_bytes()


def test_module_is_the_command(tmp_path):
    def module(*words):
        program = [sys.executable, "-m", "orograph", *words]
        return subprocess.run(program, cwd=tmp_path, capture_output=True, text=True)

    for words in ("--version", "render --help", f"info {VOLCANO}", "render no.tif x.svg", "rendr"):
        by_command = run_command(*words.split(), folder=tmp_path, check=False)
        run = module(*words.split())
        for told in ("returncode", "stdout", "stderr"):
            assert getattr(run, told) == getattr(by_command, told)
    run_command("render", VOLCANO, "map.svg", "--quiet", folder=tmp_path)
    assert module("render", VOLCANO, "module.svg").returncode == 0
    assert (tmp_path / "module.svg").read_bytes() == (tmp_path / "map.svg").read_bytes()


def test_a_session_draws_what_a_terrain_does():
    terrain = orograph.read(VOLCANO)
    session = terrain.session()
    for options in ({}, {"scene": VILLAGE}, {"view_from": (30, 40)}, {}):
        assert session.render(**options).to_svg() == terrain.render(**options).to_svg()


def test_the_report_is_the_commands(tmp_path):
    words = ["--contours", "20m", "--report", "map.json", "--quiet"]
    run_command("render", VOLCANO, "map.svg", *words, folder=tmp_path)
    by_command = json.loads((tmp_path / "map.json").read_text())
    by_python = orograph.read(VOLCANO).render(contours="20m").report
    for differs in ("output", "seconds", "peak_memory_bytes"):
        del by_command[differs], by_python[differs]
    for option in table("read"):
        by_command["settings"].pop(option, None)
    assert by_python == by_command
