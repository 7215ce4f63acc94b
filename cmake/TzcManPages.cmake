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
  string(REPLACE - _ target ${tool})
  set(depends "")
  foreach(candidate ${tool} ${target})
    if(TARGET ${candidate})
      list(APPEND depends ${candidate})
    endif()
  endforeach()
  add_custom_command(OUTPUT ${page}
    COMMAND ${TZC_HELP2MAN} --no-info --name=${description} --version-string=${PROJECT_VERSION} --source=TZC
            --output=${page} ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/${tool}
    DEPENDS ${depends} VERBATIM)
  add_custom_target(man-${tool} ALL DEPENDS ${page})
  install(FILES ${page} DESTINATION share/man/man1 COMPONENT ${component})
endfunction()

foreach(tool ${TZC_TOOLS})
  _tzc_man_page(${tool} ${TZC_TOOL_${tool}})
  install(FILES packaging/completion/tzc.bash DESTINATION share/bash-completion/completions RENAME ${tool} COMPONENT dev)
endforeach()

set(zsh_folder share/zsh/site-functions)
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(zsh_folder share/zsh/vendor-completions)  # as Debian wants it
endif()
install(FILES packaging/completion/_tzc DESTINATION ${zsh_folder} COMPONENT dev)
