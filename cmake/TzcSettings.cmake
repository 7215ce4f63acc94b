# SPDX-License-Identifier: BSD-3-Clause
# Settings that every target of the project shares.
include(GNUInstallDirs)

# In /usr catkin follows Debian's multiarch folders.
set(TZC_INSTALL_LIBDIR lib)
set(TZC_INSTALL_CMAKEDIR share/tzc/cmake)
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(TZC_INSTALL_LIBDIR ${CMAKE_INSTALL_LIBDIR})
  set(TZC_INSTALL_CMAKEDIR ${CMAKE_INSTALL_LIBDIR}/cmake/tzc)
endif()

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  if(TZC_STANDALONE)
    set(CMAKE_BUILD_TYPE RelWithDebInfo CACHE STRING "Build type" FORCE)
  else()
    set(CMAKE_BUILD_TYPE RelWithDebInfo)  # for this folder: how the rest of the workspace is built is not ours to say
  endif()
endif()
find_program(TZC_CCACHE ccache)
if(TZC_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${TZC_CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${TZC_CCACHE})
endif()

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)

add_compile_options(-Wall -Wextra)
# Function names and lines, which a stack trace of a robot's core file or a profile needs. The rest of the debug information
# took up to two fifths of the compilation; a Debug build has it.
if(CMAKE_BUILD_TYPE STREQUAL "RelWithDebInfo" AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  add_compile_options(-g1)
endif()
# What is installed must not name the folder that it was built in: log lines and debug information name files relative
# to the project. A Debug build keeps whole paths for the debugger.
if(CMAKE_BUILD_TYPE MATCHES "^(Release|RelWithDebInfo|MinSizeRel)$")
  set(prefix_maps -ffile-prefix-map=${PROJECT_SOURCE_DIR}=. -ffile-prefix-map=${PROJECT_BINARY_DIR}=build)
  add_compile_options(${prefix_maps})
  add_link_options(${prefix_maps})  # link-time optimisation writes debug information of its own
endif()
if(TZC_SANITIZE)
  add_compile_options(-fsanitize=${TZC_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${TZC_SANITIZE})
endif()

find_package(Threads REQUIRED)
