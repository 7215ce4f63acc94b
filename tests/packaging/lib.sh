# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the packaging tests: a scratch folder, and a user without rights in a fresh environment, as a new shell has.
set -euo pipefail
unset CDPATH

scratch=$(mktemp -d)
chmod 755 "$scratch"
trap 'rm -rf "$scratch"' EXIT
# The compiler's cache is the test's own (the machine's may not be writable), and outlives it where there is a place.
cache=${PACKAGING_CCACHE:-$scratch/ccache}
mkdir -p "$scratch/home" "$cache"

# Root becomes the user nobody; any other user is a normal user already.
user=()
if [ "$(id -u)" = 0 ]; then
  chown nobody:nogroup "$scratch" "$scratch/home" "$cache"
  user=(setpriv --reuid nobody --regid nogroup --clear-groups --inh-caps=-all --bounding-set=-all)
fi

# as_user COMMAND...: in the scratch folder.
as_user() {
  (cd "$scratch" && exec "${user[@]}" env -i HOME="$scratch/home" TMPDIR="$scratch" PATH=/usr/bin:/bin LANG=C.UTF-8 \
    ROS_HOME="$scratch/home/.ros" CCACHE_DIR="$cache" CCACHE_BASEDIR="$scratch" CCACHE_NOHASHDIR=1 "$@")
}

# logged NAME COMMAND...: as_user, quiet unless it fails.
logged() {
  local name=$1; shift
  as_user "$@" >"$scratch/$name.log" 2>&1 && return
  echo "FAILED: $name: $*"
  tail -n 60 "$scratch/$name.log"
  return 1
}

wrong() { echo "WRONG: $*"; exit 1; }

# install_as_user BUILD PREFIX [CMAKE_OPTION...]: a build tree of another owner lets its list of files be written.
install_as_user() {
  local build=$1 prefix=$2; shift 2
  if [ ${#user[@]} -gt 0 ]; then
    touch "$build/install_manifest.txt"
    chmod a+w "$build/install_manifest.txt"
  fi
  logged install cmake --install "$build" --prefix "$prefix" "$@"
}
