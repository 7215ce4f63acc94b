# SPDX-License-Identifier: BSD-3-Clause
# The ROS side: catkin's macros, roscpp with what the transport needs of it, and tzc as a catkin package. The files by
# which other packages find tzc are tzc's own (TzcInstall): catkin's know the prefix of configuration only.

# catkin runs the first python3 on the PATH; a private Python in front of the system's lacks catkin_pkg.
if(NOT PYTHON_EXECUTABLE)
  find_program(TZC_PYTHON3 python3)
  execute_process(COMMAND ${TZC_PYTHON3} -c "import catkin_pkg" RESULT_VARIABLE no_catkin_pkg OUTPUT_QUIET ERROR_QUIET)
  if(no_catkin_pkg)
    set(PYTHON_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that has catkin_pkg")
  endif()
endif()
set(ENV{ROS_VERSION} 1)  # Debian's pluginlib asks for ament otherwise
if(TZC_STANDALONE)
  set(CATKIN_ENABLE_TESTING OFF CACHE BOOL "tzc has its own tests")
  set(CATKIN_INSTALL_INTO_PREFIX_ROOT FALSE)  # catkin would install setup.bash to the prefix of configuration
endif()

set(TZC_CATKIN_DEPENDS roscpp roscpp_serialization roscpp_traits rosconsole roslib sensor_msgs std_msgs)
find_package(catkin QUIET)
if(NOT catkin_FOUND)
  message(FATAL_ERROR "catkin was not found: source ROS's setup.bash first (/opt/ros/noetic/setup.bash), run scripts/setup, "
    "or give -DTZC_BUILD_ROSCPP=OFF for what needs no ROS")
endif()
find_package(catkin REQUIRED COMPONENTS ${TZC_CATKIN_DEPENDS})

file(MAKE_DIRECTORY ${CATKIN_DEVEL_PREFIX}/include)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME runtime)  # package.xml, which rosrun looks for
catkin_package(SKIP_CMAKE_CONFIG_GENERATION SKIP_PKG_CONFIG_GENERATION CATKIN_DEPENDS ${TZC_CATKIN_DEPENDS})

# catkin_package() has its own idea of where binaries go. Packages that use tzc look for libraries in the devel space,
# and a workspace's setup.bash puts the devel space's bin folder on the PATH.
if(TZC_STANDALONE)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
else()
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/bin)
endif()
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/lib)
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
