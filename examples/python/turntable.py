# SPDX-License-Identifier: GPL-3.0-or-later
# A terrain from all around: 36 views with one session, which finds what holds for all of them once.
# usage: turntable.py DEM FOLDER
import pathlib
import sys

import orograph

dem, folder = sys.argv[1], pathlib.Path(sys.argv[2])
folder.mkdir(exist_ok=True)
session = orograph.read(dem).session()
for azimuth in range(0, 360, 10):
    drawing = session.render(view_from=(azimuth, 25), page="a5")
    drawing.save(folder / f"view-{azimuth:03}.svg", overwrite=True)
    print(f"{azimuth:3} degrees: {len(drawing.offsets) - 1} strokes")
