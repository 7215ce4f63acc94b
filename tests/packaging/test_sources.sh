#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What scripts fetch and copy: sources whose unpacking was interrupted, and read-only ones.
# usage: test_sources.sh SOURCE_DIR
source "$(dirname "$0")/lib.sh"
scripts=$1/scripts

# with_scripts COMMANDS: as scripts/demo and scripts/port-packages call them, by a user without rights.
with_scripts() {
  as_user env TZC_BUILD_DIR="$scratch/build" bash -c "source '$scripts/lib/common.sh'
source '$scripts/lib/debian_source.sh'
source '$scripts/lib/workspace.sh'
$1"
}

# A stand-in for apt-get that is interrupted while it unpacks, or not.
apt_get='apt-get() {
  [ "$1" = source ] || return 0
  mkdir "$2-1.0" && touch "$2-1.0/one"
  [ -n "${WHOLE:-}" ] || return 1
  touch "$2-1.0/two" "$2_1.0.dsc"
}'
for call in "debian_source pack '$scratch/sources'" "path=\$(debian_source pack '$scratch/sources') || exit 2"; do
  ! with_scripts "$apt_get; $call" >"$scratch/said" 2>&1 || wrong "an interrupted apt-get source passes"
done
for _ in first again; do
  found=$(with_scripts "$apt_get; WHOLE=yes; debian_source pack '$scratch/sources'")
  [ "$found" = "$scratch/sources/pack-1.0" ] || wrong "the sources are in '$found'"
  [ -f "$found/two" ] || wrong "half unpacked sources are taken for whole ones"
done
left=$(find "$scratch/sources" -mindepth 1 -maxdepth 1 ! -name apt ! -name pack-1.0)
[ -z "$left" ] || wrong "left behind: $left"

as_user mkdir -p demo/src
as_user touch demo/package.xml demo/src/one.cpp
as_user chmod -R a-w demo
for _ in first again; do
  with_scripts "fill_workspace '$scratch/workspace' '$scratch/demo'" 2>"$scratch/said" || wrong "$(cat "$scratch/said")"
done
as_user touch workspace/src/demo/src/two.cpp || wrong "the copy of a read-only package cannot be changed"
as_user chmod -R u+w demo
echo "sources are whole, and copies are the user's"
