# tetralux_library(NAME SOURCES file... DEPENDS target... [PRIVATE_DEPENDS target...])
#
# One folder of src/ as a static library. Headers are included as "folder/header.h". Every library has an include
# directory of its own that holds nothing but a link to its folder, so an include of a folder that is not among
# DEPENDS (or theirs) does not build: the architecture is checked by the compiler.
set(TETRALUX_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion -Wnon-virtual-dtor -Werror
    -Wno-missing-field-initializers)  # members left out are zero on purpose: Vulkan's structures name their type first
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  list(APPEND TETRALUX_WARNINGS -Wno-restrict)  # false alarms in std::string::assign (GCC bug 105651)
endif()

add_library(tetralux_options INTERFACE)
target_compile_options(tetralux_options INTERFACE ${TETRALUX_WARNINGS})
target_compile_definitions(tetralux_options INTERFACE GLM_FORCE_DEPTH_ZERO_TO_ONE)
if(TETRALUX_SANITIZE)
  target_compile_options(tetralux_options INTERFACE -fsanitize=${TETRALUX_SANITIZE} -fno-omit-frame-pointer
                                                    -fno-sanitize-recover=all)
  target_link_options(tetralux_options INTERFACE -fsanitize=${TETRALUX_SANITIZE})
endif()
if(TETRALUX_COVERAGE)
  target_compile_options(tetralux_options INTERFACE --coverage)
  target_link_options(tetralux_options INTERFACE --coverage)
endif()

function(tetralux_library NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(${NAME} STATIC ${ARG_SOURCES})
  set(layer ${PROJECT_BINARY_DIR}/layers/${NAME})
  file(MAKE_DIRECTORY ${layer})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/src/${NAME} ${layer}/${NAME} SYMBOLIC)
  target_include_directories(${NAME} PUBLIC ${layer})
  target_link_libraries(${NAME} PUBLIC ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE_DEPENDS} tetralux_options)
endfunction()
