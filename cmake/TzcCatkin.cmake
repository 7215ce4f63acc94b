# SPDX-License-Identifier: BSD-3-Clause
# The ROS side: catkin's macros, and roscpp with what the transport needs of it.

# catkin runs the first python3 on the PATH; a private Python in front of the system's lacks catkin_pkg.
if(NOT PYTHON_EXECUTABLE)
  find_program(TZC_PYTHON3 python3)
  execute_process(COMMAND ${TZC_PYTHON3} -c "import catkin_pkg" RESULT_VARIABLE no_catkin_pkg OUTPUT_QUIET ERROR_QUIET)
  if(no_catkin_pkg)
    set(PYTHON_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that has catkin_pkg")
  endif()
endif()
set(ENV{ROS_VERSION} 1)  # Debian's pluginlib asks for ament otherwise

find_package(catkin REQUIRED COMPONENTS roscpp roscpp_serialization roscpp_traits rosconsole roslib)
