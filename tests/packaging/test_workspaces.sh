#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# tzc as a member of a catkin workspace, beside a package that uses it and one with messages: catkin_make, catkin_make
# install, catkin_make_isolated with --install, and `catkin build`. As a normal user; a package that uses tzc runs from
# each of them, and rosrun finds the tools. Each compiles all of tzc: scripts/test --full runs it.
# usage: test_workspaces.sh SOURCE_DIR
source "$(dirname "$0")/lib.sh"
source_dir=$1
here=$(cd "$(dirname "$0")" && pwd)
ws=$scratch/ws

mkdir -p "$ws/src"
# What a clone would hold, build folders left out.
(cd "$source_dir" && { git ls-files -z 2>/dev/null || find . -type f -not -path './build*' -not -path './.git/*' -print0; } |
  tar --null -T - --ignore-failed-read -cf - 2>/dev/null) | { mkdir "$ws/src/tzc" && tar -xf - -C "$ws/src/tzc"; }
cp -a "$here/workspace/." "$ws/src/"
[ "$(id -u)" != 0 ] || chown -R nobody:nogroup "$ws"

# Optimizing is not what is tested here; the rewriter takes minutes, and joins once, at the end.
options=(-DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-O0 -DTZC_BUILD_REWRITER=OFF)

in_ws() { local name=$1; shift; logged "$name" sh -c 'cd "$0" && exec "$@"' "$ws" "$@"; }

# works SETUP_FILE SPACE: the user's node runs there, on the library of that space; so do the tools.
works() {
  local setup=$1 space=$2 said
  said=$(as_user bash -c ". $setup && rosrun robot robot_node")
  [ "$said" = "3 readings, not allocated" ] || wrong "$space: the node printed: $said"
  logged ldd bash -c ". $setup && ldd \$(catkin_find --first-only --libexec robot robot_node)"
  grep -qF "libtzc_roscpp.so.0 => $ws/" "$scratch/ldd.log" ||
    wrong "$space: the node does not run on the workspace's library"
  logged tools bash -c ". $setup && rosrun tzc tzc-msggen --help && tzc-msggen --help && tzc-run --help"
  echo "$space: works"
}

in_ws catkin_make catkin_make "${options[@]}"
works "$ws/devel/setup.bash" "catkin_make"
! grep -q '^TZC_BUILD_TESTS.*=ON' "$ws/build/CMakeCache.txt" || wrong "tests are on in a workspace"
in_ws catkin_make_install catkin_make install "${options[@]}"
works "$ws/install/setup.bash" "catkin_make install"
leaks=$(grep -rlI -F -e "$ws/src" -e "$ws/build" -e "$ws/devel" "$ws/install" || true)
[ -z "$leaks" ] || wrong "these files name the workspace's folders: $leaks"

in_ws catkin_make_isolated catkin_make_isolated --install "${options[@]}"
works "$ws/devel_isolated/setup.bash" "catkin_make_isolated"
works "$ws/install_isolated/setup.bash" "catkin_make_isolated --install"

rm -rf "$ws/build" "$ws/devel" "$ws/install" "$ws"/*_isolated
if command -v catkin >/dev/null; then
  in_ws catkin_config catkin config --cmake-args "${options[@]}"
  in_ws catkin_build catkin build --no-status --summarize
  works "$ws/devel/setup.bash" "catkin build"
  # As a user with Clang has it.
  in_ws catkin_config catkin config --append-args --cmake-args -DTZC_BUILD_REWRITER=ON
  in_ws catkin_build_rewriter catkin build --no-status --summarize
  logged rewriter bash -c ". $ws/devel/setup.bash && rosrun tzc tzc-rewrite --version"
  grep -q '^tzc-rewrite [0-9]' "$scratch/rewriter.log" || wrong "rosrun tzc tzc-rewrite: $(cat "$scratch/rewriter.log")"
else
  wrong "catkin (Debian: catkin-tools) is not installed; scripts/setup installs it"
fi
