# SPDX-License-Identifier: BSD-3-Clause
# tzc_precompile(TARGET header...)
#
# Compiles headers once for all files of a target: ROS's, Boost's and Clang's take longer than what the files themselves
# say. Every file still includes what it uses; style.tidy reads it without the precompiled header.
function(tzc_precompile target)
  target_precompile_headers(${target} PRIVATE ${ARGN})
  tzc_cache_precompiled(${target})
endfunction()

# tzc_share_precompiled(FROM TARGET...): targets with the same flags as FROM read its precompiled header.
function(tzc_share_precompiled from)
  foreach(target ${ARGN})
    target_precompile_headers(${target} REUSE_FROM ${from})
    tzc_cache_precompiled(${target})
  endforeach()
endfunction()

# What ccache and GCC ask for, so that such files are cached, too (ccache's manual, "Precompiled headers").
function(tzc_cache_precompiled target)
  if(TZC_CCACHE AND CMAKE_CXX_COMPILER_LAUNCHER STREQUAL TZC_CCACHE)
    set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND};-E;env;CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime;${TZC_CCACHE}")
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      target_compile_options(${target} PRIVATE -fpch-preprocess)
    endif()
  endif()
endfunction()
