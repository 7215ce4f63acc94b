# SPDX-License-Identifier: BSD-3-Clause
# Debian packages: `cpack` in a build folder that was configured with -DCMAKE_INSTALL_PREFIX=/usr, on the distribution
# that they are for. libtzc0 (what ported nodes run on), libtzc-dev (what packages are built with), tzc-tools (tzc-rewrite,
# tzc-compare, tzc-monitor, tzc-diagnostics). packaging/README.md has the commands.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME tzc)
set(CPACK_PACKAGE_VENDOR "The TZC maintainers")
set(CPACK_PACKAGE_CONTACT "The TZC maintainers <maintainers@tzc.invalid>")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime dev)
if(TARGET tzc-rewrite OR TARGET tzc-monitor)
  list(APPEND CPACK_COMPONENTS_ALL tools)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${TZC_DEVEL_PREFIX}/lib)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libtzc0)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_RUNTIME_DESCRIPTION "Towards zero-copy messages for ROS 1: libraries and tzc-run
 Ported nodes build large arrays in shared memory and send only a small control part.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libtzc-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_DESCRIPTION "Towards zero-copy messages for ROS 1: headers, CMake files, message generator
 What packages are built with that were ported to TZC.")
set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS ON)
# A package that uses tzc finds with tzc what tzc depends on, so libtzc-dev depends on what has those CMake files here.
set(dev_depends "libtzc0 (= ${PROJECT_VERSION})" catkin)
foreach(depend ${TZC_CATKIN_DEPENDS})
  execute_process(COMMAND dpkg-query --search ${${depend}_DIR}/${depend}Config.cmake OUTPUT_VARIABLE owner ERROR_QUIET)
  if(owner MATCHES "^([^:,]+):")
    list(APPEND dev_depends ${CMAKE_MATCH_1})
  elseif(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
    message(WARNING "no Debian package has ${depend}, so libtzc-dev will not depend on it")
  endif()
endforeach()
list(REMOVE_DUPLICATES dev_depends)
list(JOIN dev_depends ", " CPACK_DEBIAN_DEV_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_DEV_PACKAGE_RECOMMENDS "tzc-tools")

set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME tzc-tools)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "libtzc-dev (= ${PROJECT_VERSION})")
set(run_by_compare "python3-rosbag, python3-roslaunch, python3-rosparam")
if(TARGET tzc-rewrite)
  set(CPACK_DEBIAN_TOOLS_DESCRIPTION "Towards zero-copy messages for ROS 1: tzc-rewrite, which ports packages
 Reads a roscpp package as the compiler does, and changes its sources so that messages are not copied.")
  # Clang's own headers; the libraries are found by dpkg-shlibdeps.
  string(APPEND CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS ", libclang-common-${TZC_CLANG_MAJOR}-dev, patch")
  set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS "git, ${run_by_compare}, rosbash")
else()
  set(CPACK_DEBIAN_TOOLS_DESCRIPTION "Towards zero-copy messages for ROS 1: tzc-monitor, which shows what nodes share
 Reads what the nodes of this machine tell of their connections, and says why one does not use shared memory.")
  set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS "${run_by_compare}, rosbash")
endif()
include(CPack)
