# The library: all stages below the command behind src/orograph.hpp, as one shared and one static
# file, with what finds them from other projects (find_package and pkg-config).
set(OROGRAPH_STAGES geometry text gdal write lettering view horizon draw solids dem profiles reference tone placing hidden_lines naming map)
orograph_stage(face SOURCES ${PROJECT_SOURCE_DIR}/src/orograph.cpp DEPENDS ${OROGRAPH_STAGES}
  COMMON placed)
if(OROGRAPH_SANITIZE)
  return() # such a build is for finding faults, not for installing
endif()
set(objects $<TARGET_OBJECTS:orograph_face>)
foreach(stage IN LISTS OROGRAPH_STAGES)
  list(APPEND objects $<TARGET_OBJECTS:orograph_${stage}>)
endforeach()

add_library(orograph_shared SHARED ${objects})
set_target_properties(orograph_shared PROPERTIES OUTPUT_NAME orograph EXPORT_NAME orograph
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
target_link_libraries(orograph_shared PRIVATE GDAL::GDAL PkgConfig::GEOGRAPHICLIB fmt::fmt
  pugixml::pugixml tomlplusplus::tomlplusplus TBB::tbb CGAL::CGAL)
target_link_options(orograph_shared PRIVATE LINKER:--no-undefined)

add_library(orograph_static STATIC ${objects})
set_target_properties(orograph_static PROPERTIES OUTPUT_NAME orograph EXPORT_NAME static)
# As Debian names them; the shared library brings its own.
target_link_libraries(orograph_static INTERFACE gdal GeographicLib fmt pugixml
  tomlplusplus tbb mpfr gmp)

set(face_header ${PROJECT_BINARY_DIR}/generated/install/orograph.hpp)
file(GLOB_RECURSE face_parts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*.hpp
  ${PROJECT_SOURCE_DIR}/dem/*.hpp ${PROJECT_SOURCE_DIR}/profiles/*.hpp)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/generated/install)
add_custom_command(OUTPUT ${face_header}
  COMMAND ${PROJECT_SOURCE_DIR}/scripts/one-header ${PROJECT_VERSION} > ${face_header}
  DEPENDS ${PROJECT_SOURCE_DIR}/scripts/one-header ${face_parts} VERBATIM)
add_custom_target(face_header ALL DEPENDS ${face_header})

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
foreach(library orograph_shared orograph_static)
  target_compile_features(${library} INTERFACE cxx_std_20)
  target_include_directories(${library} INTERFACE
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR};${PROJECT_SOURCE_DIR}/src>"
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
endforeach()
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/orograph)
install(TARGETS orograph_shared EXPORT orograph
  LIBRARY COMPONENT library NAMELINK_COMPONENT development)
install(TARGETS orograph_static EXPORT orograph ARCHIVE COMPONENT development)
install(FILES ${face_header} COMPONENT development DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT orograph FILE orographConfig.cmake NAMESPACE orograph::
  COMPONENT development DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/generated/install/orographConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
# From its own folder, so that the whole may be moved.
file(RELATIVE_PATH to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${PROJECT_SOURCE_DIR}/cmake/orograph.pc.in
  ${PROJECT_BINARY_DIR}/generated/install/orograph.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/generated/install/orographConfigVersion.cmake
  COMPONENT development DESTINATION ${package_folder})
install(FILES ${PROJECT_BINARY_DIR}/generated/install/orograph.pc
  COMPONENT development DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
