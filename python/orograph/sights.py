# SPDX-License-Identifier: GPL-3.0-or-later
"""What an eye sees without a picture: given places, and its skyline all round."""

import numpy as np

from orograph.errors import error


class _Table:
    """Arrays of equal length by name, a row for each place."""

    def __init__(self, columns, crs_wkt):
        self.__dict__.update(columns)
        self.attributes = columns
        self._crs_wkt = crs_wkt

    def __len__(self):
        return len(self.x)

    def to_geopandas(self):
        """A GeoDataFrame: a point for each row, in the terrain's CRS; its columns are `attributes`."""
        import geopandas

        points = geopandas.points_from_xy(self.x, self.y)
        columns = {name: of for name, of in self.attributes.items() if name not in ("x", "y")}
        return geopandas.GeoDataFrame(columns, geometry=points, crs=self._crs_wkt or None)


class Sights(_Table):
    """What an eye sees of n places, in their order: (n,) arrays of float64 but for the state.

    attributes: all of these in a dict.
    state: "seen", "hidden" by the terrain, "gap" where it has no heights, or "outside" of it.
    hidden_m: by how much the place would have to be higher to be seen, in m; 0 where it is seen.
    hidden_deg: the same as an angle at the eye.
    azimuth_deg: clockwise from true north, of the geodesic from the eye (from the map's north where
        the CRS isn't on the earth).
    altitude_deg: above the eye's horizontal, as a picture has it: curved and refracted.
    distance_m: along the ellipsoid (on the map plane where the CRS isn't on the earth).
    height: of the ground there, in the unit of the terrain's heights.
    x, y: the places, as they were given.

    Of places in a gap and outside only azimuth and distance are known; the rest is NaN.
    """

    def __repr__(self):
        states, counts = np.unique(self.state, return_counts=True)
        told = ", ".join(f"{count} {state}" for state, count in zip(states, counts))
        return f"<orograph.Sights of {len(self)} places: {told}>"


class Horizon(_Table):
    """An eye's skyline, the highest ground in each of n directions, from north clockwise.

    (n,) arrays of float64, NaN in directions without ground:

    attributes: all of these in a dict.
    azimuth_deg: of the direction, from true north (the map's where the CRS isn't on the earth).
    altitude_deg: of the skyline above the eye's horizontal, curved and refracted.
    distance_m: along the ellipsoid, or on the map plane, to where it is.
    longitude, latitude: of that place, in degrees on WGS 84; NaN without a CRS on the earth.
    x, y: the same in the terrain's CRS.
    height: of the ground there, in the unit of the terrain's heights.
    at_border: bool; whether the terrain ends there, so that what is beyond it isn't known.

    most_distant: a dict of the same for the most distant ground that is seen, in these directions
        and others between; None where no ground is seen.
    """

    def __init__(self, columns, crs_wkt):
        self.most_distant = columns.pop("most_distant")
        super().__init__(columns, crs_wkt)

    def __repr__(self):
        return f"<orograph.Horizon in {len(self)} directions>"


def sights(views, points, lonlat, options, progress):
    places = _places(points, lonlat, views.crs_wkt)
    columns = views.visible(places, lonlat, options, progress)
    columns["state"] = np.array(columns["state"], "<U7")
    columns["x"], columns["y"] = places.T
    return Sights(columns, "EPSG:4326" if lonlat else views.crs_wkt)


def horizon(views, options, progress):
    columns = views.horizon(options, progress)
    columns["at_border"] = np.array(columns["at_border"], bool)
    far = columns["most_distant"]
    if far is not None:
        far = {name: np.asarray(values).item() for name, values in far.items()}
    return Horizon({**columns, "most_distant": far}, views.crs_wkt)


def _places(points, lonlat, crs_wkt):
    if hasattr(points, "to_crs") and hasattr(points, "geometry"):  # of geopandas
        points = points.geometry
        wanted = "EPSG:4326" if lonlat else crs_wkt
        if wanted and points.crs is not None:
            points = points.to_crs(wanted)
        if not (points.geom_type == "Point").all() or points.is_empty.any():
            raise error("points hold other geometries", "give points, as those of `.centroid`")
        return np.column_stack([points.x, points.y]).astype(np.float64)
    array = np.asarray(points)
    if array.shape == (2,):
        array = array[np.newaxis]
    if array.ndim != 2 or array.shape[1] != 2 or array.dtype.kind not in "fiu":
        shape = " x ".join(map(str, array.shape)) or "a single value"
        what = "longitude and latitude" if lonlat else "x and y in the terrain's CRS"
        raise error(f"points are {shape} of {array.dtype}", f"give a row of {what} for each")
    places = array.astype(np.float64)
    if lonlat and (abs(places[:, 1]) > 90).any():
        latitude = places[:, 1][abs(places[:, 1]) > 90][0]
        raise error(f"points have {latitude:g} for a latitude", "give longitude first")
    return places
