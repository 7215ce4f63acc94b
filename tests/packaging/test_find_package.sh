#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds and runs a consumer against tzc's install tree and its build tree, as a plain CMake package and as a catkin
# component. usage: test_find_package.sh BUILD_DIR
set -euo pipefail
build=$1
here=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export PATH=/usr/bin:$PATH ROS_VERSION=1

cmake --install "$build" --prefix "$scratch/prefix" >"$scratch/install.log" || { cat "$scratch/install.log"; exit 1; }

check() {
  local name=$1 prefix=$2 catkin=$3
  cmake -S "$here/consumer" -B "$scratch/$name" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" -DUSE_CATKIN="$catkin" \
    -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DPYTHON_EXECUTABLE=/usr/bin/python3 >"$scratch/$name.log" 2>&1 &&
    cmake --build "$scratch/$name" >>"$scratch/$name.log" 2>&1 || { tail -n 30 "$scratch/$name.log"; return 1; }
  local binary said
  binary=$(find "$scratch/$name" -name consumer -type f -perm -u+x | head -n 1)
  # As after `source setup.bash`, which puts a workspace's lib folder on the path.
  said=$(LD_LIBRARY_PATH=$prefix/lib "$binary")
  [ "$said" = "3 bytes, not allocated" ] || { echo "$name printed: $said"; return 1; }
  # A library of the build tree must not be what the install tree's consumer runs on.
  LD_LIBRARY_PATH=$prefix/lib ldd "$binary" | grep -F "$prefix/lib/libtzc_roscpp.so" >/dev/null ||
    { echo "$name does not run on $prefix/lib:"; ldd "$binary" | grep tzc; return 1; }
  echo "$name: works"
}

check install-plain "$scratch/prefix" OFF
check install-catkin "$scratch/prefix" ON
check build-plain "$build/devel" OFF
check build-catkin "$build/devel" ON
