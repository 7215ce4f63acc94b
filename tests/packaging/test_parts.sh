#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The project configures, tests included, without each of the parts that cmake/TzcOptions.cmake lets a user leave out, and
# without all of them. usage: test_parts.sh SOURCE_DIR
set -euo pipefail
source=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mapfile -t parts < <(sed -nE 's/^(option|set)\((TZC_BUILD_[A-Z]+) .*/\2/p' "$source/cmake/TzcOptions.cmake" | grep -vx TZC_BUILD_TESTS | sort -u)
[ "${#parts[@]}" -ge 6 ] || { echo "only these parts were found: ${parts[*]}"; exit 1; }

configures_without() {
  cmake -G Ninja -S "$source" -B "$scratch/build" --fresh -DTZC_BUILD_TESTS=ON "${@/%/=OFF}" >"$scratch/log" 2>&1 ||
    { echo "without ${*#-D}:"; cat "$scratch/log"; exit 1; }
}
# The Debian package of the tools needs what those need that are in it.
check_package_without_rewriter() {
  local config=$scratch/build/CPackConfig.cmake depends
  depends=$(sed -n 's/^set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "\(.*\)")$/\1/p' "$config")
  [[ $depends =~ ^libtzc-dev\ \(=\ [0-9.]+\)$ ]] || { echo "without tzc-rewrite tzc-tools depends on $depends"; exit 1; }
  ! grep -q 'TOOLS.*tzc-rewrite' "$config" || { echo "tzc-tools promises tzc-rewrite, which it has not"; exit 1; }
}
for part in "${parts[@]}"; do
  configures_without "-D$part"
  [ "$part" != TZC_BUILD_REWRITER ] || check_package_without_rewriter
done
configures_without "${parts[@]/#/-D}"
echo "configured without each of ${parts[*]}"
