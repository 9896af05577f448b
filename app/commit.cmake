# The commit that is built, as header ${OUTPUT}; asked at every build, written where it has changed. Of an archive made by
# `git archive` it is what git has put into .git_archival.txt; of a copy without either, "unknown".
#   cmake -DSOURCE=folder -DOUTPUT=file -P commit.cmake
cmake_minimum_required(VERSION 3.25)

set(commit "")
if(EXISTS ${SOURCE}/.git)
  execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12 --exclude=* OUTPUT_VARIABLE commit
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
elseif(EXISTS ${SOURCE}/.git_archival.txt)
  file(STRINGS ${SOURCE}/.git_archival.txt commit REGEX "^[0-9a-f]+$")
endif()
if(NOT commit)
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#pragma once\n\n#define LOOMLIGHT_COMMIT \"${commit}\"\n")
