# SPDX-License-Identifier: BSD-3-Clause
# tzc_generate_messages(PACKAGE [FILES file...] [INCLUDES PKG:DIR...] [OUTPUT_DIRECTORY dir])
#
# TZC headers (tzc/PACKAGE/Type.h) of a message package that does not make them itself. Targets that the same
# CMakeLists.txt defines afterwards find them, and are built after them.
#
#   find_package(catkin REQUIRED COMPONENTS roscpp other_msgs tzc)
#   tzc_generate_messages(other_msgs)                    all messages and services of a catkin package
#
#   find_package(tzc REQUIRED)
#   tzc_generate_messages(my_msgs FILES msg/Scan.msg INCLUDES std_msgs:/opt/ros/noetic/share/std_msgs/msg)
#
# FILES are .msg, .srv or .action, all that are wanted of a package, in one call; INCLUDES say where the packages are whose types they use (of a catkin package both
# are known). Headers go to OUTPUT_DIRECTORY, by default a folder of this build.
# A package that calls generate_messages() with tzc among its catkin components needs none of this.
# In a cross build TZC_HOST_MSGGEN names a tzc-msggen that runs here: -DTZC_HOST_MSGGEN=/usr/bin/tzc-msggen.

# What *-msg-paths.cmake files call. genmsg defines it too, for packages that name message_generation.
if(NOT COMMAND _prepend_path)
  macro(_prepend_path folder names result)  # ... UNIQUE, which a list of one or two folders does not need
    set(${result} "")
    foreach(_tzc_name ${names})
      list(APPEND ${result} ${folder}/${_tzc_name})
    endforeach()
  endmacro()
endif()

# Adds the command that makes the headers of one definition file; their paths are stored in `result`.
function(_tzc_header_command result package file include_flags output_directory dependencies)
  get_filename_component(name ${file} NAME_WE)
  get_filename_component(extension ${file} EXT)
  get_filename_component(folder ${output_directory}/tzc/${package} ABSOLUTE)
  set(names "")
  if(extension STREQUAL ".srv")
    set(names "" Request Response)
  elseif(extension STREQUAL ".action")
    set(names Action ActionGoal ActionResult ActionFeedback Goal Result Feedback)
  endif()
  set(headers ${folder}/${name}.h)
  if(names)
    list(TRANSFORM names PREPEND ${folder}/${name} OUTPUT_VARIABLE headers)
    list(TRANSFORM headers APPEND .h)
  endif()
  set(program ${TZC_MSGGEN_EXECUTABLE})
  if(TZC_HOST_MSGGEN)  # of a cross build, which cannot run what it has built or found
    set(program ${TZC_HOST_MSGGEN})
  elseif(TARGET tzc-msggen)  # built in the same workspace
    set(program tzc-msggen)
  endif()
  add_custom_command(OUTPUT ${headers}
    COMMAND ${program} generate --keep-going -p ${package} ${include_flags} -o ${output_directory} ${file}
    DEPENDS ${program} ${file} ${dependencies}
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    COMMENT "Generating TZC headers from ${package}/${name}${extension}"
    VERBATIM)
  set(${result} ${headers} PARENT_SCOPE)
endfunction()

# The folders of a catkin package's messages and of all that they depend on, as -IPKG:DIR; and the packages' names.
function(_tzc_include_flags package flags_result)
  set(flags "")
  set(pending ${package})
  set(handled "")
  while(pending)
    list(GET pending 0 dependency)
    list(REMOVE_AT pending 0)
    list(APPEND handled ${dependency})
    unset(paths_file CACHE)
    find_file(paths_file share/${dependency}/cmake/${dependency}-msg-paths.cmake
      PATHS ${CATKIN_DEVEL_PREFIX} ${CATKIN_WORKSPACES} ${CMAKE_PREFIX_PATH} ${${dependency}_DIR}/../../..
      CMAKE_FIND_ROOT_PATH_BOTH)  # of a cross build: the workspace does not lie in the sysroot
    if(NOT paths_file)
      message(FATAL_ERROR "tzc_generate_messages(): cannot find ${dependency}-msg-paths.cmake, which a package gets that "
        "calls generate_messages(). Is ${dependency} a message package, and among find_package(catkin COMPONENTS)?")
    endif()
    if(NOT ${dependency}_DIR)  # its -msg-paths.cmake begins there
      get_filename_component(${dependency}_DIR ${paths_file} DIRECTORY)
    endif()
    include(${paths_file})
    unset(paths_file CACHE)
    foreach(folder ${${dependency}_MSG_INCLUDE_DIRS})
      list(APPEND flags -I${dependency}:${folder})
    endforeach()
    foreach(next ${${dependency}_MSG_DEPENDENCIES})
      if(NOT next IN_LIST handled AND NOT next IN_LIST pending)
        list(APPEND pending ${next})
      endif()
    endforeach()
  endwhile()
  set(${flags_result} ${flags} PARENT_SCOPE)
