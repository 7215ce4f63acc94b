#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The lists of packages: one for each supported distribution, names only, no name twice, and every name of this
# distribution's list exists. usage: test_setup.sh SOURCE_DIR
set -euo pipefail
unset CDPATH
cd "$1"
for distribution in debian-12 ubuntu-20.04 ubuntu-22.04 ubuntu-24.04; do
  names=$(scripts/setup --list "$distribution")
  [ "$(wc -l <<<"$names")" -gt 15 ] || { echo "$distribution: the list is too short"; exit 1; }
  ! grep -vxE '[a-z0-9][a-z0-9.+-]+' <<<"$names" || { echo "$distribution: not a package's name"; exit 1; }
  twice=$(sort <<<"$names" | uniq -d)
  [ -z "$twice" ] || { echo "$distribution: twice: $twice"; exit 1; }
  grep -qE '^libclang-cpp[0-9]+-dev$' <<<"$names" || { echo "$distribution: no Clang"; exit 1; }
done
if scripts/setup --list plan9-4 >/dev/null 2>&1; then echo "an unknown distribution has a list"; exit 1; fi
if scripts/setup --list debian-12 more >/dev/null 2>&1; then echo "an argument too many is accepted"; exit 1; fi

# A user's CDPATH leads no script astray: those that do not begin with common.sh say so themselves.
[ "$(CDPATH=. scripts/setup --list debian-12)" = "$(scripts/setup --list debian-12)" ] || { echo "CDPATH changes what scripts/setup does"; exit 1; }
grep -lrE '\(cd "\$\(dirname' scripts packaging tests | while read -r script; do
  grep -qE '^unset CDPATH|/lib(/common)?\.sh"$' "$script" || { echo "$script follows CDPATH"; exit 1; }
done

if grep -q 'VERSION_ID="12"' /etc/os-release; then
  mapfile -t names < <(scripts/setup --full --list)
  [ "${#names[@]}" -gt "$(scripts/setup --list | wc -l)" ] || { echo "--full adds nothing to the list"; exit 1; }
  known=$(apt-cache pkgnames)
  missing=$(printf '%s\n' "${names[@]}" | grep -vxF -f <(printf '%s\n' "$known") || true)
  [ -z "$missing" ] || { echo "Debian 12 has no package $missing"; exit 1; }

  # As a normal user with sudo, which drops the environment: apt-get asks nothing and reads nothing.
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  dpkg-query() { :; }
  id() { echo 1000; }
  sudo() { printf '%s; reads %s\n' "$*" "$(cat)" >>"$SAID"; }
  export -f dpkg-query id sudo
  echo "the user's answer" | SAID=$scratch/said TZC_BUILD_DIR=$scratch scripts/setup >/dev/null
  asked=$(grep -vE '^env DEBIAN_FRONTEND=noninteractive apt-get -o Dpkg::Options::=--force-confold (update|install -y .*); reads $' "$scratch/said" || true)
  if [ -n "$asked" ] || [ "$(wc -l <"$scratch/said")" != 2 ]; then echo "apt-get may ask: $(cat "$scratch/said")"; exit 1; fi
fi
echo "the lists are sound"
