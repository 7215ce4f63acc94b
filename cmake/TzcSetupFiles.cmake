# SPDX-License-Identifier: BSD-3-Clause
# catkin's setup.bash and its kin in the prefix of installation, which is chosen as late as `cmake --install --prefix`.
# setup.sh is the one that cannot find out where it is, so the prefix is written into it then. A prefix that has setup
# files keeps them: it is a ROS installation or another workspace's, and they do the same.
install(CODE "set(generated \"${CMAKE_BINARY_DIR}/catkin_generated/installspace\")
set(setup_util \"${CATKIN_DEVEL_PREFIX}/_setup_util.py\")" COMPONENT dev)
install(SCRIPT cmake/install_setup_files.cmake COMPONENT dev)
