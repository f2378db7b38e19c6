# SPDX-License-Identifier: GPL-3.0-or-later
"""Which parameters an algorithm has: made from the command's options, none of which is named twice.

A parameter that isn't set isn't in the command line, so that the command's own default holds, which
often depends on what else is asked. The label tells it."""

from dataclasses import dataclass, replace

from .usage import Argument

# Kinds that options of a type don't tell by themselves. A point is picked on the map, and where it may
# have a height, that is a parameter of its own.
_POINT, _POINT_WITH_HEIGHT = "X,Y", "X,Y[,Z]"
_EXTENT = "XMIN,YMIN,XMAX,YMAX"
_VECTORS = "FILE[:LAYER]"
_WRITTEN_FILES = {"report", "horizon-table"}

# By the map's own pickers, which know CRSs; by QGIS; and by what each algorithm does itself.
NEVER = {"bbox-lonlat", "eye-lonlat", "look-at-lonlat", "oo", "of", "output", "overwrite", "quiet",
         "progress", "no-progress", "help", "help-all"}


@dataclass(frozen=True)
class Parameter:
    name: str  # as scripts and qgis_process call it: VIEW_FROM
    kind: str  # switch, whole, real, choice, list, text, texts, file, written, vectors, point, height, extent, band
    label: str
    help: str
    is_advanced: bool
    argument: Argument
    is_required: bool = False

    @property
    def option(self):
        return "--" + self.argument.name


def kind_of(argument):
    if argument.type == "boolean":
        return "switch"
    if argument.name == "band":
        return "band"
    if argument.metavar in (_POINT, _POINT_WITH_HEIGHT):
        return "point"
    if argument.metavar == _EXTENT:
        return "extent"
    if argument.metavar == _VECTORS:
        return "vectors"
    if argument.name in _WRITTEN_FILES:
        return "written"
    if argument.metavar == "FILE":
        return "file"
    if argument.is_list:
        return "list"
    if argument.choices:
        return "choice"
    if argument.type in ("integer", "real"):
        return "whole" if argument.type == "integer" else "real"
    return "texts" if argument.is_repeatable else "text"


# Where the option's name isn't what one looks for in a dialogue.
_LABELS = {
    "bbox": "Extent",
    "contours": "Contours every",
    "dpi": "Resolution",
    "drape": "Layers to lay on the ground",
    "eye": "Eye, a point to stand in",
    "eye-height": "Eye above the ground",
    "eye-summit": "Eye goes to the highest ground within",
    "fov": "Field of view",
    "hidden-layers": "Hidden lines of",
    "jobs": "Cores",
    "layers": "Kinds of lines",
    "light": "Light from",
    "look-at": "Look at",
    "page": "Paper",
    "palette": "Colours",
    "spacing": "Distance between profiles",
    "target-height": "Points above the ground",
    "view-from": "Seen from",
}

# Of texts that people write most: what one looks like says more than what it is made of.
EXAMPLES = {
    "azimuth-range": "120:240",
    "contours": "100m",
    "exaggeration": "1.5",
    "light": "315/35 or off",
    "page": "a3 or 400xauto",
    "spacing": "0.8mm or 100m",
    "view-from": "225/20, NW or auto",
}


def _name_of(argument):
    return argument.name.replace("-", "_").upper()


def _label_of(argument, kind):
    """`Field of view (degrees; else 30)`: what it is, in what, and what holds where it isn't set."""
    words = _LABELS.get(argument.name, argument.name.replace("-", " "))
    told = []
    if argument.name in EXAMPLES:
        told.append(f"such as {EXAMPLES[argument.name]}")
    elif kind in ("text", "texts"):
        told.append(argument.metavar)
    elif argument.unit:
        told.append(argument.unit)
    if argument.default and kind != "band" and len(argument.default) <= 24:
        told.append(f"else {argument.default}")
    label = words[0].upper() + words[1:]
    return f"{label} ({'; '.join(told)})" if told else label


def _help_of(argument, kind):
    text = argument.description
    if argument.allowed and kind not in ("point", "extent"):  # the map's pickers take care
        text += f": {argument.allowed}"
    if argument.default:
        text += f" [{argument.default}]"
    return f"{text} (--{argument.name})"


def _parameters_of_argument(argument, is_advanced, is_required):
    kind = kind_of(argument)
    name, label, help_text = _name_of(argument), _label_of(argument, kind), _help_of(argument, kind)
    yield Parameter(name, kind, label, help_text, is_advanced, argument, is_required)
    if argument.metavar == _POINT_WITH_HEIGHT:
        yield Parameter(name + "_Z", "height", f"{label}: its height (in the DEM's unit; else from the ground)",
                        help_text, True, argument)


def parameters_of(usage, basic=(), required=(), left_out=(), changes=None):
    """The parameters of all options but NEVER and `left_out`: `basic` first and in that order, all
    others advanced. `changes` are fields of Argument by option that the algorithm has otherwise."""
    changes = changes or {}
    options = {a.name: a for a in usage.options if a.name not in NEVER and a.name not in left_out}
    order = [name for name in basic if name in options] + [name for name in options if name not in basic]
    made = []
    for name in order:
        argument = replace(options[name], **changes.get(name, {}))
        made.extend(_parameters_of_argument(argument, name not in basic, name in required))
    return sorted(made, key=lambda parameter: parameter.is_advanced)
