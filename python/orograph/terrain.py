# SPDX-License-Identifier: GPL-3.0-or-later
"""Terrains, from files and from arrays, and the views of them."""

import os

import numpy as np

from orograph import _orograph, sights
from orograph.drawing import Drawing
from orograph.errors import error
from orograph.heights import borrowable, crs_text, geotransform_of, unpacked
from orograph.options import describe, named_values


def read(paths, **options):
    terrain_paths = [paths] if isinstance(paths, (str, os.PathLike)) else list(paths)
    texts = [os.fspath(path) for path in terrain_paths]
    return Terrain(_orograph.read(texts, named_values("read", options)))


read.__doc__ = """The terrain of a file, or of several rasters whose cells are on one lattice.

paths: a path or a sequence of them: whatever GDAL opens as a raster; triangles in OFF, PLY, OBJ,
STL, LandXML or a vector file; points in text or a vector file.

Returns a Terrain. Raises Error where a file can't be used.
""" + describe("read")


def terrain(z, transform=None, crs=None, nodata=None, *, height_unit="m", name="heights"):
    """The terrain of an array of heights, a row for each line of cells.

    z: (rows, columns), at least 2 x 2, of real numbers; or a dataset of rasterio, or a DataArray of
        xarray, which tell the next three themselves. float32 or float64 in C order, first row in
        the north, in metres and with NaN where there is no height isn't copied: it is kept as long
        as the terrain is, and mustn't be changed. All else is copied, at 4 bytes a height (8 of
        float64, and of whole numbers above 2**24).
    transform: an affine.Affine, or GDAL's six numbers (x, width, 0, y, 0, -height): the upper left
        corner and the size of a cell in units of the CRS. A height is at its cell's centre.
    crs: WKT, "EPSG:32632", 32632, or what has `to_wkt`; None: none, and units are metres.
    nodata: the number that means no height, as NaN and infinities do.
    height_unit: m, ft, us-ft, km, dm, cm or mm.
    name: what messages and titles call it.

    Returns a Terrain: the same as of a file that holds the same heights. Raises Error where they
    are no terrain.
    """
    z, transform, crs, nodata = unpacked(z, transform, crs, nodata)
    heights = borrowable(z)
    return Terrain(
        _orograph.terrain(
            heights,
            geotransform_of(transform),
            crs_text(crs),
            None if nodata is None else float(nodata),
            height_unit,
            name,
        )
    )


def tin(vertices, triangles, crs=None, *, height_unit="m", repair=False, name="triangles"):
    """The terrain of triangles.

    vertices: (n, 3) numbers: x and y in a projected CRS, height.
    triangles: (m, 3) whole numbers, which vertices each has, from 0, in any orientation.
    crs: as in `terrain`; None: none, and units are metres.
    repair: reduce triangles that lie above each other to their upper surface.

    Returns a Terrain. Raises Error where they are no surface with one height at each place.
    """
    points, corners = np.asarray(vertices), np.asarray(triangles)
    for array, argument, kinds, what in (
        (points, "vertices", "fiu", "x, y and height"),
        (corners, "triangles", "iu", "whole numbers of three vertices"),
    ):
        if array.ndim != 2 or array.shape[1] != 3 or array.dtype.kind not in kinds:
            shape = " x ".join(map(str, array.shape))
            raise error(f"{argument} are {shape} of {array.dtype}", f"give a row of {what} for each")
    if corners.size and (corners.min() < 0 or corners.max() >= len(points)):
        wrong = corners.min() if corners.min() < 0 else corners.max()
        raise error(
            f"a triangle has vertex {wrong}, and there are {len(points)}", "vertices count from 0"
        )
    return Terrain(
        _orograph.tin(
            points.astype(np.float64),
            corners.astype(np.uint32),
            crs_text(crs),
            height_unit,
            repair,
            name,
        )
    )


class Session:
    """Views of one terrain: what holds for all of them is found once, by the first.

    Also the files that `scene` and `drape` name are read once, as long as views name the same.
    Several threads may use one session at a time.
    """

    __slots__ = ("_views", "terrain")

    def __init__(self, terrain):
        self.terrain = terrain
        self._views = terrain._views.another()

    def render(self, *, progress=None, **options):
        """A view, as Terrain.render draws it."""
        drawn = self._views.draw(named_values("render", options), progress)
        return Drawing(drawn, self, options)

    def visible(self, points, *, lonlat=False, progress=None, **options):
        """What an eye sees of many places, as Terrain.visible tells it."""
        named = named_values("visible", options)
        return sights.sights(self._views, points, lonlat, named, progress)

    def horizon(self, *, progress=None, **options):
        """The skyline of an eye, as Terrain.horizon tells it."""
        return sights.horizon(self._views, named_values("horizon", options), progress)

    def __repr__(self):
        return f"<orograph.Session of {self.terrain.name}>"


class Terrain:
    """A surface with one height at each place: a DEM or a TIN. It never changes."""

    __slots__ = ("_views",)

    def __init__(self, views):
        self._views = views

    @property
    def name(self):
        """What it was read from, in brief."""
        return self._views.name

    @property
    def crs_wkt(self):
        """WKT of its CRS; empty where it has none."""
        return self._views.crs_wkt

    @property
    def notes(self):
        """What was assumed when it was read, a sentence each."""
        return self._views.notes

    def session(self):
        """A Session, for many views of this terrain."""
        return Session(self)

    def render(self, *, progress=None, **options):
        return self.session().render(progress=progress, **options)

    def visible(self, points, *, lonlat=False, progress=None, **options):
        return self.session().visible(points, lonlat=lonlat, progress=progress, **options)

    def horizon(self, *, progress=None, **options):
        return self.session().horizon(progress=progress, **options)

    def __repr__(self):
        return f"<orograph.Terrain {self.name}>"


Terrain.render.__doc__ = """A map of the terrain: what `orograph render` draws by the same options.

progress: a function that is told the share done, 0 to 1, some hundred times a second at most, on
    the thread that called. What it raises ends the drawing and goes on to the caller.

Each option is a number, a text as the command takes it, several in a tuple or list, or a path:
view_from=(315, 25), spacing="0.6mm", page=(400, 250), layers=["contours", "skyline"]. None is the
default. Other threads go on meanwhile; Ctrl-C ends the drawing within a tenth of a second.

Returns a Drawing, for paper unless `of` says otherwise. Raises Error, which says what is wrong with
an option and what would be right, and also where nothing of the terrain is on the page.
""" + describe("render")

Terrain.visible.__doc__ = """Which of many places an eye sees, and by how much others are hidden.

points: (n, 2) numbers: x and y in the terrain's CRS; or points of geopandas, which are brought into
    it. They are on the ground, or target_height above it.
lonlat: whether points are longitudes and latitudes, in degrees on WGS 84.
progress: as in `render`.

    sights = terrain.visible([(508000, 104500), (512000, 106000)], eye=(515000, 104000))
    sights.state, sights.hidden_m, sights.distance_m

Returns a Sights, with the numbers of `orograph visible`. Raises Error where there is no eye, or it
is under the ground.
""" + describe("visible")

Terrain.horizon.__doc__ = """The skyline of an eye: where the ground stands highest, all round.

progress: as in `render`.

    horizon = terrain.horizon(eye_lonlat=(7.66, 45.98), horizon_step=0.5)
    horizon.azimuth_deg, horizon.altitude_deg, horizon.distance_m

Returns a Horizon, with the numbers of `--horizon-table`. Raises the Errors of `visible`.
""" + describe("horizon")
