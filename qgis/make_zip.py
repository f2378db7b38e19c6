#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the zip that QGIS installs (Plugins, Install from ZIP) of the plugin's folder and the licence.

The same files give the same bytes, whoever owns them and whenever they were written.
usage: qgis/make_zip.py VERSION OUT.zip"""

import configparser
import pathlib
import sys
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PLUGIN = ROOT / "qgis" / "orograph"

# What the folder is called where it is installed. `orograph` is the Python package's name, which would
# be hidden in QGIS by a plugin that is called so.
FOLDER = "orograph_processing"

KEPT = {".py", ".txt", ".svg", ".qml"}
EARLIEST = (1980, 1, 1, 0, 0, 0)  # that a zip can tell


def version_told():
    metadata = configparser.ConfigParser(interpolation=None)
    metadata.read(PLUGIN / "metadata.txt", encoding="utf-8")
    return metadata["general"]["version"]


def files():
    """Name in the zip, and path."""
    found = {f"{FOLDER}/LICENSE": ROOT / "LICENSE"}
    for path in PLUGIN.rglob("*"):
        if path.suffix in KEPT:
            found[f"{FOLDER}/{path.relative_to(PLUGIN).as_posix()}"] = path
    return sorted(found.items())


def main(version, out):
    if version_told() != version:
        sys.exit(f"make_zip: error: {PLUGIN / 'metadata.txt'} is of version {version_told()}: it has to be {version}")
    with zipfile.ZipFile(out, "w") as made:
        for name, path in files():
            info = zipfile.ZipInfo(name, EARLIEST)
            info.create_system = 3  # Unix, whose rights these are
            info.external_attr = 0o100644 << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            made.writestr(info, path.read_bytes(), compresslevel=9)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
