# SPDX-License-Identifier: GPL-3.0-or-later
"""Perspective maps in QGIS: runs the command orograph."""


def classFactory(iface):
    from .plugin import OrographPlugin

    return OrographPlugin()
