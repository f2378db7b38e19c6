# SPDX-License-Identifier: GPL-3.0-or-later
"""What the plugin's tests share. OROGRAPH_PROGRAM names the command.

The plugin is imported by the name that its folder has where it is installed."""

import importlib.util
import os
import pathlib
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PLUGIN = ROOT / "qgis" / "orograph"
DATA = ROOT / "data_samples"
NAME = "orograph_processing"
PROGRAM = os.environ["OROGRAPH_PROGRAM"]

_spec = importlib.util.spec_from_file_location(NAME, PLUGIN / "__init__.py", submodule_search_locations=[str(PLUGIN)])
sys.modules[NAME] = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(sys.modules[NAME])


@pytest.fixture(scope="session")
def usages():
    from orograph_processing.usage import ask_usage

    return {command: ask_usage(PROGRAM, command) for command in ("render", "visible")}
