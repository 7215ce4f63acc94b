#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# package.xml says what the build asks CMake for, as catkin_lint sees it. It gives up on projects whose CMake code is in
# modules, so it gets one file that finds the same packages; those only run (tools such as rosbag) CMake does not look for.
# That package.xml names each package whose headers are included is what architecture.package_xml looks at.
# usage: test_manifest.sh SOURCE_DIR
source "$(dirname "$0")/lib.sh"
source_dir=$1
command -v catkin_lint >/dev/null || wrong "catkin_lint (Debian: catkin-lint) is not installed; scripts/setup installs it"

depends=$(sed -n 's/^set(TZC_CATKIN_DEPENDS \(.*\))/\1/p' "$source_dir/cmake/TzcCatkin.cmake")
named() { sed -n "s#.*<$1>\(.*\)</$1>#\1#p" "$source_dir/package.xml" | sort; }
linked_privately=$(comm -12 <(named build_depend) <(named exec_depend))
[ -n "$depends" ] && [ -n "$linked_privately" ] || wrong "no dependencies were read"

mkdir "$scratch/lint"
cp "$source_dir/package.xml" "$scratch/lint/"
# shellcheck disable=SC2086  # words
cat >"$scratch/lint/CMakeLists.txt" <<CMAKE
cmake_minimum_required(VERSION 3.16)
project(tzc)
find_package(catkin REQUIRED COMPONENTS $depends)
$(printf 'find_package(%s REQUIRED)\n' $linked_privately)
catkin_package(CATKIN_DEPENDS $depends)
CMAKE

lint() { logged lint catkin_lint --offline -W1 --strict "$scratch/lint"; }
lint
grep -q "checked 1 packages and found 0 problems" "$scratch/lint.log" || wrong "catkin_lint: $(cat "$scratch/lint.log")"
echo "catkin_lint: content with package.xml"

# That it would have found one.
sed -i "/<build_depend>${linked_privately%%$'\n'*}</d" "$scratch/lint/package.xml"
! lint >/dev/null || wrong "catkin_lint does not see that a dependency is missing"
echo "catkin_lint: a missing build_depend is found"
