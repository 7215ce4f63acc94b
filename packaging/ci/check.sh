#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds a catkin workspace and checks that its packages are ported; what the GitHub Action runs, and good for any CI.
#
#   TZC_WORKSPACE      the workspace (default: .)
#   TZC_PACKAGES       packages, relative to the workspace (default: src)
#   TZC_BASELINE       a report whose sites are accepted, relative to the workspace (default: none)
#   TZC_SETUP          tzc's setup.bash, which joins what was sourced before (default: tzc is found already)
#   TZC_SARIF          where the report for code scanning goes (default: tzc.sarif in the workspace)
#   TZC_BUILD_COMMAND  what builds the workspace, with -DCMAKE_EXPORT_COMPILE_COMMANDS=ON for CMake (default: the program
#                      that has built it before, of catkin build, catkin_make_isolated and catkin_make; else the last)
#
# Exit status as tzc-rewrite's: 0 nothing is left, 1 something is, 2 an error.
set -eo pipefail
trap 'exit 2' EXIT  # whatever ends this script before tzc-rewrite takes its place
unset CDPATH
cd "${TZC_WORKSPACE:-.}"
# shellcheck source=/dev/null
[ -z "${TZC_SETUP:-}" ] || source "$TZC_SETUP" --extend
command -v tzc-rewrite >/dev/null || { echo "tzc-rewrite was not found: set TZC_SETUP to tzc's setup.bash" >&2; exit 2; }

# The build makes the headers of the workspace's own messages, and tells how each file is compiled.
build_workspace() {
  local option=-DCMAKE_EXPORT_COMPILE_COMMANDS=ON
  if [ -n "${TZC_BUILD_COMMAND:-}" ]; then
    bash -c "$TZC_BUILD_COMMAND"
  elif [ -e .catkin_tools ]; then
    # `catkin build --cmake-args` would drop the options that the workspace is configured with.
    catkin config | grep -F -- "$option" >/dev/null || catkin config --append-args --cmake-args "$option"
    catkin build
  elif [ -e build_isolated ] && [ ! -e build ]; then
    catkin_make_isolated "$option"
  else
    catkin_make "$option"
  fi
}
build_workspace || { echo "the workspace could not be built: repair it, or set TZC_BUILD_COMMAND to what builds it" >&2; exit 2; }
baseline=()
[ -z "${TZC_BASELINE:-}" ] || baseline=(--baseline "$TZC_BASELINE")
# shellcheck disable=SC2086  # several packages
exec tzc-rewrite --check "${baseline[@]}" --report "${TZC_SARIF:-tzc.sarif}" ${TZC_PACKAGES:-src}
