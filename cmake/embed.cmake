# tetralux_embed(TARGET NAME FOLDER folder FILES file...)
#
# Compiles files into TARGET. They are found at run time by embeddedFile() (base/embedded.h) of the generated header
# "NAME.h", under their names relative to FOLDER. The program needs no data files beside it.
function(tetralux_embed TARGET NAME)
  cmake_parse_arguments(ARG "" "FOLDER" "FILES" ${ARGN})
  set(dir ${CMAKE_CURRENT_BINARY_DIR}/embedded)
  set(declarations "")
  set(entries "")
  set(index 0)
  foreach(file IN LISTS ARG_FILES)
    set(out ${dir}/${NAME}_${index}.inc)
    add_custom_command(
      OUTPUT ${out}
      COMMAND ${CMAKE_COMMAND} -DIN=${ARG_FOLDER}/${file} -DOUT=${out} -P ${PROJECT_SOURCE_DIR}/cmake/embed_file.cmake
      DEPENDS ${ARG_FOLDER}/${file} ${PROJECT_SOURCE_DIR}/cmake/embed_file.cmake
      COMMENT "Embedding ${file}" VERBATIM)
    list(APPEND outputs ${out})
    string(APPEND declarations "alignas(4) const unsigned char data${index}[] = {\n#include \"${out}\"\n};\n")
    string(APPEND entries "    {\"${file}\", data${index}, sizeof data${index}},\n")
    math(EXPR index "${index} + 1")
  endforeach()
  file(CONFIGURE OUTPUT ${dir}/${NAME}.cpp CONTENT [[#include "@NAME@.h"

namespace tetralux::@NAME@ {
namespace {

@declarations@
const EmbeddedFile kFiles[] = {
@entries@};

}  // namespace

std::span<const EmbeddedFile> files() { return kFiles; }

}  // namespace tetralux::@NAME@
]] @ONLY)
  file(CONFIGURE OUTPUT ${dir}/${NAME}.h CONTENT [[// Generated: files compiled into the program.
#pragma once

#include "base/embedded.h"

namespace tetralux::@NAME@ {

std::span<const EmbeddedFile> files();

}  // namespace tetralux::@NAME@
]] @ONLY)
  set_source_files_properties(${dir}/${NAME}.cpp PROPERTIES OBJECT_DEPENDS "${outputs}")
  target_sources(${TARGET} PRIVATE ${dir}/${NAME}.cpp ${outputs})
  target_include_directories(${TARGET} PRIVATE ${dir})
endfunction()
