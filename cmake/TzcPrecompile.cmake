# SPDX-License-Identifier: BSD-3-Clause
# tzc_precompile(TARGET header...)
#
# Compiles headers once for all files of a target: ROS's, Boost's and Clang's take longer than what the files themselves
# say. Every file still includes what it uses; style.tidy reads it without the precompiled header.
set(TZC_CCACHE_PRECOMPILED "${CMAKE_CURRENT_LIST_DIR}/ccache-precompiled")

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

# Such files are cached, too.
function(tzc_cache_precompiled target)
  if(TZC_CCACHE AND CMAKE_CXX_COMPILER_LAUNCHER STREQUAL TZC_CCACHE)
    set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER
      "${TZC_CCACHE_PRECOMPILED};${TZC_CCACHE}")
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      target_compile_options(${target} PRIVATE -fpch-preprocess)
    endif()
  endif()
endfunction()
