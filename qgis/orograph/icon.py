# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture beside the provider and its algorithms."""

import pathlib

from qgis.PyQt.QtGui import QIcon

PATH = str(pathlib.Path(__file__).parent / "icon.svg")


def icon():
    return QIcon(PATH)
