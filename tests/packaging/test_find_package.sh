#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds and runs a consumer against tzc's install tree, moved after it was installed, and its build tree: with CMake's
# variables, as a catkin component, with the targets tzc::tzc and tzc::core, and with pkg-config. As a normal user.
# usage: test_find_package.sh BUILD_DIR
source "$(dirname "$0")/lib.sh"
build=$1
here=$(cd "$(dirname "$0")" && pwd)
prefix=$scratch/prefix

install_as_user "$build" "$scratch/first"
mv "$scratch/first" "$prefix"

# runs_on NAME BINARY PREFIX LIBRARY...: the program says what it should, on that prefix's libraries.
runs_on() {
  local name=$1 binary=$2 prefix=$3 said expected library; shift 3
  # As after `source setup.bash`, which puts a workspace's lib folder on the path.
  said=$(as_user env LD_LIBRARY_PATH="$prefix/lib" "$binary")
  case $name in *-core) expected="3 bytes, allocated" ;; *) expected="3 bytes, not allocated" ;; esac
  [ "$said" = "$expected" ] || wrong "$name printed: $said"
  for library in "$@"; do
    as_user env LD_LIBRARY_PATH="$prefix/lib" ldd "$binary" | grep -F "$prefix/lib/$library" >/dev/null ||
      wrong "$name does not run on $prefix/lib/$library: $(ldd "$binary" | grep tzc)"
  done
  echo "$name: works"
}

check() {
  local name=$1 prefix=$2 how=$3
  logged "$name-configure" cmake -S "$here/consumer" -B "$scratch/$name" -DCMAKE_PREFIX_PATH="$prefix" -DHOW="$how" \
    -DCMAKE_CXX_COMPILER_LAUNCHER=ccache
  logged "$name-build" cmake --build "$scratch/$name"
  local libraries=(libtzc_core.so.0)
  [ "$how" = core ] || libraries+=(libtzc_roscpp.so.0)
  runs_on "$name" "$(find "$scratch/$name" -name consumer -type f -perm -u+x | head -n 1)" "$prefix" "${libraries[@]}"
}

check_pkg_config() {
  local name=$1 prefix=$2 flags
  flags=$(as_user env PKG_CONFIG_PATH="$prefix/lib/pkgconfig" pkg-config --cflags --libs tzc)
  # shellcheck disable=SC2086  # words
  logged "$name" ccache g++ -std=c++14 "$here/consumer/main.cpp" -o "$scratch/$name" $flags
  runs_on "$name" "$scratch/$name" "$prefix" libtzc_core.so.0 libtzc_roscpp.so.0
}

for how in variables catkin target core; do
  check "install-$how" "$prefix" "$how"
  check "build-$how" "$build/devel" "$how"
done
check_pkg_config install-pkg-config "$prefix"
check_pkg_config build-pkg-config "$build/devel"

# A version of another ABI is refused, and so is a component that does not exist.
for request in "99.0" "COMPONENTS gpu"; do
  if as_user cmake -S "$here/consumer" -B "$scratch/refused" -DCMAKE_PREFIX_PATH="$prefix" -DHOW=variables \
    -DREQUEST="$request" >"$scratch/refused.log" 2>&1; then
    wrong "find_package(tzc $request) succeeds"
  fi
done
