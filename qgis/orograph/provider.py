# SPDX-License-Identifier: GPL-3.0-or-later
"""The provider of Processing, whose algorithms are as many as the command that is installed can run."""

from processing.core.ProcessingConfig import ProcessingConfig, Setting, settingsWatcher
from qgis.core import Qgis, QgsMessageLog, QgsProcessingProvider

from .algorithm import OrographAlgorithm
from .icon import PATH, icon
from .plans import ALL
from .run_command import CommandFailed, find_program
from .usage import ask_usage

_PROGRAM = "OROGRAPH_PROGRAM"


class OrographProvider(QgsProcessingProvider):
    def __init__(self):
        super().__init__()
        self._warning = ""

    def id(self):
        return "orograph"

    def name(self):
        return "Orograph"

    def longName(self):
        return "Orograph, perspective maps as lines"

    def icon(self):
        return icon()

    def svgIconPath(self):
        return PATH

    def warningMessage(self):
        return self._warning

    def supportedOutputVectorLayerExtensions(self):
        return ["gpkg", "geojson"]

    def defaultVectorFileExtension(self, hasGeometry=True):
        return "gpkg"

    def supportsNonFileBasedOutput(self):
        return False

    def load(self):
        ProcessingConfig.settingIcons[self.name()] = self.icon()
        ProcessingConfig.addSetting(Setting(self.name(), _PROGRAM, "The program orograph, if it isn't on the PATH", "",
                                            valuetype=Setting.FILE))
        ProcessingConfig.readSettings()
        settingsWatcher.settingsChanged.connect(self.refreshAlgorithms)
        self.refreshAlgorithms()
        return True

    def unload(self):
        settingsWatcher.settingsChanged.disconnect(self.refreshAlgorithms)
        ProcessingConfig.removeSetting(_PROGRAM)

    def loadAlgorithms(self):
        self._warning = ""
        try:
            program = find_program(ProcessingConfig.getSetting(_PROGRAM) or "")
            usages = {command: ask_usage(program, command) for command in {plan.command for plan in ALL}}
        except CommandFailed as failure:
            self._warning = str(failure)
            QgsMessageLog.logMessage(self._warning, self.name(), Qgis.Warning)
            return
        for plan in ALL:
            self.addAlgorithm(OrographAlgorithm(plan, usages[plan.command], program))
