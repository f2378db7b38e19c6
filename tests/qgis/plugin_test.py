# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin as QGIS starts it, with a stand-in for QGIS: its algorithms, and the command lines that they run."""

import shlex
import sys

import pytest
import stand_in
from conftest import DATA, NAME, PROGRAM

ALPS = str(DATA / "fractal_alps.tif")


@pytest.fixture
def plugin(monkeypatch):
    """The plugin's modules anew, on the stand-in."""
    kept = {name: module for name, module in sys.modules.items() if name.startswith(NAME)}
    for name, module in stand_in.modules().items():
        monkeypatch.setitem(sys.modules, name, module)
    monkeypatch.setattr(f"{NAME}.run_command._NAME", PROGRAM)  # which `which` takes as a path
    made = sys.modules[NAME].classFactory(None)
    yield made
    for name in [name for name in sys.modules if name.startswith(NAME) and name not in kept]:
        del sys.modules[name]


@pytest.fixture
def provider(plugin):
    plugin.initProcessing()
    (made,) = sys.modules["qgis.core"].QgsApplication.processingRegistry().providers
    return made


def started(provider, name):
    algorithm = {a.name(): a for a in provider.algorithms}[name].createInstance()
    algorithm.initAlgorithm()
    return algorithm


def test_the_provider_comes_and_goes(plugin):
    plugin.initGui()
    registry = sys.modules["qgis.core"].QgsApplication.processingRegistry()
    (provider,) = registry.providers
    assert provider.id() == "orograph" and provider.warningMessage() == ""
    assert [a.name() for a in provider.algorithms] == ["perspectivemap", "panorama", "lines", "visible"]
    plugin.unload()
    assert not registry.providers and not stand_in.ProcessingConfig.settings


def test_without_the_command_there_is_a_warning(provider):
    setting = stand_in.ProcessingConfig.settings["OROGRAPH_PROGRAM"]
    changed = sys.modules["processing.core.ProcessingConfig"].settingsWatcher.settingsChanged
    setting.value = "/nowhere/orograph"
    changed.emit()
    assert provider.algorithms == [] and "/nowhere/orograph" in provider.warningMessage()
    setting.value = PROGRAM
    changed.emit()
    assert len(provider.algorithms) == 4 and provider.warningMessage() == ""


@pytest.mark.parametrize("name", ["perspectivemap", "panorama", "lines", "visible"])
def test_parameters(provider, name):
    algorithm = started(provider, name)
    names = list(algorithm.definitions)
    assert names[0] == "INPUT" and names[-1] == "OUTPUT"
    assert "TILES" in names and ("POINTS" in names) == (name == "visible")
    basic = [n for n, d in algorithm.definitions.items() if not d.flags() & stand_in.Definition.FlagAdvanced]
    assert 5 <= len(basic) <= 20
    assert algorithm.displayName() and algorithm.shortHelpString() and algorithm.icon()[1].endswith("icon.svg")
    if name != "visible":
        fov = algorithm.definitions["FOV"]
        assert (fov.least, fov.greatest) == (0, 360) and "--fov" in fov.help


def test_a_map_is_drawn_by_the_command(provider, tmp_path):
    out = str(tmp_path / "map.svg")
    feedback = stand_in.Feedback()
    algorithm = started(provider, "perspectivemap")
    results = algorithm.processAlgorithm(
        {"INPUT": stand_in.RasterLayer(ALPS + "|option:NUM_THREADS=2"), "EYE": (508000, 104500), "EYE_Z": 3300.0,
         "LOOK_AZIMUTH": 40.0, "FOV": 60.0, "BBOX": (503000, 100000, 522000, 119000), "LAYERS": ["profiles", "skyline"],
         "CROP": True, "SPACING": "2mm", "OUTPUT": out}, None, feedback)
    assert results == {"OUTPUT": out}
    assert (tmp_path / "map.svg").stat().st_size > 1000
    assert feedback.percents[-1] == 100 and "strokes" in feedback.lines[-1]
    (command,) = feedback.commands
    assert shlex.split(command) == [
        PROGRAM, "render", ALPS, out, "--oo=NUM_THREADS=2", "--eye=508000,104500,3300",
        "--bbox=503000,100000,522000,119000", "--layers=profiles,skyline", "--spacing=2mm", "--fov=60",
        "--look-azimuth=40", "--crop", "--overwrite", "--progress"]


def test_a_panorama_is_one_without_being_told(provider, tmp_path):
    feedback = stand_in.Feedback()
    started(provider, "panorama").processAlgorithm(
        {"INPUT": stand_in.RasterLayer(ALPS), "EYE": (516000, 104000), "EYE_HEIGHT": 40.0, "SPACING": "2mm",
         "REPORT": str(tmp_path / "p.json"), "OUTPUT": str(tmp_path / "p.svg")}, None, feedback)
    assert "--projection=cylindrical" in feedback.commands[0] and "panorama of 360" in feedback.lines[-1]
    assert (tmp_path / "p.json").exists()


@pytest.mark.parametrize("values, told", [
    ({"VIEW_FROM": "nowhere"}, "--view-from 'nowhere' can't be used"),
    ({"INPUT": stand_in.RasterLayer("/no/dem.tif")}, "/no/dem.tif"),
    ({"INPUT": stand_in.RasterLayer("url=tiles", "wms")}, "comes from a service"),
    ({"INPUT": None}, "no raster"),
])
def test_errors_are_one_line(provider, tmp_path, values, told):
    algorithm = started(provider, "perspectivemap")
    with pytest.raises(stand_in.QgsProcessingException, match=told) as error:
        algorithm.processAlgorithm({"INPUT": stand_in.RasterLayer(ALPS), "OUTPUT": str(tmp_path / "x.svg"), **values},
                                   None, stand_in.Feedback())
    assert "\n" not in str(error.value)
    assert not list(tmp_path.iterdir())


def test_cancelling_is_no_error_and_leaves_no_file(provider, tmp_path):
    feedback = stand_in.Feedback()
    feedback.isCanceled = lambda: True
    results = started(provider, "perspectivemap").processAlgorithm(
        {"INPUT": stand_in.RasterLayer(ALPS), "SPACING": "0.05mm", "OUTPUT": str(tmp_path / "x.svg")}, None, feedback)
    assert results == {} and not list(tmp_path.iterdir())
