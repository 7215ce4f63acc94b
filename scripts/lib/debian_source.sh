# SPDX-License-Identifier: BSD-3-Clause
# Source packages from Debian's archive, without touching the machine's own apt configuration.

# debian_source PACKAGE FOLDER: fetches and unpacks the package below FOLDER (once); prints the folder of its sources.
debian_source() {
  local package=$1 folder=$2 found
  found=$(unpacked_source "$package" "$folder")
  if [ -z "$found" ]; then
    fetch_source "$package" "$folder" || return
    found=$(unpacked_source "$package" "$folder")
  fi
  printf '%s\n' "$found"
}

unpacked_source() {
  local package=$1 folder=$2
  mkdir -p "$folder"
  find "$folder" -mindepth 1 -maxdepth 1 -type d -name "$package-[0-9]*" | head -n 1
}

# Unpacks in a folder of its own: what stands in FOLDER is complete, whenever this ends. Each step says what its failure
# does: where a caller looks at the status, as in `|| exit 2`, set -e does nothing.
fetch_source() (
  local package=$1 folder=$2 unpacking=$2/unpacking-$1 found
  source_apt_configuration "$folder/apt"
  rm -rf "$unpacking"
  mkdir "$unpacking" && cd "$unpacking" || exit
  export APT_CONFIG=$folder/apt/apt.conf
  quietly "$TZC_BUILD/log/apt-source-update.log" apt-get update || exit
  quietly "$TZC_BUILD/log/apt-source-$package.log" apt-get source "$package" || exit
  found=$(unpacked_source "$package" "$unpacking")
  [ -n "$found" ] || fail "apt-get source $package left no folder"
  mv "$found" "$folder/" || exit
  rm -rf "$unpacking"
)

# A private copy of apt's sources with deb-src wherever the machine has deb for Debian itself.
source_apt_configuration() {
  local folder=$1
  mkdir -p "$folder/lists/partial" "$folder/cache/archives/partial" "$folder/sources.d"
  # One-line and deb822 formats; only entries that point at a Debian archive carry source packages of ROS.
  sed -n 's/^deb /deb-src /p' /etc/apt/sources.list /etc/apt/sources.list.d/*.list 2>/dev/null |
    grep -E 'debian' >"$folder/sources.d/machine.list" || true
  local file
  for file in /etc/apt/sources.list.d/*.sources; do
    [ -f "$file" ] || continue
    grep -q 'Signed-By:.*debian-archive' "$file" || continue
    sed 's/^Types:.*/Types: deb-src/' "$file" >"$folder/sources.d/$(basename "$file")"
  done
  cat >"$folder/apt.conf" <<CONF
Dir::Etc::SourceList "/dev/null";
Dir::Etc::SourceParts "$folder/sources.d";
Dir::State::Lists "$folder/lists";
Dir::Cache "$folder/cache";
APT::Sandbox::User "root";
CONF
}
