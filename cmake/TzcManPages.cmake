# SPDX-License-Identifier: BSD-3-Clause
# Manual pages, made of what the tools themselves say with --help, and completion for bash and zsh, which asks them, too.
find_program(TZC_HELP2MAN help2man)
if(NOT TZC_HELP2MAN)
  message(STATUS "Manual pages are left out: help2man was not found")
endif()

function(_tzc_man_page tool component description)
  if(NOT TZC_HELP2MAN)
    return()
  endif()
  set(page ${PROJECT_BINARY_DIR}/man/${tool}.1)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/man)
  set(depends "")
  if(TARGET ${tool})
    set(depends ${tool})
  endif()
  add_custom_command(OUTPUT ${page}
    COMMAND ${TZC_HELP2MAN} --no-info --name=${description} --version-string=${PROJECT_VERSION} --source=TZC
            --output=${page} ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/${tool}
    DEPENDS ${depends} VERBATIM)
  add_custom_target(man-${tool} ALL DEPENDS ${page})
  install(FILES ${page} DESTINATION share/man/man1 COMPONENT ${component})
endfunction()

_tzc_man_page(tzc-msggen dev "generates TZC headers of ROS messages")
if(TARGET tzc-rewrite)
  _tzc_man_page(tzc-rewrite tools "ports roscpp packages to TZC")
endif()
if(TARGET tzc-monitor)
  _tzc_man_page(tzc-monitor tools "shows what nodes do with shared memory")
endif()
if(TARGET tzc-diagnostics)
  _tzc_man_page(tzc-diagnostics tools "publishes on /diagnostics what nodes do with shared memory")
endif()
if(TARGET tzc_preload)
  _tzc_man_page(tzc-run runtime "runs an unmodified roscpp program with shared memory")
endif()

set(zsh_folder share/zsh/site-functions)
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(zsh_folder share/zsh/vendor-completions)  # as Debian wants it
endif()
foreach(tool tzc-msggen tzc-rewrite tzc-monitor)
  install(FILES packaging/completion/tzc.bash DESTINATION share/bash-completion/completions RENAME ${tool} COMPONENT dev)
endforeach()
install(FILES packaging/completion/_tzc DESTINATION ${zsh_folder} COMPONENT dev)
