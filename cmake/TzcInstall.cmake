# SPDX-License-Identifier: BSD-3-Clause
# Everything that is installed, in the components runtime, dev and tools, and how others find it: as a CMake package
# (tzc::core, tzc::tzc), as a catkin package and with pkg-config; from an install tree and from a build tree (devel/).
# Nothing of it names the prefix: `cmake --install build --prefix P` may choose another one than the configuration.

set(TZC_DEVEL_PREFIX ${PROJECT_BINARY_DIR}/devel)
if(CATKIN_DEVEL_PREFIX)
  set(TZC_DEVEL_PREFIX ${CATKIN_DEVEL_PREFIX})
endif()

# --- libraries
set(libraries tzc_core)
foreach(library tzc_roscpp tzc_preload)
  if(TARGET ${library})
    list(APPEND libraries ${library})
  endif()
endforeach()
foreach(library tzc_core tzc_roscpp)
  if(TARGET ${library})
    set_target_properties(${library} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION 0)  # docs/versions.md
  endif()
endforeach()
if(NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set_target_properties(${libraries} PROPERTIES INSTALL_RPATH "$ORIGIN")  # libtzc_core.so is beside them
endif()
install(TARGETS ${libraries}
  LIBRARY DESTINATION ${TZC_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT dev)

# --- headers
foreach(folder ${TZC_PUBLIC_INCLUDE_DIRS})
  install(DIRECTORY ${folder}/tzc DESTINATION include COMPONENT dev FILES_MATCHING PATTERN "*.h")
endforeach()
if(TARGET tzc_installed_messages)
  install(DIRECTORY ${TZC_DEVEL_PREFIX}/include/tzc DESTINATION include COMPONENT dev FILES_MATCHING PATTERN "*.h")
endif()

# --- programs: in bin, and where rosrun looks. TZC_TOOLS is the list of them, each with TZC_TOOL_<name>: component and what
# it does, for manual pages, completion and tests.
set(TZC_TOOLS "")
macro(_tzc_tool name component does)
  list(APPEND TZC_TOOLS ${name})
  set(TZC_TOOL_${name} ${component} "${does}")
  _tzc_link_tool(${name} ${component})
endmacro()
function(_tzc_link_tool name component)
  set(link ${PROJECT_BINARY_DIR}/libexec/${name})
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/libexec ${TZC_DEVEL_PREFIX}/lib/tzc)
  file(CREATE_LINK ../../bin/${name} ${link} SYMBOLIC)
  install(FILES ${link} DESTINATION lib/tzc COMPONENT ${component})
  file(CREATE_LINK ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/${name} ${TZC_DEVEL_PREFIX}/lib/tzc/${name} SYMBOLIC)
endfunction()
macro(_tzc_program name component does)
  if(TARGET ${name})
    install(TARGETS ${name} RUNTIME DESTINATION bin COMPONENT ${component})
    _tzc_tool(${name} ${component} "${does}")
  endif()
endmacro()
_tzc_program(tzc-msggen dev "generates TZC headers of ROS messages")  # builds of packages with messages run it
_tzc_program(tzc-rewrite tools "ports roscpp packages to TZC")
_tzc_program(tzc-monitor tools "shows what nodes do with shared memory")
_tzc_program(tzc-diagnostics tools "publishes on /diagnostics what nodes do with shared memory")
if(TARGET tzc_compare)  # installed by its own folder, as its recorder is
  _tzc_tool(tzc-compare tools "compares what an original and a ported workspace publish")
endif()
if(TARGET tzc_preload)
  install(PROGRAMS ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/tzc-run DESTINATION bin COMPONENT runtime)
  _tzc_tool(tzc-run runtime "runs an unmodified roscpp program with shared memory")
endif()
install(PROGRAMS packaging/ci/check.sh packaging/ci/pre-commit DESTINATION share/tzc/ci COMPONENT tools)

# --- documentation: messages of nodes and tools name a page as share/doc/tzc/PAGE, which is below the prefix and in the devel
# space. File by file there, as catkin_tools does not follow links to folders.
install(DIRECTORY docs/ DESTINATION share/doc/tzc COMPONENT runtime
  FILES_MATCHING PATTERN "*.md" PATTERN "*.svg" PATTERN "*.csv")
file(GLOB_RECURSE pages RELATIVE ${PROJECT_SOURCE_DIR}/docs CONFIGURE_DEPENDS docs/*.md docs/*.svg docs/*.csv)
foreach(page ${pages})
  get_filename_component(folder ${TZC_DEVEL_PREFIX}/share/doc/tzc/${page} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/docs/${page} ${TZC_DEVEL_PREFIX}/share/doc/tzc/${page} SYMBOLIC)
endforeach()

# --- how others find it
set(TZC_HAS_ROSCPP ${TZC_BUILD_ROSCPP})
if(TARGET tzc_roscpp)
  add_library(tzc::tzc ALIAS tzc_roscpp)  # for packages of the same workspace
  target_include_directories(tzc_roscpp INTERFACE ${TZC_DEVEL_PREFIX}/include)
endif()
string(REGEX REPLACE "[^/]+" ".." to_prefix ${TZC_INSTALL_CMAKEDIR})
set(TZC_LOCATIONS "set(tzc_PREFIX \"${TZC_DEVEL_PREFIX}\")
set(_tzc_lib_dir \"\${tzc_PREFIX}/lib\")
set(_tzc_include_dirs \"${TZC_PUBLIC_INCLUDE_DIRS};\${tzc_PREFIX}/include\")
set(_tzc_cmake_dir \"${PROJECT_SOURCE_DIR}/cmake\")
set(TZC_MSGGEN_EXECUTABLE \"${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/tzc-msggen\")
set(TZC_REWRITE_EXECUTABLE \"${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/tzc-rewrite\")")
# By way of another folder: configure_file() writes a temporary file beside its output, and tzc-rewrite --check, which may
# run meanwhile, keeps no result when a folder that CMake reads from changes.
configure_file(cmake/tzcConfig.cmake.in ${PROJECT_BINARY_DIR}/develspace/tzcConfig.cmake @ONLY)
configure_file(${PROJECT_BINARY_DIR}/develspace/tzcConfig.cmake ${TZC_DEVEL_PREFIX}/share/tzc/cmake/tzcConfig.cmake COPYONLY)
list(JOIN TZC_PUBLIC_INCLUDE_DIRS "\n" folders)
# Read by tzc-rewrite; not written anew when the text is the same.
file(GENERATE OUTPUT ${TZC_DEVEL_PREFIX}/share/tzc/include_folders
  CONTENT "${folders}\n${TZC_DEVEL_PREFIX}/include\n")
set(TZC_LOCATIONS "get_filename_component(tzc_PREFIX \"\${CMAKE_CURRENT_LIST_DIR}\" REALPATH)  # /lib may be a link
get_filename_component(tzc_PREFIX \"\${tzc_PREFIX}/${to_prefix}\" ABSOLUTE)
set(_tzc_lib_dir \"\${tzc_PREFIX}/${TZC_INSTALL_LIBDIR}\")
set(_tzc_include_dirs \"\${tzc_PREFIX}/include\")
set(_tzc_cmake_dir \"\${CMAKE_CURRENT_LIST_DIR}\")
set(TZC_MSGGEN_EXECUTABLE \"\${tzc_PREFIX}/bin/tzc-msggen\")
set(TZC_REWRITE_EXECUTABLE \"\${tzc_PREFIX}/bin/tzc-rewrite\")")
configure_file(cmake/tzcConfig.cmake.in ${PROJECT_BINARY_DIR}/installspace/tzcConfig.cmake @ONLY)

include(CMakePackageConfigHelpers)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/installspace/tzcConfig-version.cmake
  COMPATIBILITY SameMinorVersion)
configure_file(${PROJECT_BINARY_DIR}/installspace/tzcConfig-version.cmake
  ${TZC_DEVEL_PREFIX}/share/tzc/cmake/tzcConfig-version.cmake COPYONLY)
install(FILES ${PROJECT_BINARY_DIR}/installspace/tzcConfig.cmake
  ${PROJECT_BINARY_DIR}/installspace/tzcConfig-version.cmake cmake/tzc_generate_messages.cmake
  cmake/tzc_check.cmake
  DESTINATION ${TZC_INSTALL_CMAKEDIR} COMPONENT dev)
install(FILES cmake/gentzc/gentzcConfig.cmake DESTINATION ${TZC_INSTALL_CMAKEDIR}/gentzc COMPONENT dev)

# tzc_core.pc for programs without ROS, tzc.pc for nodes.
function(_tzc_pc name)
  set(prefix "\${pcfiledir}/${to_prefix}")
  set(libdir "\${prefix}/${TZC_INSTALL_LIBDIR}")
  set(cflags "-I\${prefix}/include")
  configure_file(cmake/${name}.pc.in ${PROJECT_BINARY_DIR}/installspace/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/installspace/${name}.pc
    DESTINATION ${TZC_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)
  set(prefix ${TZC_DEVEL_PREFIX})
  set(libdir "\${prefix}/lib")
  list(TRANSFORM TZC_PUBLIC_INCLUDE_DIRS PREPEND -I OUTPUT_VARIABLE folders)
  list(JOIN folders " " cflags)
  set(cflags "${cflags} -I\${prefix}/include")
  configure_file(cmake/${name}.pc.in ${TZC_DEVEL_PREFIX}/lib/pkgconfig/${name}.pc @ONLY)
endfunction()
string(REGEX REPLACE "[^/]+" ".." to_prefix ${TZC_INSTALL_LIBDIR}/pkgconfig)
_tzc_pc(tzc_core)
if(TZC_BUILD_ROSCPP)
  list(JOIN TZC_CATKIN_DEPENDS " " TZC_PC_REQUIRES)
  _tzc_pc(tzc)
endif()

if(TZC_BUILD_ROSCPP AND TZC_STANDALONE AND NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  include(TzcSetupFiles)
endif()
