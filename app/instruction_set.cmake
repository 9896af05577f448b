# The level of the processor that the library behind the program is compiled for; `loomlight` itself, a small door before
# it (app/main.cpp), runs on every processor. A package holds the library for both levels, and the dynamic loader takes
# the one for its machine: `cmake --install` of a build at x86-64 lays it into lib/loomlight/private, and
# `cmake --install --component level` of a build at x86-64-v3 into lib/loomlight/private/glibc-hwcaps/x86-64-v3.
add_library(loomlight_level INTERFACE)
target_link_libraries(loomlight_level INTERFACE loomlight_build)
if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  return()
endif()

# What is built is run here, unless told otherwise.
set(level x86-64)
if(NOT CMAKE_CROSSCOMPILING)
  include(CheckCXXSourceRuns)
  check_cxx_source_runs("
    int main() {
      __builtin_cpu_init();
      return __builtin_cpu_supports(\"x86-64-v3\") ? 0 : 1;
    }" LOOMLIGHT_HOST_IS_V3)
  if(LOOMLIGHT_HOST_IS_V3)
    set(level x86-64-v3)
  endif()
endif()
set(LOOMLIGHT_LEVEL ${level} CACHE STRING "Processors to compile for: x86-64, or x86-64-v3 (with AVX2)")
set(levels x86-64 x86-64-v3)
if(NOT LOOMLIGHT_LEVEL IN_LIST levels)
  message(FATAL_ERROR "LOOMLIGHT_LEVEL: expected x86-64 or x86-64-v3, got ${LOOMLIGHT_LEVEL}")
endif()
# Vectors of four doubles are handed over in memory where there is no AVX; all that does so is compiled alike.
target_compile_options(loomlight_level INTERFACE -march=${LOOMLIGHT_LEVEL} -Wno-psabi)
