# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the project's scripts: where things are, how they speak, how the project is configured and built.
set -euo pipefail
unset CDPATH  # with it, cd goes elsewhere and says where

TZC_ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
TZC_BUILD=$(realpath -m "${TZC_BUILD_DIR:-$TZC_ROOT/build}")

# Debian's catkin and rosmaster need Debian's python3, and pluginlib drags in ament without ROS_VERSION.
export PATH=/usr/bin:$PATH
export ROS_VERSION=1 ROS_PYTHON_VERSION=3
export LANG=C.UTF-8

if [ -t 1 ] && [ -z "${NO_COLOR:-}" ]; then bold=$'\e[1m' red=$'\e[31m' plain=$'\e[0m'; else bold='' red='' plain=''; fi
say() { printf '%s== %s%s\n' "$bold" "$*" "$plain"; }
error() { printf '%serror:%s %s\n' "$red" "$plain" "$*" >&2; }
fail() { error "$@"; exit 1; }
refuse() { error "$@"; exit 2; }  # a mistake on the command line

# whole_number OPTION VALUE, positive_number OPTION VALUE: refuse what is none, before the work begins.
whole_number() { [[ ${2:-} =~ ^[1-9][0-9]*$ ]] || refuse "$1 needs a number of at least 1, not '${2:-}'"; }
positive_number() { [[ ${2:-} =~ ^[0-9]+([.][0-9]+)?$ && $2 == *[1-9]* ]] || refuse "$1 needs a number above 0, not '${2:-}'"; }

# Runs a long, chatty command quietly; shows its output only when it fails. quietly LOGFILE COMMAND...
quietly() {
  local log=$1; shift
  mkdir -p "$(dirname "$log")"
  "$@" >"$log" 2>&1 && return
  local status=$?
  tail -n 60 "$log" >&2
  error "$1 failed with status $status; its whole output is in $log"
  return "$status"
}

# build_project [CMAKE_OPTION...] -- TARGET...: configures build/ and builds the targets.
build_project() {
  local options=()
  while [ "$1" != -- ]; do options+=("$1"); shift; done
  shift
  local cache=$TZC_BUILD/CMakeCache.txt
  if [ -e "$cache" ] && ! grep -q '^CMAKE_GENERATOR:INTERNAL=Ninja$' "$cache"; then
    fail "$TZC_BUILD was configured without Ninja; give another folder: TZC_BUILD_DIR=FOLDER $0, or remove it"
  fi
  quietly "$TZC_BUILD/log/configure.log" cmake -G Ninja -S "$TZC_ROOT" -B "$TZC_BUILD" "${options[@]}"
  # Progress for people; CI logs get the summary.
  if [ -t 1 ]; then
    ninja -C "$TZC_BUILD" "$@"
  else
    quietly "$TZC_BUILD/log/build.log" ninja -C "$TZC_BUILD" "$@"
  fi
}
