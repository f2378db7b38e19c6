# SPDX-License-Identifier: GPL-3.0-or-later
"""What pip calls to build the package (PEP 517): CMake builds and installs it into a wheel.

No other package is needed for it, but all that building orograph takes (scripts/install-dependencies
build python).
"""

import base64
import hashlib
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
SOURCES = HERE.parent


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    project = tomllib.loads((HERE / "pyproject.toml").read_text())["project"]
    cmake = (SOURCES / "CMakeLists.txt").read_text()
    version = re.search(r"project\(orograph VERSION ([0-9.]+)", cmake)[1]
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    tag = f"{python}-{python}-{platform}"
    name = f"orograph-{version}-{tag}.whl"
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        _install(root)
        info = root / f"orograph-{version}.dist-info"
        info.mkdir()
        needs = "".join(f"Requires-Dist: {package}\n" for package in project["dependencies"])
        (info / "METADATA").write_text(
            f"Metadata-Version: 2.1\nName: {project['name']}\nVersion: {version}\n"
            f"Summary: {project['description']}\nLicense: GPL-3.0-or-later\n"
            f"Requires-Python: {project['requires-python']}\n{needs}"
        )
        (info / "WHEEL").write_text(
            f"Wheel-Version: 1.0\nGenerator: orograph\nRoot-Is-Purelib: false\nTag: {tag}\n"
        )
        _pack(root, info / "RECORD", pathlib.Path(wheel_directory) / name)
    return name


def build_sdist(sdist_directory, config_settings=None):
    raise RuntimeError("orograph's sources are its repository: build a wheel of that")


def _install(root):
    build = SOURCES / "build" / "wheel"
    configure = ["cmake", "-S", SOURCES, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"]
    options = ["-DOROGRAPH_PYTHON=ON", "-DOROGRAPH_TESTS=OFF", "-DOROGRAPH_PYTHON_FOLDER=."]
    subprocess.run([*configure, *options, f"-DPython_EXECUTABLE={sys.executable}"], check=True)
    subprocess.run(["cmake", "--build", build, "--target", "python_package"], check=True)
    install = ["cmake", "--install", build, "--component", "python", "--prefix", root, "--strip"]
    subprocess.run(install, check=True)


def _pack(root, record, wheel):
    lines = []
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as packed:
        for path in sorted(path for path in root.rglob("*") if path.is_file()):
            name = path.relative_to(root).as_posix()
            digest = base64.urlsafe_b64encode(hashlib.sha256(path.read_bytes()).digest())
            lines.append(f"{name},sha256={digest.rstrip(b'=').decode()},{path.stat().st_size}\n")
            packed.write(path, name)
        name = record.relative_to(root).as_posix()
        packed.writestr(name, "".join([*lines, f"{name},,\n"]))
