# SPDX-License-Identifier: BSD-3-Clause
# tzc_check([BASELINE file] [ARGUMENTS argument...])
#
# A target PACKAGE_tzc_check that fails when the package has a site that should be ported and is not, and a target
# tzc_check for all packages of the workspace that call this. Neither is part of a normal build.
#
#   find_package(catkin REQUIRED COMPONENTS roscpp tzc)
#   tzc_check(BASELINE tzc.json)          # tzc.json: a report of today, whose sites are accepted
#
# It needs tzc-rewrite, and the workspace configured with -DCMAKE_EXPORT_COMPILE_COMMANDS=ON. Headers of the package's
# own messages must have been built.
function(tzc_check)
  cmake_parse_arguments(ARG "" "BASELINE" "ARGUMENTS" ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "tzc_check(): unknown arguments: ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  set(command ${TZC_REWRITE_EXECUTABLE} --check -p ${CMAKE_BINARY_DIR} ${ARG_ARGUMENTS})
  if(TARGET tzc-rewrite)  # built in the same workspace
    list(REMOVE_AT command 0)
    list(INSERT command 0 $<TARGET_FILE:tzc-rewrite>)
  elseif(NOT EXISTS ${TZC_REWRITE_EXECUTABLE})
    set(command ${CMAKE_COMMAND} -E echo "tzc_check: this installation of tzc has no tzc-rewrite" COMMAND false)
  endif()
  if(ARG_BASELINE)
    get_filename_component(baseline ${ARG_BASELINE} ABSOLUTE)
    list(APPEND command --baseline ${baseline})
  endif()
  add_custom_target(${PROJECT_NAME}_tzc_check
    COMMAND ${command} ${PROJECT_SOURCE_DIR}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    COMMENT "Is every site of ${PROJECT_NAME} ported to TZC?"
    USES_TERMINAL VERBATIM)
  if(NOT TARGET tzc_check)
    add_custom_target(tzc_check)
  endif()
  add_dependencies(tzc_check ${PROJECT_NAME}_tzc_check)
endfunction()
