# SPDX-License-Identifier: BSD-3-Clause
# Sourced after common.sh by the steps that need a machine as a newcomer has it: Debian 12 in a folder, with nothing but
# its base system and a normal user `robot` who may use sudo. Needs debootstrap, root or sudo, and Debian's archive.
#
#   make_clean_root ROOT           the folder is removed at the end; TZC_KEEP_ROOT=1 keeps it
#   in_root COMMAND...             as root
#   as_newcomer SCRIPT             the user's login shell, with the network (for packages)
#   as_newcomer_offline SCRIPT     the same with a network and processes of its own: a roscore meets no other, and whatever
#                                  the script leaves running ends with it
#
# TZC_CLEAN_ROOT=DIR: use a root that an earlier run has kept, and keep it.

as_root=()
[ "$(id -u)" = 0 ] || as_root=(sudo)

mirror_of_this_machine() {
  local mirror  # the last sed reads to the end: one that left earlier would end the first by SIGPIPE
  mirror=$(sed -n 's/^URIs: *\([^ ]*\).*/\1/p; s/^deb \(http[^ ]*\) .*/\1/p' /etc/apt/sources.list \
    /etc/apt/sources.list.d/debian.sources 2>/dev/null | sed -n 1p) || true
  echo "${mirror:-http://deb.debian.org/debian}"
}

remove_clean_root() {
  [ -n "${TZC_KEEP_ROOT:-}${TZC_CLEAN_ROOT:-}" ] || "${as_root[@]}" rm -rf --one-file-system "$root"
}

# Mounts are those of the command alone, so nothing is left mounted whatever happens.
in_namespaces() {
  local options=(--mount --pid --fork --kill-child)
  [ "$1" = online ] || options+=(--net)
  shift
  # shellcheck disable=SC2016
  "${as_root[@]}" unshare "${options[@]}" sh -ec 'root=$1; shift
    ip link set lo up
    mount -t proc proc "$root/proc"
    mount -t tmpfs -o mode=1777,size=2g tmpfs "$root/dev/shm"
    exec chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"' \
    sh "$root" "$@"
}

in_root() { in_namespaces online "$@"; }
as_newcomer() { in_namespaces online su --login --whitelist-environment=LANG robot -c "$1" </dev/null; }
as_newcomer_offline() { in_namespaces offline su --login --whitelist-environment=LANG robot -c "$1" </dev/null; }

# What every installed Debian has and debootstrap leaves out: the host's own name, sudo, a user.
prepare_root() {
  echo "127.0.0.1 localhost $(uname -n)" | "${as_root[@]}" tee "$root/etc/hosts" >/dev/null
  apt-config dump | grep -E '^Acquire::(http|https)::' | "${as_root[@]}" tee "$root/etc/apt/apt.conf.d/01proxy" >/dev/null || true
  echo force-unsafe-io | "${as_root[@]}" tee "$root/etc/dpkg/dpkg.cfg.d/unsafe-io" >/dev/null
  "${as_root[@]}" mkdir -p "$root/dev/shm"
  in_root sh -ec 'apt-get update && apt-get install -y --no-install-recommends sudo ca-certificates
    useradd --create-home --shell /bin/bash robot
    echo "robot ALL=(ALL) NOPASSWD: ALL" >/etc/sudoers.d/robot'
}

make_clean_root() {
  root=${TZC_CLEAN_ROOT:-$1}
  trap remove_clean_root EXIT
  [ -z "${TZC_CLEAN_ROOT:-}" ] || return 0
  "${as_root[@]}" rm -rf --one-file-system "$root"
  quietly "$1.log" "${as_root[@]}" debootstrap --variant=minbase bookworm "$root" "$(mirror_of_this_machine)"
  quietly "$1.log" prepare_root
}
