# SPDX-License-Identifier: GPL-3.0-or-later
# A dataset of rasterio, its profiles coloured by how far from the viewer they are.
# usage: colours_by_depth.py DEM PICTURE
import sys

import matplotlib

matplotlib.use("Agg")
import orograph
import rasterio

dem, picture = sys.argv[1:]
with rasterio.open(dem) as dataset:
    terrain = orograph.terrain(dataset)
drawing = terrain.render(view_from=(200, 20), light="off", spacing="0.8mm")

profiles = drawing.layers["profiles"].strokes
depth = drawing.attributes["depth"][profiles]
ax = drawing.plot(layer="profiles", array=depth, cmap="viridis")
ax.add_collection(drawing.line_collection("skyline", color="black"), autolim=False)
ax.figure.savefig(picture, dpi=150)
