# SPDX-License-Identifier: GPL-3.0-or-later
"""The algorithms: which command each runs, and which of its options come first or don't apply."""

from dataclasses import dataclass, field
from types import MappingProxyType

from .parameters import parameters_of

_NONE = MappingProxyType({})

# QGIS hands over rasters; surveys and triangles are for the command line.
_OF_SURVEYS = {"input-layer", "repair", "columns", "height-field", "breaklines", "boundary", "max-edge"}
_OF_PANORAMAS = {"azimuth-range", "altitude-range", "strips"}
_OF_PLANE_PICTURES = {"view-from", "oblique", "axonometric", "view", "distance", "pitch", "roll", "scale"}
_OF_PAPER = {"device", "dpi", "pens", "pause-between-pens", "clip-to", "sheets", "overlap", "pen-speed",
             "pen-up-speed", "pen-lift-s", "pen-order", "title", "crop", "colour"}


@dataclass(frozen=True)
class Plan:
    name: str  # behind `orograph:`
    title: str
    about: str
    command: str
    output: str  # drawing, lines or points
    basic: tuple
    left_out: set = field(default_factory=set)
    required: tuple = ()
    changes: dict = field(default_factory=lambda: _NONE)  # by option: what the algorithm has otherwise
    presets: dict = field(default_factory=lambda: _NONE)  # by option: what holds unless something else is set

    def parameters(self, usage):
        return parameters_of(usage, self.basic, self.required, self.left_out, self.changes)

    def options_named(self):
        return {*self.basic, *self.left_out, *self.required, *self.changes, *self.presets}


PERSPECTIVE_MAP = Plan(
    name="perspectivemap",
    title="Perspective map",
    about="Draws a DEM as a perspective map made of clean lines: what the eye couldn't see is cut away, not painted"
          " over. As SVG and HPGL for pen plotters, as PDF and PNG for print and screens, as DXF for lasers.\n\nSet a"
          " side to look from, or a point to stand in. What isn't set is chosen by orograph; the log has the"
          " command line, for use without QGIS.",
    command="render",
    output="drawing",
    basic=("view-from", "eye", "look-at", "bbox", "exaggeration", "layers", "contours", "drape", "palette", "light",
           "spacing", "page"),
    left_out=_OF_SURVEYS | _OF_PANORAMAS,
    changes={"projection": {"choices": ("perspective", "orthographic", "oblique")}},
)

PANORAMA = Plan(
    name="panorama",
    title="Panorama",
    about="Draws what an eye sees all round, or between two azimuths, as clean lines: azimuths to the right, altitudes"
          " upwards. Pick the eye near a summit, and a radius within which it goes to the highest ground.",
    command="render",
    output="drawing",
    basic=("eye", "eye-height", "eye-summit", "projection", "look-azimuth", "azimuth-range", "strips", "bbox",
           "layers", "contours", "drape", "palette", "page"),
    required=("eye",),
    left_out=_OF_SURVEYS | _OF_PLANE_PICTURES,
    changes={"projection": {"choices": ("cylindrical", "equirectangular"), "default": ""}, "fov": {"default": "360"}},
    presets={"projection": "cylindrical"},
)

LINES = Plan(
    name="lines",
    title="Lines back into the map",
    about="The lines of a perspective map, back on the ground: LineStrings with heights in the DEM's CRS, where the"
          " eye sees them, and those that it doesn't see where hidden layers are asked for. Each kind is loaded as a"
          " layer of its own, in the colours of maps.",
    command="render",
    output="lines",
    basic=("view-from", "eye", "look-at", "bbox", "layers", "contours", "hidden-layers", "drape", "spacing"),
    left_out=_OF_SURVEYS | _OF_PAPER,
    presets={"palette": "map"},
)

WHAT_AN_EYE_SEES = Plan(
    name="visible",
    title="What an eye sees",
    about="Tells which of many points an eye sees, by how much the others are hidden (hidden_m, hidden_deg), and in"
          " which azimuth, altitude and distance each is. Points stand on the ground, or the target height above it.",
    command="visible",
    output="points",
    basic=("eye", "eye-height", "eye-summit", "target-height", "bbox"),
    required=("eye",),
    left_out=_OF_SURVEYS,
)

ALL = (PERSPECTIVE_MAP, PANORAMA, LINES, WHAT_AN_EYE_SEES)
