# SPDX-License-Identifier: GPL-3.0-or-later
"""The files behind layers: the command reads files, as GDAL does."""

from qgis.core import (
    QgsFileUtils,
    QgsProcessingException,
    QgsProcessingUtils,
    QgsProviderRegistry,
    QgsWkbTypes,
)

_FORMATS = ["gpkg", "shp", "geojson"]


def words_of_raster(layer):
    """The file of a raster layer, and the open options that go with it."""
    if layer.dataProvider().name() != "gdal":
        raise QgsProcessingException(f"{layer.name()} comes from a service ({layer.dataProvider().name()}) and not from"
                                     " a file: export it as GeoTIFF")
    parts = QgsProviderRegistry.instance().decodeUri("gdal", layer.source())
    path = parts.get("path") or layer.source()
    if parts.get("layerName"):
        path = layer.source().split("|")[0]  # GPKG:file:layer, as GDAL has it
    return path, [f"--oo={option}" for option in parts.get("openOptions") or []]


def vector_file(layer, context, feedback):
    """FILE:LAYER with what the layer shows: as it is, or exported where QGIS alone can read or filter it."""
    told = QgsFileUtils.stringToSafeFilename(layer.name()) or "layer"  # messages name the file
    path, name = QgsProcessingUtils.convertToCompatibleFormatAndLayerName(
        layer, False, told, _FORMATS, "gpkg", context, feedback)
    return f"{path}:{name}" if name else path


def point_file(algorithm, name, values, context, feedback):
    """The same for a parameter that is a source of features, whose selected ones may be all that is asked for."""
    source = algorithm.parameterAsSource(values, name, context)
    if source is None or source.wkbType() == QgsWkbTypes.NoGeometry:
        raise QgsProcessingException("the layer of points has no places: give a layer of points (a table of coordinates"
                                     " becomes one by Add Delimited Text Layer)")
    path, layer_name = algorithm.parameterAsCompatibleSourceLayerPathAndLayerName(
        values, name, context, _FORMATS, "gpkg", feedback)
    return f"{path}:{layer_name}" if layer_name else path
