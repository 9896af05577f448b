# Turns files into bytes of the program, so that the binary runs from anywhere.
#
#   loomlight_embed(TARGET HEADER NAMESPACE symbol file [symbol file ...])
#
# declares a static library TARGET with a header HEADER, where each symbol is a std::string_view of its file's bytes.
# Run as a script (cmake -P) the same file writes one C++ source.
if(CMAKE_SCRIPT_MODE_FILE)
  file(READ ${INPUT} hex HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
  string(REGEX REPLACE "((0x..,){32})" "\\1\n" bytes "${bytes}")
  file(WRITE ${OUTPUT} "#include \"${HEADER}\"\n\nnamespace {\nalignas(16) constexpr unsigned char ${SYMBOL}Bytes[] = {\n"
                       "${bytes}\n};\n}\n\nnamespace loomlight {\nconst std::string_view ${SYMBOL}{reinterpret_cast<"
                       "const char*>(${SYMBOL}Bytes), sizeof(${SYMBOL}Bytes)};\n}\n")
  return()
endif()

set(LOOMLIGHT_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
function(loomlight_embed target header)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/embedded)
  set(declarations "")
  set(sources "")
  set(rest ${ARGN})
  while(rest)
    list(POP_FRONT rest symbol file)
    string(APPEND declarations "extern const std::string_view ${symbol};\n")
    add_custom_command(
      OUTPUT ${folder}/${symbol}.cpp
      COMMAND ${CMAKE_COMMAND} -DINPUT=${file} -DOUTPUT=${folder}/${symbol}.cpp -DSYMBOL=${symbol} -DHEADER=${header}
              -P ${LOOMLIGHT_EMBED_SCRIPT}
      DEPENDS ${file} ${LOOMLIGHT_EMBED_SCRIPT} VERBATIM)
    list(APPEND sources ${folder}/${symbol}.cpp)
  endwhile()
  file(CONFIGURE OUTPUT ${folder}/${header} CONTENT
       "#pragma once\n\n#include <string_view>\n\nnamespace loomlight {\n${declarations}}  // namespace loomlight\n")
  add_library(${target} STATIC ${sources})
  target_include_directories(${target} PUBLIC ${folder})
endfunction()
