# SPDX-License-Identifier: BSD-3-Clause
# Sourced by scripts/demo for --red-light and --rotation, after workspace.sh: builds the applications and runs them.

# port_applications FOLDER: samples/red_light and samples/rotation in FOLDER/original, and ported in FOLDER/ported.
# Both are kept while the sources, tzc-rewrite and the headers of TZC are what they were.
port_applications() {
  local folder=$1 packages=(red_light rotation) state package
  state=$(applications_state "${packages[@]}")
  if [ -f "$folder/state" ] && [ "$(cat "$folder/state")" = "$state" ]; then
    say "The applications and their ports are up to date"
    return
  fi
  say "Building the original applications with catkin"
  rm -rf "$folder/state" "$folder/ported/src"
  fill_workspace "$folder/original" "${packages[@]/#/$TZC_ROOT/samples/}"
  build_workspace "$folder/original"

  say "Porting them: every site, and the size of the change"
  mkdir -p "$folder/ported/src"
  "$TZC_BUILD/bin/tzc-rewrite" -p "$folder/original/build" --out-dir "$folder/ported/src" --report "$folder/port.json" \
    "${packages[@]/#/$folder/original/src/}"
  for package in "${packages[@]}"; do
    git diff --no-index --stat "$folder/original/src/$package" "$folder/ported/src/$package" || true  # 1: they differ
  done

  say "Building the ported applications with catkin"
  build_workspace "$folder/ported"
  echo "$state" > "$folder/state"
}

# applications_state PACKAGE...: changes with whatever the ports are made from.
applications_state() {
  {
    cd "$TZC_ROOT/samples" && find "$@" -type f -print0 | sort -z | xargs -0 sha256sum
    sha256sum "$TZC_BUILD/bin/tzc-rewrite"
    find "$TZC_ROOT/runtime" "$TZC_BUILD/devel/include" -name '*.h' -print0 | sort -z | xargs -0 sha256sum
  } | sha256sum
}

# run_application EXPERIMENT FOLDER OPTION...: ends this shell with the status of the run.
run_application() {
  local experiment=$1 folder=$2; shift 2
  say "Measuring: original and port in turns, each under a roscore of its own"
  exec python3 "$TZC_ROOT/scripts/lib/applications.py" "$experiment" "$TZC_BUILD/demo/$experiment" \
    "$folder/original" "$folder/ported" --port-report "$folder/port.json" "$@"
}
