# SPDX-License-Identifier: GPL-3.0-or-later
"""Clean vector perspective maps of terrain: hidden lines are gone, not painted over.

    import orograph

    terrain = orograph.read("dem.tif")                     # or orograph.terrain(z, transform, crs)
    drawing = terrain.render(view_from=(315, 25), spacing="0.6mm")
    drawing.save("map.svg")

`render` takes the options of the command `orograph render` by their names, with underscores:
help(orograph.Terrain.render) lists them.
"""

from orograph._orograph import Error, __version__
from orograph.drawing import Drawing, Layer
from orograph.sights import Horizon, Sights
from orograph.terrain import Session, Terrain, read, terrain, tin

__all__ = [
    "Drawing",
    "Error",
    "Horizon",
    "Layer",
    "Session",
    "Sights",
    "Terrain",
    "read",
    "terrain",
    "tin",
]
