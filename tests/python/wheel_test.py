# SPDX-License-Identifier: GPL-3.0-or-later
"""What pip is given: a wheel that unpacks to the package, and says what it is."""

import base64
import csv
import hashlib
import importlib.metadata
import importlib.util
import pathlib
import shutil
import subprocess
import sys
import zipfile

import orograph
import pytest
from conftest import ROOT


@pytest.fixture
def backend(monkeypatch):
    spec = importlib.util.spec_from_file_location("wheel_by_cmake", ROOT / "python/wheel_by_cmake.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    package = pathlib.Path(orograph.__file__).parent

    def install(root):  # what CMake has built already
        shutil.copytree(package, root / "orograph", ignore=shutil.ignore_patterns("__pycache__"))

    monkeypatch.setattr(module, "_install", install)
    return module


def test_a_wheel(backend, tmp_path):
    name = backend.build_wheel(tmp_path)
    unpacked = tmp_path / "unpacked"
    with zipfile.ZipFile(tmp_path / name) as wheel:
        wheel.extractall(unpacked)
        names = wheel.namelist()
    info = unpacked / f"orograph-{orograph.__version__}.dist-info"
    assert f"Tag: {name.removesuffix('.whl').removeprefix(f'orograph-{orograph.__version__}-')}\n" in (info / "WHEEL").read_text()
    rows = {row[0]: row[1:] for row in csv.reader((info / "RECORD").read_text().splitlines())}
    assert sorted(rows) == sorted(names)
    for path, (digest, size) in rows.items():
        if path.endswith("RECORD"):
            continue
        content = (unpacked / path).read_bytes()
        assert int(size) == len(content)
        sha256 = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
        assert digest == f"sha256={sha256}"
    (found,) = importlib.metadata.distributions(path=[str(unpacked)])
    assert (found.metadata["Name"], found.version) == ("orograph", orograph.__version__)
    assert [need.split(">")[0] for need in found.requires] == ["numpy"]
    code = "import orograph; print(orograph.__file__)"
    run = subprocess.run([sys.executable, "-B", "-c", code], env={"PYTHONPATH": str(unpacked)}, capture_output=True, text=True)
    assert run.stdout.startswith(str(unpacked)), run.stderr


def test_there_are_no_sources_for_pip(backend, tmp_path):
    with pytest.raises(RuntimeError, match="build a wheel"):
        backend.build_sdist(tmp_path)
