# SPDX-License-Identifier: BSD-3-Clause
# tzc_find_tool_libraries(REQUIRED|QUIET)
#
# The libraries of the tools, in the oldest versions that have what is used: fmt::runtime, nlohmann::ordered_json. Each
# folder asks for itself: imported targets are seen below the folder that found them. Ubuntu 20.04 has older ones
# (packaging/docker/noetic.Dockerfile).
macro(tzc_find_tool_libraries how)
  find_package(CLI11 2 QUIET)
  find_package(fmt 8 QUIET)
  find_package(nlohmann_json 3.9 QUIET)
  if("${how}" STREQUAL "REQUIRED" AND NOT (CLI11_FOUND AND fmt_FOUND AND nlohmann_json_FOUND))
    message(FATAL_ERROR "TZC's tools need CLI11 2, fmt 8 and nlohmann_json 3.9, or later: scripts/setup installs them. Ubuntu "
      "20.04 has older ones or none; packaging/docker/noetic.Dockerfile shows how to build them")
  endif()
endmacro()
