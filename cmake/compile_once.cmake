# What a cold build is spared (docs/decisions/0020-build-time.md): common headers are compiled once,
# the files of a folder several at a time, and ccache remembers the rest. The debug preset has
# neither of the first two: there every file shows whether it includes what it needs, and has a line
# of its own in compile_commands.json.
option(OROGRAPH_PRECOMPILED "Compile the headers of std, fmt and Catch2 once" ON)
option(OROGRAPH_UNITY "Compile the files of a folder several at a time" ON)
option(OROGRAPH_CCACHE "Compile by ccache where it is installed" ON)

# ccache is told what its manual asks for with precompiled headers, and by CCACHE_DEPEND to look what
# is new from the files themselves, instead of letting the preprocessor go through them beforehand.
#
# The C library gives the compiler its memory in large pages, 128 MB at a time: clang takes 69,000
# pages for a bundle otherwise, and a seventh more time.
if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER env
    GLIBC_TUNABLES=glibc.malloc.hugetlb=1:glibc.malloc.top_pad=134217728)
  if(OROGRAPH_CCACHE)
    find_program(OROGRAPH_CCACHE_PROGRAM ccache)
    mark_as_advanced(OROGRAPH_CCACHE_PROGRAM)
    if(OROGRAPH_CCACHE_PROGRAM)
      list(APPEND CMAKE_CXX_COMPILER_LAUNCHER CCACHE_DEPEND=1
        CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
        ${OROGRAPH_CCACHE_PROGRAM})
    endif()
  endif()
endif()

# GCC stops again and again to look which of its memory it may use anew, from 256 MB on; here it does
# not below 1 GB, which hardly a file needs. It writes the same code. Clang writes down when the
# headers were changed that it compiles once, which ccache can't know.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(--param=ggc-min-heapsize=524288)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  add_compile_options("SHELL:-Xclang -fno-pch-timestamp")
endif()

set(OROGRAPH_COMMON_HEADERS <algorithm> <array> <atomic> <charconv> <cmath> <cstddef> <cstdint>
  <filesystem> <fstream> <functional> <limits> <map> <memory> <numeric> <optional> <ranges> <set> <span>
  <stop_token> <string> <string_view> <tuple> <utility> <variant> <vector> <fmt/format.h>)

# orograph_precompile(TARGET KIND [HEADER…]): the common headers and these. The first target of a
# KIND compiles them, the others take what it made; GCC refuses it (-Winvalid-pch) unless all of a
# KIND have the same options for code, also those that libraries bring.
function(orograph_precompile target kind)
  if(NOT OROGRAPH_PRECOMPILED)
    return()
  endif()
  target_link_libraries(${target} PRIVATE fmt::fmt)
  # In what comes from there GCC 12 sees faults of std::string's own, clang what its std::stable_sort
  # shouldn't call.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>
    $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>)
  get_property(first GLOBAL PROPERTY orograph_precompiled_${kind})
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
    get_target_property(libraries ${first} LINK_LIBRARIES)
    foreach(library IN LISTS libraries)
      if(TARGET ${library})
        target_compile_options(${target} PRIVATE
          $<TARGET_PROPERTY:${library},INTERFACE_COMPILE_OPTIONS>)
      endif()
    endforeach()
  else()
    set_property(GLOBAL PROPERTY orograph_precompiled_${kind} ${target})
    target_precompile_headers(${target} PRIVATE ${OROGRAPH_COMMON_HEADERS} ${ARGN})
  endif()
endfunction()

# orograph_compile_together(TARGET): names in anonymous namespaces have to differ within a folder. A
# file that can't follow has SKIP_UNITY_BUILD_INCLUSION.
function(orograph_compile_together target)
  if(OROGRAPH_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
    # This warning of GCC's takes every file of the bundle but the bundle itself for a header.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()
