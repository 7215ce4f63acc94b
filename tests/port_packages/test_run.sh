#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# scripts/port-packages on a folder with a package that cannot be configured beside one that can, and on Debian's sources.
set -euo pipefail
root=$1 build=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export TZC_BUILD_DIR=$build TZC_PORT_WITHOUT_BUILD=1

fail() { printf 'FAILED: %s\n' "$1" >&2; cat "$work/printed" "$work"/out/*/log/*.log >&2 || true; exit 1; }
holds() { grep -qE -- "$2" "$1" || fail "$1 does not hold: $2"; }

mkdir "$work/wild"
cp -a "$root/samples/camera_pair" "$work/wild/"
mkdir "$work/wild/broken"
sed 's/camera_pair/broken/' "$root/samples/camera_pair/package.xml" >"$work/wild/broken/package.xml"
printf 'cmake_minimum_required(VERSION 3.0.2)\nproject(broken)\nfind_package(no_such_thing REQUIRED)\n' >"$work/wild/broken/CMakeLists.txt"
mkdir "$work/inputs"
printf '%s\n' --command 'rosrun camera_pair camera_node _count:=20' --duration 20 >"$work/inputs/wild.args"

port() { "$root/scripts/port-packages" --out "$work/out" --no-speed --build-type None --inputs "$work/inputs" "$@" >"$work/printed" 2>&1; }
port --no-tests --only camera_pair --only broken --only image_publisher "$work/wild" debian:ros-image-pipeline ||
  fail "it ends with $?"
holds "$work/out/table.txt" '^wild +1 \(-1\) +3, 3 +1/0/0/0 +1/0/0/0 +1/0/0 .* equal '
holds "$work/out/table.txt" '^wild: broken is left out: CMake Error at broken/CMakeLists.txt:3'
holds "$work/out/table.txt" '^ros-image-pipeline +1 '
holds "$work/printed" '^ros-image-pipeline: its runs are not compared: .*/inputs has no ros-image-pipeline.args'
holds "$work/out/wild/port.diff" '^\+.*tzc::advertise'
holds "$work/out/wild/ported/build/CMakeCache.txt" '^CMAKE_BUILD_TYPE:.*=None'
[ -x "$work/out/wild/ported/devel/lib/camera_pair/camera_node" ] || fail "the port was not built"

port --no-tests --only camera_pair --only broken --only image_publisher "$work/wild" debian:ros-image-pipeline ||
  fail "again, it ends with $?"
holds "$work/printed" '^wild: is done already'

mkdir -p "$work/tested/tested"
sed 's/camera_pair/tested/' "$root/samples/camera_pair/package.xml" >"$work/tested/tested/package.xml"
cat >"$work/tested/tested/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.0.2)
project(tested)
find_package(catkin REQUIRED)
catkin_package()
catkin_add_gtest(passes passes.cpp)
catkin_add_gtest(cannot_be_built cannot_be_built.cpp)
CMAKE
printf '#include <gtest/gtest.h>\nTEST(Suite, passes) {}\nint main(int c, char** v) { testing::InitGoogleTest(&c, v); return RUN_ALL_TESTS(); }\n' >"$work/tested/tested/passes.cpp"
printf '#error no\n' >"$work/tested/tested/cannot_be_built.cpp"
CCACHE_DIR=$work/ccache CCACHE_STATSLOG=$work/compiled port "$work/tested" ||
  fail "with a test that cannot be built it ends with $?"
holds "$work/out/table.txt" '^tested +1 .* 1/1, 1/1 '
# Units that the port leaves as they are, in another folder, are not compiled twice.
awk '/passes.cpp/ { times++ } times == 2' "$work/compiled" >"$work/again"
holds "$work/again" '^(direct|preprocessed)_cache_hit'

refused() {
  local words=$1 status=0
  shift
  port "$@" || status=$?
  [ "$status" = 2 ] || fail "$* ends with $status"
  holds "$work/printed" "^error: .*$words"
}
refused 'lie one in the other' --out "$work/tested/tested" "$work/tested"
refused 'lie one in the other' --out "$work" "$work/tested"
refused 'needs a value' --only
refused 'needs a value' --jobs= "$work/tested"
refused '--jobs needs a number' --jobs 0 "$work/tested"
refused '--timeout needs a number' --timeout many "$work/tested"
refused 'no such folder: .*/missing' --inputs "$work/missing" "$work/tested"
refused 'no such folder: .*/missing' "$work/missing"
refused 'two sources are called' "$work/tested" "$work/out/../tested"
refused 'File exists|Not a directory' --out "$work/tested/tested/passes.cpp" "$work/wild"
[ ! -e "$work/tested/original" ] || fail "it wrote into its source"
(
  exec 9>"$work/out/tested/lock"
  flock 9
  refused 'another run works in' "$work/tested"
)
mv "$work/tested" "$work/is=tested"
port "$work/is=tested" || fail "with a name that has an equals sign it ends with $?"
holds "$work/out/table.txt" '^is=tested +1 '

status=0
port --again --only broken "$work/wild" || status=$?
[ "$status" = 1 ] || fail "with nothing to port it ends with $status"
holds "$work/out/table.txt" 'no package could be configured'
echo passed
