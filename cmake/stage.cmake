# How code is compiled that takes no time when it runs.
set(OROGRAPH_QUICKLY $<$<CONFIG:Release>:-O1>)

# How loops are compiled that are reckoned several steps at once: for that nobody may ask for an
# operation's error number or traps, which changes no number.
set(OROGRAPH_IN_LANES -fno-math-errno -fno-trapping-math)

# orograph_stage(NAME [TOGETHER] [QUICKLY] [IN_LANES] SOURCES a.cpp b.cpp [DEPENDS stage…]
#   [PRIVATE library…] [COMMON kind [header…]])
# One library for each folder. Stages link only downhill (DEPENDS); foreign libraries are PRIVATE,
# behind the one source file that includes them. TOGETHER: several files are compiled at a time,
# compile_once.cmake. QUICKLY: nothing in it takes time. IN_LANES: its loops are reckoned several steps
# at once. COMMON: headers of ours that nearly all of its files come to include are compiled once for
# all stages of this kind, the first of which names them; without it, those of std and fmt alone.
function(orograph_stage name)
  cmake_parse_arguments(STAGE "TOGETHER;QUICKLY;IN_LANES" "" "SOURCES;DEPENDS;PRIVATE;COMMON" ${ARGN})
  add_library(orograph_${name} STATIC ${STAGE_SOURCES})
  # Into the shared library, which shows nothing but what OROGRAPH_API marks.
  set_target_properties(orograph_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  list(TRANSFORM STAGE_DEPENDS PREPEND orograph_)
  target_link_libraries(orograph_${name} PUBLIC ${STAGE_DEPENDS} PRIVATE ${STAGE_PRIVATE})
  target_include_directories(orograph_${name} PUBLIC ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src)
  orograph_compile_options(orograph_${name})
  if(STAGE_TOGETHER)
    orograph_compile_together(orograph_${name})
  endif()
  if(STAGE_QUICKLY)
    target_compile_options(orograph_${name} PRIVATE ${OROGRAPH_QUICKLY})
  endif()
  if(STAGE_COMMON)
    list(TRANSFORM STAGE_COMMON PREPEND ${PROJECT_SOURCE_DIR}/ REGEX "[.]hpp$")
    orograph_precompile(orograph_${name} ${STAGE_COMMON})
  elseif(STAGE_IN_LANES) # alone, so common headers of its own would cost more than they spare
    target_compile_options(orograph_${name} PRIVATE ${OROGRAPH_IN_LANES})
  else()
    orograph_precompile(orograph_${name} plain)
  endif()
endfunction()

# orograph_in_lanes(a.cpp…): these files of a stage are compiled as a stage is that says IN_LANES.
function(orograph_in_lanes)
  set_source_files_properties(${ARGN} PROPERTIES
    SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS "${OROGRAPH_IN_LANES}")
endfunction()

# orograph_by_cgal(NAME a.cpp…): these files of the stage include CGAL, whose intervals need
# -frounding-math. If the stage were linked with CGAL::CGAL, all of its files would be compiled that
# way, and would need common headers of their own.
function(orograph_by_cgal name)
  set(options $<TARGET_PROPERTY:CGAL::CGAL,INTERFACE_COMPILE_OPTIONS>)
  if(OROGRAPH_SANITIZE AND NOT OROGRAPH_FUZZ) # optimised with the sanitizers in it: 161 s, not 23
    list(APPEND options -O0)
  endif()
  set_source_files_properties(${ARGN} PROPERTIES
    SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS "${options}"
    COMPILE_DEFINITIONS $<TARGET_PROPERTY:CGAL::CGAL,INTERFACE_COMPILE_DEFINITIONS>)
  target_link_libraries(orograph_${name} PRIVATE mpfr gmp)
endfunction()

# orograph_by_cairo(NAME): files of the stage include Cairo's headers and Pango's. Nothing is linked to
# these libraries: src/lettering/cairo_function.hpp.
function(orograph_by_cairo name)
  target_include_directories(orograph_${name} SYSTEM PRIVATE ${PANGOCAIRO_INCLUDE_DIRS})
endfunction()

# The same drawing for the same input on every machine: no contraction to fused multiply-add
# (docs/how-it-works.md).
#
# Two warnings of GCC 12 are wrong too often: it takes the inactive members of a variant that is
# moved for uninitialized, and sees overlaps in the adding of texts (GCC bug 105651).
function(orograph_compile_options target)
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  if(OROGRAPH_SANITIZE)
    # Debug information for readable findings. The checks left out cost a third of the compiling
    # (docs/decisions/0020-build-time.md), and what follows from such faults the address sanitizer
    # finds. Other builds warn.
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined
      -fno-sanitize=null,alignment,object-size,vptr,pointer-overflow -fno-sanitize-recover=all
      -fno-omit-frame-pointer -g1 -w)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  else()
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
      -Wcast-align -Woverloaded-virtual -Werror
      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-restrict>)
  endif()
  if(OROGRAPH_FUZZ)
    # Places of our own functions are counted. Most would be those of templates of std, CGAL, JSON and TOML
    # otherwise, in a copy for each caller, hence without inlining (docs/stability.md).
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link -fno-inline
      -fsanitize-coverage-allowlist=${PROJECT_SOURCE_DIR}/tests/fuzz/own_functions.txt)
  endif()
endfunction()
