# Every foreign library, in one place. All of them are Debian 12 packages: scripts/install-dependencies.
find_package(PkgConfig REQUIRED)
find_package(GDAL 3.6 CONFIG REQUIRED)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo>=1.16)
pkg_check_modules(PANGOCAIRO REQUIRED IMPORTED_TARGET pangocairo>=1.50)
# -pthread, which the precompiled headers aren't made with; nothing of Pango's headers asks for it.
set_target_properties(PkgConfig::PANGOCAIRO PROPERTIES INTERFACE_COMPILE_OPTIONS "")
# no CMake package in Debian 12
pkg_check_modules(GEOGRAPHICLIB REQUIRED IMPORTED_TARGET geographiclib>=2.1)
find_package(fmt 9 CONFIG REQUIRED)
find_package(CLI11 2.1 CONFIG REQUIRED)
find_package(nlohmann_json 3.11 CONFIG REQUIRED)
find_package(tomlplusplus 3.3 CONFIG REQUIRED)
find_package(CGAL 5.5 CONFIG REQUIRED)
find_package(pugixml 1.13 CONFIG REQUIRED)
find_package(Eigen3 3.4 CONFIG REQUIRED) # after CGAL, which looks for it in another way
find_package(TBB 2021.8 CONFIG REQUIRED)
if(OROGRAPH_PYTHON)
  # Debian's packages of pybind11 and numpy are for Debian's own Python.
  if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3)
  endif()
  find_package(Python 3.11 REQUIRED COMPONENTS Interpreter Development.Module)
  set(PYBIND11_FINDPYTHON ON)
  find_package(pybind11 2.10 CONFIG REQUIRED)
endif()
if(OROGRAPH_MPI)
  find_package(MPI 3.1 COMPONENTS CXX REQUIRED)
endif()
