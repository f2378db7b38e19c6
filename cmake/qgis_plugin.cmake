# The target qgis-plugin: orograph-qgis.zip in the build folder, which QGIS installs as a plugin. Nothing
# of it is compiled, and nothing of QGIS is needed.
if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3) # Debian's, which QGIS's own modules are for
endif()
find_package(Python 3.9 QUIET COMPONENTS Interpreter)
if(Python_Interpreter_FOUND)
  set(plugin_zip ${PROJECT_BINARY_DIR}/orograph-qgis.zip)
  add_custom_target(qgis-plugin
    COMMAND ${Python_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/qgis/make_zip.py ${PROJECT_VERSION} ${plugin_zip}
    BYPRODUCTS ${plugin_zip} VERBATIM)
endif()
