# SPDX-License-Identifier: BSD-3-Clause
# For the modules between publish() and the callback. After an idle pause every cache line and page of code on it
# is a miss, so it has to be short: direct calls, and inlining across files where the compiler is GCC. The objects are
# ordinary ones, too: tests link them without link-time optimisation.
set(TZC_HOT_PATH_LINK_OPTIONS "")
add_compile_options(-fno-semantic-interposition -fno-plt)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT TZC_SANITIZE AND NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
  add_compile_options(-flto=auto -ffat-lto-objects)
  set(TZC_HOT_PATH_LINK_OPTIONS -flto=auto)
endif()
