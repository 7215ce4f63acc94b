# SPDX-License-Identifier: BSD-3-Clause
# cmake -DPAGES_DIR=docs/diagnostics -DOUTPUT=pages.inc -P embed_pages.cmake
# Writes one {"TZCnnnn", "page"} entry per page. Literals are cut at 8 KB: compilers may limit their length.
file(GLOB pages ${PAGES_DIR}/TZC*.md)
list(SORT pages)
set(text "")
foreach(page ${pages})
  get_filename_component(code ${page} NAME_WE)
  file(READ ${page} hex HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${hex}")
  string(REGEX REPLACE "(\\\\x0a)" "\\1\"\n    \"" lines "${bytes}")
  string(APPEND text "{\"${code}\",\n    \"${lines}\"},\n")
endforeach()
file(WRITE ${OUTPUT} "${text}")
