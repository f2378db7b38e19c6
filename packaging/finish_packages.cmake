# CPack runs this when the files of all packages lie in their folders, before it packs them. It adds
# what Debian's policy wants of every package, and brings to Debian's places what others have elsewhere.
set(packaging ${CPACK_OROGRAPH_SOURCES}/packaging)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC) # of SOURCE_DATE_EPOCH, where that is set

function(compress file)
  execute_process(COMMAND gzip -9nf ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

foreach(entry IN LISTS CPACK_OROGRAPH_PACKAGES)
  string(REGEX MATCH "^(.*)=(.*)$" _ ${entry})
  set(root ${CPACK_TEMPORARY_DIRECTORY}/${CMAKE_MATCH_1}/usr)
  set(package ${CMAKE_MATCH_2})
  set(docs ${root}/share/doc/${package})

  file(COPY ${packaging}/copyright DESTINATION ${docs})
  file(COPY_FILE ${CPACK_OROGRAPH_SOURCES}/CHANGELOG.md ${docs}/changelog)
  file(WRITE ${docs}/changelog.Debian
"orograph (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) bookworm; urgency=medium

  * Of version ${CPACK_PACKAGE_VERSION}, whose changes are in changelog.gz.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  compress(${docs}/changelog)
  compress(${docs}/changelog.Debian)
  set(overrides ${root}/share/lintian/overrides/${package})
  file(READ ${packaging}/lintian-overrides text)
  file(WRITE ${overrides} "${text}")
  if(package MATCHES "^liborograph[0-9]")
    file(READ ${packaging}/liborograph/lintian-overrides text)
    file(APPEND ${overrides} "${text}")
  endif()
  file(GLOB pages ${root}/share/man/man*/*.[0-9])
  foreach(page IN LISTS pages)
    compress(${page})
  endforeach()
  if(EXISTS ${root}/share/zsh/site-functions) # where Debian's zsh doesn't look
    file(RENAME ${root}/share/zsh/site-functions ${root}/share/zsh/vendor-completions)
  endif()

  # Whatever umask is in force.
  file(GLOB_RECURSE folders LIST_DIRECTORIES true ${root}/*)
  foreach(folder IN LISTS folders)
    if(IS_DIRECTORY ${folder})
      file(CHMOD ${folder} PERMISSIONS ${CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS})
    endif()
  endforeach()
  file(GLOB_RECURSE texts ${root}/share/*)
  if(texts)
    file(CHMOD ${texts} PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
  endif()
endforeach()
