# orograph_quick_start(TARGET)
# GDAL brings more than a hundred shared libraries, and before `main` the dynamic linker looks 60,000
# symbols up in them, in the order in which they are loaded: breadth first, what the program names
# itself in front. Half of the looking is done for the few libraries of C++ far behind. Named in
# front they are found at once: 7 of 50 ms. They are GDAL's own, loaded in any case; where one isn't
# found nothing changes but that.
function(orograph_quick_start target)
  set(in_front)
  foreach(name geos_c GDAL::GDAL xerces-c proj) # geos_c has the C++ library GEOS in its wake
    if(TARGET ${name})
      list(APPEND in_front $<TARGET_FILE:${name}>)
    else()
      find_library(OROGRAPH_${name}_LIBRARY ${name})
      mark_as_advanced(OROGRAPH_${name}_LIBRARY)
      if(OROGRAPH_${name}_LIBRARY)
        list(APPEND in_front ${OROGRAPH_${name}_LIBRARY})
      endif()
    endif()
  endforeach()
  target_link_options(${target} BEFORE PRIVATE LINKER:--push-state,--no-as-needed ${in_front}
    LINKER:--pop-state)
endfunction()
