# SPDX-License-Identifier: BSD-3-Clause
# tzc_installed_messages: the TZC headers of every message package of this machine's ROS, in the devel space's include
# folder, installed with the project. tzc::messages gives targets their include folder.
#
# The command runs in every build: it takes a few hundredths of a second, finds the packages by itself (so that one that
# was installed since is not missed) and leaves files alone that would not change, so nothing is compiled again.
if(CATKIN_DEVEL_PREFIX)
  set(TZC_MESSAGES_INCLUDE_DIR ${CATKIN_DEVEL_PREFIX}/include)
else()
  set(TZC_MESSAGES_INCLUDE_DIR ${PROJECT_BINARY_DIR}/devel/include)
endif()
file(MAKE_DIRECTORY ${TZC_MESSAGES_INCLUDE_DIR}/tzc)

# A build with a sanitizer takes another build's generator, and does not compile its own.
set(TZC_HOST_MSGGEN tzc-msggen CACHE STRING "The generator that the build runs: a program, or the target tzc-msggen")
add_custom_target(tzc_installed_messages ALL
  COMMAND ${TZC_HOST_MSGGEN} generate --installed --if-changed -o ${TZC_MESSAGES_INCLUDE_DIR}
  COMMENT "TZC headers of the installed message packages"
  VERBATIM)

add_library(tzc_messages INTERFACE)
add_library(tzc::messages ALIAS tzc_messages)
target_include_directories(tzc_messages INTERFACE ${TZC_MESSAGES_INCLUDE_DIR})
add_dependencies(tzc_messages tzc_installed_messages)

# In one workspace with tzc, targets that link its library find the headers made.
if(TARGET tzc_roscpp)
  add_dependencies(tzc_roscpp tzc_installed_messages)
endif()
