# SPDX-License-Identifier: BSD-3-Clause
# What is built. TZC_STANDALONE: a person runs cmake on this folder; otherwise catkin builds it as a member of a
# workspace (catkin_make, catkin_make_isolated, catkin build), which then owns prefix, setup files and build type, and
# wants neither tests nor benchmarks. Both say so in different words: catkin_make includes the project, the others hand
# it to cmake with a devel space of their choice. That is decided once: catkin caches its own devel space later on.
if(NOT DEFINED TZC_STANDALONE)
  set(standalone ON)
  if(NOT CMAKE_SOURCE_DIR STREQUAL PROJECT_SOURCE_DIR OR DEFINED CATKIN_DEVEL_PREFIX)
    set(standalone OFF)
  endif()
  set(TZC_STANDALONE ${standalone} CACHE INTERNAL "tzc is not a member of a workspace")
endif()

option(TZC_BUILD_ROSCPP "Build the roscpp transport and the adapters (needs ROS 1)" ON)
option(TZC_BUILD_MSGGEN "Build tzc-msggen and generate the installed message packages" ON)
set(TZC_BUILD_REWRITER AUTO CACHE STRING "Build tzc-rewrite: ON, OFF, or AUTO where Clang's libraries are found")
option(TZC_BUILD_TESTS "Build the tests" ${TZC_STANDALONE})
option(TZC_BUILD_COMPARE "Build tzc-compare where rosbag is found (needs ROS 1)" ON)
option(TZC_BUILD_MONITOR "Build tzc-monitor where its libraries are found" ON)
option(TZC_BUILD_BENCH "Build tzc-bench" ${TZC_STANDALONE})
set(TZC_SANITIZE "" CACHE STRING "Sanitizers for everything: address,undefined or thread")

if(TZC_BUILD_REWRITER)
  include(TzcClang)
  if(NOT TZC_CLANG_FOUND)
    if(NOT TZC_BUILD_REWRITER STREQUAL "AUTO")
      message(FATAL_ERROR "tzc-rewrite needs Clang's libraries: ${TZC_CLANG_MISSING}")
    endif()
    message(STATUS "tzc-rewrite is left out: ${TZC_CLANG_MISSING}")
    set(TZC_BUILD_REWRITER OFF)  # for this run; the next one looks again
  endif()
endif()
