# SPDX-License-Identifier: GPL-3.0-or-later
"""A stand-in for QGIS: as much of its classes as the plugin uses, with plain values for layers.

It tells whether the plugin's modules hang together and which command they run. Whether QGIS's own
classes are called rightly only QGIS can tell (in_qgis_test.py)."""

import types


class QgsProcessingException(Exception):
    pass


class Definition:
    FlagAdvanced = 2
    Integer, Double = 0, 1

    def __init__(self, name, description, *others, **named):
        self.name, self.description, self.others, self.named, self._flags = name, description, others, named, 0
        self.help = self.least = self.greatest = None

    def setHelp(self, text):
        self.help = text

    def setMinimum(self, value):
        self.least = value

    def setMaximum(self, value):
        self.greatest = value

    def flags(self):
        return self._flags

    def setFlags(self, flags):
        self._flags = flags


class Crs:
    def isValid(self):
        return True


class RasterLayer:
    def __init__(self, path, provider="gdal"):
        self._path, self._provider = path, provider

    def name(self):
        return "dem"

    def source(self):
        return self._path

    def crs(self):
        return Crs()

    def dataProvider(self):
        return types.SimpleNamespace(name=lambda: self._provider)


class Point(tuple):
    def x(self):
        return self[0]

    def y(self):
        return self[1]


class Extent(tuple):
    def isNull(self):
        return False

    def xMinimum(self):
        return self[0]

    def yMinimum(self):
        return self[1]

    def xMaximum(self):
        return self[2]

    def yMaximum(self):
        return self[3]


class QgsProcessingAlgorithm:
    def __init__(self):
        self.definitions = {}

    def addParameter(self, definition):
        assert definition.name not in self.definitions
        self.definitions[definition.name] = definition

    def parameterAsLayerList(self, values, name, context):
        return values.get(name, [])

    def parameterAsPoint(self, values, name, context, crs):
        assert isinstance(crs, Crs)
        return Point(values[name])

    def parameterAsExtent(self, values, name, context, crs):
        assert isinstance(crs, Crs)
        return Extent(values[name])

    def invalidRasterError(self, values, name):
        return f"no raster {values.get(name)}"


for _kind in ("Bool", "Int", "Double", "String", "EnumString", "EnumStrings", "FileOutput", "RasterLayer",
              "OutputLayer"):
    setattr(QgsProcessingAlgorithm, f"parameterAs{_kind}", lambda self, values, name, context: values.get(name))


class Feedback:
    def __init__(self):
        self.percents, self.lines, self.commands = [], [], []
        self.setProgress = self.percents.append
        self.pushInfo = self.lines.append
        self.pushCommandInfo = self.commands.append

    def isCanceled(self):
        return False


class QgsProcessingProvider:
    def __init__(self):
        self.algorithms = []

    def addAlgorithm(self, algorithm):
        self.algorithms.append(algorithm)

    def refreshAlgorithms(self):
        self.algorithms = []
        self.loadAlgorithms()


class Registry:
    def __init__(self):
        self.providers = []

    def addProvider(self, provider):
        self.providers.append(provider)
        provider.load()

    def removeProvider(self, provider):
        provider.unload()
        self.providers.remove(provider)


class Signal(list):
    connect, disconnect = list.append, list.remove

    def emit(self):
        for listener in self:
            listener()


class ProcessingConfig:
    settings, settingIcons = {}, {}

    @staticmethod
    def addSetting(setting):
        ProcessingConfig.settings[setting.name] = setting

    @staticmethod
    def removeSetting(name):
        del ProcessingConfig.settings[name]

    @staticmethod
    def getSetting(name):
        return ProcessingConfig.settings[name].value

    @staticmethod
    def readSettings():
        pass


class Setting:
    FILE = 1

    def __init__(self, group, name, description, default, valuetype):
        self.name, self.value = name, default


def _decoded(provider, source):
    path, *options = source.split("|option:")
    return {"path": path, "openOptions": options}


def modules():
    """What stands in sys.modules for QGIS."""
    registry = Registry()
    core = types.ModuleType("qgis.core")
    for name in ("Band", "Boolean", "Enum", "Extent", "FeatureSink", "FeatureSource", "File", "FileDestination",
                 "MultipleLayers", "Number", "Point", "RasterLayer", "String", "VectorDestination", "Definition"):
        setattr(core, f"QgsProcessingParameter{name}", Definition)
    core.QgsProcessingAlgorithm, core.QgsProcessingProvider = QgsProcessingAlgorithm, QgsProcessingProvider
    core.QgsProcessingException = QgsProcessingException
    core.QgsProcessing = types.SimpleNamespace(TypeRaster=1, TypeVectorAnyGeometry=2, TypeVectorPoint=3,
                                               TypeVectorLine=4)
    core.QgsProcessingLayerPostProcessorInterface = object
    core.QgsApplication = types.SimpleNamespace(processingRegistry=lambda: registry)
    core.QgsProviderRegistry = types.SimpleNamespace(instance=lambda: types.SimpleNamespace(decodeUri=_decoded))
    core.QgsMessageLog = types.SimpleNamespace(logMessage=lambda text, tag, level: None)
    core.Qgis = types.SimpleNamespace(Warning=1)
    for name in ("QgsFeatureSink", "QgsFileUtils", "QgsVectorLayer", "QgsProcessingContext", "QgsProcessingUtils",
                 "QgsWkbTypes"):
        setattr(core, name, object())
    gui = types.ModuleType("qgis.PyQt.QtGui")
    gui.QIcon = lambda path: ("icon", path)
    config = types.ModuleType("processing.core.ProcessingConfig")
    config.ProcessingConfig, config.Setting, config.settingsWatcher = ProcessingConfig, Setting, types.SimpleNamespace(
        settingsChanged=Signal())
    made = {"qgis.core": core, "qgis.PyQt.QtGui": gui, "processing.core.ProcessingConfig": config}
    for name in ("qgis", "qgis.PyQt", "processing", "processing.core"):
        made[name] = types.ModuleType(name)
    return made