endfunction()

# All definition files of a catkin package, absolute.
function(_tzc_definition_files package result)
  if(NOT DEFINED ${package}_MESSAGE_FILES)
    find_package(${package} REQUIRED)
  endif()
  set(files "")
  foreach(file ${${package}_MESSAGE_FILES} ${${package}_SERVICE_FILES})
    get_filename_component(file ${file} ABSOLUTE BASE_DIR ${${package}_DIR}/..)
    list(APPEND files ${file})
  endforeach()
  set(${result} ${files} PARENT_SCOPE)
endfunction()

# The definition files in the folders of such flags: what a message may be made of.
function(_tzc_definitions_in include_flags result)
  set(definitions "")
  foreach(flag ${include_flags})
    string(REGEX REPLACE "^-I[^:]*:" "" folder ${flag})
    file(GLOB files ${folder}/*.msg)
    list(APPEND definitions ${files})
  endforeach()
  set(${result} ${definitions} PARENT_SCOPE)
endfunction()

# Headers that this build makes for other packages than this one's lie in the devel space, and where it is installed, with a
# file that names the build. Without it the next run of CMake would take them for somebody else's and make none.
set(_tzc_mark made_by)

function(_tzc_mark_as_own folder)
  set(builder "")
  if(EXISTS ${folder}/${_tzc_mark})
    file(READ ${folder}/${_tzc_mark} builder)
  endif()
  if(NOT builder STREQUAL CMAKE_BINARY_DIR)
    file(WRITE ${folder}/${_tzc_mark} "${CMAKE_BINARY_DIR}")
  endif()
endfunction()

# Whether a package is installed, so that `tzc-msggen --installed` sees its messages: a devel space names them by absolute paths.
function(_tzc_is_installed package result)
  if(NOT DEFINED ${package}_MESSAGE_FILES AND NOT DEFINED ${package}_SERVICE_FILES)
    find_package(${package} QUIET)
  endif()
  set(${result} TRUE PARENT_SCOPE)
  foreach(file ${${package}_MESSAGE_FILES} ${${package}_SERVICE_FILES})
    if(IS_ABSOLUTE ${file})
      set(${result} FALSE PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# Whether this build makes the headers that lie in a folder, or made them when its own folder had another name.
function(_tzc_is_own folder package result)
  set(builder "")
  if(EXISTS ${folder}/tzc/${package}/${_tzc_mark})
    file(READ ${folder}/tzc/${package}/${_tzc_mark} builder)
  endif()
  set(${result} FALSE PARENT_SCOPE)
  if(builder STREQUAL CMAKE_BINARY_DIR OR
     (builder AND NOT EXISTS "${builder}" AND folder STREQUAL "${CATKIN_DEVEL_PREFIX}/include"))
    set(${result} TRUE PARENT_SCOPE)
  endif()
endfunction()

# Whether tzc/PACKAGE/*.h exists already, and this build is not who makes it.
function(_tzc_has_headers package result)
  set(${result} FALSE PARENT_SCOPE)
  if(TARGET ${package}_generate_messages_tzc)
    set(${result} TRUE PARENT_SCOPE)
  elseif(TARGET tzc_installed_messages AND NOT DEFINED ${package}_SOURCE_DIR)
    _tzc_is_installed(${package} is_installed)  # tzc is built in the same workspace, the package is not
    set(${result} ${is_installed} PARENT_SCOPE)
  endif()
  if(DEFINED ${package}_SOURCE_DIR)
    return()  # the workspace's own: what came with TZC is of another version, the one that this overlays
  endif()
  foreach(folder ${tzc_INCLUDE_DIRS} ${${package}_INCLUDE_DIRS})
    if(EXISTS ${folder}/tzc/${package})
      _tzc_is_own(${folder} ${package} is_own)
      if(NOT is_own)
        set(${result} TRUE PARENT_SCOPE)
      endif()
    endif()
  endforeach()
endfunction()

# For genmsg's plugin: the headers of packages that this one's messages use and that have none. They go with this
# package's own, because who includes those needs them; what a node made for itself before (tzc_messages_of_...) does not.
function(_tzc_generate_missing package include_flags)
  foreach(flag ${include_flags})
    string(REGEX REPLACE "^-I([^:]*):.*$" "\\1" dependency ${flag})
    if(dependency STREQUAL package)
      continue()
    endif()
    set(target tzc_exported_messages_of_${dependency})  # another package of this workspace may have come first
    _tzc_has_headers(${dependency} has_headers)
    if(NOT TARGET ${target} AND NOT has_headers)
      _tzc_definition_files(${dependency} files)
      _tzc_include_flags(${dependency} flags)
      _tzc_add_headers(${target} ${dependency} ${CATKIN_DEVEL_PREFIX}/include "${flags}" ${files})
      _tzc_mark_as_own(${CATKIN_DEVEL_PREFIX}/include/tzc/${dependency})
      install(DIRECTORY ${CATKIN_DEVEL_PREFIX}/include/tzc/${dependency} DESTINATION include/tzc)
    endif()
    if(TARGET ${target})
      link_libraries(${target}_headers)
      set_property(GLOBAL APPEND PROPERTY tzc_needed_by_${package} ${target})
    endif()
  endforeach()
endfunction()

# A target that makes the headers of the files, and an interface library that carries the include folder and the order of
# building to every later target of a folder that links it.
function(_tzc_add_headers target package output_directory include_flags)  # FILE...
  _tzc_definitions_in("${include_flags}" dependencies)
  set(all_headers "")
  foreach(file ${ARGN})
    _tzc_header_command(headers ${package} ${file} "${include_flags}" ${output_directory} "${dependencies};${ARGN}")
    list(APPEND all_headers ${headers})
  endforeach()
  file(MAKE_DIRECTORY ${output_directory}/tzc/${package})
  add_custom_target(${target} ALL DEPENDS ${all_headers})
  set_target_properties(${target} PROPERTIES TZC_DEFINITIONS "${ARGN}")
  if(TARGET ${package}_generate_messages_cpp)
    add_dependencies(${target} ${package}_generate_messages_cpp)
  endif()
  add_library(${target}_headers INTERFACE)
  target_include_directories(${target}_headers INTERFACE ${output_directory})
  add_dependencies(${target}_headers ${target})
endfunction()

# One target makes a package's headers, so that no header is made twice.
function(_tzc_require_definitions target package files)
  get_target_property(made ${target} TZC_DEFINITIONS)
  foreach(file ${files})
    if(NOT file IN_LIST made)
      message(FATAL_ERROR "tzc_generate_messages(${package}): an earlier call makes headers of other files of ${package}, and not "
        "of ${file}. Name all FILES in the first call.")
    endif()
  endforeach()
endfunction()

function(tzc_generate_messages package)
  cmake_parse_arguments(ARG "" "OUTPUT_DIRECTORY" "FILES;INCLUDES" ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "tzc_generate_messages(): unknown arguments: ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  set(files "")
  foreach(file ${ARG_FILES})
    get_filename_component(file ${file} ABSOLUTE)
    list(APPEND files ${file})
  endforeach()
  if(NOT files)
    _tzc_definition_files(${package} files)
  endif()
  set(target tzc_messages_of_${package})
  foreach(known ${target} tzc_exported_messages_of_${package})
    if(TARGET ${known})
      _tzc_require_definitions(${known} ${package} "${files}")
      link_libraries(${known}_headers)
      return()
    endif()
  endforeach()
  if(NOT ARG_OUTPUT_DIRECTORY)
    set(ARG_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/tzc_messages)
  endif()
  list(TRANSFORM ARG_INCLUDES PREPEND -I OUTPUT_VARIABLE flags)
  if(NOT ARG_FILES)
    _tzc_include_flags(${package} flags)
  endif()
  _tzc_add_headers(${target} ${package} ${ARG_OUTPUT_DIRECTORY} "${flags}" ${files})
  link_libraries(${target}_headers)
endfunction()
