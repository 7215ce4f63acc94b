# SPDX-License-Identifier: BSD-3-Clause
# The target tzc_clang: Clang 19's libraries, shared ones (linking the static ones takes minutes).
find_program(TZC_LLVM_CONFIG NAMES llvm-config-19 HINTS /usr/lib/llvm-19/bin)
if(NOT TZC_LLVM_CONFIG)
  message(FATAL_ERROR "llvm-config-19 was not found: install llvm-19-dev and libclang-19-dev, "
                      "or configure with -DTZC_BUILD_REWRITER=OFF")
endif()
execute_process(COMMAND ${TZC_LLVM_CONFIG} --includedir OUTPUT_VARIABLE include_dir OUTPUT_STRIP_TRAILING_WHITESPACE)
execute_process(COMMAND ${TZC_LLVM_CONFIG} --libdir OUTPUT_VARIABLE library_dir OUTPUT_STRIP_TRAILING_WHITESPACE)
find_library(TZC_CLANG_CPP NAMES libclang-cpp.so.19.1 clang-cpp HINTS ${library_dir} NO_DEFAULT_PATH)
find_library(TZC_LLVM NAMES LLVM-19 LLVM HINTS ${library_dir} NO_DEFAULT_PATH)
if(NOT TZC_CLANG_CPP OR NOT TZC_LLVM)
  message(FATAL_ERROR "Clang 19's shared libraries are not in ${library_dir}: install libclang-cpp19-dev")
endif()

add_library(tzc_clang INTERFACE)
target_include_directories(tzc_clang SYSTEM INTERFACE ${include_dir})
target_link_libraries(tzc_clang INTERFACE ${TZC_CLANG_CPP} ${TZC_LLVM})

# Clang's own headers (stddef.h, ...), which must match the libraries.
set(TZC_CLANG_RESOURCE_DIR "${library_dir}/clang/19" CACHE PATH "Where Clang 19's own headers are")
