# How the packages differ. CPack reads this once for each.
if(CPACK_LOOMLIGHT_EPOCH)
  set(ENV{SOURCE_DATE_EPOCH} ${CPACK_LOOMLIGHT_EPOCH})
endif()
list(GET CPACK_INSTALL_CMAKE_PROJECTS 0 build)

# Beside the library for every processor, the one for those with AVX2, where that was built too.
if(EXISTS ${build}-v3/app/libloomlight.so)
  list(APPEND CPACK_INSTALL_CMAKE_PROJECTS "${build}-v3;Loomlight;level;/")
endif()

if(CPACK_GENERATOR STREQUAL "DEB")
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_SET_DESTDIR OFF)
else()
  # All that is not on every desktop travels in the archive.
  set(CPACK_PACKAGING_INSTALL_PREFIX /)
  list(APPEND CPACK_INSTALL_CMAKE_PROJECTS "${build};Loomlight;libraries;/")
endif()
