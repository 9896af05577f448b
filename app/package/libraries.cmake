# Copies the shared libraries that the installed program needs, but for those of every desktop, into
# lib/loomlight/private, where its run path leads; with the licence of each. Run by
# `cmake --install BUILD --component libraries`, after the program.
set(prefix $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX})
file(GLOB_RECURSE ours ${prefix}/lib/loomlight/private/libloomlight*.so*)

# What belongs to the system must be the system's own: the C and C++ libraries, OpenGL and the display, and the fonts,
# which read settings made for their version.
set(system "ld-linux.*|libc|libm|libdl|librt|libpthread|libgcc_s|libstdc[+][+]"
           "libGL|libEGL|libOpenGL|libGLX|libGLdispatch|libX11|libX11-xcb|libXext|libxcb|libwayland-.*"
           "libfontconfig|libfreetype|libexpat|libz")
list(JOIN system "|" system)
file(GET_RUNTIME_DEPENDENCIES
     EXECUTABLES ${prefix}/bin/loomlight
     LIBRARIES ${ours}
     RESOLVED_DEPENDENCIES_VAR libraries
     PRE_EXCLUDE_REGEXES "^(${system})[.]so" "^libloomlight")

find_program(DPKG_QUERY dpkg-query)
foreach(library ${libraries})
  file(INSTALL ${library} DESTINATION ${CMAKE_INSTALL_PREFIX}/lib/loomlight/private FOLLOW_SYMLINK_CHAIN)
  if(NOT DPKG_QUERY)
    continue()
  endif()
  # Debian lists libraries by the name of before or after the merge of /lib and /usr/lib.
  file(REAL_PATH ${library} real)
  string(REGEX REPLACE "^/usr" "" unmerged ${real})
  execute_process(COMMAND ${DPKG_QUERY} --search ${real} ${unmerged} OUTPUT_VARIABLE found ERROR_QUIET)
  if(NOT found MATCHES "^([^:]+):")
    message(FATAL_ERROR "${library}: expected a library of a Debian package, with its licence")
  endif()
  file(INSTALL /usr/share/doc/${CMAKE_MATCH_1}/copyright
       DESTINATION ${CMAKE_INSTALL_PREFIX}/share/doc/loomlight/libraries RENAME ${CMAKE_MATCH_1} FOLLOW_SYMLINK_CHAIN)
endforeach()
