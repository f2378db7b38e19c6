# SPDX-License-Identifier: GPL-3.0-or-later
"""A drawing: strokes as arrays, and the ways out of it."""

import functools
import json
import os
import pathlib
from typing import NamedTuple

import numpy as np

from orograph.errors import error
from orograph.options import named_values, table

# Points to an inch, in which matplotlib has the widths of lines, and mm to one.
_POINTS, _MM = 72, 25.4


class Layer(NamedTuple):
    """A layer of a drawing.

    name: as in `layers`, or its pen's.
    colour: "#rrggbb".
    width_mm: of the pen; strokes may have widths of their own.
    hidden: whether its lines are those that the eye doesn't see.
    strokes: a slice, for `attributes` and `offsets`: which of the drawing's strokes are its.
    """

    name: str
    colour: str
    width_mm: float
    hidden: bool
    strokes: slice


class Drawing:
    """Strokes on a page in mm, x to the right and y down from the upper left corner."""

    def __init__(self, drawn, session, options):
        self._drawn = drawn
        self._session = session
        self._options = options
        self._others = []  # the same view, drawn for other formats

    @property
    def page(self):
        """Width and height in mm."""
        return self._drawn.page_mm

    @property
    def title(self):
        return self._drawn.title

    @functools.cached_property
    def _strokes(self):
        return self._drawn.strokes()

    @property
    def coords(self):
        """(n, 2) float64: the points of all strokes, one stroke behind the other, in mm."""
        return self._strokes["coords"]

    @property
    def offsets(self):
        """(m + 1,) int64: stroke i has coords[offsets[i]:offsets[i + 1]]."""
        return self._strokes["offsets"]

    @property
    def ground(self):
        """(n, 3) float64: where each point of `coords` lies: x and y in the terrain's CRS, height.

        Only of a drawing tied to the ground, as of="geojson" draws it; lines on paper are smoothed
        and cut in ways that places on the ground don't follow. Raises Error for others.
        """
        ground = self._strokes["ground"]
        if ground is None:
            raise error(
                f"strokes drawn for {self._drawn.format} have no places on the ground",
                'give of="geojson" to render',
            )
        return ground

    @functools.cached_property
    def attributes(self):
        """A dict of arrays, one value for each of the m strokes.

        layer: its name. profile: number front to back, from 0; -1 for other lines. depth: distance
        from the viewer in m, NaN where it has no single one. visible: False for hidden lines.
        level: of profiles, how often the number of lines is halved before it goes; -1 for others.
        darkness: 0 to 1 where that is told, else NaN. width_mm. And what its lines are lines of
        tells: the elevation of contours, the fields of draped vectors; None or NaN where it has none.
        """
        strokes, layers = self._strokes, self._drawn.layers()
        number = strokes["layer"]
        attributes = {
            "layer": np.array([layer[0] for layer in layers] or [""])[number],
            "profile": strokes["profile"],
            "depth": strokes["depth"],
            "visible": ~np.array([layer[3] for layer in layers] or [False])[number],
            "level": strokes["level"],
            "darkness": strokes["darkness"],
            "width_mm": strokes["width_mm"],
        }
        rows = [
            layers[of][5][feature] if feature >= 0 else {}
            for of, feature in zip(number.tolist(), strokes["feature"].tolist())
        ]
        for name in dict.fromkeys(name for row in rows for name in row):
            key = name + "_" if name in attributes else name
            attributes[key] = _column([row.get(name) for row in rows])
        return attributes

    @functools.cached_property
    def layers(self):
        """The layers by name, in drawing order, each a Layer."""
        layers = {}
        begin = 0
        for name, colour, width_mm, hidden, count, _ in self._drawn.layers():
            layers[name] = Layer(name, colour, width_mm, hidden, slice(begin, begin + count))
            begin += count
        return layers

    @functools.cached_property
    def report(self):
        """What was drawn, how exactly and in which time: the report of `orograph render`."""
        return json.loads(self._drawn.report())

    def to_svg(self):
        """The text of the SVG that `orograph render` writes."""
        return self._for("svg")._drawn.svg()

    def _repr_svg_(self):
        return self.to_svg()

    def save(self, path, *, overwrite=False, dpi=None, device=None):
        """Writes what `orograph render` writes to such a path, whole or not at all.

        The format is by the path's extension, else that of `of`. Formats for the ground (geojson,
        gpkg) and for pens of one width (hpgl, gcode, dxf) want other strokes than those for paper:
        where these were drawn for another kind of format they are drawn again, by the same options.

        overwrite: may replace a file. dpi: of PNG. device: of HPGL and G-code.
        """
        path = os.fspath(path)
        extension = pathlib.PurePath(path).suffix.lower().removeprefix(".")
        of = extension if extension in table("render")["of"]["choices"] else self._drawn.format
        drawing = self._for(of)
        extra = {"overwrite": overwrite, "dpi": dpi, "device": device}
        extra = {name: value for name, value in extra.items() if value is not None}
        options = {**drawing._options, **extra, "of": of}
        drawing._session._views.save(drawing._drawn, path, named_values("render", options))

    def line_collection(self, layer=None, **kwargs):
        """A matplotlib LineCollection of a layer's strokes, or of all, in mm with y down.

        Its keywords go before the layers' colours and widths: array=… and cmap=… colour strokes by
        a value for each, such as attributes["depth"][layers["profiles"].strokes].
        """
        from matplotlib.collections import LineCollection

        which = self._strokes_of(layer)
        ends = self.offsets[which.start : which.stop + 1].tolist()
        segments = [self.coords[a:b] for a, b in zip(ends, ends[1:])]
        if "array" not in kwargs and not {"color", "colors", "edgecolors"} & kwargs.keys():
            colours = [of.colour for of in self.layers.values()]
            kwargs["colors"] = [colours[i] for i in self._strokes["layer"][which]]
        if not {"linewidth", "linewidths", "lw"} & kwargs.keys():
            kwargs["linewidths"] = self.attributes["width_mm"][which] * _POINTS / _MM
        kwargs.setdefault("capstyle", "round")
        kwargs.setdefault("joinstyle", "round")
        return LineCollection(segments, **kwargs)

    def plot(self, ax=None, **kwargs):
        """Draws all strokes into matplotlib axes, as large as the page fits; returns the axes.

        Without `ax` a figure of the page's size is made. `kwargs` are those of line_collection.
        """
        import matplotlib.pyplot as plt

        width, height = self.page
        if ax is None:
            figure = plt.figure(figsize=(width / _MM, height / _MM))
            ax = figure.add_axes([0, 0, 1, 1])
            ax.set_axis_off()
        ax.set_xlim(0, width)
        ax.set_ylim(height, 0)
        ax.set_aspect("equal")
        lines = self.line_collection(**kwargs)
        if not {"linewidth", "linewidths", "lw"} & kwargs.keys():
            room = ax.get_window_extent()
            points = _POINTS / ax.figure.dpi
            scale = min(room.width * points / width, room.height * points / height) * _MM / _POINTS
            lines.set_linewidths(np.asarray(lines.get_linewidths()) * scale)
        ax.add_collection(lines, autolim=False)
        return ax

    def to_geopandas(self):
        """A GeoDataFrame: a line with heights for each stroke, in the terrain's CRS.

        Its columns are `attributes`. A drawing for paper is drawn again for the ground.
        """
        import geopandas

        drawing = self._for("geojson")
        lines = geopandas.GeoSeries.from_wkb(drawing._wkb(), crs=drawing._drawn.crs_wkt or None)
        return geopandas.GeoDataFrame(drawing.attributes, geometry=lines)

    def __repr__(self):
        width, height = self.page
        return (
            f"<orograph.Drawing {len(self.offsets) - 1} strokes in {len(self.layers)} layers on "
            f"{width:g} x {height:g} mm>"
        )

    def _strokes_of(self, layer):
        if layer is None:
            return slice(0, len(self.offsets) - 1)
        if layer not in self.layers:
            names = ", ".join(self.layers)
            raise error(f"the drawing has no layer {layer!r}", f"one of {names}")
        return self.layers[layer].strokes

    def _for(self, of):
        """The drawing of the same view for a format: itself, or one that is drawn for it."""
        for drawing in (self, *self._others):
            if drawing._drawn.is_drawn_for(of):
                return drawing
        self._others.append(self._session.render(**{**self._options, "of": of}))
        return self._others[-1]

    def _wkb(self):
        """The strokes on the ground as WKB's line strings with Z."""
        head = np.array([1, 0xEA, 3, 0, 0], np.uint8).tobytes()  # little-endian, 1002
        ground = self.ground.astype("<f8", copy=False)
        ends = self.offsets.tolist()
        counts = np.diff(self.offsets).astype("<u4")
        return [
            head + counts[i].tobytes() + ground[ends[i] : ends[i + 1]].tobytes()
            for i in range(len(counts))
        ]


def _column(values):
    """An array of numbers where all are, with NaN for None; else of objects."""
    if all(value is None or isinstance(value, (int, float)) for value in values):
        if all(isinstance(value, int) for value in values):
            return np.array(values, np.int64)
        return np.array([np.nan if value is None else value for value in values], np.float64)
    return np.array(values, object)
