# SPDX-License-Identifier: BSD-3-Clause
# tzc_clang_program(NAME OUTPUT path [COMPILE flag...] [LINK flag...] [DEPENDS file...] SOURCES file... [TOGETHER file...])
#
# A test program that Clang builds, whatever compiler the project uses: for libFuzzer, and because Clang compiles much
# generated code with sanitizers in half of GCC's time. The files of TOGETHER are compiled as one, where CMAKE_UNITY_BUILD is
# on. Target NAME is part of ALL.
include(TzcLlvmVersions)
list(TRANSFORM TZC_LLVM_VERSIONS PREPEND clang++- OUTPUT_VARIABLE names)
find_program(TZC_CLANGXX NAMES ${names} clang++)
if(POLICY CMP0116)
  cmake_policy(SET CMP0116 NEW)  # dependency files hold absolute paths here
endif()

function(tzc_clang_program name)
  cmake_parse_arguments(PROGRAM "" "OUTPUT" "SOURCES;TOGETHER;COMPILE;LINK;DEPENDS" ${ARGN})
  if(PROGRAM_TOGETHER AND CMAKE_UNITY_BUILD)
    set(unity ${CMAKE_CURRENT_BINARY_DIR}/${name}.dir/together.cpp)
    list(TRANSFORM PROGRAM_TOGETHER REPLACE "(.+)" "#include \"\\1\"\n" OUTPUT_VARIABLE includes)
    string(CONCAT includes ${includes})
    file(GENERATE OUTPUT ${unity} CONTENT "${includes}")
    list(APPEND PROGRAM_SOURCES ${unity})
  else()
    list(APPEND PROGRAM_SOURCES ${PROGRAM_TOGETHER})
  endif()
  set(depfiles ON)
  if(NOT CMAKE_GENERATOR MATCHES "Ninja" AND CMAKE_VERSION VERSION_LESS 3.20)
    set(depfiles OFF)
  endif()
  set(objects)
  foreach(source ${PROGRAM_SOURCES})
    file(RELATIVE_PATH object ${PROJECT_SOURCE_DIR} ${source})
    string(REGEX REPLACE "[^A-Za-z0-9_]" "_" object ${object})
    set(object ${CMAKE_CURRENT_BINARY_DIR}/${name}.dir/${object}.o)
    set(depfile)
    if(depfiles)
      set(depfile DEPFILE ${object}.d)
    endif()
    add_custom_command(OUTPUT ${object}
      COMMAND ${CMAKE_CXX_COMPILER_LAUNCHER} ${TZC_CLANGXX} ${PROGRAM_COMPILE} -MD -MT ${object} -MF ${object}.d
        -c ${source} -o ${object}
      DEPENDS ${source} ${PROGRAM_DEPENDS}
      ${depfile}
      COMMENT "Clang: ${source}"
      VERBATIM)
    list(APPEND objects ${object})
  endforeach()
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/${name}.dir)
  add_custom_command(OUTPUT ${PROGRAM_OUTPUT}
    COMMAND ${TZC_CLANGXX} ${objects} -o ${PROGRAM_OUTPUT} ${PROGRAM_LINK}
    DEPENDS ${objects}
    VERBATIM)
  add_custom_target(${name} ALL DEPENDS ${PROGRAM_OUTPUT})
endfunction()
