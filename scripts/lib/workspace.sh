# SPDX-License-Identifier: BSD-3-Clause
# Catkin workspaces for demonstrations and tests.

# fill_workspace WORKSPACE PACKAGE_DIR...: a workspace with fresh copies of the packages, which can be changed and removed
# where the originals are read-only.
fill_workspace() {
  local workspace=$1 package; shift
  mkdir -p "$workspace/src"
  for package in "$@"; do
    rm -rf "$workspace/src/$(basename "$package")"
    cp -a "$package" "$workspace/src/"
    chmod -R u+w "$workspace/src/$(basename "$package")"
  done
}

# build_workspace WORKSPACE: catkin_make, with this project's build tree among the prefixes.
build_workspace() {
  local workspace=$1
  (
    cd "$workspace"
    export CMAKE_PREFIX_PATH=$TZC_BUILD/devel${CMAKE_PREFIX_PATH:+:$CMAKE_PREFIX_PATH}
    quietly "$workspace/catkin_make.log" catkin_make --use-ninja -DCMAKE_BUILD_TYPE=Release \
      -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DPYTHON_EXECUTABLE=/usr/bin/python3
  )
}
