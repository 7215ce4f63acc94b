#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# `cmake --install BUILD --prefix P` as a normal user: everything is below P, a shell that sources P's setup file finds
# the tools, and nothing that is installed names the folder of the build.
# usage: test_install.sh SOURCE_DIR BUILD_DIR BUILD_TYPE TOOL...
source "$(dirname "$0")/lib.sh"
source_dir=$1 build=$2 build_type=$3
shift 3
tools=("$@")
prefix=$scratch/prefix

install_as_user "$build" "$prefix"
outside=$(grep -v "^$prefix/" "$build/install_manifest.txt" || true)
[ -z "$outside" ] || wrong "installed outside of the prefix: $outside"
for file in setup.bash setup.sh setup.zsh local_setup.bash env.sh _setup_util.py .catkin include/tzc/ros.h \
  include/tzc/channel.h include/tzc/sensor_msgs/Image.h lib/libtzc_core.so lib/libtzc_roscpp.so lib/libtzc_preload.so \
  share/tzc/package.xml share/tzc/cmake/tzcConfig.cmake lib/pkgconfig/tzc.pc lib/pkgconfig/tzc_core.pc bin/tzc-msggen \
  bin/tzc-run lib/tzc/tzc-msggen lib/tzc/tzc-run; do
  [ -e "$prefix/$file" ] || wrong "no $file in the prefix"
done

# Shells of three kinds.
for shell in bash sh zsh; do
  command -v "$shell" >/dev/null || { echo "no $shell here: not tried"; continue; }
  for tool in "${tools[@]}"; do
    found=$(as_user "$shell" -c ". $prefix/setup.$shell && command -v $tool" || true)
    [ "$found" = "$prefix/bin/$tool" ] || wrong "$shell finds $tool in '$found'"
  done
done
for tool in "${tools[@]}"; do
  logged "rosrun-$tool" bash -c ". $prefix/setup.bash && rosrun tzc $tool --help"
  grep -q -i usage "$scratch/rosrun-$tool.log" || wrong "rosrun tzc $tool --help says nothing of its usage"
done

# The loader's names hold the version of the ABI.
for library in core roscpp; do
  readelf -d "$prefix/lib/libtzc_$library.so" | grep -q "SONAME.*\[libtzc_$library.so.0\]" ||
    wrong "libtzc_$library.so has no SONAME libtzc_$library.so.0"
done

# Every page that a message of a library or a program names is there; the source tree's docs/ is not.
named=$(grep -raohE 'share/doc/tzc/[A-Za-z0-9/_-]+\.md' "$prefix/lib" "$prefix/bin" | sort -u || true)
for page in configuration guard traces troubleshooting versions; do
  grep -q "^share/doc/tzc/$page.md$" <<<"$named" || wrong "no message names share/doc/tzc/$page.md any more: is this looking at messages?"
done
for page in $named; do
  [ -f "$prefix/$page" ] || wrong "a message names $page, which is not installed"
  [ -f "$build/devel/$page" ] || wrong "a message names $page, which is not in the devel space"
done
lost=$(grep -raohE '(^|[^A-Za-z0-9/])docs/[A-Za-z0-9/_-]+\.md' "$prefix/lib" "$prefix/bin" | sort -u || true)
[ -z "$lost" ] || wrong "messages name pages of the source tree, which is not installed: $lost"

# A row of a table belongs to a head: a blank line in between cuts the table.
headless=$(find "$prefix/share/doc/tzc" -name '*.md' -exec awk '
  FNR == 1 { before = ""; head = 0 }
  head && !/^\|[ :|-]+\|$/ { print FILENAME ":" FNR - 1 }
  { head = /^\|/ && before !~ /^\|/; before = $0 }' {} +)
[ -z "$headless" ] || wrong "rows of a table without its head: $headless"

# Nothing names the folders of source and build. A debugger wants a Debug build's paths; the others have none.
options=-rlI
case $build_type in Release | RelWithDebInfo | MinSizeRel) options=-rl ;; esac
leaks=$(grep "$options" -F -e "$source_dir" -e "$build" "$prefix" || true)
[ -z "$leaks" ] || wrong "these files name $source_dir or $build: $leaks"

# For packagers: DESTDIR goes in front, and what is written names the prefix alone.
logged destdir env DESTDIR="$scratch/stage" cmake --install "$build" --prefix /opt/tzc
[ -e "$scratch/stage/opt/tzc/lib/libtzc_core.so" ] || wrong "DESTDIR is not respected"
grep -q ':=/opt/tzc}' "$scratch/stage/opt/tzc/setup.sh" || wrong "setup.sh of DESTDIR does not name its prefix"
leaks=$(grep -rlI -F "$scratch/stage" "$scratch/stage" || true)
[ -z "$leaks" ] || wrong "these files name DESTDIR: $leaks"

# A prefix that has setup files keeps them.
as_user sh -c "echo '# mine' >>$prefix/setup.sh"
install_as_user "$build" "$prefix"
tail -n 1 "$prefix/setup.sh" | grep -q mine || wrong "setup.sh of the prefix was overwritten"
echo "installed below $prefix, found by bash, sh, zsh and rosrun, without a path of the build"
