# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameters are those of the command that is there, and command lines are what it takes."""

import subprocess

import pytest
from conftest import DATA, PROGRAM
from orograph_processing.command_line import words_of
from orograph_processing.parameters import EXAMPLES, NEVER
from orograph_processing.plans import ALL, LINES, PANORAMA, PERSPECTIVE_MAP, WHAT_AN_EYE_SEES

PLANS = pytest.mark.parametrize("plan", ALL, ids=lambda plan: plan.name)


def by_name(plan, usages):
    return {p.name: p for p in plan.parameters(usages[plan.command])}


@PLANS
def test_every_option_is_a_parameter_or_left_out_on_purpose(plan, usages):
    usage = usages[plan.command]
    parameters = plan.parameters(usage)
    options = {p.argument.name for p in parameters}
    assert options | plan.left_out | NEVER >= {argument.name for argument in usage.options}
    assert not options & (plan.left_out | NEVER)
    assert len({p.name for p in parameters}) == len(parameters)


@PLANS
def test_plans_name_only_options_that_there_are(plan, usages):
    there = {argument.name for argument in usages["render"].options} | {a.name for a in usages["visible"].options}
    assert plan.options_named() - plan.left_out <= {a.name for a in usages[plan.command].options}
    assert plan.left_out | NEVER <= there


@PLANS
def test_basic_parameters_come_first(plan, usages):
    parameters = plan.parameters(usages[plan.command])
    advanced = [p.is_advanced for p in parameters]
    assert advanced == sorted(advanced)
    basic = [p.argument.name for p in parameters if not p.is_advanced]
    assert basic == list(plan.basic)


def test_kinds(usages):
    parameters = by_name(PERSPECTIVE_MAP, usages)
    kinds = {name: parameters[name].kind for name in (
        "BAND", "BBOX", "EYE", "EYE_Z", "FOV", "CROP", "LAYERS", "PALETTE", "PROFILES", "DRAPE", "SCENE", "REPORT",
        "HORIZON_TABLE", "VIEW_FROM", "COLOUR", "EYE_SUMMIT", "DEVICE", "CONTOURS")}
    assert kinds == {
        "BAND": "band", "BBOX": "extent", "EYE": "point", "EYE_Z": "height", "FOV": "real", "CROP": "switch",
        "LAYERS": "list", "PALETTE": "choice", "PROFILES": "whole", "DRAPE": "vectors", "SCENE": "file",
        "REPORT": "written", "HORIZON_TABLE": "written", "VIEW_FROM": "text", "COLOUR": "texts", "EYE_SUMMIT": "real",
        "DEVICE": "text", "CONTOURS": "text"}


def test_labels_and_help(usages):
    parameters = by_name(PERSPECTIVE_MAP, usages)
    assert parameters["FOV"].label == "Field of view (degrees; else 30)"
    assert by_name(PANORAMA, usages)["FOV"].label == "Field of view (degrees; else 360)"
    assert parameters["VIEW_FROM"].label == "Seen from (such as 225/20, NW or auto; else 180/25)"
    assert parameters["CLIP_TO"].label == "Clip to (WIDTHxHEIGHT)"
    assert parameters["EYE_HEIGHT"].help.endswith("metres, above 0 [2] (--eye-height)")
    assert not parameters["EYE"].is_advanced and parameters["EYE_Z"].is_advanced


def test_examples_are_taken(usages, tmp_path):
    for name, example in EXAMPLES.items():
        for i, value in enumerate(example.replace(" or ", ", ").split(", ")):
            eye = ["--eye=508000,104500", "--projection=cylindrical"] if name == "azimuth-range" else []
            subprocess.run([PROGRAM, "render", DATA / ("fractal_alps.tif" if eye else "cone.tif"),
                            tmp_path / f"{name}-{i}.svg", f"--{name}={value}", "--quiet", "--layers=skyline", *eye],
                           check=True)


def test_panoramas_have_their_own_choices(usages):
    assert by_name(PANORAMA, usages)["PROJECTION"].argument.choices == ("cylindrical", "equirectangular")
    assert "cylindrical" not in by_name(PERSPECTIVE_MAP, usages)["PROJECTION"].argument.choices
    assert by_name(PANORAMA, usages)["EYE"].is_required


VALUES = {
    "BAND": 1, "BBOX": (503000.5, 100000, 522000, 119000.25), "FOV": 40.0, "CROP": True, "PORTRAIT": False,
    "LAYERS": ["contours", "skyline"], "CONTOURS": "100m", "PALETTE": "map", "EYE": (508000.0, 104500.0),
    "EYE_Z": 3300.0, "LOOK_AZIMUTH": 40.0, "PITCH": -4.5, "COLOUR": "contours=brown\n\nskyline=#102030\n",
    "DRAPE": [str(DATA / "fractal_alps_ways.geojson")], "TITLE": "two words", "MIN_STROKE": 0.0, "PAGE": "",
    "SPACING": None}
WORDS = [
    "--bbox=503000.5,100000,522000,119000.25", "--layers=contours,skyline", "--contours=100m",
    f"--drape={DATA / 'fractal_alps_ways.geojson'}", "--palette=map", "--band=1", "--fov=40",
    "--eye=508000,104500,3300", "--look-azimuth=40", "--pitch=-4.5", "--min-stroke=0", "--colour=contours=brown",
    "--colour=skyline=#102030", "--crop", "--title=two words"]


def test_the_words_of_values_are_what_the_command_takes(usages, tmp_path):
    words = words_of(PERSPECTIVE_MAP.parameters(usages["render"]), VALUES)
    assert sorted(words) == sorted(WORDS)
    out = tmp_path / "alps.svg"
    subprocess.run([PROGRAM, "render", str(DATA / "fractal_alps.tif"), str(out), *words, "--quiet"], check=True)
    text = out.read_text()
    assert "two words" in text and "#102030" in text


def test_nothing_set_is_no_word(usages):
    for plan in ALL:
        assert words_of(plan.parameters(usages[plan.command]), {}) == []


def test_a_point_of_visible(usages, tmp_path):
    words = words_of(WHAT_AN_EYE_SEES.parameters(usages["visible"]),
                     {"EYE": (508000.0, 104500.0), "EYE_SUMMIT": 500.0, "TARGET_HEIGHT": 3.5})
    assert words == ["--eye=508000,104500", "--eye-summit=500", "--target-height=3.5"]
    run = subprocess.run([PROGRAM, "visible", str(DATA / "fractal_alps.tif"), str(DATA / "fractal_alps_summits.csv"),
                          *words], capture_output=True, text=True, check=True)
    assert ",seen," in run.stdout


def test_lines_have_no_parameter_for_paper(usages):
    names = set(by_name(LINES, usages))
    assert {"CONTOURS", "HIDDEN_LAYERS", "SPACING"} <= names and not {"PENS", "SHEETS", "DPI"} & names
