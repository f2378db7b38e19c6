# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameters as QGIS has them: their widgets, and their values in the terrain's CRS."""

from qgis.core import (
    QgsProcessing,
    QgsProcessingParameterBand,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
    QgsProcessingParameterExtent,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterNumber,
    QgsProcessingParameterPoint,
    QgsProcessingParameterString,
)

INPUT = "INPUT"


def _number(parameter, kind):
    argument = parameter.argument
    made = QgsProcessingParameterNumber(parameter.name, parameter.label, kind, optional=True)
    if parameter.kind != "height":
        if argument.least is not None:
            made.setMinimum(argument.least)
        if argument.greatest is not None:
            made.setMaximum(argument.greatest)
    return made


def _choice(parameter, preset, allow_multiple):
    # Words instead of numbers: what scripts hold stays right when a word is added.
    return QgsProcessingParameterEnum(parameter.name, parameter.label, list(parameter.argument.choices), allow_multiple,
                                      preset, optional=preset is None, usesStaticStrings=True)


def _written_file(parameter):
    wanted = ";;".join(f"{name.upper()} (*.{name})" for name in parameter.argument.extensions or ("csv",))
    return QgsProcessingParameterFileDestination(parameter.name, parameter.label, wanted, optional=True,
                                                 createByDefault=False)


def _file(parameter):
    patterns = " ".join(f"*.{name}" for name in parameter.argument.extensions)
    return QgsProcessingParameterFile(parameter.name, parameter.label, optional=True,
                                      fileFilter=f"Files ({patterns})" if patterns else "")


def definition_of(parameter, preset=None):
    """A parameter for an algorithm to add."""
    name, label, kind = parameter.name, parameter.label, parameter.kind
    is_optional = not parameter.is_required
    if kind == "switch":
        made = QgsProcessingParameterBoolean(name, label, False, optional=True)
    elif kind == "whole":
        made = _number(parameter, QgsProcessingParameterNumber.Integer)
    elif kind in ("real", "height"):
        made = _number(parameter, QgsProcessingParameterNumber.Double)
    elif kind in ("choice", "list"):
        made = _choice(parameter, preset, kind == "list")
    elif kind == "band":
        made = QgsProcessingParameterBand(name, label, None, INPUT, optional=True)
    elif kind == "point":
        made = QgsProcessingParameterPoint(name, label, optional=is_optional)
    elif kind == "extent":
        made = QgsProcessingParameterExtent(name, label, optional=True)
    elif kind == "vectors":
        made = QgsProcessingParameterMultipleLayers(name, label, QgsProcessing.TypeVectorAnyGeometry, optional=True)
    elif kind == "file":
        made = _file(parameter)
    elif kind == "written":
        made = _written_file(parameter)
    else:
        made = QgsProcessingParameterString(name, label, multiLine=kind == "texts", optional=True)
    made.setHelp(parameter.help)
    if parameter.is_advanced:
        made.setFlags(made.flags() | QgsProcessingParameterDefinition.FlagAdvanced)
    return made


def _corners(extent):
    if extent.isNull():
        return None
    return (extent.xMinimum(), extent.yMinimum(), extent.xMaximum(), extent.yMaximum())


def value_of(parameter, algorithm, values, context, crs):
    """What is set, as command_line.words_of takes it, with points and extents in `crs`; None where nothing is."""
    name, kind = parameter.name, parameter.kind
    given = values.get(name)
    if given is None or given == "":
        return None
    if kind == "switch":
        return algorithm.parameterAsBool(values, name, context)
    if kind in ("whole", "band"):
        return algorithm.parameterAsInt(values, name, context)
    if kind in ("real", "height"):
        return algorithm.parameterAsDouble(values, name, context)
    if kind == "choice":
        return algorithm.parameterAsEnumString(values, name, context)
    if kind == "list":
        return algorithm.parameterAsEnumStrings(values, name, context)
    if kind == "point":
        point = algorithm.parameterAsPoint(values, name, context, crs)
        return (point.x(), point.y())
    if kind == "extent":
        return _corners(algorithm.parameterAsExtent(values, name, context, crs))
    if kind == "written":
        return algorithm.parameterAsFileOutput(values, name, context)
    return algorithm.parameterAsString(values, name, context)
