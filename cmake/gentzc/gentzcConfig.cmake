# SPDX-License-Identifier: BSD-3-Clause
# genmsg's plugin: what generate_messages() calls for each message and service of a package, and once at the end.
set(gentzc_FOUND TRUE)
set(gentzc_INSTALL_DIR include/tzc)

# folder is CATKIN_DEVEL_PREFIX/include/tzc/PACKAGE: genmsg installs it.
macro(_generate_msg_tzc package file include_flags dependencies folder)
  file(MAKE_DIRECTORY ${folder})
  _tzc_generate_missing(${package} "${include_flags}")
  _tzc_header_command(_tzc_headers ${package} ${file} "${include_flags}" ${folder}/../.. "${dependencies}")
  list(APPEND ALL_GEN_OUTPUT_FILES_tzc ${_tzc_headers})
endmacro()

macro(_generate_srv_tzc package file include_flags dependencies folder)
  _generate_msg_tzc(${package} ${file} "${include_flags}" "${dependencies}" ${folder})
endmacro()

# Who waits for a package's C++ headers waits for its TZC headers, too, and for those that they include.
macro(_generate_module_tzc package folder headers)
  if(TARGET ${package}_generate_messages_cpp)
    get_property(_tzc_needed GLOBAL PROPERTY tzc_needed_by_${package})
    add_dependencies(${package}_generate_messages_cpp ${package}_generate_messages_tzc ${_tzc_needed})
  endif()
endmacro()
