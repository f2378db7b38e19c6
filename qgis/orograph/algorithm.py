# SPDX-License-Identifier: GPL-3.0-or-later
"""An algorithm of Processing: a plan and the command's options, run as the command."""

import os
import shlex
import tempfile

from qgis.core import (
    QgsFeatureSink,
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingException,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterRasterLayer,
    QgsProcessingParameterVectorDestination,
    QgsVectorLayer,
)

from .command_line import words_of
from .definitions import INPUT, definition_of, value_of
from .icon import icon
from .line_layers import load_by_kind
from .run_command import Cancelled, CommandFailed, run
from .sources import point_file, vector_file, words_of_raster

TILES, POINTS, OUTPUT = "TILES", "POINTS", "OUTPUT"

# What a drawing may be written as, the first unless told; GeoPackage is another algorithm's.
_DRAWINGS = "SVG files (*.svg);;PDF files (*.pdf);;PNG files (*.png);;EPS files (*.eps);;PostScript files (*.ps);;" \
            "HPGL files (*.hpgl);;G-code files (*.gcode);;DXF files (*.dxf)"


class OrographAlgorithm(QgsProcessingAlgorithm):
    def __init__(self, plan, usage, program):
        super().__init__()
        self._plan, self._usage, self._program = plan, usage, program
        self._parameters = plan.parameters(usage)

    def createInstance(self):
        return OrographAlgorithm(self._plan, self._usage, self._program)

    def name(self):
        return self._plan.name

    def displayName(self):
        return self._plan.title

    def shortHelpString(self):
        return self._plan.about

    def icon(self):
        return icon()

    def tags(self):
        return ["terrain", "dem", "hidden lines", "plotter", "3d", "view", self._plan.command]

    def initAlgorithm(self, configuration=None):
        self.addParameter(QgsProcessingParameterRasterLayer(INPUT, "DEM"))
        if self._plan.output == "points":
            self.addParameter(QgsProcessingParameterFeatureSource(POINTS, "Points", [QgsProcessing.TypeVectorPoint]))
        for parameter in self._parameters:
            self.addParameter(definition_of(parameter, self._plan.presets.get(parameter.argument.name)))
        tiles = QgsProcessingParameterMultipleLayers(TILES, "More tiles of the same DEM", QgsProcessing.TypeRaster,
                                                     optional=True)
        tiles.setFlags(tiles.flags() | QgsProcessingParameterDefinition.FlagAdvanced)
        self.addParameter(tiles)
        self.addParameter(self._output_definition())

    def _output_definition(self):
        if self._plan.output == "points":
            return QgsProcessingParameterFeatureSink(OUTPUT, "What is seen", QgsProcessing.TypeVectorPoint)
        if self._plan.output == "lines":
            return QgsProcessingParameterVectorDestination(OUTPUT, "Lines", QgsProcessing.TypeVectorLine)
        return QgsProcessingParameterFileDestination(OUTPUT, "Drawing", _DRAWINGS)

    def processAlgorithm(self, values, context, feedback):
        dem = self.parameterAsRasterLayer(values, INPUT, context)
        if dem is None:
            raise QgsProcessingException(self.invalidRasterError(values, INPUT))
        try:
            if self._plan.output == "points":
                return self._points(dem, values, context, feedback)
            return self._drawing(dem, values, context, feedback)
        except CommandFailed as failure:
            raise QgsProcessingException(str(failure)) from None
        except Cancelled:
            return {}

    def _terrain(self, dem, values, context):
        """Files, and what GDAL is to open them with."""
        inputs, options = [], []
        for layer in [dem, *self.parameterAsLayerList(values, TILES, context)]:
            path, words = words_of_raster(layer)
            inputs.append(path)
            options += [word for word in words if word not in options]
        return inputs, options

    def _option_words(self, dem, values, context, feedback):
        set_values = {}
        for parameter in self._parameters:
            if parameter.kind == "vectors":
                layers = self.parameterAsLayerList(values, parameter.name, context)
                set_values[parameter.name] = [vector_file(layer, context, feedback) for layer in layers]
            else:
                set_values[parameter.name] = value_of(parameter, self, values, context, dem.crs())
                if set_values[parameter.name] is None:
                    set_values[parameter.name] = self._plan.presets.get(parameter.argument.name)
        return words_of(self._parameters, set_values)

    def _run(self, words, feedback, tell_line=None):
        feedback.pushCommandInfo(shlex.join(words))
        run(words, feedback.setProgress, tell_line or feedback.pushInfo, feedback.isCanceled)

    def _drawing(self, dem, values, context, feedback):
        if self._plan.output == "lines":
            output = self.parameterAsOutputLayer(values, OUTPUT, context)
        else:
            output = self.parameterAsFileOutput(values, OUTPUT, context)
        inputs, options = self._terrain(dem, values, context)
        options += self._option_words(dem, values, context, feedback)
        self._run([self._program, "render", *inputs, output, *options, "--overwrite", "--progress"], feedback)
        if self._plan.output == "lines":
            load_by_kind(output, context, dem.crs())
        written = {p.name: values[p.name] for p in self._parameters if p.kind == "written" and values.get(p.name)}
        return {OUTPUT: output, **written}

    def _points(self, dem, values, context, feedback):
        inputs, options = self._terrain(dem, values, context)
        points = point_file(self, POINTS, values, context, feedback)
        options += self._option_words(dem, values, context, feedback)
        with tempfile.TemporaryDirectory() as folder:
            seen = os.path.join(folder, "seen.geojson")

            def tell_line(line):
                feedback.pushInfo(line.removeprefix(f"{seen}: "))  # which is gone in a moment

            self._run([self._program, "visible", *inputs, points, *options, f"--output={seen}"], feedback, tell_line)
            return self._sink_of(seen, dem.crs(), values, context)

    def _sink_of(self, path, crs, values, context):
        seen = QgsVectorLayer(path, "seen", "ogr")
        sink, output = self.parameterAsSink(values, OUTPUT, context, seen.fields(), seen.wkbType(), crs)
        if sink is None:
            raise QgsProcessingException(self.invalidSinkError(values, OUTPUT))
        for feature in seen.getFeatures():
            sink.addFeature(feature, QgsFeatureSink.FastInsert)
        return {OUTPUT: output}
