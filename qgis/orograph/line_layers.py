# SPDX-License-Identifier: GPL-3.0-or-later
"""The strokes of a GeoPackage as layers of a project, one for each kind of line, with their styles."""

import pathlib

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingLayerPostProcessorInterface,
    QgsVectorLayer,
)

STYLES = pathlib.Path(__file__).parent / "styles"

# Below others first, as the command draws them.
KINDS = ("profiles", "mesh", "hachures", "walls", "wall-contours", "wall-index-contours", "block", "contours",
         "index-contours", "graticule", "grid", "edges", "waterlines", "shores", "border", "drape",
         "voids", "silhouettes", "skyline", "solids")

# What isn't seen of a kind has a name of its own.
_HIDDEN_OF_SOLIDS = "hidden"


def names_of(kind):
    return (kind, _HIDDEN_OF_SOLIDS if kind == "solids" else f"hidden-{kind}")


def style_of(kind):
    return str(STYLES / f"{kind}.qml")


def kinds_in(path):
    """The kinds of line in a file."""
    strokes = QgsVectorLayer(path, "strokes", "ogr")
    there = strokes.uniqueValues(strokes.fields().indexOf("layer")) if strokes.isValid() else set()
    return [kind for kind in KINDS if there.intersection(names_of(kind))]


# QGIS holds no reference to what is to be done with a layer, and the algorithm's object is gone by then. So
# these stay until QGIS ends: a few hundred bytes each.
_kept = []


class _Styled(QgsProcessingLayerPostProcessorInterface):
    def __init__(self, kind, crs):
        super().__init__()
        self._kind, self._crs = kind, crs
        _kept.append(self)

    def postProcessLayer(self, layer, context, feedback):
        layer.loadNamedStyle(style_of(self._kind))
        if not layer.crs().isValid():
            layer.setCrs(self._crs)  # of a DEM to which QGIS alone gives one
        layer.triggerRepaint()


def load_by_kind(path, context, crs):
    """Has the project load each kind where it would have loaded the file."""
    wanted = context.layersToLoadOnCompletion()
    if path not in wanted:
        return
    details = wanted.pop(path)
    for kind in kinds_in(path):
        words = ", ".join(f"'{name}'" for name in names_of(kind))
        # Without the output's name: QGIS would ask for the style that is set for it.
        layer = QgsProcessingContext.LayerDetails(kind, details.project, "")
        layer.setPostProcessor(_Styled(kind, crs))
        wanted[f'{path}|subset="layer" IN ({words})'] = layer
    context.setLayersToLoadOnCompletion(wanted)
