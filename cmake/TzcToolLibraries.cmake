# SPDX-License-Identifier: BSD-3-Clause
# tzc_find_tool_libraries(REQUIRED|QUIET)
#
# The libraries of the tools, in the oldest versions that have what is used: fmt::runtime, nlohmann::ordered_json. Each
# folder asks for itself: imported targets are seen below the folder that found them. Ubuntu 20.04 has older ones
# (packaging/docker/noetic.Dockerfile).
macro(tzc_find_tool_libraries how)
  find_package(CLI11 2 ${how})
  find_package(fmt 8 ${how})
  find_package(nlohmann_json 3.9 ${how})
endmacro()
