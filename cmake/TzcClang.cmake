# SPDX-License-Identifier: BSD-3-Clause
# The target tzc_clang: the libraries of LLVM and Clang, shared ones (linking the static ones takes minutes).
# Sets TZC_CLANG_FOUND; when it is false, TZC_CLANG_MISSING says what to install.
#
#   TZC_LLVM_VERSION   one of TZC_LLVM_VERSIONS; empty: the newest that is complete
#   TZC_LLVM_CONFIG    an llvm-config of your own
include(TzcLlvmVersions)
set(TZC_LLVM_VERSION "" CACHE STRING "LLVM's major version for tzc-rewrite; empty: the newest of ${TZC_LLVM_VERSIONS}")
set(TZC_LLVM_CONFIG "" CACHE FILEPATH "llvm-config for tzc-rewrite; empty: the one of TZC_LLVM_VERSION")

function(_tzc_ask_llvm program question result)
  execute_process(COMMAND ${program} --${question} OUTPUT_VARIABLE answer OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(${result} "${answer}" PARENT_SCOPE)
endfunction()

# Looks at one llvm-config: sets TZC_CLANG_* in the caller when headers and libraries are complete, else `missing`.
function(_tzc_try_llvm program)
  _tzc_ask_llvm(${program} version version)
  string(REGEX MATCH "^[0-9]+" major "${version}")
  _tzc_ask_llvm(${program} includedir include_dir)
  _tzc_ask_llvm(${program} libdir library_dir)
  find_library(clang NAMES clang-cpp libclang-cpp.so.${major} libclang-cpp.so.${major}.1
               PATHS ${library_dir} NO_DEFAULT_PATH)
  find_library(llvm NAMES LLVM-${major} LLVM PATHS ${library_dir} NO_DEFAULT_PATH)
  find_path(resource NAMES include/stddef.h PATHS ${library_dir}/clang/${major} ${library_dir}/clang/${version}
            NO_DEFAULT_PATH)
  set(missing "")
  if(NOT major IN_LIST TZC_LLVM_VERSIONS)
    set(missing "${program} is of LLVM ${version}; versions ${TZC_LLVM_OLDEST} to ${TZC_LLVM_NEWEST} are known to work")
  elseif(NOT EXISTS ${include_dir}/clang/Tooling/Tooling.h)
    set(missing "${include_dir} has no headers of Clang; install libclang-${major}-dev")
  elseif(NOT clang OR NOT llvm)
    set(missing "${library_dir} has no libclang-cpp.so; install libclang-cpp${major}-dev")
  elseif(NOT resource)
    set(missing "${library_dir}/clang has no stddef.h; install libclang-common-${major}-dev")
  else()
    set(TZC_CLANG_MAJOR ${major} PARENT_SCOPE)
    set(TZC_CLANG_INCLUDE_DIR ${include_dir} PARENT_SCOPE)
    set(TZC_CLANG_LIBRARIES ${clang} ${llvm} PARENT_SCOPE)
    set(TZC_CLANG_RESOURCE ${resource} PARENT_SCOPE)
  endif()
  set(missing "${missing}" PARENT_SCOPE)
  unset(clang CACHE)
  unset(llvm CACHE)
  unset(resource CACHE)
endfunction()

# Every llvm-config to look at, the best first.
function(_tzc_llvm_configs result)
  set(programs "")
  if(TZC_LLVM_CONFIG)
    set(programs ${TZC_LLVM_CONFIG})
  else()
    set(versions ${TZC_LLVM_VERSIONS})
    if(TZC_LLVM_VERSION)
      set(versions ${TZC_LLVM_VERSION})
    endif()
    foreach(version ${versions})
      find_program(program NAMES llvm-config-${version} llvm-config${version} llvm-config-${version}-64
                   HINTS /usr/lib/llvm-${version}/bin /usr/lib/llvm${version}/bin /opt/llvm-${version}/bin)
      if(program)
        list(APPEND programs ${program})
      endif()
      unset(program CACHE)
    endforeach()
    find_program(program NAMES llvm-config)
    if(program AND NOT TZC_LLVM_VERSION)
      list(APPEND programs ${program})
    endif()
    unset(program CACHE)
  endif()
  set(${result} ${programs} PARENT_SCOPE)
endfunction()

set(TZC_CLANG_FOUND FALSE)
set(TZC_CLANG_MISSING "no llvm-config of LLVM ${TZC_LLVM_OLDEST} to ${TZC_LLVM_NEWEST} was found; install \
llvm-${TZC_LLVM_NEWEST}-dev, libclang-${TZC_LLVM_NEWEST}-dev and libclang-cpp${TZC_LLVM_NEWEST}-dev, or name one with \
-DTZC_LLVM_CONFIG")
if(TZC_LLVM_VERSION)
  set(TZC_CLANG_MISSING "llvm-config-${TZC_LLVM_VERSION} was not found; install llvm-${TZC_LLVM_VERSION}-dev, \
libclang-${TZC_LLVM_VERSION}-dev and libclang-cpp${TZC_LLVM_VERSION}-dev")
endif()
_tzc_llvm_configs(programs)
set(first_missing "")
foreach(program ${programs})
  _tzc_try_llvm(${program})
  if(NOT missing)
    set(TZC_CLANG_FOUND TRUE)
    break()
  endif()
  if(NOT first_missing)
    set(first_missing "${missing}")
    set(TZC_CLANG_MISSING "${missing}")
  endif()
endforeach()

if(TZC_CLANG_FOUND)
  message(STATUS "tzc-rewrite uses Clang ${TZC_CLANG_MAJOR} (${TZC_CLANG_INCLUDE_DIR})")
  # Clang's own headers (stddef.h, ...), which must match the libraries.
  set(TZC_CLANG_RESOURCE_DIR ${TZC_CLANG_RESOURCE})
  add_library(tzc_clang INTERFACE)
  target_include_directories(tzc_clang SYSTEM INTERFACE ${TZC_CLANG_INCLUDE_DIR})
  target_link_libraries(tzc_clang INTERFACE ${TZC_CLANG_LIBRARIES})
  target_compile_options(tzc_clang INTERFACE -Wno-nonnull)  # its headers warn when their functions are inlined
endif()
