# SPDX-License-Identifier: BSD-3-Clause
# The ROS side: catkin's macros, roscpp with what the transport needs of it, and tzc as a catkin package, which
# find_package(tzc) and find_package(catkin COMPONENTS tzc) find in an install tree and in a build tree (its devel/).

# catkin runs the first python3 on the PATH; a private Python in front of the system's lacks catkin_pkg.
if(NOT PYTHON_EXECUTABLE)
  find_program(TZC_PYTHON3 python3)
  execute_process(COMMAND ${TZC_PYTHON3} -c "import catkin_pkg" RESULT_VARIABLE no_catkin_pkg OUTPUT_QUIET ERROR_QUIET)
  if(no_catkin_pkg)
    set(PYTHON_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that has catkin_pkg")
  endif()
endif()
set(ENV{ROS_VERSION} 1)  # Debian's pluginlib asks for ament otherwise
set(CATKIN_ENABLE_TESTING OFF CACHE BOOL "tzc has its own tests")

find_package(catkin REQUIRED COMPONENTS roscpp roscpp_serialization roscpp_traits rosconsole roslib)

file(MAKE_DIRECTORY ${CATKIN_DEVEL_PREFIX}/include)
catkin_package(
  INCLUDE_DIRS runtime/include ${CATKIN_DEVEL_PREFIX}/include
  LIBRARIES tzc_roscpp tzc_core
  CATKIN_DEPENDS roscpp roscpp_serialization roscpp_traits rosconsole roslib
  CFG_EXTRAS tzc-extras.cmake)

# catkin_package() has its own idea of where binaries go. Packages that use tzc look for libraries in the devel space.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/lib)
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
